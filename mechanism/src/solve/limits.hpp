// Turns links that are placed into the coordinates of joints, and these into whether limits are
// kept.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The coordinate of a joint without a driver, between links of the mechanism that are placed.
[[nodiscard]] JointMotion coordinate_of(const Values& values, const Table<LinkIndex, Frame>& links,
                                        const std::vector<SlideState>& slides, JointIndex joint);

/// By how much a joint with limits is beyond them, where what it joins is placed: radians, or the
/// unit of length; 0 where it keeps them, to the rounding of its coordinate.
[[nodiscard]] double beyond_limits(const Values& values, const Table<LinkIndex, Frame>& links,
                                   const std::vector<SlideState>& slides, JointIndex joint);

}  // namespace assur::mechanism::solve
