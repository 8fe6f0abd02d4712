#include "audit/running/work_directory.hpp"

#include <unistd.h>

#include <assur/text/error.hpp>
#include <fstream>
#include <iterator>

namespace assur::generator::audit::running {

WorkDirectory::WorkDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "assur-audit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw text::InputError(name + ": this directory cannot be made");
  }
  path_ = name;
}

WorkDirectory::~WorkDirectory() {
  std::error_code ignored;  // files that cannot be removed do not end the audit
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path WorkDirectory::write(const std::string& name, const std::string& text) const {
  std::ofstream out(path_ / name, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    throw text::InputError((path_ / name).string() + ": cannot be written");
  }
  return path_ / name;
}

std::string WorkDirectory::read(const std::string& name) const {
  std::ifstream in(path_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace assur::generator::audit::running
