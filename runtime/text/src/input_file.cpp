#include <assur/text/error.hpp>
#include <assur/text/input_file.hpp>
#include <fstream>
#include <iterator>

namespace assur::text {

std::string read_input_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError(file.string() + ": cannot be read (does it exist, and is it a file?)");
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace assur::text
