// Forces in a configuration, from the equilibrium of its links.
#include <algorithm>
#include <assur/mechanism/forces.hpp>
#include <cmath>

#include "force_reader.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism {

bool JointForce::is_determined() const {
  return std::ranges::all_of(on, [](const auto& part) { return part.second.allFinite(); }) &&
         std::isfinite(moment);
}

/// Unknown pulls of springs and dampers are unknowns, after those of joints.
Forces forces_of(const Values& values, const Configuration& configuration) {
  using forces::LinearEquations;
  const forces::Balance balance(values, configuration);
  const forces::LinkLoads loads = forces::link_loads(values, configuration, balance);
  const Eigen::VectorXd load = balance.rows_of(loads.applied) + balance.rows_of(loads.inertia);
  const auto solved = [&](const std::vector<forces::Reaction>& pulls) -> Eigen::VectorXd {
    const LinearEquations equations(balance.matrix_with(pulls), balance.threshold(),
                                    LinearEquations::OfLinks::rows);
    return equations.solve(-load).topRows(balance.matrix().cols());
  };
  const Eigen::VectorXd unknowns = solved(loads.unknown_pulls);
  forces::ForceReader reader(values.plan().mechanism, balance);
  reader.add_couples(unknowns);
  reader.add_forces(unknowns, forces::directions_of(balance.units()));
  Forces result = reader.take();
  result.ground = forces::ground_resultant(values.plan().mechanism, balance, loads);
  const bool is_ground_known =
      result.ground.force.allFinite() && std::isfinite(result.ground.moment);
  if (!unknowns.allFinite() || !is_ground_known) {
    result.reason = loads.reason;
    if (loads.unknown_pulls.empty() || !is_ground_known || !solved({}).allFinite()) {
      result.reason += (result.reason.empty() ? "" : "; ") + balance.reason();
    }
  }
  return result;
}

}  // namespace assur::mechanism
