// Kind and roles of the group that a set of links forms.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <optional>
#include <vector>

namespace assur::mechanism::plan {

/// The group that `moving` links form with `joints`, if all other links are placed; nothing if no
/// generated group has this graph. The kind is spelled from the first of the group's links in the
/// mechanism's order, and then from its first joints.
[[nodiscard]] std::optional<FoundGroup> find_group(const Linkage& linkage,
                                                   const std::vector<LinkIndex>& moving,
                                                   const std::vector<ElementaryJointIndex>& joints);

/// The group of any graph that they form, with the model that is derived from it. The links, and
/// then the joints, are in the order of their names. Nothing if there is no such model, for the
/// reason in `obstacle`.
[[nodiscard]] std::optional<FoundGroup> derived_group(
    const Linkage& linkage, const std::vector<LinkIndex>& moving,
    const std::vector<ElementaryJointIndex>& joints, std::string& obstacle);

/// Assur's class of the group that `moving` links form with `joints`.
[[nodiscard]] int assur_class_of(const Linkage& linkage, const std::vector<LinkIndex>& moving,
                                 const std::vector<ElementaryJointIndex>& joints);

}  // namespace assur::mechanism::plan
