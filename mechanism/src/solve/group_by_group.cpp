#include "group_by_group.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace assur::mechanism::solve {

bool GroupByGroup::factorise(const AllConstraints::Blocks& blocks, Eigen::MatrixXd J,
                             double least) {
  J_ = std::move(J);
  groups_.clear();
  firmness_ = 1;
  const auto group = [this](std::size_t block) -> Group& {
    if (block >= groups_.size()) {
      groups_.resize(block + 1);
    }
    return groups_[block];
  };
  for (std::size_t row = 0; row < blocks.of_rows.size(); ++row) {
    group(blocks.of_rows[row]).rows.push_back(static_cast<Eigen::Index>(row));
  }
  for (std::size_t column = 0; column < blocks.of_unknowns.size(); ++column) {
    group(blocks.of_unknowns[column]).unknowns.push_back(static_cast<Eigen::Index>(column));
  }
  for (Group& own : groups_) {
    if (own.rows.size() < own.unknowns.size()) {
      return false;
    }
    if (own.unknowns.empty()) {
      continue;
    }
    for (Eigen::Index column = 0; column < J_.cols(); ++column) {
      const bool is_own = blocks.of_unknowns[static_cast<std::size_t>(column)] ==
                          static_cast<std::size_t>(&own - groups_.data());
      const auto is_contained = [&](Eigen::Index row) { return J_(row, column) != 0; };
      if (!is_own && std::ranges::any_of(own.rows, is_contained)) {
        own.known.push_back(column);
      }
    }
    own.of_known = J_(own.rows, own.known);
    own.factors.compute(J_(own.rows, own.unknowns));
    const auto pivots = own.factors.matrixR().diagonal().cwiseAbs();
    firmness_ = std::min(firmness_, pivots(pivots.size() - 1) / pivots(0));
    if (!(firmness_ > least)) {
      return false;
    }
  }
  return true;
}

Eigen::VectorXd GroupByGroup::solve(const Eigen::VectorXd& f) const {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(J_.cols());
  for (const Group& own : groups_) {
    if (!own.unknowns.empty()) {
      const Eigen::VectorXd open = f(own.rows) + own.of_known * q(own.known);
      q(own.unknowns) = -own.factors.solve(open);
    }
  }
  return q;
}

}  // namespace assur::mechanism::solve
