// Law: either all of several files are written, or none.
#include "emission/cpp/files.hpp"

#include <gtest/gtest.h>

#include <assur/text/error.hpp>
#include <filesystem>
#include <numeric>
#include <set>

#include "all_or_none.hpp"
#include "command/command.hpp"

namespace assur::test::files_test {
namespace {

namespace fs = std::filesystem;
namespace cpp = generator::emission::cpp;

const std::vector<cpp::EmittedFile> files = {{"a/one.hpp", "one\n"}, {"b/two.hpp", "two\n"}};

TEST(WrittenFiles, AreAllThere) {
  const TemporaryDirectory directory;
  cpp::write_files(files, directory.path());
  EXPECT_EQ(read_file(directory.path() / "a/one.hpp"), "one\n");
  EXPECT_EQ(read_file(directory.path() / "b/two.hpp"), "two\n");
  EXPECT_TRUE(cpp::differing_files(files, directory.path()).empty());
}

TEST(WrittenFiles, AreNoneWhereADirectoryHasThePlaceOfOne) {
  const TemporaryDirectory directory;
  const fs::path taken = directory.path() / "b/two.hpp";
  fs::create_directories(taken);
  try {
    cpp::write_files(files, directory.path());
    ADD_FAILURE() << "nothing was refused";
  } catch (const text::InputError& error) {
    EXPECT_EQ(error.what(), "--output: " + taken.string() +
                                " cannot be written: it is a directory; give another name");
  }
  EXPECT_TRUE(fs::is_empty(taken));
  EXPECT_FALSE(fs::exists(directory.path() / "a"));
}

/// The second file has the name of a directory that is made for the third one, so that it is
/// written beside its place and cannot be moved there.
TEST(WrittenFiles, AreAllOldWhereOneCannotBeMoved) {
  const TemporaryDirectory directory;
  const fs::path first = directory.write("one.hpp", "old");
  EXPECT_THROW(cpp::write_files({{"one.hpp", "new"}, {"two", "new"}, {"two/three.hpp", "new"}},
                                directory.path()),
               text::InputError);
  EXPECT_EQ(read_file(first), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), {}), 1);
}

/// Of three files with new texts, two have a file in their place.
class RenamedFiles : public testing::Test {
 protected:
  RenamedFiles() {
    for (const std::string name : {"one", "three"}) {
      directory_.write(name, "old");
    }
    for (const std::string name : {"one", "two", "three"}) {
      renamings_.push_back({directory_.write(name + ".part", "new"), directory_.path() / name});
    }
    for (const std::string name : {"one", "two"}) {
      directory_.write(name + ".part.old", "of a killed process");
    }
  }
  /// All files and their texts.
  [[nodiscard]] std::string texts() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(directory_.path())) {
      all.insert(entry.path().filename().string() + ": " + read_file(entry.path()) + "\n");
    }
    return std::accumulate(all.begin(), all.end(), std::string());
  }

  TemporaryDirectory directory_;
  std::vector<generator::Renaming> renamings_;
};

TEST_F(RenamedFiles, AreAllNew) {
  EXPECT_FALSE(generator::rename_all(renamings_));
  EXPECT_EQ(texts(), "one: new\nthree: new\ntwo: new\n");
}

TEST_F(RenamedFiles, AreAllOldWhereTheLastIsRefused) {
  renamings_.push_back({directory_.path() / "four.part", directory_.path() / "four"});
  const auto failed = generator::rename_all(renamings_);
  ASSERT_TRUE(failed);
  EXPECT_EQ(failed->to.filename(), "four");
  EXPECT_EQ(failed->reason, std::errc::no_such_file_or_directory);
  EXPECT_EQ(texts(), "one: old\nthree: old\n");
}

TEST_F(RenamedFiles, AreAllOldWhereADirectoryIsInThePlaceOfOne) {
  fs::remove(renamings_[1].to);
  fs::create_directories(renamings_[1].to / "below");
  EXPECT_TRUE(generator::rename_all(renamings_));
  EXPECT_TRUE(fs::is_directory(renamings_[1].to / "below"));
  fs::remove_all(renamings_[1].to);
  EXPECT_EQ(texts(), "one: old\nthree.part: new\nthree: old\ntwo.part: new\n");
}

}  // namespace
}  // namespace assur::test::files_test
