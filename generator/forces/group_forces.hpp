// Turns the elimination of a rigid model, transposed, into the forces in its joints under given
// loads.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::forces {

/// What acts on a link beside the joints of its group: a force, and the moment of all about the
/// origin of the link's frame, in the directions of the fixed frame.
struct LinkLoad {
  GiNaC::symbol x, y, moment;
};

/// The force of a joint on its second link; on the first link acts the opposite one. At a revolute
/// joint it acts at the joint. At a slide it acts at the foot of the perpendicular from the origin
/// of the second link's frame, together with a couple.
struct JointReaction {
  equations::Vector2 force;
  std::optional<GiNaC::ex> couple;  ///< of a slide
};

/// The equilibrium of a model's links by virtual work. The tree that places the links cuts one
/// joint of each loop; the loads have the parts Q along the unknowns by this tree, and the forces
/// lambda in the cut joints satisfy
///     J^T lambda = -Q.
/// The other joints follow from the leaves of the tree to the base by sums of forces, and the
/// couples of slides from the last links that they tie by sums of moments.
struct GroupForces {
  structure::LinkTable<LinkLoad> loads;
  std::vector<GiNaC::ex> generalised;           ///< Q, one for each unknown
  std::vector<equations::Vector2> multipliers;  ///< lambda, one for each loop: on the second link
  structure::JointTable<JointReaction> joints;
  /// The components of lambda where they are found in numbers; else empty.
  std::vector<GiNaC::symbol> given;
  equations::Vocabulary vocabulary;  ///< the names of all this, after those of the elimination
};

/// `derivatives`, of the same equations: the links' poses have theirs along the same tree. Without
/// a `jacobian`, as for groups of more than four links, the program that calls solves for lambda.
[[nodiscard]] GroupForces group_forces(const equations::ClosureEquations& equations,
                                       const derivatives::Derivatives& derivatives,
                                       const pivoting::StructuredJacobian* jacobian);

}  // namespace assur::generator::forces
