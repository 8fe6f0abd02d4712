// Turns a parameter into the parts of a mechanism that it moves.
#pragma once

#include <assur/mechanism/values.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Whether a parameter moves drivers alone, and neither links nor the dimensions of groups.
/// Formulas tell, since a derivative may be zero where a length is longest or shortest, as at a
/// change point.
[[nodiscard]] bool moves_drivers_alone(const Values& values, ParameterIndex parameter);

/// The features of joints and outputs that a parameter moves on their links.
[[nodiscard]] std::vector<FeatureIndex> features_moved_by(const Values& values,
                                                          ParameterIndex parameter);

}  // namespace assur::mechanism::solve
