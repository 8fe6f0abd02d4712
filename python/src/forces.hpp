// Turns the forces of one configuration into dictionaries.
#pragma once

#include <pybind11/pybind11.h>

#include "solved_scene.hpp"

namespace assur::python {

/// The efforts, the forces in joints and the resultant on the ground, under the names of the
/// report; with sensitivities wanted, also these, with worst case and rss. Throws NotWanted where
/// the scene does not want forces.
[[nodiscard]] pybind11::dict forces_in(const SolvedScene& solved, std::size_t place);

}  // namespace assur::python
