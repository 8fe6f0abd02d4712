// Exact arithmetic on Gaussian rationals.
#pragma once

#include <complex>

#include "runtime/rational.hpp"

namespace assur::test {

/// A point, a vector or a turn of the plane with rational coordinates.
struct Gaussian {
  Rational re = 0;
  Rational im = 0;

  [[nodiscard]] std::complex<double> rounded() const { return {re.rounded(), im.rounded()}; }
  [[nodiscard]] bool is_zero() const { return re.is_zero() && im.is_zero(); }

  friend Gaussian operator+(const Gaussian& a, const Gaussian& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend Gaussian operator-(const Gaussian& a, const Gaussian& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend Gaussian operator*(const Gaussian& a, const Gaussian& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Gaussian conj(const Gaussian& a) { return {a.re, -a.im}; }
  friend Rational norm(const Gaussian& a) { return a.re * a.re + a.im * a.im; }
  friend Gaussian operator/(const Gaussian& a, const Gaussian& b) {
    const Gaussian product = a * conj(b);
    return {product.re / norm(b), product.im / norm(b)};
  }
  friend bool operator==(const Gaussian& a, const Gaussian& b) {
    return a.re == b.re && a.im == b.im;
  }
};

}  // namespace assur::test
