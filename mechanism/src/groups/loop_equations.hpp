// The loop closures of a group at given numbers.
#pragma once

#include <assur/loops/loop_equations.hpp>
#include <vector>

#include "groups/loops.hpp"
#include "groups/placed_links.hpp"

namespace assur::mechanism::groups {

using LoopEquations = loops::LoopEquations<loops::AnySizes>;

[[nodiscard]] LoopEquations loop_equations(const Loops& loops,
                                           const std::vector<JointFeatures<double>>& features);

}  // namespace assur::mechanism::groups
