// Turns the places of two features that other joints bring together into how far they are apart.
#pragma once

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::support {

/// A frame that stands in another one.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> pose_in(const Pose<Scalar>& frame, const Pose<Scalar>& inner) {
  const auto& [c, s] = frame.direction;
  return {frame.x + c * inner.x - s * inner.y, frame.y + s * inner.x + c * inner.y,
          turned(inner.direction, frame.direction)};
}

/// The largest coordinate of frames: rounding of all places is a part of it.
template <typename Scalar, std::size_t Count>
[[nodiscard]] Scalar largest_coordinate(const std::array<Pose<Scalar>, Count>& frames) {
  Scalar largest = 0;
  for (const Pose<Scalar>& frame : frames) {
    largest = (std::max)({largest, std::abs(frame.x), std::abs(frame.y)});
  }
  return largest;
}

/// How far apart rounding may leave features in a mechanism of the given size, where its
/// configuration is regular and where it is not.
template <typename Scalar>
[[nodiscard]] Scalar redundancy_slack(Scalar size, Status regularity) {
  constexpr bool is_fine = std::numeric_limits<Scalar>::epsilon() < 1e-12;
  constexpr auto where_regular = static_cast<Scalar>(is_fine ? 1e-11 : 1e-4);
  constexpr auto where_singular = static_cast<Scalar>(is_fine ? 1e-6 : 1e-2);
  return (regularity == Status::ok ? where_regular : where_singular) * size;
}

/// The parts of rates, and of second rates, by which redundant constraints may contradict others
/// for rounding.
template <typename Scalar>
inline constexpr double agreement_of_rates = std::numeric_limits<Scalar>::epsilon() < 1e-12 ? 1e-8
                                                                                            : 1e-3;
template <typename Scalar>
inline constexpr double agreement_of_second_rates = std::numeric_limits<Scalar>::epsilon() < 1e-12
                                                        ? 1e-4
                                                        : 1e-2;

/// The distance of two points, of which each is a frame's origin.
template <typename Scalar>
[[nodiscard]] Scalar points_apart(const Pose<Scalar>& one, const Pose<Scalar>& other) {
  return std::hypot(other.x - one.x, other.y - one.y);
}

/// How far a point, a frame's origin, is from a line, a frame's x-axis.
template <typename Scalar>
[[nodiscard]] Scalar point_off_line(const Pose<Scalar>& line, const Pose<Scalar>& point) {
  const auto& [c, s] = line.direction;
  return std::abs(c * (point.y - line.y) - s * (point.x - line.x));
}

/// How far lines, each a frame's x-axis, are apart: the larger of the second one's distance from
/// the first, and of how far they part over a mechanism's size. Lines that point in opposite ways
/// part by twice that size.
template <typename Scalar>
[[nodiscard]] Scalar lines_apart(const Pose<Scalar>& one, const Pose<Scalar>& other, Scalar size) {
  const Direction<Scalar> turn = turned(other.direction, reversed(one.direction));
  const Scalar parting = (std::max)(std::abs(turn.sin), 1 - turn.cos) * size;
  return std::isnan(parting) ? parting : (std::max)(point_off_line(one, other), parting);
}

}  // namespace assur::support
