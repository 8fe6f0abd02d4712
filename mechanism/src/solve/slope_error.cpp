#include "slope_error.hpp"

#include <Eigen/LU>
#include <limits>

#include "all_constraints.hpp"
#include "moved_by_parameter.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

double slope_error(const Values& values, const Configuration& configuration, Eigen::Index column) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  constexpr std::size_t most_tried_links = 100;
  constexpr double short_step = 1e-5;  // halves the digits that a difference of J keeps
  const PlanData& plan = values.plan();
  if (!plan.redundant.empty() || !plan.structure.reading.empty() ||
      plan.mechanism.links().size() > most_tried_links ||
      !moves_drivers_alone(values, plan.evaluation.columns[static_cast<std::size_t>(column)])) {
    return unknown;
  }
  AllConstraints constraints(values);
  AllConstraints::Links links = configuration.links;
  const AllConstraints::Poses poses = poses_of(links);
  constraints.measure(poses);
  const Eigen::MatrixXd inverse = constraints.jacobian(poses).partialPivLu().inverse();
  for (Frame& link : links) {
    link.velocity.setZero();
    link.follows.set_zero(std::ssize(values.columns()), false);
  }
  const Eigen::VectorXd slopes = inverse * constraints.first_rates(links).col(1 + column);
  const double steepest = slopes.cwiseAbs().maxCoeff();
  if (!(steepest > 0 && steepest < unknown)) {
    return unknown;
  }
  const double step = short_step / steepest;
  AllConstraints::Poses before = poses;
  AllConstraints::Poses after = poses;
  constraints.move(-step * slopes, before);
  constraints.move(step * slopes, after);
  const Eigen::MatrixXd bent =
      (constraints.jacobian(after) - constraints.jacobian(before)) / (2 * step);
  const Eigen::MatrixXd effects = inverse * bent * inverse;
  const double most = effects.cwiseAbs().rowwise().sum().maxCoeff();
  const Eigen::VectorXd off =
      inverse * constraints.first_rates(configuration.links).col(1 + column);
  const double error = off.cwiseAbs().maxCoeff() + constraints.rounding() * most;
  return off.allFinite() ? error / steepest : unknown;
}

}  // namespace assur::mechanism::solve
