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
  using Unknowns = Vector<double, Model::unknown_count>;
  using Inverse = Matrix<double, Model::unknown_count, Model::equation_count>;

 public:
  /// `displaced`: how far any placed point may be from where exact arithmetic has it. Where a
  /// neighbour holds the group is known to a rounding of its coordinates at best.
  DisplacedGroup(const Dimensions& d, const Inputs& u, double displaced)
      : size_(1 / unit_scale<Model>(d, u)),
        longest_(Model::dimension_count == 0 ? 1 : size_of<Model>(d, u)),
        held_(displaced + epsilon * longest_length(u)) {}

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

  /// A second look at a configuration that `regularity` calls near-singular: that bound multiplies
  /// the firmness of parts that need not fail together. Rounding and the neighbours move a
  /// configuration by dq = J^-1 df, and that changes the derivatives J^-1 c by J^-1 H(J^-1 c, dq),
  /// with H the second derivatives of the closures. Lengths and angles are each counted in parts of
  /// their own derivatives.
  [[nodiscard]] Regularity<double> regularity(const Dimensions& d, const Inputs& u,
                                              const Configuration& q,
                                              const Inverse& J_inverse) const {
    Regularity<double> result = regularity(d, u, q);
    if (result.status != Status::near_singular || !J_inverse.allFinite()) {
      return result;
    }
    const double reach = std::max(size_, longest_length(q));
    const double unclosed = 2 * held_ + epsilon * reach;
    double error = 0;
    for (const bool angles : {false, true}) {
      const Unknowns moved = unclosed * loosest(J_inverse, angles);
      // Of the linear equations alone: right-hand sides as long as the group reaches, of which a
      // turn by one may be left, or a length of the group's size.
      error = std::max(
          error, epsilon * reach * largest(moved, angles) / (angles ? unclosed : unclosed * size_));
      Inverse change;
      for (int column = 0; column < Model::equation_count; ++column) {
        change.col(column) = J_inverse * bent(d, u, q, J_inverse.col(column), moved);
      }
      for (const bool of_angles : {false, true}) {
        const double size = largest(J_inverse, of_angles);
        error = std::max(error, size > 0 ? largest(change, of_angles) / size : 0);
      }
    }
    result.error = second_look_constant * error;
    result.status = result.error < six_digits ? Status::ok : Status::near_singular;
    return result;
  }

  /// By how much more than rates second rates are in error: J q'' = -H(q', q') - ..., in which an
  /// error of q' weighs 1 / s, s how firmly J holds. Near a fold q'' is as large; at a crossing it
  /// is not.
  [[nodiscard]] double second_rate_error(const Inverse& J_inverse, const Unknowns& rate,
                                         const Unknowns& second_rate) const {
    const double speed = norm(rate) * norm(rate) / size_;
    const double firm = std::max(norm(loosest(J_inverse, false)), norm(loosest(J_inverse, true)));
    const double size = std::max(norm(second_rate), speed);
    return size > 0 ? std::max(1.0, firm * speed / size) : 1.0;
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
    return held_ + largest * (2 * held_ + epsilon * size_);
  }

 private:
  /// The largest entry in the rows of angles, or of lengths.
  template <typename Rows>
  [[nodiscard]] static double largest(const Rows& rows, bool angles) {
    double result = 0;
    for (int row = 0; row < Model::unknown_count; ++row) {
      if (detail::is_angle<Model>(row) == angles) {
        result = std::max(result, rows.row(row).cwiseAbs().maxCoeff());
      }
    }
    return result;
  }
  /// With turns as lengths.
  [[nodiscard]] double norm(const Unknowns& of) const {
    return std::max(largest(of, false), size_ * largest(of, true));
  }
  /// J^-1 f for closures f that fail by one each, with the signs that move angles, or lengths,
  /// most.
  [[nodiscard]] static Unknowns loosest(const Inverse& J_inverse, bool angles) {
    int row_of_all = 0;
    double most = -1;
    for (int row = 0; row < Model::unknown_count; ++row) {
      const double moves = J_inverse.row(row).cwiseAbs().sum();
      if (detail::is_angle<Model>(row) == angles && moves > most) {
        most = moves;
        row_of_all = row;
      }
    }
    Unknowns sum = Unknowns::Zero();
    for (int column = 0; column < Model::equation_count; ++column) {
      sum += J_inverse.col(column) * (J_inverse(row_of_all, column) < 0 ? -1 : 1);
    }
    return sum;
  }
  /// H(x, y), up to its sign, from the quadratic form: both are brought to one length.
  [[nodiscard]] Vector<double, Model::equation_count> bent(const Dimensions& d, const Inputs& u,
                                                           const Configuration& q,
                                                           const Unknowns& x,
                                                           const Unknowns& y) const {
    const double length_x = norm(x);
    const double length_y = norm(y);
    const auto curvature = [&](const Unknowns& along) {
      Vector<double, Model::equation_count> second;
      Model::curvature_rhs(d, u, q, along, Vector<double, Model::dimension_count>::Zero().eval(),
                           Vector<double, Model::input_count>::Zero().eval(), second);
      return second;
    };
    if (!(length_x > 0 && length_y > 0)) {
      return Vector<double, Model::equation_count>::Zero();
    }
    return (curvature(x / length_x + y / length_y) - curvature(x / length_x - y / length_y)) *
           (length_x * length_y / 4);
  }

  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double six_digits = 5e-7;
  static constexpr double second_look_constant = 4;
  double size_;
  double longest_;
  double held_;
};

}  // namespace assur::support
