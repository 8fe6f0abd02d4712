// Complex configurations of a group, each enclosed in a ball that holds exactly one.
#pragma once

#include <vector>

#include "groups/elimination.hpp"
#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// A configuration, as Newton's method has settled it, and a ball about it where Krawczyk's
/// operator is a contraction, with bounds for all roundings. The ball is measured by the largest of
/// the moduli of the angles' errors and of the displacements' errors in parts of the group's size.
/// Within `holds` of the configuration there is one exact solution of the equations as they stand
/// in doubles, and within `alone` no other one.
struct Enclosed {
  ComplexConfiguration at;
  double holds;
  double alone;
  bool is_real;  ///< the solution is its own mirror image theta -> 1 / conj(theta), s -> conj(s)
};

/// The complex configurations that were found, in disjoint balls.
struct AllConfigurations {
  std::vector<Enclosed> enclosed;
  /// Where closures vanish to rounding without a ball being found: approximate.
  std::vector<ComplexConfiguration> unproven;

  [[nodiscard]] int count() const { return static_cast<int>(enclosed.size()); }
};

/// Searches by one elimination after another until `complex_count` balls are found, or all
/// eliminations are used.
[[nodiscard]] AllConfigurations all_configurations(const LoopEquations& equations,
                                                   const std::vector<Elimination>& eliminations,
                                                   int complex_count);

}  // namespace assur::mechanism::groups
