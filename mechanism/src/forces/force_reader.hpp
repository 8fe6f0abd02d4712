// Efforts, joint forces and the ground's resultant, or their derivatives, from the unknowns of the
// equilibrium.
#pragma once

#include <assur/mechanism/forces.hpp>
#include <vector>

#include "balance.hpp"
#include "link_loads.hpp"

namespace assur::mechanism::forces {

/// Collects efforts, couples and forces, each a sum of unknowns of the equilibrium.
class ForceReader {
 public:
  /// Both must outlive it.
  ForceReader(const Mechanism& mechanism, const Balance& balance);

  /// Adds unknowns of the given sizes: couples, efforts, and forces along the directions.
  void add(const Eigen::VectorXd& sizes, const std::vector<Eigen::Vector2d>& directions);
  /// Adds the forces alone.
  void add_forces(const Eigen::VectorXd& sizes, const std::vector<Eigen::Vector2d>& directions);
  /// Makes unknown all that a vector of the unknowns' null space changes, a force as a whole: the
  /// choice of an unknown component would depend on the axes.
  void forget(const LinearSolution& unknowns, const std::vector<Eigen::Vector2d>& directions);
  [[nodiscard]] Forces take() { return std::move(result_); }

 private:
  using Directions = std::vector<Eigen::Vector2d>;

  [[nodiscard]] JointForce& joint_of(std::size_t pair, Forces& forces) const;
  void begin(std::size_t index);
  /// `couple` is the unit of couples.
  void add_couples(const Eigen::VectorXd& sizes, double couple, Forces& to) const;
  void add_forces(const Eigen::VectorXd& sizes, const Directions& directions, Forces& to) const;

  const Mechanism& mechanism_;
  const Balance& balance_;
  Forces none_;  ///< every entry zero
  Forces result_;
};

/// The directions of the unknown forces, and their derivatives with respect to the links'
/// parameter.
[[nodiscard]] std::vector<Eigen::Vector2d> directions_of(const std::vector<Reaction>& units);
[[nodiscard]] std::vector<Eigen::Vector2d> turning_of(const std::vector<Reaction>& units);

/// The resultant of all forces on the ground: by the equilibrium of all links together, the sum of
/// the loads on each.
[[nodiscard]] Wrench ground_resultant(const Mechanism& mechanism, const Balance& balance,
                                      const LinkLoads& loads);

}  // namespace assur::mechanism::forces
