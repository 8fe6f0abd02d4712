#include "emission/cpp/files.hpp"

#include <assur/text/error.hpp>
#include <fstream>
#include <iterator>
#include <system_error>

namespace assur::generator::emission::cpp {

namespace fs = std::filesystem;

void write_files(const std::vector<EmittedFile>& files, const fs::path& directory) {
  for (const EmittedFile& file : files) {
    const fs::path target = directory / file.path;
    fs::path beside = target;
    beside += ".part";
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    std::ofstream out(beside, std::ios::binary);
    out << file.text;
    out.close();
    if (!out) {
      fs::remove(beside, error);
      throw text::InputError("--output: cannot write " + target.string() +
                             " (is the directory writable?)");
    }
    fs::rename(beside, target, error);
    if (error) {
      const std::string reason = error.message();
      fs::remove(beside, error);
      throw text::InputError("--output: cannot replace " + target.string() + ": " + reason);
    }
  }
}

std::vector<fs::path> differing_files(const std::vector<EmittedFile>& files,
                                      const fs::path& directory) {
  std::vector<fs::path> differing;
  for (const EmittedFile& file : files) {
    std::ifstream in(directory / file.path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (text != file.text) {
      differing.push_back(file.path);
    }
  }
  return differing;
}

}  // namespace assur::generator::emission::cpp
