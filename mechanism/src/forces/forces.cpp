// Forces in a configuration, from the equilibrium of its links.
#include <algorithm>
#include <assur/mechanism/forces.hpp>
#include <cmath>

#include "force_reader.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::forces {

namespace {

/// Whether all efforts and all forces in joints are determined.
bool are_determined(const Forces& forces) {
  return std::ranges::all_of(forces.efforts, [](double effort) { return std::isfinite(effort); }) &&
         std::ranges::all_of(forces.joints, &JointForce::is_determined);
}

}  // namespace

}  // namespace assur::mechanism::forces

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
  const auto told = [&](const std::vector<forces::Reaction>& pulls) {
    forces::LinearSolution unknowns =
        LinearEquations(balance.matrix_with(pulls), balance.threshold(),
                        LinearEquations::OfLinks::rows)
            .solution(-load);
    const Eigen::Index count = balance.matrix().cols();
    const std::vector<Eigen::Vector2d> directions = forces::directions_of(balance.units());
    forces::ForceReader reader(values.plan().mechanism, balance);
    unknowns.null_space.conservativeResize(count, Eigen::NoChange);
    reader.add(unknowns.shortest.topRows(count), directions);
    reader.forget(unknowns, directions);
    return reader.take();
  };
  Forces result = told(loads.unknown_pulls);
  result.ground = forces::ground_resultant(values.plan().mechanism, balance, loads);
  const bool is_ground_known =
      result.ground.force.allFinite() && std::isfinite(result.ground.moment);
  if (!forces::are_determined(result) || !is_ground_known) {
    result.reason = loads.reason;
    if (loads.unknown_pulls.empty() || !is_ground_known || !forces::are_determined(told({}))) {
      result.reason += (result.reason.empty() ? "" : "; ") + balance.reason();
    }
  }
  return result;
}

}  // namespace assur::mechanism
