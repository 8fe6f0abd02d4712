#include "campaign/short_number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>

namespace assur::generator::campaign {

namespace {

__extension__ using Wide = unsigned __int128;

/// No number needs more room.
constexpr std::size_t room = 32;
/// The range of decimal exponents in which fixed notation is shorter and every product below is
/// exact.
constexpr int least_exponent = -4;
constexpr int most_exponent = 14;

constexpr auto powers_of_five = [] {
  std::array<std::uint64_t, 22> powers{1};
  for (std::size_t power = 1; power < powers.size(); ++power) {
    powers[power] = powers[power - 1] * 5;
  }
  return powers;
}();

/// digits x 10^(exponent - 16), with 17 digits, the last of which may be zeros.
struct Decimal {
  std::uint64_t digits = 0;  ///< zero if `shortest` does not find them
  int exponent = 0;
};

template <int Power>
constexpr std::uint64_t ten_to_the = 10 * ten_to_the<Power - 1>;
template <>
constexpr std::uint64_t ten_to_the<0> = 1;

constexpr auto pairs_of_digits = [] {
  std::array<char, 200> pairs{};
  for (std::size_t number = 0; number < 100; ++number) {
    pairs[2 * number] = static_cast<char>('0' + number / 10);
    pairs[2 * number + 1] = static_cast<char>('0' + number % 10);
  }
  return pairs;
}();

/// The multiple of a step nearest to whole + part/2^shift; zero if two are equally near.
template <std::uint64_t Step>
std::uint64_t nearest(std::uint64_t whole, std::uint64_t part, int shift) {
  const std::uint64_t below = whole / Step * Step;
  const std::uint64_t to_below = ((whole - below) << shift) + part;
  const std::uint64_t to_above = (Step << shift) - to_below;
  return to_below == to_above ? 0 : to_below < to_above ? below : below + Step;
}

/// The shortest decimal that is closer to m 2^e than to its neighbouring doubles, and of several
/// the closest; m has 53 bits and is not a power of two. All operations are exact: with 10^k times
/// the number in [1e16, 1e17), the numbers closer to it form an interval of length 1.1 to 22.3.
Decimal shortest(std::uint64_t m, int e) {
  // The decimal exponent, or one less: log10(2) is 78913 / 2^18 to five digits.
  int exponent = ((e + 52) * 78913) >> 18;
  for (;; ++exponent) {
    if (exponent < least_exponent || exponent > most_exponent) {
      return {};
    }
    const int k = 16 - exponent;
    const int shift = 1 - (e + k);  // in halves of the last place of m
    const std::uint64_t half = powers_of_five[static_cast<std::size_t>(k)];
    const Wide value = Wide{m} * 2 * half;
    const auto whole = static_cast<std::uint64_t>(value >> shift);
    if (whole >= ten_to_the<17>) {
      continue;  // the exponent was one too small
    }
    // At most 48 of the 101 bits are fractional: sums of parts and steps fit 64 bits.
    const std::uint64_t mask = (std::uint64_t{1} << shift) - 1;
    const std::uint64_t part = static_cast<std::uint64_t>(value) & mask;
    const std::uint64_t above = part + half;
    const std::int64_t below = static_cast<std::int64_t>(part) - static_cast<std::int64_t>(half);
    if ((above & mask) == 0 || (static_cast<std::uint64_t>(below) & mask) == 0) {
      return {};  // an end of the interval is an integer: std::to_chars decides whether it counts
    }
    const std::uint64_t highest = whole + (above >> shift);
    const std::uint64_t lowest = whole + static_cast<std::uint64_t>(below >> shift) + 1;
    if (const std::uint64_t hundreds = highest / 100 * 100; hundreds >= lowest) {
      return {hundreds, exponent};
    }
    const std::uint64_t tens = nearest<10>(whole, part, shift);
    if (tens == 0 || (tens >= lowest && tens <= highest)) {
      return {tens, exponent};
    }
    return {nearest<1>(whole, part, shift), exponent};
  }
}

/// Writes a number with this many digits, in pairs.
template <int Digits>
void put_digits(std::uint32_t number, char* at) {
  for (int place = Digits - 2; place >= 0; place -= 2) {
    const std::uint32_t left = number / 100;
    std::copy_n(pairs_of_digits.data() + std::size_t{2} * (number - left * 100), 2, at + place);
    number = left;
  }
  if (Digits % 2 != 0) {
    *at = static_cast<char>('0' + number);
  }
}

}  // namespace

char* put_shortest(double number, char* at) {
  constexpr int digits_of_mantissa = 52;
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << digits_of_mantissa) - 1);
  const int biased = static_cast<int>(bits >> digits_of_mantissa & 0x7FFU);
  const Decimal decimal =
      fraction == 0 || biased == 0
          ? Decimal{}
          : shortest(fraction | std::uint64_t{1} << digits_of_mantissa, biased - 1075);
  if (decimal.digits < ten_to_the<16> || decimal.digits >= ten_to_the<17>) {
    return std::to_chars(at, at + room, number).ptr;
  }
  std::array<char, 17> digits;
  const std::uint64_t left = decimal.digits / ten_to_the<8>;
  put_digits<9>(static_cast<std::uint32_t>(left), digits.data());
  put_digits<8>(static_cast<std::uint32_t>(decimal.digits - left * ten_to_the<8>),
                digits.data() + 9);
  const char* end = digits.data() + digits.size();
  while (end[-1] == '0') {
    --end;
  }
  const char* const begin = digits.data();
  const auto* const before_point = begin + decimal.exponent + 1;
  if (end <= before_point || end - begin < 2) {
    return std::to_chars(at, at + room, number).ptr;  // an integer, or a single digit
  }
  if (number < 0) {
    *at++ = '-';
  }
  if (decimal.exponent < 0) {
    *at++ = '0';
    *at++ = '.';
    at = std::fill_n(at, -decimal.exponent - 1, '0');
    return std::copy(begin, end, at);
  }
  at = std::copy(begin, before_point, at);
  *at++ = '.';
  return std::copy(before_point, end, at);
}

}  // namespace assur::generator::campaign
