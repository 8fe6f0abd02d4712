// Linear equations J q = -f of all constraints, solved for the unknowns of one group after another.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// J, the derivative of all constraints, where the unknowns of each group follow from its own rows:
/// the derivatives of rows with respect to unknowns of later groups are zero. Where a group has
/// more rows than unknowns, since constraints are redundant, these hold in the least squares.
class GroupByGroup {
 public:
  /// False where a group has fewer rows than unknowns, or is not firm: the least pivot of its part
  /// of J, whose columns are exchanged, is not above `least` in parts of the largest.
  [[nodiscard]] bool factorise(const AllConstraints::Blocks& blocks, Eigen::MatrixXd J,
                               double least);
  /// The least pivot of a group in parts of its largest.
  [[nodiscard]] double firmness() const { return firmness_; }
  /// q with J q = -f.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& f) const;
  /// J q + f.
  [[nodiscard]] Eigen::VectorXd left(const Eigen::VectorXd& q, const Eigen::VectorXd& f) const {
    return J_ * q + f;
  }

 private:
  struct Group {
    std::vector<Eigen::Index> rows, unknowns;
    std::vector<Eigen::Index> known;  ///< the unknowns of groups before it that its rows contain
    Eigen::MatrixXd of_known;         ///< their part of J
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
  };

  Eigen::MatrixXd J_;
  std::vector<Group> groups_;
  double firmness_ = 1;
};

}  // namespace assur::mechanism::solve
