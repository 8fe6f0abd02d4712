// Turns a parameter into what of a mechanism it moves.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// Whether a parameter moves drivers alone, and neither links nor the dimensions of groups.
/// `column`: its place among those to which derivatives are taken.
[[nodiscard]] bool moves_drivers_alone(const Values& values, Eigen::Index column);

}  // namespace assur::mechanism::solve
