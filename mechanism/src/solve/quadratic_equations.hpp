// Real common roots of quadratic equations in one or two unknowns.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace assur::mechanism::solve {

/// Equations constant_e + linear.row(e) x + x' square_e x = 0, one for each row.
struct QuadraticEquations {
  std::vector<Eigen::MatrixXd> square;  ///< symmetric
  Eigen::MatrixXd linear;
  Eigen::VectorXd constant;

  [[nodiscard]] Eigen::Index count() const { return constant.size(); }
  [[nodiscard]] Eigen::Index unknowns() const { return linear.cols(); }
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::MatrixXd derivative(const Eigen::VectorXd& x) const;
  /// The given equations in the unknowns from `known.size()` on, where the unknowns before these
  /// have the values `known`.
  [[nodiscard]] QuadraticEquations of(const std::vector<Eigen::Index>& equations,
                                      const Eigen::VectorXd& known, Eigen::Index unknowns) const;
};

/// The real roots that all equations share; roots closer than rounding separates are one. `noise`
/// is the rounding error of the coefficients, whose size is at most about one. Returns nothing
/// where fewer equations than unknowns exceed rounding, or where there are more than two unknowns.
[[nodiscard]] std::optional<std::vector<Eigen::VectorXd>> common_roots(
    const QuadraticEquations& equations, double noise);

}  // namespace assur::mechanism::solve
