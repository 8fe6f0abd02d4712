#include "branch_motions.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/followed_parts.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "along_parameter.hpp"
#include "branch_order.hpp"
#include "motions_through.hpp"
#include "moved_by_parameter.hpp"
#include "moving_laws.hpp"
#include "plan/plan_data.hpp"
#include "redundant_joints.hpp"

namespace assur::mechanism::solve {

namespace {

/// Removes the accelerations of a configuration whose velocities are known to two digits, since
/// second rates lose more digits.
void forget_accelerations(const PlanData& plan, Configuration& configuration) {
  for_each_followed(plan.mechanism, plan.structure, configuration, [](auto& part) {
    part.acceleration *= std::numeric_limits<double>::quiet_NaN();
  });
  configuration.rates_known = true;
}

/// The motions of the drivers. A law that reads links is evaluated once these move.
Motions in_time(const Values& values) {
  const PlanData& plan = values.plan();
  Motions motions{{}, true};
  motions.drivers.resize(plan.mechanism.drivers().size());
  const auto coordinate = [&](JointIndex joint) {
    const DriverIndex other = plan.mechanism.driver_of(joint);
    models::Series moving = motions.drivers[other];
    moving.c[0] = values.motion(other).position.value();
    return moving;
  };
  for (const DriverIndex driver : plan.evaluation.drivers) {
    if (!plan.evaluation.reads_links[driver]) {
      motions.drivers[driver] = moving_law(values, driver, coordinate);
      motions.drivers[driver].c[0] = 0;
    }
  }
  return motions;
}

/// The motions of the drivers along a parameter. Where motions meet, their first rates depend on
/// the second rates of the laws, so these are included. Of a law that reads links, only the first
/// rate is known.
Motions along_parameter(const Values& values, ParameterIndex parameter, Eigen::Index column) {
  const AlongParameter along(values, parameter);
  Motions motions{along.laws(), false};
  for (const DriverIndex driver : motions.drivers.keys()) {
    models::Series& motion = motions.drivers[driver];
    const Eigen::VectorXd& follows = values.motion(driver).position.derivatives();
    motion.c[0] = 0;
    motion.c[1] = follows.size() > 0 ? follows(column) : 0;
  }
  return motions;
}

/// Whether a law reads links of a group whose rates are not known.
bool reads_unknown(const Values& values, const PlacedLinks& placed) {
  return std::ranges::any_of(values.plan().structure.reading, [&](const ReadingDriver& reading) {
    return reading.groups_before > 0 &&
           !placed.groups[GroupIndex(reading.groups_before - 1)].rates_known;
  });
}

/// A configuration as it moves: what groups place gets the rates of the motion.
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

/// The motions through a configuration, each as that configuration with its rates.
std::optional<std::vector<Configuration>> moving_configurations(const Values& values,
                                                                const Configuration& configuration,
                                                                const Motions& motions) {
  const PlanData& plan = values.plan();
  // Constraints that need to hold only within a tolerance determine no motion.
  const bool has_tolerance = plan.request.redundancy_tolerance.exists();
  const MovingConstraints F(values, has_tolerance ? std::vector<RedundantJoint>() : plan.redundant,
                            configuration, motions);
  const std::optional<std::vector<Motion>> known = motions_through(F);
  if (!known) {
    return std::nullopt;
  }
  std::vector<Configuration> found;
  for (const Motion& motion : *known) {
    found.push_back(moving_along(F, motion, configuration));
  }
  if (has_tolerance) {
    std::erase_if(found, [&](const Configuration& motion) {
      return !moves_redundantly(values, motion.links);
    });
  }
  return found;
}

/// Takes the derivatives of what groups place with respect to a parameter from a motion along it.
void take_derivatives(const Configuration& motion, Eigen::Index column,
                      Configuration& configuration) {
  const auto take = [column](const auto& from, auto& to) {
    to.follows.first.col(column) << from.velocity;
  };
  const Mechanism& mechanism = configuration.plan->mechanism;
  const Table<LinkIndex, bool> is_driven = configuration.plan->structure.placed_by_drivers();
  for (const LinkIndex link : configuration.links.keys()) {
    if (!is_driven[link]) {
      take(motion.links[link], configuration.links[link]);
    }
  }
  for (const OutputIndex output : configuration.outputs.keys()) {
    if (!is_driven[mechanism.features()[mechanism.outputs()[output].point].link]) {
      take(motion.outputs[output], configuration.outputs[output]);
    }
  }
  for (std::size_t slide = 0; slide < configuration.slides.size(); ++slide) {
    SlideState& of = configuration.slides[slide];
    if (!mechanism.driver_of(of.joint).exists()) {
      of.follows.first(column) = motion.slides[slide].velocity;
    }
  }
}

}  // namespace

void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration) {
  const Eigen::Index column = values.plan().evaluation.column_of[parameter];
  if (!moves_drivers_alone(values, parameter) || reads_unknown(values, placed)) {
    return;
  }
  const auto found =
      moving_configurations(values, configuration, along_parameter(values, parameter, column));
  if (found && found->size() == 1) {
    take_derivatives(found->front(), column, configuration);
    configuration.path_known = true;
  }
}

void find_branches(const Values& values, Configuration& configuration) {
  auto found = moving_configurations(values, configuration, in_time(values));
  if (!found) {
    return;
  }
  if (found->size() == 1) {
    configuration = std::move(found->front());
    return;
  }
  if (found->empty() && configuration.derivatives_known) {
    forget_accelerations(values.plan(), configuration);
    return;
  }
  put_in_order(values.plan().named_parts, *found);
  configuration.branches = std::move(*found);
}

}  // namespace assur::mechanism::solve
