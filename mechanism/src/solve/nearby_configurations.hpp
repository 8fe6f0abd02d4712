// Turns the configurations at one value of a parameter into how far their links may have turned at
// another value.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// The configurations at another value of a parameter, of which those here are continuations.
struct NearbyConfigurations {
  const std::vector<Configuration>* configurations = nullptr;  ///< none if null
  Eigen::Index column = 0;  ///< of the derivatives with respect to the parameter
  double way = 0;           ///< from that value to the one here

  /// How far a link of a continuation may have turned from where it stands in a configuration
  /// there, as the distance of the two directions.
  [[nodiscard]] double reach(const Configuration& configuration, LinkIndex link) const;
};

}  // namespace assur::mechanism::solve
