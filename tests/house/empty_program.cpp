// Does nothing: linked with one folder's library, it shows that the folder needs none above it.
int main() { return 0; }
