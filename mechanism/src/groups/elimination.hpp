// Every complex configuration of a group, by the determinant of Dixon in the complex plane as an
// eigenproblem.
#pragma once

#include <cstdint>
#include <vector>

#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// A set of angles, by the bits of their numbers.
using AngleSet = std::uint32_t;

/// How a group's equations are brought to one unknown: all angles are measured against one of them,
/// the ground, and another one, x = exp(i angle), is hidden in the coefficients. With t_c = 1 /
/// theta_c, every set K of the other angles gives one equation: of the 2l loops and conjugates,
/// linear in theta_c, t_c and the displacements, all theta_c with c outside K, all t_c with c in K
/// and all displacements are eliminated, and what is left is multiplied by the product t_K:
///   sum_{c in K} [theta_c] t_{K - c} + sum_{c outside K} [t_c] t_{K + c} + [1] t_K = 0.
/// The equations are linear in the products of the columns, with polynomials in x as coefficients.
/// Wampler, Solving the kinematics of planar mechanisms by Dixon determinant and a complex-plane
/// formulation, Journal of Mechanical Design 123 (2001); slides as in the notes on groups.
struct Elimination {
  /// In place of a hidden angle where slides fix all angles: the equations are linear.
  static constexpr int none = -1;

  int ground;
  int hidden;
  std::vector<AngleSet> sets;      ///< of the equations: a row each
  std::vector<int> lowest_powers;  ///< of x in each row
  std::vector<AngleSet> products;  ///< a column each
  int degree;                      ///< of the polynomials in x, once each row begins at x^0
};

/// The eliminations that serve a group in general position. A displacement must run along the
/// ground or the hidden angle; there is none where slides lie in three directions.
[[nodiscard]] std::vector<Elimination> eliminations_of(const LoopEquations& general);

/// Approximate complex configurations: all in general position, and some that close nothing.
[[nodiscard]] std::vector<ComplexConfiguration> candidates(const LoopEquations& equations,
                                                           const Elimination& elimination);

}  // namespace assur::mechanism::groups
