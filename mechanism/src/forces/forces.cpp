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

Forces forces_of(const Values& values, const Configuration& configuration) {
  const forces::Balance balance(values, configuration);
  const forces::LinkLoads loads = forces::link_loads(values, configuration, balance);
  const Eigen::VectorXd load = balance.rows_of(loads.applied) + balance.rows_of(loads.inertia);
  const Eigen::VectorXd unknowns = forces::LinearEquations(balance.matrix(), balance.threshold(),
                                                           forces::LinearEquations::OfLinks::rows)
                                       .solve(-load);
  forces::ForceReader reader(values.plan().mechanism, balance);
  reader.add_couples(unknowns);
  reader.add_forces(unknowns, forces::directions_of(balance.units()));
  Forces result = reader.take();
  result.ground = forces::ground_resultant(values.plan().mechanism, balance, loads);
  const bool is_determined =
      std::ranges::all_of(result.efforts, [](double effort) { return std::isfinite(effort); }) &&
      std::ranges::all_of(result.joints, &JointForce::is_determined);
  result.reason = is_determined ? "" : balance.reason();
  return result;
}

}  // namespace assur::mechanism
