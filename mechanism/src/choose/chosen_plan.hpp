// Choice of a mechanism's plan, by trial if constraints are redundant.
#pragma once

#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <memory>

#include "plan/plan_data.hpp"

namespace assur::mechanism::choose {

/// Returns the plan of the mechanism, or of the part on which the reported parts depend. An
/// over-constrained mechanism is planned without the excess constraints, if these hold where the
/// others do. Whole joints are left out first, since that gives the smallest groups; such groups
/// may move freely where the mechanism does not, as a coupler does on parallel cranks. Throws
/// MechanismError as the constructor of Plan does.
[[nodiscard]] std::shared_ptr<const PlanData> chosen_plan(const Mechanism& mechanism,
                                                          const Request& request);

}  // namespace assur::mechanism::choose
