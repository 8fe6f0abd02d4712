// Turns the forces of a configuration into names and numbers, one after the other, for tables.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::report {

/// The columns of the wanted forces, `A.effort`, `C.fx`; none where no forces are wanted.
[[nodiscard]] std::vector<std::string> force_columns(const Plan& plan);
/// The numbers of these columns; NaN where a force is not determined.
[[nodiscard]] std::vector<double> force_numbers(const Plan& plan, const Values& values,
                                                const Configuration& configuration);

}  // namespace assur::mechanism::report
