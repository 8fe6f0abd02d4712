// Turns a search that grows beyond its bounds into the error that says how to ask for less.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <cstddef>
#include <string>

namespace assur::mechanism::solve {

/// What a search takes at most: groups that are solved, families that are told, and numbers that
/// the list of configurations holds (800 MB).
inline constexpr std::size_t most_steps = 300000;
inline constexpr std::size_t most_families = 1000;
inline constexpr double most_numbers = 1e8;

/// How many configurations a mechanism has at most, by the models of its groups.
[[nodiscard]] double most_configurations(const Structure& structure);

/// Throws MechanismError, which says what is too much and what to do.
[[noreturn]] void refuse_search(const Structure& structure, const std::string& what);

/// Throws likewise where so many configurations, with their derivatives to each parameter, leave no
/// room for another one.
void expect_room(const Values& values, std::size_t listed);

}  // namespace assur::mechanism::solve
