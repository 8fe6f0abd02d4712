// Turns the frames of an animation into the JSON that a page reads.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "draw/film.hpp"

namespace assur::mechanism::draw {

using Json = nlohmann::ordered_json;

/// Title, unit, sweep, shapes, outputs, events, branches, and the values of the parameters with
/// whether each is its own, not a formula of others; `told` turns the numbers of a branch
/// into JSON: the numbers themselves, or where they are.
[[nodiscard]] Json film_json(const Mechanism& mechanism, const Request& request, const Film& film,
                             const std::function<Json(const std::vector<double>&)>& told);

}  // namespace assur::mechanism::draw
