// Motion of points and carried links from the motion of the links that carry them.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::support {

/// A frame in another: its pose (x, y, theta), its first `Order` time derivatives, one per column,
/// and its derivatives with respect to `Parameters` parameters, one per column.
template <typename Scalar, int Order, int Parameters>
struct Frame {
  Pose<Scalar> pose{};
  Matrix<Scalar, 3, Order> rates = numeric::zeros<Matrix<Scalar, 3, Order>>();
  Matrix<Scalar, 3, Parameters> gradient = numeric::zeros<Matrix<Scalar, 3, Parameters>>();
  DisplacementOf<Scalar> displaced{};  ///< by rounding
};

/// The same for a point in a frame.
template <typename Scalar, int Order, int Parameters>
struct Point {
  Scalar x{};
  Scalar y{};
  Matrix<Scalar, 2, Order> rates = numeric::zeros<Matrix<Scalar, 2, Order>>();
  Matrix<Scalar, 2, Parameters> gradient = numeric::zeros<Matrix<Scalar, 2, Parameters>>();
  DisplacementOf<Scalar> displaced{};  ///< by rounding
};

/// A point fixed in a frame.
template <typename Scalar>
struct Place {
  Scalar x = 0;
  Scalar y = 0;
};

/// A fixed point of a moving frame, in the outer frame. Its arm turns with the moving frame: see
/// `carried` and `carried_twice`.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Point<Scalar, Order, Parameters> point_in(
    const Frame<Scalar, Order, Parameters>& frame, const Place<Scalar>& place) {
  const auto& [c, s] = frame.pose.direction;
  const Scalar arm_x = c * place.x - s * place.y;
  const Scalar arm_y = s * place.x + c * place.y;
  Point<Scalar, Order, Parameters> result;
  result.x = frame.pose.x + arm_x;
  result.y = frame.pose.y + arm_y;
  result.displaced = frame.displaced.carries(place.x, place.y);
  // Coordinates are moved one by one, not as vectors, so that compilers keep them in registers.
  for (int order = 0; order < Order; ++order) {
    const Scalar square = order == 0 ? 0 : frame.rates(2, 0) * frame.rates(2, 0);
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

/// The position in the outer frame of a point (x, y) of a moving frame, by `carried` and
/// `carried_twice`. `inner` and `outer` hold the derivatives of its two coordinates, and perhaps of
/// an angle, which is unchanged.
template <typename Scalar, int Order, int Parameters, typename Inner, typename Outer>
[[nodiscard]] Vector<Scalar, 2> carry(const Frame<Scalar, Order, Parameters>& frame,
                                      const Scalar& x, const Scalar& y, const Inner& inner,
                                      Outer& outer) {
  const Scalar c = frame.pose.direction.cos;
  const Scalar s = frame.pose.direction.sin;
  const std::array<Scalar, 2> arm = {c * x - s * y, s * x + c * y};
  const std::array<Scalar, 2> across = {-arm[1], arm[0]};
  const auto turned_own = [c, s](const auto& own, int index) {
    return std::array<Scalar, 2>{c * own(0, index) - s * own(1, index),
                                 s * own(0, index) + c * own(1, index)};
  };
  const auto carry_slope = [&](const auto& slopes, const auto& own, auto& result, int index) {
    const std::array<Scalar, 2> by_own = turned_own(own, index);
    result(0, index) = slopes(0, index) + slopes(2, index) * across[0] + by_own[0];
    result(1, index) = slopes(1, index) + slopes(2, index) * across[1] + by_own[1];
  };
#pragma GCC unroll 2
  for (int order = 0; order < Order; ++order) {
    carry_slope(frame.rates, inner.rates, outer.rates, order);
  }
  if constexpr (Order > 1) {
    const Scalar omega = frame.rates(2, 0);
    const std::array<Scalar, 2> sliding = turned_own(inner.rates, 0);
    outer.rates(0, 1) += -omega * omega * arm[0] - Scalar(2) * omega * sliding[1];
    outer.rates(1, 1) += -omega * omega * arm[1] + Scalar(2) * omega * sliding[0];
  }
#pragma GCC unroll 16
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    carry_slope(frame.gradient, inner.gradient, outer.gradient, parameter);
  }
  return {frame.pose.x + arm[0], frame.pose.y + arm[1]};
}

/// A point given in a moving frame, in the outer frame.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Point<Scalar, Order, Parameters> point_in(
    const Frame<Scalar, Order, Parameters>& frame, const Point<Scalar, Order, Parameters>& point) {
  Point<Scalar, Order, Parameters> result;
  const Vector<Scalar, 2> place = carry(frame, point.x, point.y, point, result);
  result.x = place(0);
  result.y = place(1);
  result.displaced = frame.displaced.carries(point.x, point.y);
  return result;
}

