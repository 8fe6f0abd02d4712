// Turns a configuration into the coordinates of its joints, and these into whether limits are kept.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The coordinate of a joint without a driver, between links of the mechanism that are placed.
[[nodiscard]] JointMotion coordinate_of(const Values& values,
                                        const Table<LinkIndex, Frame>& links,
                                        const std::vector<SlideState>& slides, JointIndex joint);

/// Whether every joint of a configuration keeps its limits, to the rounding of its coordinate.
[[nodiscard]] bool keeps_limits(const Values& values, const Configuration& configuration);

/// Leaves out the configurations that do not, and says so if none is left.
void leave_out_beyond_limits(Solution& solution);

}  // namespace assur::mechanism::solve
