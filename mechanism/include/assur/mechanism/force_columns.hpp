// Turns the forces of a configuration into names and numbers, one after the other, for tables.
#pragma once

#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/plan.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// A number of the forces: `A.effort`, `C.fx`, `P.rod.fx`.
struct ForceColumn {
  std::string of;          ///< `A`, `P.rod`
  std::string part;        ///< `effort`, `fx`
  bool is_couple = false;  ///< otherwise it is a force
  std::string joint = {};  ///< that transmits it; empty for an effort, and for the ground
  std::string on = {};     ///< the link on which it acts then

  [[nodiscard]] std::string name() const { return of + "." + part; }
};

/// The wanted forces; none where no forces are wanted.
[[nodiscard]] std::vector<ForceColumn> force_columns(const Plan& plan);
/// The numbers of these columns, for forces or their derivatives; NaN where they are not
/// determined.
[[nodiscard]] std::vector<double> force_numbers(const Plan& plan, const Forces& forces);

/// Whether sensitivities of forces are told.
[[nodiscard]] bool wants_force_sensitivities(const Plan& plan);
/// The numbers of worst case and rss of these columns, one after the other.
[[nodiscard]] std::vector<double> force_deviations(const Plan& plan, const Values& values,
                                                   const Configuration& configuration);

}  // namespace assur::mechanism
