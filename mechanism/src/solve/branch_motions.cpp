#include "branch_motions.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/followed_parts.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "all_constraints.hpp"
#include "branch_order.hpp"
#include "group_by_group.hpp"
#include "motions_through.hpp"
#include "moved_by_parameter.hpp"
#include "moving_laws.hpp"
#include "plan/plan_data.hpp"
#include "precision.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

/// Removes the accelerations of a configuration whose velocities are accurate to two digits only,
/// since second rates lose more digits.
void forget_accelerations(const PlanData& plan, Configuration& configuration) {
  for_each_followed(plan.mechanism, plan.structure, configuration, [](auto& part) {
    part.acceleration *= std::numeric_limits<double>::quiet_NaN();
  });
  configuration.rates_known = true;
}

/// The displacement of each driver from its present position, as a series in time. A law that reads
/// links is evaluated once these move.
Table<DriverIndex, models::Series> moving_drivers(const Values& values) {
  const PlanData& plan = values.plan();
  Table<DriverIndex, models::Series> motions;
  motions.resize(plan.mechanism.drivers().size());
  const auto coordinate = [&](JointIndex joint) {
    const DriverIndex other = plan.mechanism.driver_of(joint);
    models::Series moving = motions[other];
    moving.c[0] = values.motion(other).position.value();
    return moving;
  };
  for (const DriverIndex driver : plan.evaluation.drivers) {
    if (!plan.evaluation.reads_links[driver]) {
      motions[driver] = moving_law(values, driver, coordinate);
      motions[driver].c[0] = 0;
    }
  }
  return motions;
}

/// The constraints that the plan leaves out, except those that hold only within a tolerance, since
/// these determine no motion.
std::vector<RedundantJoint> determining(const PlanData& plan) {
  return plan.request.redundancy_tolerance.exists() ? std::vector<RedundantJoint>()
                                                    : plan.redundant;
}

/// Whether a law reads links of a group whose rates are not known.
bool reads_unknown(const Values& values, const PlacedLinks& placed) {
  return std::ranges::any_of(values.plan().structure.reading, [&](const ReadingDriver& reading) {
    return reading.groups_before > 0 &&
           !placed.groups[GroupIndex(reading.groups_before - 1)].rates_known;
  });
}

/// A configuration whose links have the rates of a motion.
Configuration moving_along(const MovingConstraints& F, const Motion& motion,
                           const Configuration& at) {
  Configuration result = at;
  const Mechanism& mechanism = at.plan->mechanism;
  const MovingConstraints::Links links = F.links(motion.parts);
  const Table<LinkIndex, bool> is_driven = at.plan->structure.placed_by_drivers();
  for (const LinkIndex link : mechanism.links().keys()) {
    if (!is_driven[link]) {
      const Pose<models::Series>& pose = links[link];
      result.links[link].velocity << pose.x.rate(), pose.y.rate(), turning_rate(pose.direction);
      result.links[link].acceleration << pose.x.second_rate(), pose.y.second_rate(),
          second_turning_rate(pose.direction);
    }
  }
  for (const OutputIndex output : mechanism.outputs().keys()) {
    const FeatureIndex point = mechanism.outputs()[output].point;
    if (!is_driven[mechanism.features()[point].link]) {
      const Pose<models::Series> place = F.placed(point, links);
      result.outputs[output].velocity << place.x.rate(), place.y.rate();
      result.outputs[output].acceleration << place.x.second_rate(), place.y.second_rate();
    }
  }
  for (SlideState& slide : result.slides) {
    if (!mechanism.driver_of(slide.joint).exists()) {
      const models::Series moved = F.coordinate(slide.joint, links);
      slide.velocity = moved.rate();
      slide.acceleration = moved.second_rate();
    }
  }
  result.rates_known = true;
  if (!motion.is_known_twice) {
    forget_accelerations(*at.plan, result);
  }
  return result;
}

}  // namespace

void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration) {
  const Eigen::Index column = values.plan().evaluation.column_of[parameter];
  if (!moves_drivers_alone(values, parameter) || reads_unknown(values, placed)) {
    return;
  }
  AllConstraints constraints(values, determining(values.plan()));
  const AllConstraints::Poses poses = poses_of(configuration.links);
  constraints.measure(poses);
  GroupByGroup J;
  if (!J.factorise(constraints.blocks(), constraints.jacobian(poses),
                   std::sqrt(constraints.rounding() / one_digit))) {
    return;
  }
  const Eigen::VectorXd f = constraints.along_laws(column);
  const Eigen::VectorXd rates = J.solve(f);
  // A place that is accurate to r / s gives J to r / s.
  constexpr double some = 16;  // growth of a rounding error by several sums and products
  if (!(J.left(rates, f).norm() <=
        some * constraints.rounding() / J.firmness() * std::max(1.0, rates.norm()))) {
    return;  // redundant constraints cease to hold
  }
  const Table<LinkIndex, bool> is_driven = values.plan().structure.placed_by_drivers();
  const AllConstraints::Body::Poses moving = constraints.moving_poses(poses);
  for (std::size_t place = 0; place < moving.size(); ++place) {
    const LinkIndex link = constraints.moving()[place];
    if (!is_driven[link]) {
      configuration.links[link].follows.first.col(column) =
          constraints.body().rates_of(static_cast<int>(place), rates, moving);
    }
  }
  for (SlideState& slide : configuration.slides) {
    if (slide.joint.exists() && !values.plan().mechanism.driver_of(slide.joint).exists()) {
      slide.follows.first(column) =
          measured_slide(values, configuration.links, slide.joint).follows.first(column);
    }
  }
  configuration.path_known = true;
}

void find_branches(const Values& values, Configuration& configuration) {
  const MovingConstraints F(values, determining(values.plan()), configuration,
                            moving_drivers(values));
  const std::optional<std::vector<Motion>> known = motions_through(F);
  if (!known) {
    return;
  }
  std::vector<Configuration> found;
  for (const Motion& motion : *known) {
    found.push_back(moving_along(F, motion, configuration));
  }
  if (found.size() == 1) {
    configuration = std::move(found.front());
    return;
  }
  if (found.empty() && configuration.derivatives_known) {
    forget_accelerations(values.plan(), configuration);
    return;
  }
  put_in_order(values.plan().named_parts, found);
  configuration.branches = std::move(found);
}

}  // namespace assur::mechanism::solve
