// Derivatives of a point carried by a moving frame, to second order, and angles that go on beyond
// half a turn.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <cmath>
#include <limits>

namespace assur::support {

/// The vector turned by a direction.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> rotated(const Direction<Scalar>& direction,
                                        const Vector<Scalar, 2>& v) {
  return {direction.cos * v(0) - direction.sin * v(1), direction.sin * v(0) + direction.cos * v(1)};
}

/// The vector turned by a right angle: for a rate w of turning, w times this is the tip's velocity.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> across(const Vector<Scalar, 2>& v) {
  return {-v(1), v(0)};
}

/// The point lies at p = X + r, where r = R(theta) p' is its arm in a frame (X, theta) and p' its
/// place in the frame. Its derivative along one direction x of whatever varies:
///     p_x = X_x + theta_x r' + R p'_x,  r' = r turned by a right angle.
/// `frame_x` is (X_x, theta_x), `own_x` is R p'_x. Along time this is the velocity.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> carried(const Vector<Scalar, 3>& frame_x,
                                        const Vector<Scalar, 2>& arm,
                                        const Vector<Scalar, 2>& own_x) {
  return frame_x.template head<2>() + frame_x(2) * across(arm) + own_x;
}

/// The second derivative along two directions x and y:
///     p_xy = X_xy + theta_xy r' - theta_x theta_y r + theta_x (R p'_y)' + theta_y (R p'_x)'
///            + R p'_xy.
/// If both directions are time, this is the acceleration, and the middle terms are the centripetal
/// and the Coriolis acceleration.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> carried_twice(const Vector<Scalar, 3>& frame_xy,
                                              const Scalar& theta_x, const Scalar& theta_y,
                                              const Vector<Scalar, 2>& arm,
                                              const Vector<Scalar, 2>& own_x,
                                              const Vector<Scalar, 2>& own_y,
                                              const Vector<Scalar, 2>& own_xy) {
  return frame_xy.template head<2>() + frame_xy(2) * across(arm) - theta_x * theta_y * arm +
         theta_x * across(own_y) + theta_y * across(own_x) + own_xy;
}

/// An angle within half a turn. Half a turn itself, whose sign rounding would choose, counts as
/// positive.
template <typename Scalar>
[[nodiscard]] Scalar within_half_turn(const Scalar& angle) {
  constexpr auto turn = static_cast<Scalar>(6.28318530717958647692);
  constexpr Scalar negligible =
      (std::max)(static_cast<Scalar>(1e-9), 16 * std::numeric_limits<Scalar>::epsilon());
  const Scalar within = std::remainder(angle, turn);
  return within < negligible - turn / 2 ? within + turn : within;
}

/// An angle continued from its last value by at most half a turn.
template <typename Scalar>
[[nodiscard]] Scalar continued_angle(const Scalar& angle, const Scalar& last) {
  return last + within_half_turn(Scalar(angle - last));
}
}  // namespace assur::support