/// A frame given in a moving frame, in the outer frame.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> frame_in(
    const Frame<Scalar, Order, Parameters>& frame, const Frame<Scalar, Order, Parameters>& inner) {
  Frame<Scalar, Order, Parameters> result;
  const Vector<Scalar, 2> origin = carry(frame, inner.pose.x, inner.pose.y, inner, result);
  result.pose = {origin(0), origin(1), turned(frame.pose.direction, inner.pose.direction)};
  for (int order = 0; order < Order; ++order) {
    result.rates(2, order) = frame.rates(2, order) + inner.rates(2, order);
  }
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    result.gradient(2, parameter) = frame.gradient(2, parameter) + inner.gradient(2, parameter);
  }
  result.displaced = frame.displaced.carries(inner.pose.x, inner.pose.y, inner.displaced);
  return result;
}

/// The origin of a frame.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Point<Scalar, Order, Parameters> origin_of(
    const Frame<Scalar, Order, Parameters>& frame) {
  Point<Scalar, Order, Parameters> origin;
  origin.x = frame.pose.x;
  origin.y = frame.pose.y;
  for (int order = 0; order < Order; ++order) {
    origin.rates(0, order) = frame.rates(0, order);
    origin.rates(1, order) = frame.rates(1, order);
  }
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    origin.gradient(0, parameter) = frame.gradient(0, parameter);
    origin.gradient(1, parameter) = frame.gradient(1, parameter);
  }
  origin.displaced = frame.displaced;
  return origin;
}

/// The coordinate of a joint between two frames: an angle in (-pi, pi] or a displacement.
template <typename Scalar, int Order, int Parameters>
struct Coordinate {
  Scalar position = 0;
  Matrix<Scalar, 1, Order> rates = numeric::zeros<Matrix<Scalar, 1, Order>>();
  Matrix<Scalar, 1, Parameters> gradient = numeric::zeros<Matrix<Scalar, 1, Parameters>>();
};

/// The angle from one frame to another, theta_other - theta_one. Half a turn is +pi even if
/// rounding makes it -pi, so that a law that reads the angle has the same value for both.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Coordinate<Scalar, Order, Parameters> angle_between(
    const Frame<Scalar, Order, Parameters>& one, const Frame<Scalar, Order, Parameters>& other) {
  constexpr auto pi = static_cast<Scalar>(3.14159265358979323846);
  constexpr Scalar negligible =
      (std::max)(static_cast<Scalar>(1e-9), 16 * std::numeric_limits<Scalar>::epsilon());
  const Scalar angle = angle_of(turned(other.pose.direction, reversed(one.pose.direction)));
  Coordinate<Scalar, Order, Parameters> result;
  result.position = angle < negligible - pi ? angle + 2 * pi : angle;
  for (int order = 0; order < Order; ++order) {
    result.rates(order) = other.rates(2, order) - one.rates(2, order);
  }
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    result.gradient(parameter) = other.gradient(2, parameter) - one.gradient(2, parameter);
  }
  return result;
}

