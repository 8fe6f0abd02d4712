// Law: of several files all are written, or none where one of them cannot be.
#include "emission/cpp/files.hpp"

#include <gtest/gtest.h>

#include <assur/text/error.hpp>
#include <filesystem>

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
  EXPECT_TRUE(fs::is_empty(directory.path() / "a"));
}

}  // namespace
}  // namespace assur::test::files_test
