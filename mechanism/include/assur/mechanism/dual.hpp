// Numbers with gradients and optional Hessians, for automatic differentiation.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/eigen_alignment.hpp>
#include <assur/support/power_derivative.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace assur::mechanism {

/// A value with its gradient with respect to the mechanism's parameters and, if carried, its
/// Hessian. An Eigen::AutoDiffScalar of AutoDiffScalars would carry the Hessian too, but as a
/// vector of separately allocated vectors, and the gradient twice.
///
/// A number made from a bare double is a constant: it has no gradient, and counts as having zero
/// derivatives of every order. A result carries a Hessian if all operands that are not constants
/// carry one.
class Dual {
 public:
  Dual() = default;
  explicit Dual(double value) : value_(value) {}
  Dual(double value, Eigen::VectorXd derivatives, Eigen::MatrixXd hessian = {})
      : value_(value), derivatives_(std::move(derivatives)), hessian_(std::move(hessian)) {}

  [[nodiscard]] double value() const { return value_; }
  /// Empty for a constant.
  [[nodiscard]] const Eigen::VectorXd& derivatives() const { return derivatives_; }
  /// Symmetric; empty if it is not carried, and for a constant.
  [[nodiscard]] const Eigen::MatrixXd& hessian() const { return hessian_; }
  [[nodiscard]] bool has_hessian() const { return hessian_.size() != 0; }

  /// f(a) by the chain rule: f' da, f' d2a + f'' da da^T.
  [[nodiscard]] static Dual chained(double f, const Dual& a, double f_a, double f_aa) {
    Dual result(f);
    if (!a.is_constant()) {
      result.derivatives_ = f_a * a.derivatives_;
      if (a.has_hessian()) {
        result.hessian_ = f_a * a.hessian_;
        result.hessian_ += f_aa * a.derivatives_ * a.derivatives_.transpose();
      }
    }
    return result;
  }

  /// First and second partial derivatives of a function f(a, b).
  struct Partials {
    double a, b;
    double aa, ab, bb;
  };
  /// f(a, b) by the chain rule.
  [[nodiscard]] static Dual chained(double f, const Dual& a, const Dual& b,
                                    const Partials& partial) {
    if (b.is_constant()) {
      return chained(f, a, partial.a, partial.aa);
    }
    if (a.is_constant()) {
      return chained(f, b, partial.b, partial.bb);
    }
    Dual result(f);
    result.derivatives_ = partial.a * a.derivatives_ + partial.b * b.derivatives_;
    if (a.has_hessian() && b.has_hessian()) {
      const Eigen::MatrixXd mixed = partial.ab * a.derivatives_ * b.derivatives_.transpose();
      result.hessian_ = partial.a * a.hessian_ + partial.b * b.hessian_ + mixed + mixed.transpose();
      result.hessian_ += partial.aa * a.derivatives_ * a.derivatives_.transpose();
      result.hessian_ += partial.bb * b.derivatives_ * b.derivatives_.transpose();
    }
    return result;
  }

  /// The same number with unknown derivatives (NaN) with respect to all parameters on which an
  /// argument depends, for a function without a derivative by that argument.
  [[nodiscard]] Dual without_what_follows(const Dual& argument) && {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (Eigen::Index i = 0; i < argument.derivatives_.size(); ++i) {
      if (argument.derivatives_(i) != 0) {
        derivatives_(i) = none;
      }
      for (Eigen::Index j = 0; has_hessian() && j < hessian_.cols(); ++j) {
        const bool follows = argument.derivatives_(i) != 0 || argument.derivatives_(j) != 0 ||
                             (argument.has_hessian() && argument.hessian_(i, j) != 0);
        hessian_(i, j) = follows ? none : hessian_(i, j);
      }
    }
    return std::move(*this);
  }

  friend bool operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value_ > b.value_; }

 private:
  [[nodiscard]] bool is_constant() const { return derivatives_.size() == 0; }

  double value_ = 0;
  Eigen::VectorXd derivatives_;
  Eigen::MatrixXd hessian_;
};

/// Whether the number also represents other values, as a formula with variable parameters does.
[[nodiscard]] inline bool may_change(const Dual&) { return false; }