/// The displacement along the x-axis of one frame to the origin of another, which lies on the axis:
/// with r from one to the other and c along the axis, s = c.r, s' = c.r', s'' = c.r'' + omega^2 s.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Coordinate<Scalar, Order, Parameters> displacement_along(
    const Frame<Scalar, Order, Parameters>& one, const Frame<Scalar, Order, Parameters>& other) {
  const Scalar c = one.pose.direction.cos;
  const Scalar s = one.pose.direction.sin;
  Coordinate<Scalar, Order, Parameters> result;
  result.position = c * (other.pose.x - one.pose.x) + s * (other.pose.y - one.pose.y);
  const auto along = [c, s](const auto& two, const auto& from, int index) {
    return c * (two(0, index) - from(0, index)) + s * (two(1, index) - from(1, index));
  };
  for (int order = 0; order < Order; ++order) {
    result.rates(order) = along(other.rates, one.rates, order);
  }
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    result.gradient(parameter) = along(other.gradient, one.gradient, parameter);
  }
  if constexpr (Order > 1) {
    result.rates(1) += one.rates(2, 0) * one.rates(2, 0) * result.position;
  }
  return result;
}

/// The frame on the far side of a revolute joint, in that on the near side, for the joint's angle,
/// its rates and its derivatives with respect to the parameters.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> turning(
    Scalar angle,
    const Matrix<Scalar, 1, Order>& rates = numeric::zeros<Matrix<Scalar, 1, Order>>(),
    const Matrix<Scalar, 1, Parameters>& gradient =
        numeric::zeros<Matrix<Scalar, 1, Parameters>>()) {
  Frame<Scalar, Order, Parameters> frame;
  frame.pose.direction = direction_of(angle);
  frame.displaced = DisplacementOf<Scalar>::of_turn(angle);
  numeric::set_row(frame.rates, 2, rates);
  numeric::set_row(frame.gradient, 2, gradient);
  return frame;
}

/// The same for a prismatic joint along the x-axis and its displacement.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Frame<Scalar, Order, Parameters> sliding(
    Scalar displacement,
    const Matrix<Scalar, 1, Order>& rates = numeric::zeros<Matrix<Scalar, 1, Order>>(),
    const Matrix<Scalar, 1, Parameters>& gradient =
        numeric::zeros<Matrix<Scalar, 1, Parameters>>()) {
  Frame<Scalar, Order, Parameters> frame;
  frame.pose.x = displacement;
  frame.displaced = DisplacementOf<Scalar>::of_slide(displacement);
  numeric::set_row(frame.rates, 0, rates);
  numeric::set_row(frame.gradient, 0, gradient);
  return frame;
}

/// The sum of |derivative| x tolerance over the parameters, of each coordinate.
template <typename Scalar, int Parameters>
[[nodiscard]] Vector<Scalar, 2> worst_case(
    const Matrix<Scalar, 2, Parameters>& gradient,
    const std::array<double, static_cast<std::size_t>(Parameters)>& tolerances) {
  using std::abs;
  std::array<Scalar, 2> sum{Scalar(0), Scalar(0)};
#pragma GCC unroll 16
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    const auto tolerance = static_cast<Scalar>(detail::entry(tolerances, parameter));
    if (detail::entry(tolerances, parameter) == 0) {
      continue;  // its derivative may be unknown
    }
    sum[0] += abs(gradient(0, parameter)) * tolerance;
    sum[1] += abs(gradient(1, parameter)) * tolerance;
  }
  return {sum[0], sum[1]};
}

/// The square root of the sum of (derivative x tolerance)^2 over the parameters, of each
/// coordinate.
template <typename Scalar, int Parameters>
[[nodiscard]] Vector<Scalar, 2> root_sum_square(
    const Matrix<Scalar, 2, Parameters>& gradient,
    const std::array<double, static_cast<std::size_t>(Parameters)>& tolerances) {
  using std::sqrt;
  std::array<Scalar, 2> sum{Scalar(0), Scalar(0)};
#pragma GCC unroll 16
  for (int parameter = 0; parameter < Parameters; ++parameter) {
    const auto tolerance = static_cast<Scalar>(detail::entry(tolerances, parameter));
    if (detail::entry(tolerances, parameter) == 0) {
      continue;
    }
    const std::array<Scalar, 2> part = {gradient(0, parameter) * tolerance,
                                        gradient(1, parameter) * tolerance};
    sum[0] += part[0] * part[0];
    sum[1] += part[1] * part[1];
  }
  return {sqrt(sum[0]), sqrt(sum[1])};
}

}  // namespace assur::support
