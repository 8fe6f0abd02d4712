// Turns places of links into whether joints beyond those that determine them hold.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/status.hpp>
#include <string>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

/// Whether the rates of the redundant joints of a plan hold to rounding, where all rates are known,
/// and where the configuration is regular, which tells them well enough, their second rates.
[[nodiscard]] bool goes_on_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                                       Status regularity);

/// Whether they hold along one of several motions through a configuration in which they do: to
/// first and second order, for at a change point all motions agree to first order.
[[nodiscard]] bool moves_redundantly(const Values& values, const Table<LinkIndex, Frame>& links);

/// By how much the worst redundant joint fails to close, in the scene's unit; zero where all do, to
/// rounding or to the tolerance that the request states.
[[nodiscard]] double gap_of_redundant(const Values& values, const Table<LinkIndex, Frame>& links,
                                      Status regularity);

/// What is said of a mechanism whose redundant joints fail to close by a gap at least; if that is
/// zero, they close at its own numbers alone.
[[nodiscard]] OverConstrained refusal_of_redundant(const PlanData& plan, double gap);

/// What is said where they hold, but not where the drivers have gone on: if it can be assembled
/// there without them, they lock it.
[[nodiscard]] OverConstrained refusal_where_driven_on(const PlanData& plan, bool assembles);

/// What is said where the mechanism has no configuration without them either, for a reason.
[[nodiscard]] OverConstrained refusal_without_assembly(const PlanData& plan,
                                                       const std::string& reason);

}  // namespace assur::mechanism::solve
