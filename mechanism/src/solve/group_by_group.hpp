// Linear equations J q = -f of all constraints, solved for the unknowns of one group after another.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// J, the derivative of all constraints, where the unknowns of each group follow from its own rows:
/// the derivatives of rows with respect to unknowns of later groups are zero. A group with more
/// rows than unknowns, due to redundant constraints, is solved by least squares.
class GroupByGroup {
 public:
  /// Returns false where a group has fewer rows than unknowns, or where the least pivot of its part
  /// of J, after column exchange, is at most `least` times the largest.
  [[nodiscard]] bool factorise(const AllConstraints::Blocks& blocks, Eigen::MatrixXd J,
                               double least);
  /// The least ratio of a group's smallest pivot to its largest.
  [[nodiscard]] double firmness() const { return firmness_; }
  /// q with J q = -f.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& f) const;
  /// The residual J q + f.
  [[nodiscard]] Eigen::VectorXd left(const Eigen::VectorXd& q, const Eigen::VectorXd& f) const {
    return J_ * q + f;
  }

 private:
  struct Group {
    std::vector<Eigen::Index> rows, unknowns;
    std::vector<Eigen::Index> known;  ///< the unknowns of earlier groups in its rows
    Eigen::MatrixXd of_known;         ///< their part of J
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
  };

  Eigen::MatrixXd J_;
  std::vector<Group> groups_;
  double firmness_ = 1;
};

}  // namespace assur::mechanism::solve
