// Turns the files of one program into a new directory, which is removed with the object.
#pragma once

#include <filesystem>
#include <string>

namespace assur::generator::audit::running {

class WorkDirectory {
 public:
  WorkDirectory();
  WorkDirectory(const WorkDirectory&) = delete;
  WorkDirectory& operator=(const WorkDirectory&) = delete;
  ~WorkDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // NOLINTNEXTLINE(modernize-use-nodiscard): it writes, and callers that read by name need no path
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  /// Empty where there is no such file.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace assur::generator::audit::running
