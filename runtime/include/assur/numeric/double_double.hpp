// Turns two doubles into one number of twice the digits.
//
// The number is the unevaluated sum high + low, |low| <= ulp(high)/2: about 106
// significant bits over the exponent range of double. Used to decide signs that double leaves open,
// so every operation below carries a proven relative error bound (Joldes, Muller, Popescu, "Tight
// and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2),
// 2017; square root: Lefevre et al., ACM TOMS 49(1), 2023), with u = 2^-53:
//   sum 3u^2,  product 5u^2,  quotient 15u^2,  square root 25/8 u^2   -- all below 16u^2 = 2^-102.
// The bounds need round-to-nearest, no overflow, and no underflow of the low parts: keep magnitudes
// between ~1e-270 and ~1e290. Nothing depends on whether the processor has a fused product, and
// `sums_are_exact` of arithmetic.hpp tells whether sums are.
#pragma once

#include <cmath>
#include <limits>

namespace assur::numeric {

struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}
  constexpr DoubleDouble(int value) : high(value) {}
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
  explicit constexpr operator double() const { return high; }
};

// Exact: a + b = high + low. No product occurs, so fused contraction cannot change it.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Exact when |a| >= |b| or a == 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// Exact: a = high + low, both of at most 26 bits (Veltkamp).
constexpr DoubleDouble halves_of(double a) {
  const double shifted = (0x1p27 + 1) * a;
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

// Exact: a * b = high + low (unless the low part underflows). Where the processor has no fused
// product, a library's may be slow, or round twice: then by Dekker's, in which every product of
// halves is exact. Compilers that may fuse products do have the processor's.
constexpr DoubleDouble two_prod(double a, double b) {
  const double product = a * b;
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
  if (!__builtin_is_constant_evaluated()) {
    return {product, std::fma(a, b, -product)};
  }
#endif
  const DoubleDouble x = halves_of(a);
  const DoubleDouble y = halves_of(b);
  const double rest = ((x.high * y.high - product) + x.high * y.low) + x.low * y.high;
  return {product, rest + x.low * y.low};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble partial = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(partial.high, low.low + partial.low);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_prod(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.high / b.high;
  const DoubleDouble product = two_prod(b.high, quotient);
  const DoubleDouble rounded = fast_two_sum(product.high, b.low * quotient);
  const DoubleDouble scaled = fast_two_sum(rounded.high, rounded.low + product.low);
  const double rest =
      (a.high - scaled.high) + (a.low - scaled.low);  // the first difference is exact
  return fast_two_sum(quotient, rest / b.high);
}

// Not a number for a negative argument, like std::sqrt.
inline DoubleDouble sqrt(DoubleDouble a) {
  const double root = std::sqrt(a.high);
  if (root == 0.0) return {root, 0.0};  // the correction below would divide by zero
  const DoubleDouble square = two_prod(root, root);
  const double rest = (a.high - square.high) - square.low;  // exact, both of it
  return fast_two_sum(root, (rest + a.low) / (2.0 * root));
}

constexpr DoubleDouble& operator+=(DoubleDouble& a, DoubleDouble b) { return a = a + b; }
constexpr DoubleDouble& operator-=(DoubleDouble& a, DoubleDouble b) { return a = a - b; }
constexpr DoubleDouble& operator*=(DoubleDouble& a, DoubleDouble b) { return a = a * b; }
constexpr DoubleDouble& operator/=(DoubleDouble& a, DoubleDouble b) { return a = a / b; }

constexpr bool operator==(DoubleDouble a, DoubleDouble b) {
  return a.high == b.high && a.low == b.low;
}
constexpr bool operator!=(DoubleDouble a, DoubleDouble b) { return !(a == b); }
constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }
constexpr bool operator<=(DoubleDouble a, DoubleDouble b) {
  return a.high < b.high || (a.high == b.high && a.low <= b.low);
}
constexpr bool operator>=(DoubleDouble a, DoubleDouble b) { return b <= a; }

constexpr DoubleDouble abs(DoubleDouble a) {
  return a.high < 0.0 || (a.high == 0.0 && a.low < 0.0) ? -a : a;
}

}  // namespace assur::numeric

// epsilon() is twice the largest relative error of the operations above, as it is for double.
template <>
class std::numeric_limits<assur::numeric::DoubleDouble> : public std::numeric_limits<double> {
 public:
  static constexpr assur::numeric::DoubleDouble epsilon() noexcept { return {0x1p-101, 0.0}; }
};
