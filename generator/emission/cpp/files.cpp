#include "emission/cpp/files.hpp"

#include <unistd.h>

#include <assur/text/error.hpp>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "all_or_none.hpp"

namespace assur::generator::emission::cpp {

namespace fs = std::filesystem;

namespace {

/// The scene file named in an emitted solver; empty for any other text.
std::string scene_of(const std::string& text) {
  const std::string before = "// Reproduce: assur emit --scene ";
  const std::size_t place = text.find(before);
  if (place == std::string::npos) {
    return "";
  }
  const std::size_t begin = place + before.size();
  return text.substr(begin, text.find(" --", begin) - begin);
}

/// The first bytes of a regular file; empty for anything else, since a device may have no end.
std::string head_of(const fs::path& file, std::size_t most) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    return "";
  }
  std::ifstream in(file, std::ios::binary);
  std::string text(most, ' ');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// Throws if the file would replace the solver of another scene.
void expect_same_scene(const EmittedFile& file, const fs::path& target) {
  constexpr std::size_t most_before_scene = 4096;
  const std::string there = scene_of(head_of(target, most_before_scene));
  const std::string scene = scene_of(file.text);
  if (!there.empty() && !scene.empty() && there != scene) {
    throw text::InputError("--output: " + target.string() + " is the solver of '" + there +
                           "', whose name differs from '" + scene +
                           "' in punctuation alone; rename one of them, or remove that file");
  }
}

/// Files written beside those that they are to replace; removed unless they replace them.
class PendingFiles {
 public:
  explicit PendingFiles(fs::path directory) : directory_(std::move(directory)) {}
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles() {
    std::error_code ignored;
    for (const auto& [beside, target] : written_) {
      fs::remove(beside, ignored);
    }
    for (const fs::path& made : made_) {  // a directory that is not empty stays
      fs::remove(made, ignored);
    }
  }

  void write(const EmittedFile& file) {
    const fs::path target = directory_ / file.path;
    fs::path beside = target;
    // Two simultaneous runs must not write the same file.
    beside += ".part" + std::to_string(getpid());
    std::error_code error;
    auto place = made_.begin();
    for (fs::path folder = target.parent_path(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path()) {
      place = made_.insert(place, folder) + 1;
    }
    fs::create_directories(target.parent_path(), error);
    if (error) {
      throw text::InputError("--output: " + target.string() +
                             " cannot be written: " + error.message() + "; give another name");
    }
    if (fs::is_directory(target, error)) {
      throw text::InputError("--output: " + target.string() +
                             " cannot be written: it is a directory; give another name");
    }
    expect_same_scene(file, target);
    errno = 0;
    std::ofstream out(beside, std::ios::binary);
    if (out) {
      written_.push_back({beside, target});
    }
    out << file.text;
    out.close();
    if (!out) {
      throw text::InputError("--output: " + target.string() +
                             " cannot be written: " + std::generic_category().message(errno));
    }
  }

  void replace_all() {
    if (const auto failed = rename_all(written_)) {
      throw text::InputError("--output: " + failed->to.string() + " cannot be written: " +
                             failed->reason.message() + "; give another name");
    }
  }

 private:
  fs::path directory_;
  std::vector<Renaming> written_;
  std::vector<fs::path> made_;  ///< directories, the inner ones first
};

}  // namespace

void write_files(const std::vector<EmittedFile>& files, const fs::path& directory) {
  PendingFiles pending(directory);
  for (const EmittedFile& file : files) {
    pending.write(file);
  }
  pending.replace_all();
}

std::vector<fs::path> differing_files(const std::vector<EmittedFile>& files,
                                      const fs::path& directory) {
  std::vector<fs::path> differing;
  for (const EmittedFile& file : files) {
    // One byte more than is emitted shows a file that is longer.
    if (head_of(directory / file.path, file.text.size() + 1) != file.text) {
      differing.push_back(file.path);
    }
  }
  return differing;
}

}  // namespace assur::generator::emission::cpp
