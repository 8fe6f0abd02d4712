// The numbers of a scene's group for its specialised model.
#pragma once

#include <vector>

#include "emission/scene/solver_scene.hpp"
#include "emission/scene/specialised_group.hpp"

namespace assur::generator::emission::scene {

/// An external joint of a group, and the link that holds it.
struct ExternalJoint {
  const mechanism::ElementaryJoint* joint;
  mechanism::LinkIndex base;
  bool is_in_frame;  ///< whether `base` is the ground, or the group is solved relative to it

  [[nodiscard]] LinkFeature<SceneNumber> feature(const SolverScene& solver) const {
    return solver.numbers.feature(*joint, base);
  }
  /// The frame of that link; empty if it is the frame of the group.
  [[nodiscard]] OptionalExpression frame(const SolverScene& solver) const {
    return is_in_frame ? std::nullopt : solver.placed(base);
  }
  /// Whether the joint is fixed in the group's frame at every time and for all parameters.
  [[nodiscard]] bool is_fixed(const SolverScene& solver) const;
  /// Whether the joint moves in the group's frame with time.
  [[nodiscard]] bool moves(const SolverScene& solver) const;
};

/// The links of a group in normal form. Throws MechanismError for a degenerate group.
[[nodiscard]] const mechanism::GroupGeometry<SceneNumber>& normal_group(
    const SolverScene& solver, mechanism::GroupIndex group);

/// The external joints of a group in its order.
[[nodiscard]] std::vector<ExternalJoint> external_joints(const SolverScene& solver,
                                                         mechanism::GroupIndex group);

/// The needed parts of the frames of the group's links, in the order of its model.
[[nodiscard]] std::vector<FrameNeed> frame_needs(const SolverScene& solver,
                                                 mechanism::GroupIndex group);

/// For each dimension of a group's model, whether drivers move it.
[[nodiscard]] std::vector<bool> moving_dimensions(const SolverScene& solver,
                                                  mechanism::GroupIndex group);

/// The group's dimensions, and those of its inputs that the ground holds.
[[nodiscard]] SpecialisedNumbers specialised_numbers(const SolverScene& solver,
                                                     mechanism::GroupIndex group);

/// The group specialised to its numbers. Throws MechanismError as `normal_group` does.
[[nodiscard]] SpecialisedGroup specialised_group_of(const SolverScene& solver,
                                                    mechanism::GroupIndex group);

}  // namespace assur::generator::emission::scene
