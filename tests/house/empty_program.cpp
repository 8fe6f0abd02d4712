// Does nothing: a program of one folder's library alone links if the folder needs none above it.
int main() { return 0; }
