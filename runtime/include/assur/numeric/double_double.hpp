// Turns two doubles into one number of twice the digits.
//
// The number is the unevaluated sum high + low, |low| <= ulp(high)/2: about 106
// significant bits over the exponent range of double. Used to decide signs that double leaves open,
// so every operation below carries a proven relative error bound (Joldes, Muller, Popescu, "Tight
// and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2),
// 2017; square root: Lefevre et al., ACM TOMS 49(1), 2023), with u = 2^-53:
//   sum 3u^2,  product 5u^2,  quotient 15u^2,  square root 25/8 u^2   -- all below 16u^2 = 2^-102.
// The bounds need round-to-nearest, no overflow, and no underflow of the low parts: keep magnitudes
// above ~1e-270.
#pragma once

#include <cmath>
#include <limits>

#ifdef __FAST_MATH__
#error "double_double.hpp relies on exact rounding errors; do not compile it with -ffast-math"
#endif

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

// Exact: a * b = high + low (unless the low part underflows).
inline DoubleDouble two_prod(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble partial = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(partial.high, low.low + partial.low);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_prod(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.high / b.high;
  const DoubleDouble product = two_prod(b.high, quotient);
  const DoubleDouble scaled = fast_two_sum(product.high, std::fma(b.low, quotient, product.low));
  const double rest =
      (a.high - scaled.high) + (a.low - scaled.low);  // the first difference is exact
  return fast_two_sum(quotient, rest / b.high);
}

// Not a number for a negative argument, like std::sqrt.
inline DoubleDouble sqrt(DoubleDouble a) {
  const double root = std::sqrt(a.high);
  if (root == 0.0) return {root, 0.0};  // the correction below would divide by zero
  return fast_two_sum(root, (std::fma(-root, root, a.high) + a.low) / (2.0 * root));
}

inline DoubleDouble& operator+=(DoubleDouble& a, DoubleDouble b) { return a = a + b; }
inline DoubleDouble& operator-=(DoubleDouble& a, DoubleDouble b) { return a = a - b; }
inline DoubleDouble& operator*=(DoubleDouble& a, DoubleDouble b) { return a = a * b; }
inline DoubleDouble& operator/=(DoubleDouble& a, DoubleDouble b) { return a = a / b; }

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
