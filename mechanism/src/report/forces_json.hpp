// Forces and coefficients of a configuration as JSON.
#pragma once

#include <assur/mechanism/report.hpp>
#include <nlohmann/json.hpp>

namespace assur::mechanism::report {

/// Adds the requested forces, dynamics and coefficients of a configuration to the entry of its
/// links, joints and outputs.
void add_forces(const Report& report, const Configuration& configuration,
                nlohmann::ordered_json& entry);

}  // namespace assur::mechanism::report
