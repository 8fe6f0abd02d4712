// Errors that say why an over-constrained mechanism cannot be used.
#pragma once

#include <assur/mechanism/error.hpp>
#include <string>

#include "plan_data.hpp"

namespace assur::mechanism::plan {

/// The error for a mechanism whose redundant joints fail to close by `gap` at least; if that is
/// zero, they close, but not after the drivers advance.
[[nodiscard]] OverConstrained refusal_of_redundant(const PlanData& plan, double gap);

/// The error if the redundant joints hold, but not after the drivers advance. If the mechanism
/// `assembles` there without them, they lock it.
[[nodiscard]] OverConstrained refusal_where_driven_on(const PlanData& plan, bool assembles);

/// The error if no choice of constraints to leave out gives supported groups, so that it is unknown
/// whether the excess constraints hold.
[[nodiscard]] OverConstrained refusal_without_groups(const Mechanism& mechanism,
                                                     const OverConstrained& excess);

/// The error if the mechanism has no configuration even without the redundant joints.
[[nodiscard]] OverConstrained refusal_without_assembly(const PlanData& plan,
                                                       const std::string& reason);

}  // namespace assur::mechanism::plan
