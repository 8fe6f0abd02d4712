// Rational coefficients with their expressions in named constants.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace assur::generator::program {

/// A rational number, and an equal expression in named constants: 25/16 as `BC`. Only values are
/// compared, and the first of equal coefficients gives the expression.
class Coefficient {
 public:
  Coefficient() = default;
  Coefficient(const GiNaC::numeric& number) : value_(number), origin_(number) {}  // NOLINT
  Coefficient(int number) : Coefficient(GiNaC::numeric(number)) {}                // NOLINT
  Coefficient(GiNaC::numeric value, GiNaC::ex origin);

  [[nodiscard]] const GiNaC::numeric& value() const { return value_; }
  [[nodiscard]] const GiNaC::ex& origin() const { return origin_; }
  [[nodiscard]] bool is_zero() const { return value_.is_zero(); }
  [[nodiscard]] bool is_negative() const { return value_.is_negative(); }
  /// Whether it is neither 1 nor -1.
  [[nodiscard]] bool scales() const { return value_ != 1 && value_ != -1; }
  [[nodiscard]] std::string text() const;  ///< of the value: `25/16`
  [[nodiscard]] Coefficient size() const { return is_negative() ? -*this : *this; }

  Coefficient& operator+=(const Coefficient& other);
  Coefficient& operator*=(const Coefficient& other);
  Coefficient& operator/=(const Coefficient& other);
  Coefficient operator-() const { return {-value_, -origin_}; }
  friend Coefficient operator*(Coefficient a, const Coefficient& b) { return a *= b; }
  friend Coefficient operator/(Coefficient a, const Coefficient& b) { return a /= b; }

 private:
  GiNaC::numeric value_ = 0;
  GiNaC::ex origin_ = 0;
};

}  // namespace assur::generator::program
