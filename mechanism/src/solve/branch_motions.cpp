#include "branch_motions.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/followed_parts.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "all_constraints.hpp"
#include "along_parameter.hpp"
#include "branch_order.hpp"
#include "branch_walk.hpp"
#include "moved_by_parameter.hpp"
#include "moving_laws.hpp"
#include "plan/plan_data.hpp"
#include "precision.hpp"
#include "redundant_joints.hpp"
#include "settled_redundancy.hpp"

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

/// Takes the derivatives with respect to a parameter from a motion along it.
void take_derivatives(const Configuration& motion, Eigen::Index column,
                      Configuration& configuration) {
  const auto take = [column](const auto& from, auto& to) {
    to.follows.first.col(column) << from.velocity;
  };
  for (const LinkIndex link : configuration.links.keys()) {
    take(motion.links[link], configuration.links[link]);
  }
  for (const OutputIndex output : configuration.outputs.keys()) {
    take(motion.outputs[output], configuration.outputs[output]);
  }
  for (std::size_t slide = 0; slide < configuration.slides.size(); ++slide) {
    configuration.slides[slide].follows.first(column) = motion.slides[slide].velocity;
  }
}

/// Whether the constraints that the plan leaves out allow a motion of the rest of the mechanism.
bool is_motion_of_all(const Values& values, const Configuration& motion) {
  if (!SettledRedundancy::can_close(values.plan())) {
    return moves_redundantly(values, motion.links);
  }
  AllConstraints constraints(values);
  constraints.measure(poses_of(motion.links));
  return constraints.allow_velocities(motion.links);
}

}  // namespace

void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration) {
  const Eigen::Index column = values.plan().evaluation.column_of[parameter];
  if (!moves_drivers_alone(values, parameter) || reads_unknown(values, placed)) {
    return;
  }
  const auto found =
      motions_through(values, placed, configuration, along_parameter(values, parameter, column));
  if (found && found->size() == 1) {
    take_derivatives(found->front(), column, configuration);
    configuration.path_known = true;
  }
}

void find_branches(const Values& values, const PlacedLinks& placed, Configuration& configuration) {
  auto known = motions_through(values, placed, configuration, in_time(values));
  if (!known) {
    return;
  }
  std::vector<Configuration>& found = *known;
  // A motion that the left-out constraints would stop is not a motion of the mechanism.
  if (!values.plan().redundant.empty()) {
    std::erase_if(found,
                  [&](const Configuration& motion) { return !is_motion_of_all(values, motion); });
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
