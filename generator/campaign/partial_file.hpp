// A file that is written piece by piece and appears as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assur::generator::campaign {

/// A file with the temporary name `NAME.partial` that is renamed when it is complete. It is locked:
/// of two processes that write the same file one is refused. The next process overwrites the
/// remains of one that was killed.
class PartialFile {
 public:
  /// Throws InputError if the file cannot be created, or another process is writing it.
  explicit PartialFile(std::filesystem::path target);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  /// Removes an unfinished file.
  ~PartialFile();

  [[nodiscard]] const std::filesystem::path& target() const { return target_; }
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
  /// Throws InputError if writing fails, for instance for lack of space.
  void write(const std::string& text);
  /// Writes all data to the disk.
  void flush() const;
  /// Renames files, all of them or none. Throws InputError.
  static void take_names(const std::vector<PartialFile*>& files);
  /// Throws an InputError with the file and the reason, a system error number.
  [[noreturn]] void fail(int reason) const;

 private:
  std::filesystem::path target_, partial_;
  int descriptor_ = -1;
};

/// Throws InputError if the directory of the file is missing: a mistyped one is not created.
void expect_directory(const std::filesystem::path& file);

/// Throws InputError if no file can have that name: it is too long, its links form a cycle, it is a
/// directory, or its directory does not exist.
void expect_writable(const std::filesystem::path& file);

/// Throws InputError if the file, or its temporary file, is one of the inputs, which would be lost.
void expect_other(const std::filesystem::path& file,
                  const std::vector<std::filesystem::path>& inputs);

/// Throws InputError if the name is taken, unless the file may be replaced.
void expect_new(const std::filesystem::path& file, bool may_replace);

}  // namespace assur::generator::campaign
