// Efforts, joint forces and the ground's resultant, or their derivatives, from the unknowns of the
// equilibrium.
#pragma once

#include <assur/mechanism/forces.hpp>
#include <vector>

#include "balance.hpp"
#include "link_loads.hpp"

namespace assur::mechanism::forces {

/// Collects efforts, couples and forces from the unknowns of the equilibrium.
class ForceReader {
 public:
  /// Both must outlive it.
  ForceReader(const Mechanism& mechanism, const Balance& balance);

  /// Adds the sizes of the unknowns to efforts and couples.
  void add_couples(const Eigen::VectorXd& unknowns);
  /// Adds the unknowns times their directions to the forces of joints.
  void add_forces(const Eigen::VectorXd& unknowns, const std::vector<Eigen::Vector2d>& directions);
  [[nodiscard]] Forces take() { return std::move(result_); }

 private:
  [[nodiscard]] JointForce& joint_of(std::size_t pair);
  void begin(std::size_t index);

  const Mechanism& mechanism_;
  const Balance& balance_;
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
