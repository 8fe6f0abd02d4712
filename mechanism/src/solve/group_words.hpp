// Turns a group that has no position, or infinitely many, into the words by which this is told.
#pragma once

#include <assur/mechanism/values.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::solve {

/// With three digits.
[[nodiscard]] std::string short_number(double number);

/// The names of a group's joints, or of its prismatic ones alone, in the order of their roles.
[[nodiscard]] std::vector<std::string> joint_names(const Values& values, GroupIndex group,
                                                   bool slides_only);
/// Why a group that closes has no position of its own.
[[nodiscard]] std::string reason_of_freedom(const Values& values, GroupIndex group);
/// Why no group of its model has one, whether or not its angles are compatible where it is held.
[[nodiscard]] std::string reason_of_model(const Values& values, GroupIndex group, bool compatible);

}  // namespace assur::mechanism::solve
