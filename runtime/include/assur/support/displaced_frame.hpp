// Turns how far rounding has displaced a frame into how far it has displaced what the frame holds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::support {

/// By how much rounding may have moved what stands in a frame up to `extent` from its origin, and
/// turned the frame, at most. What is computed from lengths that cancel is not known to a rounding
/// of its own value, but to one of theirs: `reach` is the longest of them.
struct Displacement {
  double moved = 0;
  double turned = 0;
  double reach = 0;
  double extent = 0;

  /// The same where it is finite. What is not bounds nothing: all may be off by any amount.
  [[nodiscard]] Displacement bounded() const {
    constexpr double any = std::numeric_limits<double>::infinity();
    const bool is_bound = std::isfinite(moved) && std::isfinite(turned);
    return {is_bound ? moved : any, is_bound ? turned : any, std::isfinite(reach) ? reach : 0,
            extent};
  }
  /// A frame that turns about its origin by an angle, which is rounded as its cosine and sine are.
  [[nodiscard]] static Displacement of_turn(double angle) {
    return {0, std::numeric_limits<double>::epsilon() * (1 + std::abs(angle)), 0};
  }
  /// A frame that slides along an axis.
  [[nodiscard]] static Displacement of_slide(double displacement) {
    const double length = std::abs(displacement);
    return {std::numeric_limits<double>::epsilon() * length, 0, length};
  }
  /// A feature whose coordinates are computed with an error, and its direction with another.
  [[nodiscard]] static Displacement of_rounding(double error, double turn) {
    return {error, turn, error / std::numeric_limits<double>::epsilon()};
  }
  /// The larger of each, of two that may not add up.
  [[nodiscard]] Displacement worst_of(const Displacement& other) const {
    return {(std::max)(moved, other.moved), (std::max)(turned, other.turned),
            (std::max)(reach, other.reach)};
  }
  /// Lengths in another unit.
  [[nodiscard]] Displacement scaled(double scale) const {
    return {moved * scale, turned, reach * scale, extent * scale};
  }
  /// Of what stands at (x, y) in this frame.
  [[nodiscard]] Displacement carries(double x, double y) const {
    const double arm = std::abs(x) + std::abs(y);
    return {moved + turned * (std::max)(0.0, arm - extent), turned, (std::max)(reach, arm)};
  }
  /// Of a frame that stands there and is displaced against this one.
  [[nodiscard]] Displacement carries(double x, double y, const Displacement& inner) const {
    const Displacement origin = carries(x, y);
    return {origin.moved + inner.moved, turned + inner.turned,
            (std::max)(origin.reach, inner.reach)};
  }
};

}  // namespace assur::support
