// Turns how far rounding has moved and turned a group's neighbours into how far it may move and
// turn the group's links.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/kinematics.hpp>
#include <assur/support/scale.hpp>
#include <limits>

namespace assur::support {

/// A group among neighbours that rounding has moved and turned; lengths in the group's unit.
template <typename Model>
class DisplacedGroup {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  using Inverse = Matrix<double, Model::unknown_count, Model::equation_count>;

 public:
  /// `displaced`: how far what holds the group may be from where exact arithmetic has it. That is
  /// known to a rounding of its coordinates at best.
  DisplacedGroup(const Dimensions& d, const Inputs& u, const Displacement& displaced)
      : size_(1 / unit_scale<Model>(d, u, displaced)),
        held_((std::max)(displaced.moved, epsilon * longest_length(u))),
        moved_(displaced.moved + epsilon * longest_length(u)),
        turned_(displaced.turned),
        unsure_(unsure_jacobian<Model>(d, u, displaced)),
        reach_(displaced.reach) {}

  /// The regularity of a configuration, counting the neighbours' displacement.
  [[nodiscard]] Regularity<double> regularity(const Dimensions& d, const Inputs& u,
                                              const Configuration& q) const {
    return assur::regularity<Model, double>(d, u, q, unsure_);
  }

  /// How far the group's own links may be off: both ends of a closure move, slides turn, its own
  /// rounding is added, J^-1 makes of it turns and slides, and a turn moves points by the group's
  /// size.
  [[nodiscard]] Displacement displaced(const Configuration& q, const Inverse& J_inverse) const {
    const double reach = (std::max)(reach_, size_);
    constexpr double half_turn = 3.14159265358979;  // and no direction is off by more
    if (!J_inverse.allFinite()) {
      return {std::numeric_limits<double>::infinity(), half_turn, reach, size_};
    }
    double largest = 0;
    double turn = 0;
    for (int row = 0; row < Model::unknown_count; ++row) {
      const bool is_angle = detail::is_angle<Model>(row);
      const double sum = J_inverse.row(row).cwiseAbs().sum();
      largest = (std::max)(largest, (is_angle ? size_ : 1) * sum);
      turn = (std::max)(turn, is_angle ? sum : 0);
    }
    const double open =
        2 * (moved_ + turned_ * (std::max)(size_, longest_length(q))) + epsilon * size_;
    const double turned = turn > 0 ? turn * open : 0;  // open may be infinite
    return {moved_ + largest * open, (std::min)(turned_ + epsilon + turned, half_turn), reach,
            size_};
  }

  /// What one radian moves points by.
  [[nodiscard]] double size() const { return size_; }
  /// How far what holds the group may be from where exact arithmetic has it.
  [[nodiscard]] double held() const { return (std::max)(held_, turned_ * size_); }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double size_;
  double held_;
  double moved_;  ///< and by its own rounding once more, for what stands behind
  double turned_;
  double unsure_;
  double reach_;
};

}  // namespace assur::support
