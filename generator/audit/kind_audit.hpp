// Audits a printed table of kinds against the derived kinematic models.
#pragma once

#include <map>

#include "audit/finding.hpp"
#include "structure/group.hpp"

namespace assur::generator::audit {

/// Rows `NUMBER : KIND, KIND, ... [: FAMILY]`. Checks whether each kind belongs to the model of
/// that number, which kinds a row omits, and whether the family is right: a model is a structure if
/// and only if its family is 3.
[[nodiscard]] std::vector<Finding> audit_kinds(const structure::Group& group,
                                               const std::vector<closures::PlacedText>& rows,
                                               const std::string& file);

/// Numbers that a text about a group may print: `kinds`, `models`, `rigid_models`,
/// `degenerate_models`, `rigid_kinds`, and `mobility_1` and so on, each model's mobility where it
/// can be assembled.
[[nodiscard]] std::map<std::string, double> group_numbers(const structure::Group& group);

}  // namespace assur::generator::audit
