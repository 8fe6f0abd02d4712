// The six-bar's worst case by Ceres Solver's Jet and Eigen's LU.
#include <ceres/jet.h>

#include <Eigen/LU>

#include "scenes/six_bar.hpp"

namespace assur::speed {

namespace {

/// The closures of the loops through E and D in the caller's scalar.
template <typename T>
struct Closure {
  std::array<T, 4> f;
  T x_M, y_M;
};

template <typename T, typename A>
Closure<T> closure(const std::array<T, 4>& angle, const std::array<A, SixBar::parameters>& a,
                   const Plate<A>& at, double crank) {
  using std::cos;
  using std::sin;
  using P = SixBar;
  std::array<T, 4> c;
  std::array<T, 4> s;
  for (std::size_t index = 0; index < 4; ++index) {
    c[index] = cos(angle[index]);
    s[index] = sin(angle[index]);
  }
  const T x_B = a[P::x_O] + a[P::OA] * std::cos(crank) + a[P::AB] * c[1];
  const T y_B = a[P::y_O] + a[P::OA] * std::sin(crank) + a[P::AB] * s[1];
  return {{x_B + a[P::BE] * c[0] - a[P::EF] * c[2] - a[P::x_F],
           y_B + a[P::BE] * s[0] - a[P::EF] * s[2] - a[P::y_F],
           x_B + at.x_D * c[0] - at.y_D * s[0] - a[P::DG] * c[3] - a[P::x_G],
           y_B + at.x_D * s[0] + at.y_D * c[0] - a[P::DG] * s[3] - a[P::y_G]},
          x_B + at.x_M * c[0] - at.y_M * s[0],
          y_B + at.x_M * s[0] + at.y_M * c[0]};
}

constexpr int slots = 4 + SixBar::parameters;
using Jet = ceres::Jet<double, slots>;

template <typename Scalar>
Plate<Scalar> made_plate(const std::array<Scalar, SixBar::parameters>& a) {
  return plate<Scalar>(a[SixBar::BE], a[SixBar::BD], a[SixBar::ED],
                       {Scalar(0.5), Scalar(std::sqrt(0.75))});
}

/// The parameters as Jets, and the plate, are the same at all positions.
const std::array<Jet, SixBar::parameters>& parameter_jets() {
  static const auto list = [] {
    std::array<Jet, SixBar::parameters> made;
    for (std::size_t index = 0; index < made.size(); ++index) {
      made[index] = Jet(SixBar::value[index], 4 + static_cast<int>(index));
    }
    return made;
  }();
  return list;
}

}  // namespace

SixBarAnswer six_bar_by_jets(double crank, const Eigen::Vector4d& theta) {
  static const Plate<Jet> at = made_plate(parameter_jets());
  std::array<Jet, 4> angle;
  for (std::size_t index = 0; index < 4; ++index) {
    angle[index] = Jet(theta(static_cast<Eigen::Index>(index)), static_cast<int>(index));
  }
  const Closure<Jet> all = closure<Jet, Jet>(angle, parameter_jets(), at, crank);
  Eigen::Matrix4d J;
  Eigen::Matrix<double, 4, SixBar::parameters> F;
  for (int row = 0; row < 4; ++row) {
    const auto& v = all.f[static_cast<std::size_t>(row)].v;
    J.row(row) = v.head<4>().transpose();
    F.row(row) = v.tail<SixBar::parameters>().transpose();
  }
  const Eigen::Matrix<double, 4, SixBar::parameters> by_angles =
      Eigen::PartialPivLU<Eigen::Matrix4d>(J).solve(F);
  const Eigen::Map<const Eigen::Matrix<double, SixBar::parameters, 1>> tolerance(
      SixBar::tolerance.data());
  const auto worst = [&](const Jet& coordinate) {
    return (coordinate.v.tail<SixBar::parameters>().transpose() -
            coordinate.v.head<4>().transpose() * by_angles)
        .cwiseAbs()
        .dot(tolerance.transpose());
  };
  return {false, {worst(all.x_M), worst(all.y_M)}};
}

SixBarAnswer six_bar_tracked_by_jets(double crank, Eigen::Vector4d theta) {
  using Angle = ceres::Jet<double, 4>;
  static const Plate<double> at = made_plate(SixBar::value);
  for (int iteration = 0; iteration < 25; ++iteration) {
    std::array<Angle, 4> angle;
    for (std::size_t index = 0; index < 4; ++index) {
      angle[index] = Angle(theta(static_cast<Eigen::Index>(index)), static_cast<int>(index));
    }
    const Closure<Angle> all = closure<Angle, double>(angle, SixBar::value, at, crank);
    Eigen::Matrix4d J;
    Eigen::Vector4d f;
    for (int row = 0; row < 4; ++row) {
      J.row(row) = all.f[static_cast<std::size_t>(row)].v.transpose();
      f(row) = all.f[static_cast<std::size_t>(row)].a;
    }
    const Eigen::Vector4d step = Eigen::PartialPivLU<Eigen::Matrix4d>(J).solve(f);
    theta -= step;
    if (step.cwiseAbs().maxCoeff() < 1e-8) {  // the step just taken has squared this error
      return six_bar_by_jets(crank, theta);
    }
  }
  return {true, {}};
}

}  // namespace assur::speed
