// Turns the forces and coefficients of a configuration into entries of its JSON object.
#pragma once

#include <assur/mechanism/report.hpp>
#include <nlohmann/json.hpp>

namespace assur::mechanism::report {

/// Adds the wanted forces, dynamics and coefficients of a configuration to the entry that has its
/// links, joints and outputs.
void add_forces(const Report& report, const Configuration& configuration,
                nlohmann::ordered_json& entry);

}  // namespace assur::mechanism::report
