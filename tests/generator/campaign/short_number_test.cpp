// Law: the shortest digits of a number are those that the standard library writes.
#include "campaign/short_number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace assur::test::short_number_test {
namespace {

std::string ours(double number) {
  std::array<char, 32> text;
  return {text.data(), generator::campaign::put_shortest(number, text.data())};
}
std::string of_the_library(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

TEST(ShortNumber, IsWhatTheStandardLibraryWrites) {
  std::mt19937_64 random(20261123);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  long longest = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double whole = std::round(between(-1e6, 1e6));
    const double of_any_size = std::pow(10.0, between(-8, 18));
    for (const double number :
         {std::bit_cast<double>(random()), between(-200, 200), of_any_size, whole, whole / 100,
          whole / 1024, std::nextafter(whole / 1000, 1e9), std::nextafter(whole / 1000, -1e9),
          std::ldexp(1.0, static_cast<int>(random() % 200) - 100),
          static_cast<double>(random() >> 20) / 4, static_cast<double>(random() >> 11) + 0.5}) {
      ASSERT_EQ(ours(number), of_the_library(number)) << std::hexfloat << number;
      longest += of_the_library(number).size() > 16 ? 1 : 0;
    }
  }
  EXPECT_GT(longest, 20000);
}

TEST(ShortNumber, HoldsAtTheEndsOfWhatThereIs) {
  using Limits = std::numeric_limits<double>;
  for (const double number : {0.0,
                              -0.0,
                              Limits::infinity(),
                              -Limits::infinity(),
                              Limits::quiet_NaN(),
                              Limits::max(),
                              Limits::min(),
                              Limits::denorm_min(),
                              9007199254740993.0,
                              0.1,
                              0.3,
                              1e-5,
                              9.9999e-5,
                              1e-4,
                              123456789012345.6,
                              999999999999999.9,
                              99999999999999.98,
                              0.00012345678901234567,
                              736179922923960.25,
                              9.999999999999999,
                              99.99999999999999,
                              2.2250738585072011e-308}) {
    EXPECT_EQ(ours(number), of_the_library(number));
    EXPECT_EQ(ours(std::nextafter(number, 1e300)), of_the_library(std::nextafter(number, 1e300)));
    EXPECT_EQ(ours(std::nextafter(number, -1e300)), of_the_library(std::nextafter(number, -1e300)));
  }
}

}  // namespace
}  // namespace assur::test::short_number_test
