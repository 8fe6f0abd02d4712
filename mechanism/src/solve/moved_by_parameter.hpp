// Parts of a mechanism that a parameter moves.
#pragma once

#include <assur/mechanism/values.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Whether a parameter moves drivers alone, and neither links nor the dimensions of groups.
/// Formulas decide this, since a derivative may vanish where a length is longest or shortest, as at
/// a change point.
[[nodiscard]] bool moves_drivers_alone(const Values& values, ParameterIndex parameter);

/// The features of joints and outputs that a parameter moves on their links.
[[nodiscard]] std::vector<FeatureIndex> features_moved_by(const Values& values,
                                                          ParameterIndex parameter);

}  // namespace assur::mechanism::solve
