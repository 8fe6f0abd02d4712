// Coordinates of joints between placed links, and their excess beyond limits.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The coordinate of a joint without a driver between placed links of the mechanism.
[[nodiscard]] JointMotion coordinate_of(const Values& values, const Table<LinkIndex, Frame>& links,
                                        const std::vector<SlideState>& slides, JointIndex index);

/// The excess of a joint's coordinate beyond its limits, in radians or the unit of length; 0 within
/// the limits or up to the rounding of the coordinate. The links of the joint must be placed.
[[nodiscard]] double beyond_limits(const Values& values, const Table<LinkIndex, Frame>& links,
                                   const std::vector<SlideState>& slides, JointIndex index);

}  // namespace assur::mechanism::solve
