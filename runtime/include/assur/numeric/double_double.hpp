// Double-word arithmetic: two numbers of one precision as one number of twice the digits.
//
// The number is the unevaluated sum high + low, |low| <= ulp(high)/2: of two doubles about 106
// significant bits over the exponent range of double, of two floats about 48. Used to decide signs
// that one part leaves open, so every operation below has a proven relative error bound (Joldes,
// Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic", ACM TOMS 44(2), 2017; square root: Lefevre et al., ACM TOMS 49(1), 2023), with u =
// 2^-p, p the digits of a part, 53 of double and 24 of float:
//   sum 3u^2,  product 5u^2,  quotient 15u^2,  square root 25/8 u^2   -- all below 16u^2.
// The bounds hold in any precision p >= 7, and need round-to-nearest, no overflow, and no underflow
// of the low parts: keep magnitudes of doubles between ~1e-270 and ~1e290, of floats between ~1e-24
// and ~1e30. Results do not depend on a fused multiply-add; `sums_are_exact` of arithmetic.hpp
// checks the sums.
#pragma once

#include <assur/numeric/precision.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::numeric {

template <typename Part>
struct DoubleWord;
using DoubleDouble = DoubleWord<double>;
using DoubleFloat = DoubleWord<float>;

/// Returns the exact sum: a + b = high + low. No product occurs, so fused contraction cannot change
/// it.
template <typename Part>
constexpr DoubleWord<Part> two_sum(Part a, Part b) {
  const Part sum = a + b;
  const Part b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// Returns the sum in the same way, exactly if |a| >= |b| or a == 0.
template <typename Part>
constexpr DoubleWord<Part> fast_two_sum(Part a, Part b) {
  const Part sum = a + b;
  return {sum, b - (sum - a)};
}

/// Splits a number exactly: a = high + low, both of at most half of the digits (Veltkamp).
template <typename Part>
constexpr DoubleWord<Part> halves_of(Part a) {
  constexpr int half = (std::numeric_limits<Part>::digits + 1) / 2;
  constexpr Part shift = power_of_two<Part>(half) + 1;
  const Part shifted = shift * a;
  const Part high = shifted - (shifted - a);
  return {high, a - high};
}

/// Whether the processor has a fused multiply-add for such numbers.
#if defined(__FMA__) || defined(__aarch64__)
template <typename Part>
inline constexpr bool has_fused_product = true;
#else
template <typename Part>
inline constexpr bool has_fused_product = false;
#if defined(FP_FAST_FMA) || defined(__FP_FAST_FMA)
template <>
inline constexpr bool has_fused_product<double> = true;
#endif
#if defined(FP_FAST_FMAF) || defined(__FP_FAST_FMAF)
template <>
inline constexpr bool has_fused_product<float> = true;
#endif
#endif

/// Returns the exact product: a * b = high + low (unless the low part underflows). Without a fused
/// multiply-add in the processor, that of a library may be slow or round twice; then Dekker's
/// method is used, in which every product of halves is exact.
template <typename Part>
constexpr DoubleWord<Part> two_prod(Part a, Part b) {
  const Part product = a * b;
  if constexpr (has_fused_product<Part>) {
    if (!__builtin_is_constant_evaluated()) {
      return {product, std::fma(a, b, -product)};
    }
  }
  const DoubleWord<Part> x = halves_of(a);
  const DoubleWord<Part> y = halves_of(b);
  const Part rest = ((x.high * y.high - product) + x.high * y.low) + x.low * y.high;
  return {product, rest + x.low * y.low};
}

template <typename Part>
struct DoubleWord {
  Part high = Part(0);
  Part low = Part(0);

  constexpr DoubleWord() = default;
  constexpr DoubleWord(Part value) : high(value) {}
  constexpr DoubleWord(int value) : high(static_cast<Part>(value)) {}
  constexpr DoubleWord(Part high_part, Part low_part) : high(high_part), low(low_part) {}
  /// A constant of generated code, to the digits of both parts.
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Part, double>, int> = 0>
  constexpr DoubleWord(Number value)
      : high(static_cast<Part>(value)),
        low(static_cast<Part>(value - static_cast<double>(static_cast<Part>(value)))) {}
  explicit constexpr operator Part() const { return high; }

  friend constexpr DoubleWord operator-(DoubleWord a) { return {-a.high, -a.low}; }

  friend constexpr DoubleWord operator+(DoubleWord a, DoubleWord b) {
    const DoubleWord upper = two_sum(a.high, b.high);
    const DoubleWord lower = two_sum(a.low, b.low);
    const DoubleWord partial = fast_two_sum(upper.high, upper.low + lower.high);
    return fast_two_sum(partial.high, lower.low + partial.low);
  }

  friend constexpr DoubleWord operator-(DoubleWord a, DoubleWord b) { return a + (-b); }

  friend constexpr DoubleWord operator*(DoubleWord a, DoubleWord b) {
    const DoubleWord product = two_prod(a.high, b.high);
    return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
  }

  friend constexpr DoubleWord operator/(DoubleWord a, DoubleWord b) {
    const Part quotient = a.high / b.high;
    const DoubleWord product = two_prod(b.high, quotient);
    const DoubleWord rounded = fast_two_sum(product.high, b.low * quotient);
    const DoubleWord scaled = fast_two_sum(rounded.high, rounded.low + product.low);
    const Part rest =
        (a.high - scaled.high) + (a.low - scaled.low);  // the first difference is exact
    return fast_two_sum(quotient, rest / b.high);
  }

  // NaN for a negative argument, like std::sqrt.
  friend DoubleWord sqrt(DoubleWord a) {
    const Part root = std::sqrt(a.high);
    if (root == Part(0)) return {root, Part(0)};  // the correction below would divide by zero
    const DoubleWord square = two_prod(root, root);
    const Part rest = (a.high - square.high) - square.low;  // both differences are exact
    return fast_two_sum(root, (rest + a.low) / (Part(2) * root));
  }

  friend constexpr DoubleWord& operator+=(DoubleWord& a, DoubleWord b) { return a = a + b; }
  friend constexpr DoubleWord& operator-=(DoubleWord& a, DoubleWord b) { return a = a - b; }
  friend constexpr DoubleWord& operator*=(DoubleWord& a, DoubleWord b) { return a = a * b; }
  friend constexpr DoubleWord& operator/=(DoubleWord& a, DoubleWord b) { return a = a / b; }

  friend constexpr bool operator==(DoubleWord a, DoubleWord b) {
    return a.high == b.high && a.low == b.low;
  }
  friend constexpr bool operator!=(DoubleWord a, DoubleWord b) { return !(a == b); }
  friend constexpr bool operator<(DoubleWord a, DoubleWord b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend constexpr bool operator>(DoubleWord a, DoubleWord b) { return b < a; }
  friend constexpr bool operator<=(DoubleWord a, DoubleWord b) {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
  }
  friend constexpr bool operator>=(DoubleWord a, DoubleWord b) { return b <= a; }

  friend constexpr DoubleWord abs(DoubleWord a) {
    return a.high < Part(0) || (a.high == Part(0) && a.low < Part(0)) ? -a : a;
  }
};

template <typename Part>
struct PartOf<DoubleWord<Part>> {
  using Type = Part;
};

}  // namespace assur::numeric

/// The value of epsilon() is twice the largest relative error of the operations above, as it is for
/// the parts.
template <typename Part>
class std::numeric_limits<assur::numeric::DoubleWord<Part>> : public std::numeric_limits<Part> {
 public:
  static constexpr assur::numeric::DoubleWord<Part> epsilon() noexcept {
    constexpr Part part =
        assur::numeric::power_of_two<Part>(5 - 2 * std::numeric_limits<Part>::digits);
    return {part, Part(0)};
  }
};
