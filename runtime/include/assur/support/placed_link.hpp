// Turns links of known motion into the motion of their points and of the links that they carry.
#pragma once

#include <array>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cstddef>

namespace assur::support {

/// A frame in another: its pose (x, y, theta), the first `Order` time derivatives of these, one a
/// column, and their derivatives to `Parameters` parameters, one a column.
template <typename Scalar, int Order, int Parameters>
struct Frame {
  Pose<Scalar> pose{};
  Matrix<Scalar, 3, Order> rates = Matrix<Scalar, 3, Order>::Zero();
  Matrix<Scalar, 3, Parameters> gradient = Matrix<Scalar, 3, Parameters>::Zero();
  Displacement displaced{};  ///< by rounding
};

/// A point in a frame, likewise.
template <typename Scalar, int Order, int Parameters>
struct Point {
  Scalar x{};
  Scalar y{};
  Matrix<Scalar, 2, Order> rates = Matrix<Scalar, 2, Order>::Zero();
  Matrix<Scalar, 2, Parameters> gradient = Matrix<Scalar, 2, Parameters>::Zero();
  Displacement displaced{};  ///< by rounding
};

/// A point that stays where it is in a frame.
struct Place {
  double x = 0;
  double y = 0;
};

/// Such a point, in the frame in which that one moves: see `carried` and
/// `carried_twice`, of an arm that turns with the frame.
template <int Order, int Parameters>
[[nodiscard]] Point<double, Order, Parameters> point_in(
    const Frame<double, Order, Parameters>& frame, const Place& place) {
  const auto& [c, s] = frame.pose.direction;
  const double arm_x = c * place.x - s * place.y;
  const double arm_y = s * place.x + c * place.y;
  Point<double, Order, Parameters> result;
  result.x = frame.pose.x + arm_x;
  result.y = frame.pose.y + arm_y;
  result.displaced = frame.displaced.carries(place.x, place.y);
  // By coordinates, not as vectors: compilers keep them in registers then.
  for (int order = 0; order < Order; ++order) {
    const double square = order == 0 ? 0 : frame.rates(2, 0) * frame.rates(2, 0);
    result.rates(0, order) = frame.rates(0, order) - frame.rates(2, order) * arm_y - square * arm_x;
    result.rates(1, order) = frame.rates(1, order) + frame.rates(2, order) * arm_x - square * arm_y;
  }
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    const auto& slope = frame.gradient;
    result.gradient(0, parameter) = slope(0, parameter) - slope(2, parameter) * arm_y;
    result.gradient(1, parameter) = slope(1, parameter) + slope(2, parameter) * arm_x;
  }
  return result;
}

/// A point that is given in a moving frame, in the frame in which that one moves: see `carried` and
/// `carried_twice`.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Point<Scalar, Order, Parameters> point_in(
    const Frame<Scalar, Order, Parameters>& frame, const Point<Scalar, Order, Parameters>& point) {
  const auto turn = [&frame](const Vector<Scalar, 2>& v) {
    return rotated(frame.pose.direction, v);
  };
  const Vector<Scalar, 2> arm = turn({point.x, point.y});
  Point<Scalar, Order, Parameters> result;
  result.x = frame.pose.x + arm(0);
  result.y = frame.pose.y + arm(1);
  result.displaced =
      frame.displaced.carries(static_cast<double>(point.x), static_cast<double>(point.y));
  // Eigen has no columns of a matrix without columns.
  if constexpr (Order > 0) {
    const Vector<Scalar, 2> sliding = turn(point.rates.col(0));
    result.rates.col(0) = carried<Scalar>(frame.rates.col(0), arm, sliding);
    if constexpr (Order > 1) {
      const Scalar omega = frame.rates(2, 0);
      result.rates.col(1) = carried_twice<Scalar>(frame.rates.col(1), omega, omega, arm, sliding,
                                                  sliding, turn(point.rates.col(1)));
    }
  }
  if constexpr (Parameters > 0) {
    for (int parameter = 0; parameter < Parameters; ++parameter) {
      result.gradient.col(parameter) =
          carried<Scalar>(frame.gradient.col(parameter), arm, turn(point.gradient.col(parameter)));
    }
  }
  return result;
}

/// A frame that is given in a moving frame, in the frame in which that one moves; likewise.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> frame_in(
    const Frame<Scalar, Order, Parameters>& frame, const Frame<Scalar, Order, Parameters>& inner) {
  const Point<Scalar, Order, Parameters> origin =
      point_in(frame, Point<Scalar, Order, Parameters>{inner.pose.x,
                                                       inner.pose.y,
                                                       inner.rates.template topRows<2>(),
                                                       inner.gradient.template topRows<2>(),
                                                       {}});
  Frame<Scalar, Order, Parameters> result;
  result.pose = {origin.x, origin.y, turned(frame.pose.direction, inner.pose.direction)};
  result.rates.template topRows<2>() = origin.rates;
  result.rates.row(2) = frame.rates.row(2) + inner.rates.row(2);
  result.gradient.template topRows<2>() = origin.gradient;
  result.gradient.row(2) = frame.gradient.row(2) + inner.gradient.row(2);
  result.displaced = frame.displaced.carries(static_cast<double>(inner.pose.x),
                                             static_cast<double>(inner.pose.y), inner.displaced);
  return result;
}

