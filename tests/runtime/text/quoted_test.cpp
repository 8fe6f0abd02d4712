// Law: characters that move the cursor, end a line or change the order in which others are shown
// are found in names and never shown.
#include <gtest/gtest.h>

#include <array>
#include <assur/text/quoted.hpp>

namespace assur::test::quoted_test {
namespace {

TEST(ControlCharacters, AreFoundAndNotShown) {
  constexpr std::array<const char*, 19> controls = {
      "\x01",         "\x1B",         "\x7F",         "\xC2\x80",     "\xC2\x9B",
      "\xC2\x9F",     "\xD8\x9C",     "\xE2\x80\x8E", "\xE2\x80\x8F", "\xE2\x80\xA8",
      "\xE2\x80\xAA", "\xE2\x80\xAB", "\xE2\x80\xAC", "\xE2\x80\xAD", "\xE2\x80\xAE",
      "\xE2\x81\xA6", "\xE2\x81\xA7", "\xE2\x81\xA8", "\xE2\x81\xA9"};
  for (const std::string control : controls) {
    const std::string text = "\xC3\xA4 b" + control + "c";
    EXPECT_EQ(text::first_control_character(text), 4) << text;
    EXPECT_EQ(text::on_one_line(text), "\xC3\xA4 b?c") << text;
  }
}

TEST(ControlCharacters, AreNoLettersBesideThem) {
  // U+00A0, U+061B, U+200D, U+2010, U+2027, U+202F, U+2065, U+206A, U+20AC; letters cut short.
  constexpr std::array<const char*, 13> others = {"",
                                                  "a",
                                                  "\xC2\xA0",
                                                  "\xD8\x9B",
                                                  "\xE2\x80\x8D",
                                                  "\xE2\x80\x90",
                                                  "\xE2\x80\xA7",
                                                  "\xE2\x80\xAF",
                                                  "\xE2\x81\xA5",
                                                  "\xE2\x81\xAA",
                                                  "\xE2\x82\xAC",
                                                  "\xC2",
                                                  "\xE2\x80"};
  for (const std::string other : others) {
    EXPECT_EQ(text::first_control_character(other), other.size()) << other;
    EXPECT_EQ(text::on_one_line(other), other);
  }
  EXPECT_EQ(text::first_control_character("a\tb\nc"), 5);
  EXPECT_EQ(text::on_one_line("a\tb\nc"), "a?b?c");
}

}  // namespace
}  // namespace assur::test::quoted_test