inline Dual operator-(const Dual& a) { return Dual::chained(-a.value(), a, -1, 0); }
inline Dual operator+(const Dual& a, const Dual& b) {
  return Dual::chained(a.value() + b.value(), a, b, {1, 1, 0, 0, 0});
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return Dual::chained(a.value() - b.value(), a, b, {1, -1, 0, 0, 0});
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return Dual::chained(a.value() * b.value(), a, b, {b.value(), a.value(), 0, 1, 0});
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double inverse = 1 / b.value();
  const double quotient = a.value() / b.value();
  return Dual::chained(
      quotient, a, b,
      {inverse, -quotient * inverse, 0, -inverse * inverse, 2 * quotient * inverse * inverse});
}
inline Dual operator*(double a, const Dual& b) { return Dual(a) * b; }
inline Dual operator/(const Dual& a, double b) { return a / Dual(b); }

inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value());
  return Dual::chained(root, a, 0.5 / root, -0.25 / (root * a.value()));
}
inline Dual sin(const Dual& a) {
  const double sine = std::sin(a.value());
  return Dual::chained(sine, a, std::cos(a.value()), -sine);
}
inline Dual cos(const Dual& a) {
  const double cosine = std::cos(a.value());
  return Dual::chained(cosine, a, -std::sin(a.value()), -cosine);
}
inline Dual tan(const Dual& a) {
  const double tangent = std::tan(a.value());
  const double slope = 1 + tangent * tangent;
  return Dual::chained(tangent, a, slope, 2 * tangent * slope);
}
inline Dual asin(const Dual& a) {
  const double slope = 1 / std::sqrt((1 - a.value()) * (1 + a.value()));
  return Dual::chained(std::asin(a.value()), a, slope, a.value() * slope * slope * slope);
}
inline Dual acos(const Dual& a) {
  const double slope = -1 / std::sqrt((1 - a.value()) * (1 + a.value()));
  return Dual::chained(std::acos(a.value()), a, slope, a.value() * slope * slope * slope);
}
inline Dual atan(const Dual& a) {
  const double slope = 1 / (1 + a.value() * a.value());
  return Dual::chained(std::atan(a.value()), a, slope, -2 * a.value() * slope * slope);
}
/// The angle of (x, y); with c = x/r, s = y/r its partial derivatives are -s/r, c/r of first order
/// and (2 c s, s^2 - c^2, -2 c s)/r^2 of second.
inline Dual atan2(const Dual& y, const Dual& x) {
  const double radius = std::hypot(x.value(), y.value());
  const double c = x.value() / radius;
  const double s = y.value() / radius;
  const double curvature = 2 * c * s / radius / radius;
  return Dual::chained(
      std::atan2(y.value(), x.value()), y, x,
      {c / radius, -s / radius, -curvature, (s - c) * (s + c) / radius / radius, curvature});
}
/// The derivatives at zero are those of the side of positive arguments.
inline Dual abs(const Dual& a) { return a.value() < 0 ? -a : a; }
/// Of two equal numbers, the first.
inline Dual min(const Dual& a, const Dual& b) { return b.value() < a.value() ? b : a; }
inline Dual max(const Dual& a, const Dual& b) { return a.value() < b.value() ? b : a; }
/// A constant power of any base.
inline Dual pow(const Dual& a, double exponent) {
  return Dual::chained(std::pow(a.value(), exponent), a,
                       support::power_derivative<1, 0>(a.value(), exponent),
                       support::power_derivative<2, 0>(a.value(), exponent));
}
/// A power whose exponent may depend on parameters, too. Derivatives through the exponent are
/// unknown, NaN, where there is no derivative by it.
inline Dual pow(const Dual& a, const Dual& b) {
  if (b.derivatives().size() == 0) {
    return pow(a, b.value());
  }
  const double x = a.value();
  const double n = b.value();
  const double by_exponent = support::power_derivative<0, 1>(x, n);
  const bool is_known = !std::isnan(by_exponent);
  const auto known = [is_known](double slope) { return is_known ? slope : 0; };
  Dual result = Dual::chained(
      std::pow(x, n), a, b,
      {support::power_derivative<1, 0>(x, n), known(by_exponent),
       support::power_derivative<2, 0>(x, n), known(support::power_derivative<1, 1>(x, n)),
       known(support::power_derivative<0, 2>(x, n))});
  return is_known ? result : std::move(result).without_what_follows(b);
}

}  // namespace assur::mechanism
