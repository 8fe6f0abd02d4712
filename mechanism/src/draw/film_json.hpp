// Frames of an animation as the JSON of a page.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "draw/film.hpp"

namespace assur::mechanism::draw {

using Json = nlohmann::ordered_json;

/// Title, unit, sweep, shapes, outputs, events, branches, and the values of the parameters, each
/// with a flag that it is given and not a formula of others; `told` converts the numbers of a
/// branch to JSON: the numbers themselves, or their location.
[[nodiscard]] Json film_json(const Mechanism& mechanism, const Request& request, const Film& film,
                             const std::function<Json(const std::vector<double>&)>& told);

}  // namespace assur::mechanism::draw
