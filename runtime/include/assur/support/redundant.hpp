// Gaps of redundant joints, and their tolerances.
#pragma once

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/support/derivative_digits.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::support {

/// A frame given in another one, in the outer frame.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> pose_in(const Pose<Scalar>& frame, const Pose<Scalar>& inner) {
  const auto& [c, s] = frame.direction;
  return {frame.x + c * inner.x - s * inner.y, frame.y + s * inner.x + c * inner.y,
          turned(inner.direction, frame.direction)};
}

/// The largest coordinate of frames, which scales the rounding of all positions.
template <typename Scalar, std::size_t Count>
[[nodiscard]] Scalar largest_coordinate(const std::array<Pose<Scalar>, Count>& frames) {
  Scalar largest = 0;
  for (const Pose<Scalar>& frame : frames) {
    largest = (std::max)({largest, std::abs(frame.x), std::abs(frame.y)});
  }
  return largest;
}

/// The tolerance for the gap between features in a mechanism of the given size, for a regular
/// configuration and for one that is not.
template <typename Scalar>
[[nodiscard]] Scalar redundancy_slack(Scalar size, Status regularity) {
  constexpr bool is_fine = std::numeric_limits<Scalar>::epsilon() < 1e-12;
  constexpr auto where_regular = static_cast<Scalar>(is_fine ? 1e-11 : 1e-4);
  constexpr auto where_singular = static_cast<Scalar>(is_fine ? 1e-6 : 1e-2);
  return (regularity == Status::ok ? where_regular : where_singular) * size;
}

/// The relative differences of rates, and of second rates, that rounding may cause between
/// redundant constraints.
template <typename Scalar>
inline constexpr double agreement_of_rates = std::numeric_limits<Scalar>::epsilon() < 1e-12 ? 1e-8
                                                                                            : 1e-3;
template <typename Scalar>
inline constexpr double agreement_of_second_rates = std::numeric_limits<Scalar>::epsilon() < 1e-12
                                                        ? 1e-4
                                                        : 1e-2;

/// How many digits the rates have that all constraints of a mechanism determine together, if their
/// derivative J by the links' poses has the firmness s: its least singular value in parts of the
/// largest. `rounding` is that of the constraints.
template <typename Scalar>
struct RateDigits {
  Scalar error;       ///< of first rates: rounding / s^2
  Scalar last_error;  ///< of the last rates that are computed; second ones divide by s once more

  RateDigits(Scalar rounding, Scalar firmness, int order)
      : error(rounding / (firmness * firmness)), last_error(order < 2 ? error : error / firmness) {}

  [[nodiscard]] bool are_known() const { return error < Scalar(two_digits); }
  [[nodiscard]] bool are_all_known() const { return last_error < Scalar(two_digits); }
  [[nodiscard]] Status regularity() const {
    return last_error < Scalar(regular_error<Scalar>) ? Status::ok : Status::near_singular;
  }
};

/// Norms of the rates of one column: the solution q of J q = -f in the least squares, f, and what
/// is left, J q + f.
template <typename Scalar>
struct SolvedRates {
  Scalar rates, open, left;

  /// Whether redundant constraints contradict one another in first rates: more is left than
  /// rounding causes.
  [[nodiscard]] bool contradict() const {
    return !(left <= Scalar(agreement_of_rates<Scalar>) * open);
  }
  /// The same of second rates, whose f has terms of the first ones.
  [[nodiscard]] bool contradict_twice(const SolvedRates& first) const {
    return !(left <=
             Scalar(agreement_of_second_rates<Scalar>) * (open + first.rates * first.rates));
  }
};

/// The distance of the origins of two frames.
template <typename Scalar>
[[nodiscard]] Scalar points_apart(const Pose<Scalar>& one, const Pose<Scalar>& other) {
  return std::hypot(other.x - one.x, other.y - one.y);
}

/// The distance of a point, a frame's origin, from a line, a frame's x-axis.
template <typename Scalar>
[[nodiscard]] Scalar point_off_line(const Pose<Scalar>& line, const Pose<Scalar>& point) {
  const auto& [c, s] = line.direction;
  return std::abs(c * (point.y - line.y) - s * (point.x - line.x));
}

/// The gap between two lines, each a frame's x-axis: the larger of the second origin's distance
/// from the first line, and of their divergence over the mechanism's size. Lines of opposite
/// direction diverge by twice that size.
template <typename Scalar>
[[nodiscard]] Scalar lines_apart(const Pose<Scalar>& one, const Pose<Scalar>& other, Scalar size) {
  const Direction<Scalar> turn = turned(other.direction, reversed(one.direction));
  const Scalar parting = (std::max)(std::abs(turn.sin), 1 - turn.cos) * size;
  return std::isnan(parting) ? parting : (std::max)(point_off_line(one, other), parting);
}

}  // namespace assur::support
