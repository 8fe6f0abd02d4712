// Turns the values of a scene into the variables of generated models, and their derivatives.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "scene/group_problem.hpp"

namespace assur::generator {

inline DimensionValue<double> plain(const DimensionValue<Dual>& value) {
  return {value.is_angle, value.length.value(), {value.angle.cos.value(), value.angle.sin.value()}};
}

inline std::vector<DimensionValue<Dual>> dimension_values(const GroupProblem& problem) {
  std::vector<DimensionValue<Dual>> values;
  for (const NormalForm<Dual>& link : problem.links) {
    values.insert(values.end(), link.dimensions.begin(),
                  link.dimensions.begin() + link.dimension_count);
  }
  return values;
}

template <typename Variables>
Variables filled(const std::vector<DimensionValue<Dual>>& values) {
  Variables result;
  std::apply(
      [&](auto&... member) {
        std::size_t index = 0;
        (detail::take_value(member, plain(values[index++])), ...);
      },
      result.members());
  return result;
}

/// Some quantities as functions of the parameters: gradients, one row a quantity, and a Hessian for
/// each where they are carried.
struct QuantityDerivatives {
  Eigen::MatrixXd gradients;
  std::vector<Eigen::MatrixXd> hessians;

  /// The Hessians' entries for parameters i and j, a column in the order of the quantities.
  [[nodiscard]] Eigen::VectorXd mixed(Eigen::Index i, Eigen::Index j) const {
    Eigen::VectorXd column(gradients.rows());
    for (Eigen::Index row = 0; row < column.size(); ++row) {
      column(row) = hessians[static_cast<std::size_t>(row)](i, j);
    }
    return column;
  }
  void set_mixed(Eigen::Index i, Eigen::Index j, const Eigen::VectorXd& column) {
    for (Eigen::Index row = 0; row < column.size(); ++row) {
      Eigen::MatrixXd& hessian = hessians[static_cast<std::size_t>(row)];
      hessian(i, j) = hessian(j, i) = column(row);
    }
  }
  [[nodiscard]] Dual quantity(double value, Eigen::Index row) const {
    const auto slot = static_cast<std::size_t>(row);
    return {value, gradients.row(row).transpose(),
            hessians.empty() ? Eigen::MatrixXd() : hessians[slot]};
  }
};

/// The derivatives of a model's dimensions or inputs; of an angle, those of the angle in radians.
inline QuantityDerivatives derivatives(const std::vector<DimensionValue<Dual>>& values,
                                       Eigen::Index count) {
  QuantityDerivatives result{Eigen::MatrixXd(static_cast<Eigen::Index>(values.size()), count), {}};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const Dual quantity = values[row].is_angle ? angle_of(values[row].angle) : values[row].length;
    result.gradients.row(static_cast<Eigen::Index>(row)) = quantity.derivatives().transpose();
    if (quantity.has_hessian()) {
      result.hessians.push_back(quantity.hessian());
    }
  }
  return result;
}

/// A link's frame from its pose and the derivatives of (x, y, theta), which stand from `row` on.
inline LinkState frame_of(const Pose<double>& pose, const QuantityDerivatives& p,
                          Eigen::Index row) {
  const Dual turning = p.quantity(0.0, row + 2);
  LinkState frame;
  frame.x = p.quantity(pose.x, row);
  frame.y = p.quantity(pose.y, row + 1);
  frame.direction = turned({Dual(pose.direction.cos), Dual(pose.direction.sin)},
                           Direction<Dual>{cos(turning), sin(turning)});
  return frame;
}

}  // namespace assur::generator
