#include "campaign/partial_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <assur/text/error.hpp>
#include <cerrno>
#include <cstring>
#include <utility>

#include "all_or_none.hpp"

namespace assur::generator::campaign {

namespace {

/// The name under which a file is written until it is complete.
std::filesystem::path partial_name(std::filesystem::path file) {
  file += ".partial";
  return file;
}

[[noreturn]] void refuse(const std::filesystem::path& file, int reason) {
  throw text::InputError(file.string() + ": cannot be written: " + std::strerror(reason) +
                         "; give another name");
}

/// Whether a path still names the open file: the process that held the lock may have renamed or
/// removed it.
bool is_named(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

PartialFile::PartialFile(std::filesystem::path target)
    : target_(std::move(target)), partial_(partial_name(target_)) {
  while (true) {
    descriptor_ = open(partial_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      fail(errno);
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      (void)close(descriptor_);
      descriptor_ = -1;
      throw text::InputError(target_.string() +
                             ": another process is writing it; wait for it, or give another name");
    }
    if (is_named(descriptor_, partial_)) {
      break;
    }
    (void)close(descriptor_);
  }
  if (ftruncate(descriptor_, 0) != 0) {
    fail(errno);
  }
}

PartialFile::~PartialFile() {
  if (descriptor_ >= 0) {
    (void)unlink(partial_.c_str());
    (void)close(descriptor_);
  }
}

void PartialFile::fail(int reason) const {
  throw text::InputError(target_.string() + ": cannot be written: " + std::strerror(reason));
}

// NOLINTNEXTLINE(readability-make-member-function-const): the file that it writes is its state
void PartialFile::write(const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = ::write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno != EINTR) {
      fail(errno);
    }
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

void PartialFile::flush() const {
  if (fsync(descriptor_) != 0 && errno != EINVAL) {  // not every file can be synchronised
    fail(errno);
  }
}

void PartialFile::take_names(const std::vector<PartialFile*>& files) {
  std::vector<Renaming> renamings;
  for (const PartialFile* file : files) {
    renamings.push_back({file->partial_, file->target_});
  }
  if (const auto failed = rename_all(renamings)) {
    throw text::InputError(failed->to.string() +
                           ": cannot be written: " + failed->reason.message());
  }
  for (PartialFile* file : files) {
    (void)close(std::exchange(file->descriptor_, -1));
  }
}

void expect_directory(const std::filesystem::path& file) {
  std::error_code error;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), error)) {
    throw text::InputError(file.string() + ": there is no directory " +
                           file.parent_path().string() + "; make it, or name another one");
  }
}

void expect_writable(const std::filesystem::path& file) {
  expect_directory(file);
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw text::InputError(file.string() + ": it is a directory; give another name");
  }
  for (const std::filesystem::path& name : {file, partial_name(file)}) {
    (void)std::filesystem::status(name, error);
    if (error && error != std::errc::no_such_file_or_directory) {
      refuse(file, error.value());
    }
  }
}

void expect_other(const std::filesystem::path& file,
                  const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& input : inputs) {
    std::error_code error;  // a file that does not exist is not an input
    if (std::filesystem::equivalent(file, input, error) ||
        std::filesystem::equivalent(partial_name(file), input, error)) {
      throw text::InputError(file.string() + ": writing it would replace the input " +
                             input.string() + "; give another name");
    }
  }
}

void expect_new(const std::filesystem::path& file, bool may_replace) {
  std::error_code error;
  if (!may_replace && std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
    throw text::InputError(file.string() +
                           ": the file exists; give another name, or --force to replace it");
  }
}

}  // namespace assur::generator::campaign
