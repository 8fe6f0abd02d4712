// Turns how far rounding has moved a group's neighbours into how far it may move the group's links.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/kinematics.hpp>
#include <assur/support/scale.hpp>
#include <limits>

namespace assur::support {

/// A group among neighbours that rounding has moved; lengths in the group's unit.
template <typename Model>
class DisplacedGroup {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  using Inverse = Matrix<double, Model::unknown_count, Model::equation_count>;

 public:
  /// `displaced`: how far any placed point may be from where exact arithmetic has it. Where a
  /// neighbour holds the group is known to a rounding of its coordinates at best.
  DisplacedGroup(const Dimensions& d, const Inputs& u, double displaced)
      : size_(1 / unit_scale<Model>(d, u, displaced)),
        longest_(Model::dimension_count == 0 ? 1 : size_of<Model>(d, u)),
        held_(std::max(displaced, epsilon * longest_length(u))),
        moved_(displaced + epsilon * longest_length(u)) {}

  /// The regularity of a configuration, counting the neighbours' displacement.
  [[nodiscard]] Regularity<double> regularity(const Dimensions& d, const Inputs& u,
                                              const Configuration& q) const {
    bool turns = false;
    for (int unknown = 0; unknown < Model::unknown_count; ++unknown) {
      turns = turns || detail::is_angle<Model>(unknown);
    }
    // Where nothing turns, J does not depend on places but on directions, which the neighbours hold
    // as well as they stand themselves. Elsewhere what rounding has left of a size tells nothing.
    const double size = turns ? longest_ : std::max(longest_, longest_length(u));
    return assur::regularity<Model, double>(d, u, q, held_ / size);
  }

  /// How far the group's own points may be off: both ends of a closure move, its own rounding is
  /// added, J^-1 makes of it turns and slides, and a turn moves points by the group's size.
  [[nodiscard]] double displaced(const Inverse& J_inverse) const {
    if (!J_inverse.allFinite()) {
      return std::numeric_limits<double>::infinity();
    }
    double largest = 0;
    for (int row = 0; row < Model::unknown_count; ++row) {
      const bool is_angle = detail::is_angle<Model>(row);
      const double sum = J_inverse.row(row).cwiseAbs().sum();
      largest = std::max(largest, (is_angle ? size_ : 1) * sum);
    }
    return moved_ + largest * (2 * moved_ + epsilon * size_);
  }

  /// What one radian moves points by.
  [[nodiscard]] double size() const { return size_; }
  /// How far what holds the group may be from where exact arithmetic has it.
  [[nodiscard]] double held() const { return held_; }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double size_;
  double longest_;
  double held_;
  double moved_;  ///< and by its own rounding once more, for what stands behind
};

}  // namespace assur::support
