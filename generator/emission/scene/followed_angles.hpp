// Angles that loads and springs read and that a solver continues along a branch.
#pragma once

#include <optional>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// The angle between two features, less a spring's rest angle, which may be absent. Where a branch
/// begins it is within half a turn of zero.
struct FollowedAngle {
  std::vector<mechanism::FeatureIndex> between;
  mechanism::NumberIndex rest;
};

/// The angles of joints that no driver moves, at which a spring acts or which a load reads; none if
/// no forces are wanted. The coordinates of coefficients and dynamics do not depend on them.
[[nodiscard]] std::vector<FollowedAngle> followed_angles(const SolverScene& solver);

/// The angle on the branch, as `placed` has it at the last position; none if it is not followed.
[[nodiscard]] OptionalExpression last_followed(const SolverScene& solver,
                                               const FollowedAngle& angle);

/// Statements that return all followed angles of the placed links; empty if there are none.
[[nodiscard]] cpp::Block following_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
