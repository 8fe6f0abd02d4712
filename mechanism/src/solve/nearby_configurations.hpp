// Turns the configurations at a value of a parameter nearby into how well links that are placed
// here continue each of them.
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
  bool go_on = false;       ///< whether all are expected to be continued here
};

/// How well the motion of a configuration, along its slope, leads to directions of links here.
struct Continuation {
  double error = 0;  ///< the sum of the directions' distances from where the slope leads
  double away = 0;   ///< the sum of the directions' distances from where they are there
  double reach = 0;  ///< how far, by their slopes, the links can be expected to turn at most

  /// Adds a link.
  void add(const NearbyConfigurations& nearby, const Configuration& there, LinkIndex link,
           const Direction<double>& here);
};

}  // namespace assur::mechanism::solve
