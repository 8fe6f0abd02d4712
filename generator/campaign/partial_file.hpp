// Turns text that is written piece by piece into a file that exists as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assur::generator::campaign {

/// A file under a temporary name, `NAME.partial`, that takes its own name when it is whole. It is
/// locked: of two processes that write the same file one is refused. The next process overwrites
/// what a killed one has left.
class PartialFile {
 public:
  /// Throws InputError where the file cannot be made, or another process is writing it.
  explicit PartialFile(std::filesystem::path target);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  /// Removes what has not been finished.
  ~PartialFile();

  [[nodiscard]] const std::filesystem::path& target() const { return target_; }
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
  /// Throws InputError where it cannot be written, for lack of room for instance.
  void write(const std::string& text);
  /// Brings everything to the disk.
  void flush() const;
  /// Gives files their names, all of them or none. Throws InputError.
  static void take_names(const std::vector<PartialFile*>& files);
  /// Throws an InputError that names the file and the reason, which is the system's error number.
  [[noreturn]] void fail(int reason) const;

 private:
  std::filesystem::path target_, partial_;
  int descriptor_ = -1;
};

/// Throws InputError where the directory of the file is missing: a mistyped one is not made.
void expect_directory(const std::filesystem::path& file);

/// Throws InputError where no file can have that name: it is too long, its links lead in a circle,
/// it is that of a directory, or there is no directory to hold it.
void expect_writable(const std::filesystem::path& file);

/// Throws InputError where the file, or the temporary one that becomes it, is one of the inputs,
/// which would be lost.
void expect_other(const std::filesystem::path& file,
                  const std::vector<std::filesystem::path>& inputs);

/// Throws InputError where something has that name, unless it may be replaced.
void expect_new(const std::filesystem::path& file, bool may_replace);

}  // namespace assur::generator::campaign
