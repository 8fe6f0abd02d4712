// Turns a group of a scene into the numbers of its specialised model.
#pragma once

#include <utility>
#include <vector>

#include "emission/solver_scene.hpp"
#include "emission/specialised_group.hpp"
#include "scene/group_pose.hpp"

namespace assur::generator {

/// A group of the scene with its links in normal form. Throws InputError for a degenerate one.
[[nodiscard]] PosedGroup normal_group(const SolverScene& solver, std::size_t index);

/// The external joints of a group in its order, each with the link that holds it.
[[nodiscard]] std::vector<std::pair<const MechanismJoint*, int>> external_joints(
    const SolverScene& solver, const PosedGroup& group);

/// The group's dimensions, and its inputs as far as the ground holds them.
[[nodiscard]] GroupNumbers group_numbers(const SolverScene& solver, const PosedGroup& group);

/// The group specialised to its numbers. Throws InputError if these leave no closed form.
[[nodiscard]] SpecialisedGroup specialised_group_of(const SolverScene& solver,
                                                    const PosedGroup& group, std::size_t index);

}  // namespace assur::generator
