// Bounds on the displacement of frames and points by rounding.
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

/// Bounds on the translation of points of a frame, up to `extent` from its origin, and on the
/// rotation of the frame, by rounding. A difference of lengths that cancel is known only to a
/// rounding of these lengths: `reach` is the longest of them.
template <typename Scalar>
struct DisplacementOf {
  static constexpr auto epsilon =
      std::numeric_limits<typename numeric::PartOf<Scalar>::Type>::epsilon();
  Scalar moved = 0;
  Scalar turned = 0;
  Scalar reach = 0;
  Scalar extent = 0;

  /// The bounds if both are finite, otherwise infinity, since a bound that is not finite holds for
  /// nothing.
  [[nodiscard]] DisplacementOf bounded() const {
    constexpr Scalar any = std::numeric_limits<Scalar>::infinity();
    const bool is_bound = std::isfinite(moved) && std::isfinite(turned);
    return {is_bound ? moved : any, is_bound ? turned : any, std::isfinite(reach) ? reach : 0,
            extent};
  }
  /// The displacement of a frame that turns about its origin by a rounded angle with rounded cosine
  /// and sine.
  [[nodiscard]] static DisplacementOf of_turn(Scalar angle) {
    using std::abs;
    return {Scalar(0), Scalar(epsilon) * (Scalar(1) + abs(angle)), Scalar(0)};
  }
  /// The displacement of a frame that slides along an axis.
  [[nodiscard]] static DisplacementOf of_slide(Scalar displacement) {
    using std::abs;
    const Scalar length = abs(displacement);
    return {Scalar(epsilon) * length, Scalar(0), length};
  }
  /// The displacement of a feature with given errors of its coordinates and its direction.
  [[nodiscard]] static DisplacementOf of_rounding(Scalar error, Scalar turn) {
    return {error, turn, error / Scalar(epsilon)};
  }
  /// The larger of each bound of two displacements that cannot add up.
  [[nodiscard]] DisplacementOf worst_of(const DisplacementOf& other) const {
    return {larger(moved, other.moved), larger(turned, other.turned), larger(reach, other.reach)};
  }
  /// The bounds with lengths in another unit.
  [[nodiscard]] DisplacementOf scaled(Scalar scale) const {
    return {moved * scale, turned, reach * scale, extent * scale};
  }
  /// The bounds in double.
  [[nodiscard]] DisplacementOf<double> in_double() const {
    return {static_cast<double>(moved), static_cast<double>(turned), static_cast<double>(reach),
            static_cast<double>(extent)};
  }
  /// The displacement of the point (x, y) of this frame.
  [[nodiscard]] DisplacementOf carries(Scalar x, Scalar y) const {
    using std::abs;
    const Scalar arm = abs(x) + abs(y);
    return {moved + turned * larger(Scalar(0), arm - extent), turned, larger(reach, arm)};
  }
  /// The displacement of a frame at (x, y) that is itself displaced relative to this one.
  [[nodiscard]] DisplacementOf carries(Scalar x, Scalar y, const DisplacementOf& inner) const {
    const DisplacementOf origin = carries(x, y);
    return {origin.moved + inner.moved, turned + inner.turned, larger(origin.reach, inner.reach)};
  }
};
using Displacement = DisplacementOf<double>;

}  // namespace assur::support
