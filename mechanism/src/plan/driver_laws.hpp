// Joints that the laws of drivers read, and the order in which laws can be evaluated.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism::plan {

/// The joints that the law of a driver names.
[[nodiscard]] std::vector<JointIndex> joints_in_law(const Mechanism& mechanism, DriverIndex driver);

/// All drivers, each after those whose laws its own law reads. Throws MechanismError with the names
/// of the joints if laws read one another in a cycle.
[[nodiscard]] std::vector<DriverIndex> laws_in_order(const Mechanism& mechanism);

/// The joints whose coordinates a law takes from the links' poses: those without drivers, in the
/// law itself and in those that it reads. The laws must have an order.
[[nodiscard]] std::vector<JointIndex> joints_read(const Mechanism& mechanism, DriverIndex driver);

}  // namespace assur::mechanism::plan
