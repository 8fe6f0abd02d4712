// Methods that find all configurations of a group.
#pragma once

#include <Eigen/LU>

#include "positions/position_samples.hpp"

namespace assur::speed {

template <typename Model>
using Polynomial = TrigonometricPolynomial<double, Model::polynomial_degree>;

/// How far a computed root may be from the real line, or from the unit circle, and still count as a
/// root: rounding moves two roots that meet apart by its square root. This power of ten has the
/// fewest failures, near-singular groups and others.
inline constexpr double nearly_real = 1e-5;

/// The number of steps that a method takes for one configuration.
struct Effort {
  int polishing_steps;  ///< Newton's, at most, from a root of the polynomial
  int newton_steps;     ///< from one of many starts
};
/// The first is enough in general, the second where two configurations meet, where Newton's
/// iteration begins slowly.
inline constexpr Effort usual_effort = {3, 20};
inline constexpr Effort patient_effort = {10, 40};

/// The same elimination with the roots found by another method, completed and polished as usual.
template <typename Model, typename FindAngles>
[[nodiscard]] Found<Model> from_roots(const PositionSample<Model>& sample, Effort effort,
                                      FindAngles find_angles) {
  Polynomial<Model> T;
  Model::position_polynomial(sample.d, sample.u, T);
  const auto roots = find_angles(T);
  Found<Model> found;
  for (int root = 0; root < roots.count; ++root) {
    typename Model::template Configuration<double> q;
    std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members()) =
        direction_of(roots.angles[static_cast<std::size_t>(root)]);
    if constexpr (Model::second_unknown >= 0) {
      Matrix<double, 2, 3> e;
      Model::second_equations(sample.d, sample.u, q, e);
      auto& second = std::get<static_cast<std::size_t>(Model::second_unknown)>(q.members());
      second = numeric::second_candidates<std::decay_t<decltype(second)>>(e).list[0].value;
    }
    Model::complete(sample.d, sample.u, q);
    (void)refine<Model, double>(sample.d, sample.u, q, effort.polishing_steps);
    found.add(q);
  }
  return found;
}

/// The coefficients of the half-angle polynomial are a linear map of the trigonometric ones; the
/// map is made once.
template <std::size_t Degree>
[[nodiscard]] test::ReferenceRoots<Degree> half_angle_roots(
    const TrigonometricPolynomial<double, Degree>& T) {
  constexpr int size = 2 * static_cast<int>(Degree) + 1;
  using Square = Eigen::Matrix<double, size, size>;
  static const Square map = [] {
    Square columns;
    for (std::size_t k = 0; k <= Degree; ++k) {
      TrigonometricPolynomial<double, Degree> unit;
      unit.cosine[k] = 1;
      columns.col(static_cast<Eigen::Index>(k)) = test::half_angle_coefficients(unit);
      if (k > 0) {
        unit.cosine[k] = 0;
        unit.sine[k] = 1;
        columns.col(static_cast<Eigen::Index>(Degree + k)) = test::half_angle_coefficients(unit);
      }
    }
    return columns;
  }();
  Eigen::Matrix<double, size, 1> given;
  for (std::size_t k = 0; k <= Degree; ++k) {
    given(static_cast<Eigen::Index>(k)) = T.cosine[k];
    if (k > 0) {
      given(static_cast<Eigen::Index>(Degree + k)) = T.sine[k];
    }
  }
  const Eigen::Matrix<double, size, 1> coefficients = map * given;
  test::ReferenceRoots<Degree> roots;
  if (coefficients(size - 1) == 0) {
    return roots;
  }
  const Eigen::PolynomialSolver<double, size - 1> solver(coefficients);
  for (int index = 0; index < size - 1; ++index) {
    const std::complex<double> t = solver.roots()(index);
    if (std::abs(t.imag()) < nearly_real * (1 + std::abs(t.real()))) {
      roots.add(2 * std::atan(t.real()));
    }
  }
  return roots;
}

/// Newton's iteration with Eigen's LU from 64 starts that are the same for every group. No unknown
/// changes by more than one per step.
template <typename Model>
class MultiStartNewton {
  using Configuration = typename Model::template Configuration<double>;
  static constexpr int size = Model::unknown_count;

 public:
  [[nodiscard]] static Found<Model> find(const PositionSample<Model>& sample, Effort effort) {
    Found<Model> found;
    for (const Configuration& start : starts()) {
      Configuration q = start;
      if (settles(sample, effort, q) && !known(found, q)) {
        found.add(q);
      }
    }
    return found;
  }

 private:
  static bool settles(const PositionSample<Model>& sample, Effort effort, Configuration& q) {
    for (int iteration = 0; iteration < effort.newton_steps; ++iteration) {
      Vector<double, size> f;
      Matrix<double, size, size> J;
      Model::residual(sample.d, sample.u, q, f);
      Model::jacobian(sample.d, sample.u, q, J);
      Vector<double, size> step = Eigen::PartialPivLU<Matrix<double, size, size>>(J).solve(-f);
      const double largest = step.cwiseAbs().maxCoeff();
      if (!(largest < 1e6)) {
        return false;
      }
      if (largest > 1) {
        step /= largest;
      }
      advance(q, step);
      if (largest < 1e-9) {  // the step just taken has squared this error
        return true;
      }
    }
    return false;
  }
  static bool known(const Found<Model>& found, const Configuration& q) {
    for (std::size_t index = 0; index < found.count; ++index) {
      if (apart(found.list[index], q) < 1e-8) {
        return true;
      }
    }
    return false;
  }
  static const std::array<Configuration, 64>& starts() {
    static const std::array<Configuration, 64> list = [] {
      std::array<Configuration, 64> made;
      test::RandomInputs random(64);
      for (Configuration& q : made) {
        q = random.variables<Configuration>();
      }
      return made;
    }();
    return list;
  }
};

}  // namespace assur::speed
