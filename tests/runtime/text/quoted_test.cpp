// Law: characters that move the cursor, end a line or change the order in which others are shown
// are found in names and never shown.
#include <gtest/gtest.h>

#include <assur/text/quoted.hpp>
#include <initializer_list>
#include <string>
#include <vector>

namespace assur::test::quoted_test {
namespace {

/// A character below U+10000 in UTF-8.
std::string utf8(unsigned number) {
  const auto bytes = [](std::initializer_list<unsigned> all) {
    std::string text;
    for (const unsigned byte : all) {
      text += static_cast<char>(byte);
    }
    return text;
  };
  const unsigned last = 0x80U | (number & 0x3FU);
  return number < 0x80    ? bytes({number})
         : number < 0x800 ? bytes({0xC0U | number >> 6U, last})
                          : bytes({0xE0U | number >> 12U, 0x80U | (number >> 6U & 0x3FU), last});
}

TEST(ControlCharacters, AreFoundAndNotShown) {
  for (const unsigned number :
       {0x01U, 0x1BU, 0x7FU, 0x80U, 0x9BU, 0x9FU, 0x61CU, 0x200EU, 0x200FU, 0x2028U, 0x202AU,
        0x202BU, 0x202CU, 0x202DU, 0x202EU, 0x2066U, 0x2067U, 0x2068U, 0x2069U}) {
    const std::string text = utf8(0xE4) + " b" + utf8(number) + "c";
    EXPECT_EQ(text::first_control_character(text), 4) << number;
    EXPECT_EQ(text::on_one_line(text), utf8(0xE4) + " b?c") << number;
  }
}

TEST(ControlCharacters, AreNoLettersBesideThem) {
  std::vector<std::string> others = {"", "a", "\xC2", "\xE2\x80"};  // the last two are cut short
  for (const unsigned number :
       {0xA0U, 0x61BU, 0x200DU, 0x2010U, 0x2027U, 0x202FU, 0x2065U, 0x206AU, 0x20ACU}) {
    others.push_back(utf8(number));
  }
  for (const std::string& other : others) {
    EXPECT_EQ(text::first_control_character(other), other.size()) << other;
    EXPECT_EQ(text::on_one_line(other), other);
  }
  EXPECT_EQ(text::first_control_character("a\tb\nc"), 5);
  EXPECT_EQ(text::on_one_line("a\tb\nc"), "a?b?c");
}

}  // namespace
}  // namespace assur::test::quoted_test
