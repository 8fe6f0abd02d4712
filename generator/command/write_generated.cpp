// Turns every model into the files of generated/, for developers who changed the generator.
#include <iostream>

#include "emission/emit.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_generated DIRECTORY\n";
    return 2;
  }
  try {
    assur::generator::write_files(assur::generator::emit_all(), argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
