// Turns how far rounding has displaced a frame into how far it has displaced what the frame holds.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <limits>

namespace assur::support {

/// The larger of two numbers, or lane by lane of two packs.
template <typename Scalar>
[[nodiscard]] constexpr Scalar larger(const Scalar& one, const Scalar& other) {
  using std::max;
  return max EIGEN_NOT_A_MACRO(one, other);
}

/// The largest amounts by which rounding may have moved what stands in a frame, up to `extent` from
/// its origin, and turned the frame. What is computed from lengths that cancel is not known to a
/// rounding of its own value, but to one of theirs: `reach` is the longest of them.
template <typename Scalar>
struct DisplacementOf {
  static constexpr auto epsilon =
      std::numeric_limits<typename numeric::PartOf<Scalar>::Type>::epsilon();
  Scalar moved = 0;
  Scalar turned = 0;
  Scalar reach = 0;
  Scalar extent = 0;

  /// The amounts where both are finite, else infinity: an amount that is not finite bounds nothing.
  [[nodiscard]] DisplacementOf bounded() const {
    constexpr Scalar any = std::numeric_limits<Scalar>::infinity();
    const bool is_bound = std::isfinite(moved) && std::isfinite(turned);
    return {is_bound ? moved : any, is_bound ? turned : any, std::isfinite(reach) ? reach : 0,
            extent};
  }
  /// A frame that turns about its origin by an angle, which is rounded as its cosine and sine are.
  [[nodiscard]] static DisplacementOf of_turn(Scalar angle) {
    using std::abs;
    return {Scalar(0), Scalar(epsilon) * (Scalar(1) + abs(angle)), Scalar(0)};
  }
  /// A frame that slides along an axis.
  [[nodiscard]] static DisplacementOf of_slide(Scalar displacement) {
    using std::abs;
    const Scalar length = abs(displacement);
    return {Scalar(epsilon) * length, Scalar(0), length};
  }
  /// A feature whose coordinates have one error and whose direction has another.
  [[nodiscard]] static DisplacementOf of_rounding(Scalar error, Scalar turn) {
    return {error, turn, error / Scalar(epsilon)};
  }
  /// The larger of each amount of two displacements, which may not add up.
  [[nodiscard]] DisplacementOf worst_of(const DisplacementOf& other) const {
    return {larger(moved, other.moved), larger(turned, other.turned), larger(reach, other.reach)};
  }
  /// The amounts with lengths in another unit.
  [[nodiscard]] DisplacementOf scaled(Scalar scale) const {
    return {moved * scale, turned, reach * scale, extent * scale};
  }
  /// The amounts in double.
  [[nodiscard]] DisplacementOf<double> in_double() const {
    return {static_cast<double>(moved), static_cast<double>(turned), static_cast<double>(reach),
            static_cast<double>(extent)};
  }
  /// The displacement of what stands at (x, y) in this frame.
  [[nodiscard]] DisplacementOf carries(Scalar x, Scalar y) const {
    using std::abs;
    const Scalar arm = abs(x) + abs(y);
    return {moved + turned * larger(Scalar(0), arm - extent), turned, larger(reach, arm)};
  }
  /// The displacement of a frame that stands there and is displaced against this one.
  [[nodiscard]] DisplacementOf carries(Scalar x, Scalar y, const DisplacementOf& inner) const {
    const DisplacementOf origin = carries(x, y);
    return {origin.moved + inner.moved, turned + inner.turned, larger(origin.reach, inner.reach)};
  }
};
using Displacement = DisplacementOf<double>;

}  // namespace assur::support
