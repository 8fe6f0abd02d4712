// Turns the laws of drivers into what they read, and into an order in which they can be computed.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism::plan {

/// The joints that the law of a driver names.
[[nodiscard]] std::vector<JointIndex> joints_in_law(const Mechanism& mechanism, DriverIndex driver);

/// All drivers, each behind those whose laws its own law reads. Throws MechanismError with the
/// names of the joints where laws read one another in a circle.
[[nodiscard]] std::vector<DriverIndex> laws_in_order(const Mechanism& mechanism);

/// The joints whose coordinates a law reads from where links are: those without drivers, in the law
/// itself and in those that it reads. The laws must have an order.
[[nodiscard]] std::vector<JointIndex> joints_read(const Mechanism& mechanism, DriverIndex driver);

}  // namespace assur::mechanism::plan
