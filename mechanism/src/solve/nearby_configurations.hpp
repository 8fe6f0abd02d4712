// Configurations at a neighbouring value of a parameter, and how well placed links continue them.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// The configurations at another value of a parameter.
struct NearbyConfigurations {
  const std::vector<Configuration>* configurations = nullptr;
  const Table<GroupIndex, const RoleAssignment*>* roles = nullptr;  ///< of the groups' links there
  Eigen::Index column = 0;  ///< of the derivatives with respect to the parameter
  double way = 0;           ///< from that value to the one here
  bool go_on = false;       ///< whether all should continue here
};

/// How well the motion of a configuration, along its slope, predicts the directions of links here.
struct Continuation {
  double error = 0;  ///< the sum of the directions' distances from the predicted ones
  double away = 0;   ///< the sum of the directions' distances from those at the other value
  double reach = 0;  ///< the largest turn of the links that their slopes make plausible

  /// Adds a link.
  void add(const NearbyConfigurations& nearby, const Configuration& there, LinkIndex link,
           const Direction<double>& here);
};

}  // namespace assur::mechanism::solve
