// A scalar of 50 decimal digits that is cheap to compile: Boost's templates are confined to one
// optimised file.
#pragma once

#include <Eigen/Core>
#include <array>
#include <assur/numeric/precision.hpp>
#include <cstddef>
#include <limits>
#include <string>

#include "runtime/number_traits.hpp"

namespace assur::stability {

/// A number of 50 decimal digits.
class Real {
 public:
  Real();
  Real(int value);             // NOLINT(google-explicit-constructor): a number
  Real(std::ptrdiff_t value);  // NOLINT(google-explicit-constructor): a number, as Eigen counts
  Real(double value);          // NOLINT(google-explicit-constructor): a number
  explicit Real(const std::string& digits);
  Real(const Real& other);
  Real& operator=(const Real& other);
  ~Real() = default;

  /// Truncates toward zero.
  explicit operator int() const;
  explicit operator double() const;
  explicit operator long double() const;

  Real& operator+=(const Real& other) { return *this = *this + other; }
  Real& operator-=(const Real& other) { return *this = *this - other; }
  Real& operator*=(const Real& other) { return *this = *this * other; }
  Real& operator/=(const Real& other) { return *this = *this / other; }

  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);
  friend Real operator-(const Real& a);
  friend bool operator==(const Real& a, const Real& b);
  friend bool operator<(const Real& a, const Real& b);
  friend bool operator>(const Real& a, const Real& b) { return b < a; }
  friend bool operator<=(const Real& a, const Real& b);
  friend bool operator>=(const Real& a, const Real& b) { return b <= a; }

  friend Real abs(const Real& a);
  friend Real sqrt(const Real& a);
  friend Real sin(const Real& a);
  friend Real cos(const Real& a);
  friend bool isfinite(const Real& a);

  /// The difference between one and the next number.
  static Real epsilon();

 private:
  struct Access;  // reads and writes the stored number, whose type is defined in real.cpp
  alignas(16) std::array<std::byte, 64> storage_;
};

}  // namespace assur::stability

/// Bounds and sizes do not need more digits than a double has.
template <>
struct assur::numeric::PartOf<assur::stability::Real> {
  using Type = double;
};

template <>
class std::numeric_limits<assur::stability::Real> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr int digits10 = 50;
  static constexpr bool has_quiet_NaN = false;
  static assur::stability::Real epsilon() { return assur::stability::Real::epsilon(); }
  /// Returns zero, as for other types that have no NaN; sanitizer builds fill matrices with it.
  static assur::stability::Real quiet_NaN() { return {}; }
};

template <>
struct Eigen::NumTraits<assur::stability::Real>
    : assur::test::NumberTraits<assur::stability::Real> {
  using Real = assur::stability::Real;
  static Real epsilon() { return Real::epsilon(); }
  static Real dummy_precision() { return Real(1000) * Real::epsilon(); }
};
