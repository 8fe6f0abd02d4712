// Law: a pattern matches a text if its `?` can stand for parts of it that are not empty and have no
// superscript; of all ways to match, each `?` takes the shortest part, the first one first.
#include <gtest/gtest.h>

#include "latex/notation.hpp"

namespace assur::test::wildcards_test {
namespace {

using Parts = std::vector<std::string>;

/// Tries every length of every part, the shortest first.
bool tried(const std::string& pattern, const std::string& text, Parts& parts) {
  if (pattern.empty()) {
    return text.empty();
  }
  if (pattern[0] != '?') {
    return !text.empty() && text[0] == pattern[0] &&
           tried(pattern.substr(1), text.substr(1), parts);
  }
  for (std::size_t length = 1; length <= text.size() && text[length - 1] != '^'; ++length) {
    parts.push_back(text.substr(0, length));
    if (tried(pattern.substr(1), text.substr(length), parts)) {
      return true;
    }
    parts.pop_back();
  }
  return false;
}

/// All texts of these letters, up to a length.
std::vector<std::string> all_texts(const std::string& letters, std::size_t length) {
  std::vector<std::string> list = {""};
  for (std::size_t from = 0; list[from].size() < length; ++from) {
    for (const char letter : letters) {
      list.push_back(list[from] + letter);
    }
  }
  return list;
}

TEST(Wildcards, MatchAsTryingEveryLengthDoes) {
  const std::vector<std::string> texts = all_texts("ab^", 6);
  int matches = 0;
  for (const std::string& pattern : all_texts("ab^?", 5)) {
    for (const std::string& text : texts) {
      Parts parts;
      const bool expected = tried(pattern, text, parts);
      const auto found = generator::latex::matched({pattern}, {text});
      ASSERT_EQ(found.has_value(), expected) << pattern << " in " << text;
      if (expected) {
        ASSERT_EQ(*found, parts) << pattern << " in " << text;
        ++matches;
      }
    }
  }
  EXPECT_GT(matches, 10'000);
}

}  // namespace
}  // namespace assur::test::wildcards_test
