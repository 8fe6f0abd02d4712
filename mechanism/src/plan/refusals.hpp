// Turns a mechanism with too many constraints into the error that says why it cannot be used.
#pragma once

#include <assur/mechanism/error.hpp>
#include <string>

#include "plan_data.hpp"

namespace assur::mechanism::plan {

/// The error for a mechanism whose redundant joints fail to close by `gap` at least; if that is
/// zero, they close, but not after the drivers advance.
[[nodiscard]] OverConstrained refusal_of_redundant(const PlanData& plan, double gap);

/// The error where the redundant joints hold, but not after the drivers advance. If the
/// mechanism `assembles` there without them, they lock it.
[[nodiscard]] OverConstrained refusal_where_driven_on(const PlanData& plan, bool assembles);

/// The error where no choice of constraints to leave out makes the mechanism's groups known ones,
/// so that it is not known whether the excess constraints hold.
[[nodiscard]] OverConstrained refusal_without_groups(const Mechanism& mechanism,
                                                     const OverConstrained& excess);

/// The error where the mechanism has no configuration even without the redundant joints.
[[nodiscard]] OverConstrained refusal_without_assembly(const PlanData& plan,
                                                       const std::string& reason);

}  // namespace assur::mechanism::plan
