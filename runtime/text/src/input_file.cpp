#include <array>
#include <assur/text/error.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/utf8.hpp>
#include <fstream>

namespace assur::text {

namespace {

/// Far more than any scene needs; a device file might never end.
constexpr std::size_t largest_file = std::size_t{8} << 20;

}  // namespace

std::string read_input_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError(file.string() + ": cannot be read (does it exist, and is it a file?)");
  }
  std::string text;
  std::array<char, 65536> block{};
  while (stream) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_file) {
      throw InputError(file.string() + ": the file is longer than " +
                       std::to_string(largest_file >> 20) +
                       " MiB, the limit of input files; divide it");
    }
  }
  expect_no_nul(text, file.string());
  return text;
}

}  // namespace assur::text
