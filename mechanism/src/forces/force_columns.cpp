// Columns for efforts, joint forces and the ground's resultant, and their numbers.
#include <algorithm>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/held_pairs.hpp>

namespace assur::mechanism::forces {

namespace {

/// The reported joints, in the mechanism's order, followed by those that are left out as redundant.
std::vector<std::string> told_joints(const Plan& plan) {
  std::vector<std::string> names;
  for (const JointIndex joint : plan.mechanism().joints().keys()) {
    if (plan.request().reported.has(joint) && !plan.is_stand_in(joint)) {
      names.push_back(plan.mechanism().joints()[joint].name);
    }
  }
  for (const RedundantJoint& joint : plan.redundant()) {
    if (std::ranges::find(names, joint.name) == names.end()) {
      names.push_back(joint.name);
    }
  }
  return names;
}

/// The links of a joint, each once, as named by the plan and its redundant joints.
std::vector<LinkIndex> links_at(const Plan& plan, const std::string& name) {
  std::vector<LinkIndex> links;
  const auto add = [&](FeatureIndex feature) {
    const LinkIndex link = plan.mechanism().features()[feature].link;
    if (std::ranges::find(links, link) == links.end()) {
      links.push_back(link);
    }
  };
  for (const HeldPair& pair : held_pairs(plan.mechanism(), plan.redundant())) {
    if (pair.joint == name) {
      std::ranges::for_each(pair.between, add);
    }
  }
  return links;
}

/// Whether a joint transmits a couple.
bool has_moment(const Plan& plan, const std::string& name) {
  const std::vector<HeldPair> pairs = held_pairs(plan.mechanism(), plan.redundant());
  const auto is_line = [&](FeatureIndex feature) {
    return plan.mechanism().features()[feature].is_line;
  };
  return std::ranges::any_of(pairs, [&](const HeldPair& pair) {
    return pair.joint == name && std::ranges::all_of(pair.between, is_line);
  });
}

}  // namespace

}  // namespace assur::mechanism::forces

namespace assur::mechanism {

std::vector<ForceColumn> force_columns(const Plan& plan) {
  std::vector<ForceColumn> columns;
  if (!plan.request().want.forces) {
    return columns;
  }
  const Mechanism& mechanism = plan.mechanism();
  for (const DriverIndex driver : described_drivers(mechanism)) {
    const Joint& joint = mechanism.joints()[mechanism.drivers()[driver].joint];
    columns.push_back({joint.name, "effort", joint.type == JointType::revolute});
  }
  for (const std::string& joint : forces::told_joints(plan)) {
    const std::vector<LinkIndex> links = forces::links_at(plan, joint);
    for (const LinkIndex link : links) {
      if (links.size() > 2 || link == links.back()) {
        const std::string& on = mechanism.links()[link].name;
        const std::string of = joint + (links.size() > 2 ? "." + on : std::string());
        columns.push_back({of, "fx", false, joint, on});
        columns.push_back({of, "fy", false, joint, on});
      }
    }
    if (forces::has_moment(plan, joint)) {
      columns.push_back({joint, "moment", true, joint, mechanism.links()[links.back()].name});
    }
  }
  columns.insert(columns.end(), {{"ground", "fx"}, {"ground", "fy"}, {"ground", "moment", true}});
  return columns;
}

std::vector<double> force_numbers(const Plan& plan, const Forces& forces) {
  std::vector<double> numbers;
  for (const DriverIndex driver : described_drivers(plan.mechanism())) {
    numbers.push_back(forces.efforts[driver]);
  }
  const auto add = [&](const Eigen::Vector2d& vector) {
    numbers.insert(numbers.end(), {vector.x(), vector.y()});
  };
  for (const std::string& name : forces::told_joints(plan)) {
    const auto joint = std::ranges::find(forces.joints, name, &JointForce::joint);
    for (const auto& [link, force] : joint->on) {
      if (joint->on.size() > 2 || link == joint->on.back().first) {
        add(force);
      }
    }
    if (joint->has_moment) {
      numbers.push_back(joint->moment);
    }
  }
  add(forces.ground.force);
  numbers.push_back(forces.ground.moment);
  return numbers;
}

bool wants_force_sensitivities(const Plan& plan) {
  return plan.request().want.forces && plan.request().want.sensitivity &&
         plan.mechanism().parameters().size() > 0;
}

std::vector<double> force_deviations(const Plan& plan, const Values& values,
                                     const Configuration& configuration) {
  std::vector<double> numbers;
  if (wants_force_sensitivities(plan)) {
    const std::vector<Forces> sensitivities = force_sensitivities(values, configuration);
    numbers = force_numbers(plan, worst_case(sensitivities, values.spread()));
    const std::vector<double> rss =
        force_numbers(plan, root_sum_square(sensitivities, values.spread()));
    numbers.insert(numbers.end(), rss.begin(), rss.end());
  }
  return numbers;
}

}  // namespace assur::mechanism
