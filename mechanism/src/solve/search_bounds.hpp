// Bounds of a search, and the errors for a search that exceeds them.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <cstddef>
#include <string>

namespace assur::mechanism::solve {

/// The bounds of a search: the groups that it solves, the families that it lists, and the numbers
/// in the list of configurations (800 MB).
inline constexpr std::size_t most_steps = 300000;
inline constexpr std::size_t most_families = 1000;
inline constexpr double most_numbers = 1e8;

/// The largest number of configurations of a mechanism, by the models of its groups.
[[nodiscard]] double most_configurations(const Structure& structure);

/// Throws MechanismError that names the exceeded bound `what` and how to ask for less.
[[noreturn]] void refuse_search(const Structure& structure, const std::string& what);

/// Throws MechanismError where `listed` configurations, with their derivatives with respect to each
/// parameter, leave no room for another one.
void expect_room(const Values& values, std::size_t listed);

}  // namespace assur::mechanism::solve
