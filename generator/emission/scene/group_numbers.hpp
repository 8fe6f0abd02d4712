// Turns a group of a scene into the numbers of its specialised model.
#pragma once

#include <vector>

#include "emission/scene/solver_scene.hpp"
#include "emission/scene/specialised_group.hpp"

namespace assur::generator::emission::scene {

/// An external joint of a group, and the link that holds it.
struct ExternalJoint {
  const mechanism::ElementaryJoint* joint;
  mechanism::LinkIndex base;

  [[nodiscard]] LinkFeature<mechanism::Dual> feature(const SolverScene& solver) const {
    return solver.values.feature(joint->on(base), joint->prismatic);
  }
};

/// The links of a group in normal form. Throws MechanismError for a degenerate group.
[[nodiscard]] const mechanism::GroupGeometry<mechanism::Dual>& normal_group(
    const SolverScene& solver, mechanism::GroupIndex group);

/// The external joints of a group in its order.
[[nodiscard]] std::vector<ExternalJoint> external_joints(const SolverScene& solver,
                                                         mechanism::GroupIndex group);

/// What is needed of the frames of the group's links, in the order of its model.
[[nodiscard]] std::vector<FrameNeed> frame_needs(const SolverScene& solver,
                                                 mechanism::GroupIndex group);

/// The group's dimensions, and its inputs as far as the ground holds them.
[[nodiscard]] GroupNumbers group_numbers(const SolverScene& solver, mechanism::GroupIndex group);

/// The group specialised to its numbers. Throws MechanismError if these leave no closed form.
[[nodiscard]] SpecialisedGroup specialised_group_of(const SolverScene& solver,
                                                    mechanism::GroupIndex group);

}  // namespace assur::generator::emission::scene
