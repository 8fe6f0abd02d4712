// An empty program: linked with one folder's library, it shows that the folder depends on none
// above it.
int main() { return 0; }
