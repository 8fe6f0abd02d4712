// A scalar of CLN's rational numbers that is cheap to compile.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/rational_io.h>

#include <ostream>

namespace assur::test {

/// An exact rational number. CLN offers a dozen of each operator, and to choose among them in every
/// line of generated code is a fifth of what a test costs to compile; here there is one of each.
/// None of them throws: division by zero ends the test, and nothing needs to be unwound on the way.
class Rational {
 public:
  Rational() = default;
  Rational(int value) noexcept : value_(value) {}  // NOLINT(google-explicit-constructor): a number
  explicit Rational(const cln::cl_RA& value) noexcept : value_(value) {}
  /// The exact value of a double: generated code writes a half as 0.5.
  explicit Rational(double value) noexcept : value_(cln::rational(cln::cl_F(value))) {}
  static Rational exactly(double value) noexcept { return Rational(value); }

  [[nodiscard]] double rounded() const noexcept { return cln::double_approx(value_); }
  [[nodiscard]] bool is_zero() const noexcept { return cln::zerop(value_); }
  [[nodiscard]] bool is_positive() const noexcept { return cln::plusp(value_); }

  friend Rational abs(const Rational& a) noexcept { return Rational(cln::abs(a.value_)); }
  /// Whether a number that is not negative is the square of a rational one, which is then set.
  friend bool is_square(const Rational& a, Rational& root) noexcept {
    return bool(cln::sqrtp(a.value_, &root.value_));
  }
  friend Rational operator+(const Rational& a, const Rational& b) noexcept {
    return Rational(a.value_ + b.value_);
  }
  friend Rational operator-(const Rational& a, const Rational& b) noexcept {
    return Rational(a.value_ - b.value_);
  }
  friend Rational operator-(const Rational& a) noexcept { return Rational(-a.value_); }
  friend Rational operator*(const Rational& a, const Rational& b) noexcept {
    return Rational(a.value_ * b.value_);
  }
  friend Rational operator/(const Rational& a, const Rational& b) noexcept {
    return Rational(a.value_ / b.value_);
  }
  friend bool operator==(const Rational& a, const Rational& b) noexcept {
    return cln::equal(a.value_, b.value_);
  }
  friend bool operator<(const Rational& a, const Rational& b) noexcept {
    return cln::compare(a.value_, b.value_) < 0;
  }
  friend bool operator<=(const Rational& a, const Rational& b) noexcept {
    return cln::compare(a.value_, b.value_) <= 0;
  }
  friend std::ostream& operator<<(std::ostream& out, const Rational& a) {
    cln::fprint(out, a.value_);
    return out;
  }

 private:
  cln::cl_RA value_ = 0;
};

}  // namespace assur::test
