// Writes the headers of all models: write_generated DIRECTORY [WORD...].
#include <iostream>

#include "emission/model/emit.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: write_generated DIRECTORY [WORD...]\n";
    return 2;
  }
  try {
    using namespace assur::generator::emission;
    cpp::write_files(model::emit_all({argv + 2, argv + argc}), argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
