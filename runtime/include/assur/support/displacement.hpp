// Bounds on the displacement of a group's links by rounding, from those of the neighbours that hold
// the group.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/detail/second_look.hpp>
#include <assur/kinematics.hpp>
#include <assur/support/scale.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::support {

/// A group whose neighbours are displaced by rounding; lengths in the group's unit.
template <typename Model, typename Scalar = double>
class DisplacedGroup {
  using Dimensions = typename Model::template Dimensions<Scalar>;
  using Inputs = typename Model::template Inputs<Scalar>;
  using Configuration = typename Model::template Configuration<Scalar>;
  using Displacement = DisplacementOf<Scalar>;
  using Inverse = Matrix<Scalar, Model::unknown_count, Model::equation_count>;

 public:
  /// `displaced` bounds the displacement of the neighbours that hold the group. Their positions are
  /// known to a rounding of their coordinates at best.
  DisplacedGroup(const Dimensions& d, const Inputs& u, const Displacement& displaced)
      : size_(is_exact ? own_size<Model, Scalar>(d, u)
                       : 1 / unit_scale<Model, Scalar>(d, u, displaced)),
        held_((std::max)(displaced.moved, epsilon * longest_length(u))),
        moved_(displaced.moved + epsilon * longest_length(u)),
        turned_(displaced.turned),
        unsure_(unsure_jacobian<Model, Scalar>(d, u, displaced)),
        reach_(displaced.reach) {}

  /// The regularity of a configuration, including the effect of the neighbours' displacement.
  [[nodiscard]] Regularity<Scalar> regularity(const Dimensions& d, const Inputs& u,
                                              const Configuration& q) const {
    return assur::regularity<Model, Scalar>(d, u, q, unsure_);
  }

  /// The regularity with second rates included: in float the pivots alone do not suffice.
  [[nodiscard]] Regularity<Scalar> regularity_in_motion(const Dimensions& d, const Inputs& u,
                                                        const Configuration& q) const {
    Regularity<Scalar> result = regularity(d, u, q);
    if constexpr (std::is_same_v<Scalar, float>) {
      if (result.status == Status::ok) {
        const auto pivots = detail::firmness_of(detail::pivots_at<Model, Scalar>(d, u, q));
        detail::look_again<Model, Scalar>(d, u, q, unsure_, pivots, result);
      }
    }
    return result;
  }

  /// Bounds on the displacement of the group's own links: both ends of a closure move, slides turn,
  /// and the group's own rounding is added. J^-1 maps this to errors of angles and displacements;
  /// an angle moves points by itself times the group's size.
  [[nodiscard]] Displacement displaced(const Configuration& q, const Inverse& J_inverse) const {
    const Scalar reach = (std::max)(reach_, size_);
    constexpr auto half_turn =
        static_cast<Scalar>(3.14159265358979);  // the largest error of a direction
    if (!J_inverse.allFinite()) {
      return {std::numeric_limits<Scalar>::infinity(), half_turn, reach, size_};
    }
    Scalar largest = 0;
    Scalar turn = 0;
    for (int row = 0; row < Model::unknown_count; ++row) {
      const bool is_angle = detail::is_angle<Model>(row);
      const Scalar sum = loosened_by(J_inverse, row);
      largest = (std::max)(largest, (is_angle ? size_ : 1) * sum);
      turn = (std::max)(turn, is_angle ? sum : 0);
    }
    // The rotation of links that hold pins is already part of the pins' displacement.
    const Scalar held_turn = is_exact && !has_slides ? Scalar(0) : turned_;
    const Scalar open =
        2 * (moved_ + held_turn * (std::max)(size_, longest_length(q))) + epsilon * size_;
    const Scalar turned = turn > 0 ? turn * open : 0;  // `open` may be infinite
    return {moved_ + largest * open, (std::min)(turned_ + epsilon + turned, half_turn), reach,
            size_};
  }

  /// The length by which a turn of one radian moves points.
  [[nodiscard]] Scalar size() const { return size_; }
  /// Bound on the displacement of the neighbours that hold the group.
  [[nodiscard]] Scalar held() const { return (std::max)(held_, turned_ * size_); }

 private:
  /// The change of an unknown per unit of closure error: in the worst direction of the plane; or,
  /// if the scalar has digits to spare, along both axes at once.
  [[nodiscard]] static Scalar loosened_by(const Inverse& J_inverse, int row) {
    if constexpr (!is_exact || Model::equation_count % 2 != 0) {
      return J_inverse.row(row).cwiseAbs().sum();
    }
    Scalar sum = 0;
    for (int loop = 0; loop < Model::equation_count; loop += 2) {
      sum += std::hypot(J_inverse(row, loop), J_inverse(row, loop + 1));
    }
    return sum;
  }
  /// Float has no digit to spare: in a chain of groups none would soon be left.
  static constexpr bool is_exact = std::is_same_v<Scalar, float>;
  /// Whether any neighbour holds a slide.
  static constexpr bool has_slides = [] {
    bool any = false;
    for (const bool is_angle : detail::SortsOf<Inputs>::angles) {
      any = any || is_angle;
    }
    return any;
  }();
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  Scalar size_;
  Scalar held_;
  Scalar moved_;  ///< including another rounding of the inputs, for the groups that follow
  Scalar turned_;
  Scalar unsure_;
  Scalar reach_;
};

}  // namespace assur::support
