// Real roots of a trigonometric polynomial by slow and common methods, for comparison: none of them
// certifies that it has found all.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <assur/model.hpp>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/Polynomials>

namespace assur::test {

template <std::size_t Degree>
struct ReferenceRoots {
  int count = 0;
  std::array<double, 64> angles{};

  void add(double angle) {
    if (count < 64) {
      angles[static_cast<std::size_t>(count++)] = angle;
    }
  }
};

/// Eigenvalues of the companion matrix in z = exp(i x) that lie within `tolerance` of the circle.
/// A `Square` of no fixed size is compiled sooner and runs longer.
template <std::size_t Degree,
          typename Square = Eigen::Matrix<std::complex<double>, 2 * static_cast<int>(Degree),
                                          2 * static_cast<int>(Degree)>>
ReferenceRoots<Degree> companion_roots(const TrigonometricPolynomial<double, Degree>& T,
                                       double tolerance = 1e-8) {
  using Complex = std::complex<double>;
  constexpr int size = 2 * static_cast<int>(Degree);
  std::array<Complex, 2 * Degree + 1> coefficient;
  coefficient[Degree] = T.cosine[0];
  for (std::size_t k = 1; k <= Degree; ++k) {
    coefficient[Degree + k] = Complex(T.cosine[k], -T.sine[k]) / 2.0;
    coefficient[Degree - k] = std::conj(coefficient[Degree + k]);
  }
  Square companion = Square::Zero(size, size);
  for (int row = 0; row < size; ++row) {
    companion(row, size - 1) =
        -coefficient[static_cast<std::size_t>(row)] / coefficient[2 * Degree];
    if (row > 0) {
      companion(row, row - 1) = 1;
    }
  }
  const Eigen::ComplexEigenSolver<Square> solver(companion, false);
  ReferenceRoots<Degree> roots;
  for (int index = 0; index < size && solver.info() == Eigen::Success; ++index) {
    const Complex z = solver.eigenvalues()(index);
    if (std::abs(std::abs(z) - 1) < tolerance) {
      roots.add(std::arg(z));
    }
  }
  return roots;
}

/// Coefficients of (1 + t^2)^n T in t = tan(x/2), ascending.
template <std::size_t Degree>
Eigen::Matrix<double, 2 * static_cast<int>(Degree) + 1, 1> half_angle_coefficients(
    const TrigonometricPolynomial<double, Degree>& T) {
  constexpr int size = 2 * static_cast<int>(Degree) + 1;
  using Row = Eigen::Matrix<std::complex<double>, size, 1>;
  Eigen::Matrix<double, size, 1> sum = Eigen::Matrix<double, size, 1>::Zero();
  const auto times = [](const Row& p, std::complex<double> linear, double square) {
    Row q = p;
    for (int power = 0; power + 1 < size; ++power) {
      q(power + 1) += linear * p(power);
    }
    for (int power = 0; power + 2 < size; ++power) {
      q(power + 2) += square * p(power);
    }
    return q;
  };
  for (std::size_t k = 0; k <= Degree; ++k) {
    Row p = Row::Zero();
    p(0) = 1;
    for (std::size_t factor = 0; factor < 2 * k; ++factor) {
      p = times(p, {0, 1}, 0);
    }
    for (std::size_t factor = k; factor < Degree; ++factor) {
      p = times(p, 0, 1);
    }
    sum += T.cosine[k] * p.real();
    if (k > 0) {
      sum += T.sine[k] * p.imag();
    }
  }
  return sum;
}

/// The tangent of the half angle and Eigen's general polynomial solver: one chart, fails at pi.
template <std::size_t Degree, int Size = 2 * static_cast<int>(Degree)>
ReferenceRoots<Degree> half_angle_roots(const TrigonometricPolynomial<double, Degree>& T,
                                        double tolerance = 1e-8) {
  constexpr int degree = 2 * static_cast<int>(Degree);
  const auto coefficients = half_angle_coefficients(T);
  ReferenceRoots<Degree> roots;
  if (coefficients(degree) == 0) {
    return roots;
  }
  const Eigen::PolynomialSolver<double, Size> solver(coefficients);
  for (int index = 0; index < degree; ++index) {
    const std::complex<double> t = solver.roots()(index);
    if (std::abs(t.imag()) < tolerance * (1 + std::abs(t.real()))) {
      roots.add(2 * std::atan(t.real()));
    }
  }
  return roots;
}

/// Sign changes over a fixed grid, each narrowed by bisection: loses roots in pairs.
template <std::size_t Degree>
ReferenceRoots<Degree> subdivision_roots(const TrigonometricPolynomial<double, Degree>& T) {
  const auto value = [&](double x) {
    double sum = T.cosine[0];
    for (std::size_t k = 1; k <= Degree; ++k) {
      const double multiple = static_cast<double>(k) * x;
      sum += T.cosine[k] * std::cos(multiple) + T.sine[k] * std::sin(multiple);
    }
    return sum;
  };
  constexpr int cells = 360;
  constexpr double width = 2 * 3.14159265358979323846 / cells;
  ReferenceRoots<Degree> roots;
  double left_value = value(0);
  for (int cell = 0; cell < cells; ++cell) {
    double left = cell * width;
    double right = left + width;
    const double right_value = value(right);
    if ((left_value < 0) != (right_value < 0)) {
      for (int step = 0; step < 50; ++step) {
        const double centre = (left + right) / 2;
        ((value(centre) < 0) == (left_value < 0) ? left : right) = centre;
      }
      roots.add((left + right) / 2);
    }
    left_value = right_value;
  }
  return roots;
}

}  // namespace assur::test
