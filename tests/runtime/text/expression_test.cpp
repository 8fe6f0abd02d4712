// Law: expressions have the values of arithmetic, and any other text is refused at a column of it.
#include <gtest/gtest.h>

#include <assur/text/expression.hpp>
#include <iostream>
#include <random>

namespace assur::text {
namespace {

double value(const std::string& text) {
  return evaluate<double>(parse_expression(text), [](const std::string&) { return 3.0; });
}

TEST(Expression, FollowsThePrecedenceOfArithmetic) {
  EXPECT_EQ(value("1 + 2*3"), 7);
  EXPECT_EQ(value("(1 + 2)*3"), 9);
  EXPECT_EQ(value("8 - 4 - 2"), 2);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("+-+3"), -3);
  EXPECT_EQ(value("x*x"), 9);
  EXPECT_EQ(value(" 1.5e1 "), 15);
  EXPECT_EQ(value(".5"), 0.5);
}

TEST(Expression, KnowsItsFunctionsAndConstants) {
  EXPECT_EQ(value("sqrt(16)"), 4);
  EXPECT_DOUBLE_EQ(value("sin(30*deg)"), 0.5);
  EXPECT_DOUBLE_EQ(value("cos(pi)"), -1);
  EXPECT_DOUBLE_EQ(value("tan(45*deg)"), 1);
  EXPECT_DOUBLE_EQ(value("asin(1)/deg"), 90);
  EXPECT_DOUBLE_EQ(value("acos(0)/deg"), 90);
  EXPECT_DOUBLE_EQ(value("atan(1)/deg"), 45);
  EXPECT_DOUBLE_EQ(value("atan2(1, -1)/deg"), 135);
}

TEST(Expression, SaysTheColumnOfAFault) {
  const auto column = [](const std::string& text) -> std::size_t {
    try {
      (void)parse_expression(text);
    } catch (const ExpressionError& error) {
      return error.column;
    }
    return 0;
  };
  EXPECT_EQ(column(""), 1U);
  EXPECT_EQ(column("1 +"), 4U);
  EXPECT_EQ(column("1 2"), 3U);
  EXPECT_EQ(column("(1"), 3U);
  EXPECT_EQ(column("1 + foo(2)"), 5U);
  EXPECT_EQ(column("sin"), 4U);
  EXPECT_EQ(column("3 $ 4"), 3U);
  EXPECT_EQ(column("1.2.3"), 4U);
}

TEST(Expression, SurvivesRandomText) {
  constexpr unsigned seed = 161803;
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  const std::vector<std::string> pieces = {"1", "2.5", "x", "pi", "+",   "-",    "*",     "/",
                                           "^", "(",   ")", ",",  "sin", "sqrt", "atan2", "1e9",
                                           ".", "_",   " ", "\t", "e",   "0x",   "\xff"};
  int parsed = 0;
  for (int sample = 0; sample < 200000; ++sample) {
    std::string text;
    for (auto length = engine() % 12; length > 0; --length) {
      text += pieces[engine() % pieces.size()];
    }
    try {
      (void)value(text);
      ++parsed;
    } catch (const ExpressionError& error) {
      EXPECT_LE(error.column, text.size() + 1);
    }
  }
  EXPECT_GT(parsed, 1000);
}

}  // namespace
}  // namespace assur::text
