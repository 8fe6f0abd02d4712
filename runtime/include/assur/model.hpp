// Types of generated models: directions, poses, trigonometric polynomials and constants.
#pragma once

#include <Eigen/Core>
#include <array>
#include <assur/detail/refused_options.hpp>
#include <assur/model_tables.hpp>
#include <cstddef>
#include <tuple>

namespace assur {

/// An angle as (cos, sin). Generated code never calls a trigonometric function.
template <typename Scalar>
struct Direction {
  Scalar cos{1};
  Scalar sin{0};
};

template <typename Scalar, int Rows>
using Vector = Eigen::Matrix<Scalar, Rows, 1>;
template <typename Scalar, int Rows, int Columns>
using Matrix = Eigen::Matrix<Scalar, Rows, Columns>;

/// T(x) = sum over k of cosine[k] cos(k x) + sine[k] sin(k x), k = 0 .. Degree; sine[0] is not
/// used.
template <typename Scalar, std::size_t Degree>
struct TrigonometricPolynomial {
  std::array<Scalar, Degree + 1> cosine{};
  std::array<Scalar, Degree + 1> sine{};
};

/// A link's frame in the fixed frame: a point p of the link lies at (x, y) + R(direction) p.
template <typename Scalar>
struct Pose {
  Scalar x{};
  Scalar y{};
  Direction<Scalar> direction{};
};

template <typename Scalar, int Links>
using Poses = std::array<Pose<Scalar>, static_cast<std::size_t>(Links)>;

/// A number of generated code that is not a double: the nearest double and the remainder.
template <typename Scalar>
[[nodiscard]] constexpr Scalar constant(double nearest, double rest) {
  return Scalar(nearest) + Scalar(rest);
}

}  // namespace assur
