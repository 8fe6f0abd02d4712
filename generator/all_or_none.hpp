// Renames several complete files: all of them, or none.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

namespace assur::generator {

/// A file and its new name in the same directory.
struct Renaming {
  std::filesystem::path from, to;
};

/// A renaming that failed, and the reason.
struct FailedRenaming {
  std::filesystem::path to;
  std::error_code reason;
};

/// Renames all files, replacing files that have these names. If one renaming fails, the replaced
/// files get their names back, and the files renamed before it are removed.
[[nodiscard]] inline std::optional<FailedRenaming> rename_all(const std::vector<Renaming>& files) {
  namespace fs = std::filesystem;
  const auto old_of = [](const Renaming& file) { return fs::path(file.from) += ".old"; };
  std::optional<FailedRenaming> failed;
  std::error_code ignored;
  std::size_t done = 0;
  for (; done < files.size() && !failed; ++done) {
    const auto& [from, to] = files[done];
    std::error_code error;
    const fs::file_status there = fs::symlink_status(to, ignored);
    fs::remove(old_of(files[done]), ignored);  // left by a killed process
    // The file that the last one replaces need not be kept, as nothing can fail afterwards.
    if (done + 1 < files.size() && fs::exists(there) && !fs::is_directory(there)) {
      fs::create_hard_link(to, old_of(files[done]), error);
      if (error) {  // not every file system has hard links
        fs::copy(to, old_of(files[done]), fs::copy_options::copy_symlinks, error);
      }
    }
    if (!error) {
      fs::rename(from, to, error);
    }
    if (error) {
      failed = FailedRenaming{to, error};
    }
  }
  for (std::size_t place = 0; place < done; ++place) {
    const fs::path old = old_of(files[place]);
    const bool is_changed = failed && place + 1 < done;
    if (is_changed && fs::exists(fs::symlink_status(old, ignored))) {
      fs::rename(old, files[place].to, ignored);
    } else {
      fs::remove(is_changed ? files[place].to : old, ignored);
    }
  }
  return failed;
}

}  // namespace assur::generator
