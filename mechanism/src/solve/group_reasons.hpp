// Reasons why a group has no position, or infinitely many, in words.
#pragma once

#include <assur/mechanism/values.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::solve {

/// The names of a group's joints, or of its prismatic ones alone, in the order of their roles.
[[nodiscard]] std::vector<std::string> joint_names(const Values& values, GroupIndex group,
                                                   bool slides_only);
/// The reason why a group that closes has infinitely many positions.
[[nodiscard]] std::string reason_of_freedom(const Values& values, GroupIndex group);
/// The reason why it is undecided whether a group closes.
[[nodiscard]] std::string reason_of_doubt(const Values& values, GroupIndex group);
/// The reason why a group cannot be assembled if prismatic joints over-determine its angles.
[[nodiscard]] std::string reason_of_conflict(const Values& values, GroupIndex group);
/// The reason why configurations of a group may be missing: fewer isolated complex configurations
/// were found than there are in general position.
[[nodiscard]] std::string reason_of_incompleteness(const Values& values, GroupIndex group,
                                                   int found);

}  // namespace assur::mechanism::solve
