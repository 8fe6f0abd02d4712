// Mass matrix, bias and load of the equations of motion.
#include <assur/mechanism/forces.hpp>
#include <assur/support/rigid_motion.hpp>
#include <limits>

#include "balance.hpp"
#include "coefficients.hpp"
#include "link_loads.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism {

/// With h the first coefficients of a mass centre, k those of its link's angle, and a0, alpha0 the
/// accelerations without those of the coordinates:
///     M = sum m h h + I k k,  bias = sum m h a0 + I k alpha0,  load = sum f h + M k.
Dynamics dynamics_of(const Values& values, const Configuration& configuration) {
  using Eigen::Vector2d;
  const Mechanism& mechanism = values.plan().mechanism;
  const forces::Balance balance(values, configuration);
  const KinematicCoefficients coefficients =
      forces::first_coefficients(values, configuration, balance);
  const forces::LinkLoads loads = forces::link_loads(values, configuration, balance);
  const Eigen::Index count = std::ssize(coefficients.drivers);
  Dynamics result{coefficients.drivers, Eigen::MatrixXd::Zero(count, count),
                  Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), ""};
  Eigen::VectorXd accelerations(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    accelerations(i) =
        values.motion(coefficients.drivers[static_cast<std::size_t>(i)]).acceleration;
  }
  for (const forces::MassCentre& centre : forces::mass_centres(values, configuration)) {
    if (centre.link == mechanism.ground()) {
      continue;
    }
    const ParameterRows<3>& frame = coefficients.links[centre.link].first;
    ParameterRows<3> h(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      h.col(i) << support::carried<double>(frame.col(i), centre.arm, Vector2d::Zero()), frame(2, i);
    }
    const Eigen::Vector3d mass(centre.mass, centre.mass, centre.inertia);
    Eigen::Vector3d at_rest;
    at_rest << centre.acceleration, configuration.links[centre.link].acceleration(2);
    at_rest -= h * accelerations;
    result.mass_matrix += h.transpose() * mass.asDiagonal() * h;
    result.bias += h.transpose() * mass.cwiseProduct(at_rest);
  }
  for (const LinkIndex link : mechanism.links().keys()) {
    if (link == mechanism.ground()) {
      continue;
    }
    const Wrench& load = loads.applied[link];
    if (load.force.isZero(0) && load.moment == 0) {
      continue;
    }
    const Pose<double>& pose = configuration.links[link].pose;
    const Vector2d arm = balance.pivots()[link] - Vector2d(pose.x, pose.y);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto frame = coefficients.links[link].first.col(i);
      result.load(i) += load.force.dot(support::carried<double>(frame, arm, Vector2d::Zero())) +
                        load.moment * frame(2);
    }
  }
  if (!loads.unknown_pulls.empty()) {
    result.load.setConstant(std::numeric_limits<double>::quiet_NaN());
    result.reason = loads.reason;
  }
  if (!result.mass_matrix.allFinite() || !result.bias.allFinite() ||
      (loads.unknown_pulls.empty() && !result.load.allFinite())) {
    result.reason += (result.reason.empty() ? "" : "; ") + balance.reason();
  }
  return result;
}

}  // namespace assur::mechanism
