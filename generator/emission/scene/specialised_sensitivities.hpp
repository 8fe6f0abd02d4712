// Functions for the sensitivities of a group to a scene's parameters.
#pragma once

#include <vector>

#include "derivatives/differentiate.hpp"
#include "emission/model/model_functions.hpp"
#include "emission/scene/specialised_group.hpp"

namespace assur::generator::emission::scene {

/// The derivatives of the closures and of the poses of the links: by parameters, through the
/// dimensions and the ground, and by the inputs.
[[nodiscard]] std::vector<model::ModelFunction> sensitivity_functions(
    const SpecialisedNumbers& numbers, const derivatives::Derivatives& derivatives);

}  // namespace assur::generator::emission::scene
