// Turns links that can only be solved together into a group of known structure: kind and roles.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <optional>
#include <vector>

namespace assur::mechanism::plan {

/// The group that `moving` links form with `joints`, if all other links are placed; nothing if no
/// known group has this graph. The kind is spelled from the first of the group's links in the
/// mechanism's order, and then from its first joints.
[[nodiscard]] std::optional<FoundGroup> find_group(const Linkage& linkage,
                                                   const std::vector<LinkIndex>& moving,
                                                   const std::vector<ElementaryJointIndex>& joints);

/// The group that they form, whatever its graph is, with the model that is derived from it. The
/// links, and then the joints, are in the order of their names. Nothing where there is no such
/// model: `obstacle` then tells why.
[[nodiscard]] std::optional<FoundGroup> derived_group(
    const Linkage& linkage, const std::vector<LinkIndex>& moving,
    const std::vector<ElementaryJointIndex>& joints, std::string& obstacle);

/// Assur's class of the group that `moving` links form with `joints`.
[[nodiscard]] int assur_class_of(const Linkage& linkage, const std::vector<LinkIndex>& moving,
                                 const std::vector<ElementaryJointIndex>& joints);

}  // namespace assur::mechanism::plan