/// The coordinate of a joint between two frames: an angle in (-pi, pi] or a displacement.
template <int Order, int Parameters>
struct Coordinate {
  double position = 0;
  Matrix<double, 1, Order> rates = Matrix<double, 1, Order>::Zero();
  Matrix<double, 1, Parameters> gradient = Matrix<double, 1, Parameters>::Zero();
};

/// The angle from one frame to another, theta_other - theta_one. It is above -pi by more than what
/// rounding leaves of half a turn, so that a law that reads it says the same for both.
template <int Order, int Parameters>
[[nodiscard]] Coordinate<Order, Parameters> angle_between(
    const Frame<double, Order, Parameters>& one, const Frame<double, Order, Parameters>& other) {
  constexpr double pi = 3.14159265358979323846;
  constexpr double negligible = 1e-9;
  const double angle = angle_of(turned(other.pose.direction, reversed(one.pose.direction)));
  return {angle < negligible - pi ? angle + 2 * pi : angle, other.rates.row(2) - one.rates.row(2),
          other.gradient.row(2) - one.gradient.row(2)};
}

/// How far along the x-axis of one frame, on which it lies, the origin of another is: with r from
/// one to the other and c along the axis, s = c.r, s' = c.r', s'' = c.r'' + omega^2 s.
template <int Order, int Parameters>
[[nodiscard]] Coordinate<Order, Parameters> displacement_along(
    const Frame<double, Order, Parameters>& one, const Frame<double, Order, Parameters>& other) {
  const Vector<double, 2> axis(one.pose.direction.cos, one.pose.direction.sin);
  Coordinate<Order, Parameters> result;
  result.position = axis(0) * (other.pose.x - one.pose.x) + axis(1) * (other.pose.y - one.pose.y);
  const auto along = [&](const auto& two, const auto& from) {
    return (axis.transpose() * (two.template topRows<2>() - from.template topRows<2>())).eval();
  };
  result.rates = along(other.rates, one.rates);
  result.gradient = along(other.gradient, one.gradient);
  if constexpr (Order > 1) {
    result.rates(1) += one.rates(2, 0) * one.rates(2, 0) * result.position;
  }
  return result;
}

/// The frame on the far side of a revolute joint, in that on the near side, for the joint's angle,
/// its rates and its derivatives to the parameters.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> turning(
    Scalar angle, const Matrix<Scalar, 1, Order>& rates = Matrix<Scalar, 1, Order>::Zero(),
    const Matrix<Scalar, 1, Parameters>& gradient = Matrix<Scalar, 1, Parameters>::Zero()) {
  Frame<Scalar, Order, Parameters> frame;
  frame.pose.direction = direction_of(angle);
  frame.displaced = Displacement::of_turn(static_cast<double>(angle));
  frame.rates.row(2) = rates;
  frame.gradient.row(2) = gradient;
  return frame;
}

/// The same of a prismatic joint along the x-axis, for its displacement.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> sliding(
    Scalar displacement, const Matrix<Scalar, 1, Order>& rates = Matrix<Scalar, 1, Order>::Zero(),
    const Matrix<Scalar, 1, Parameters>& gradient = Matrix<Scalar, 1, Parameters>::Zero()) {
  Frame<Scalar, Order, Parameters> frame;
  frame.pose.x = displacement;
  frame.displaced = Displacement::of_slide(static_cast<double>(displacement));
  frame.rates.row(0) = rates;
  frame.gradient.row(0) = gradient;
  return frame;
}

/// The sum of |derivative| x tolerance over the parameters, of each coordinate.
template <int Parameters>
[[nodiscard]] Vector<double, 2> worst_case(
    const Matrix<double, 2, Parameters>& gradient,
    const std::array<double, static_cast<std::size_t>(Parameters)>& tolerances) {
  return gradient.cwiseAbs() * Eigen::Map<const Vector<double, Parameters>>(tolerances.data());
}

/// The root of the sum of the squares of derivative x tolerance, likewise.
template <int Parameters>
[[nodiscard]] Vector<double, 2> root_sum_square(
    const Matrix<double, 2, Parameters>& gradient,
    const std::array<double, static_cast<std::size_t>(Parameters)>& tolerances) {
  const Eigen::Map<const Vector<double, Parameters>> half_widths(tolerances.data());
  return (gradient * half_widths.asDiagonal()).rowwise().norm();
}

}  // namespace assur::support
