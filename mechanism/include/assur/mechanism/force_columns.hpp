// Names and numbers of a configuration's forces, for the columns of tables.
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
  std::string joint = {};  ///< the joint that transmits it; empty for an effort, and for the ground
  std::string on = {};     ///< the link on which that joint force acts

  [[nodiscard]] std::string name() const { return of + "." + part; }
};

/// The columns of the requested forces; none if no forces are requested.
[[nodiscard]] std::vector<ForceColumn> force_columns(const Plan& plan);
/// The numbers of these columns, for forces or their derivatives; NaN where they are not
/// determined.
[[nodiscard]] std::vector<double> force_numbers(const Plan& plan, const Forces& forces);

/// Whether sensitivities of forces are reported.
[[nodiscard]] bool wants_force_sensitivities(const Plan& plan);
/// The worst-case and root-sum-square deviations of these columns, column by column.
[[nodiscard]] std::vector<double> force_deviations(const Plan& plan, const Values& values,
                                                   const Configuration& configuration);

}  // namespace assur::mechanism
