// Turns a printed table of kinds into findings against the derived kinematic models.
#pragma once

#include <map>

#include "audit/finding.hpp"
#include "structure/group.hpp"

namespace assur::generator::audit {

/// Rows `NUMBER : KIND, KIND, ... [: FAMILY]`. Each kind is asked whether it belongs to the model
/// of that number, each row for kinds that it leaves out, and each family whether the group is a
/// structure: it is if and only if all its loops are of family 3.
[[nodiscard]] std::vector<Finding> audit_kinds(const structure::Group& group,
                                               const std::vector<closures::PlacedText>& rows,
                                               const std::string& file);

/// Numbers that a text about a group may print: `kinds`, `models`, `rigid_models`,
/// `degenerate_models`, `rigid_kinds`, and `mobility_1` and so on, each model's mobility when it
/// can be assembled.
[[nodiscard]] std::map<std::string, double> group_numbers(const structure::Group& group);

}  // namespace assur::generator::audit
