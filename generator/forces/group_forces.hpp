// Joint forces of a rigid model under given loads, by the transposed elimination.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::forces {

/// The loads on a link apart from the joints of its group: a force, and the total moment about the
/// origin of the link's frame, in the directions of the fixed frame.
struct LinkLoad {
  GiNaC::symbol x, y, moment;
};

/// The force of a joint on its second link; its opposite acts on the first link. The force of a
/// revolute joint acts at the joint. That of a slide acts at the foot of the perpendicular from the
/// origin of the second link's frame, together with a couple.
struct JointReaction {
  equations::Vector2 force;
  std::optional<GiNaC::ex> couple;  ///< for a slide
};

/// The equilibrium of a model's links by virtual work. The spanning tree that places the links cuts
/// one joint of each loop; the loads have the components Q along the unknowns by this tree, and the
/// forces lambda in the cut joints satisfy
///     J^T lambda = -Q.
/// The other joints follow from the leaves of the tree to the base by sums of forces, and the
/// couples of slides from the last links that they tie by sums of moments.
struct GroupForces {
  structure::LinkTable<LinkLoad> loads;
  std::vector<GiNaC::ex> generalised;           ///< Q, one for each unknown
  std::vector<equations::Vector2> multipliers;  ///< lambda, one for each loop: on the second link
  structure::JointTable<JointReaction> joints;
  /// The components of lambda if they are found numerically; else empty.
  std::vector<GiNaC::symbol> given;
  equations::Vocabulary vocabulary;  ///< all these names, after those of the elimination
};

/// `derivatives` must be of the same equations, with link poses along the same tree. Without a
/// `jacobian`, as for groups of more than four links, the calling program solves for lambda.
[[nodiscard]] GroupForces group_forces(const equations::ClosureEquations& equations,
                                       const derivatives::Derivatives& derivatives,
                                       const pivoting::StructuredJacobian* jacobian);

}  // namespace assur::generator::forces
