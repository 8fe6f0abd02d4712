// The parameters of a scene that can be arguments of its solver.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// The parameters on which the positions of joints and outputs depend and that depend on no others.
/// A parameter that is a formula in others would no longer follow them if it were an argument.
[[nodiscard]] std::vector<mechanism::ParameterIndex> independent_parameters(
    const mechanism::Scene& scene);

/// Throws MechanismError for a parameter that the solver would not read: no reported result depends
/// on it, or only the law of a driver, and drivers are arguments themselves.
void expect_arguments(const mechanism::Plan& plan,
                      const std::vector<mechanism::ParameterIndex>& parameters);

}  // namespace assur::generator::emission::scene
