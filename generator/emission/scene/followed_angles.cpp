#include "emission/scene/followed_angles.hpp"

#include <algorithm>
#include <utility>

#include "emission/scene/carried_links.hpp"

namespace assur::generator::emission::scene {

namespace {

bool is_same(const FollowedAngle& one, const FollowedAngle& other) {
  return one.between == other.between && one.rest == other.rest;
}

/// Whether a joint without a line has this pair of features, and no driver.
bool turns_freely(const mechanism::Mechanism& mechanism,
                  const std::vector<mechanism::FeatureIndex>& between) {
  const auto is_line = [&](mechanism::FeatureIndex at) { return mechanism.features()[at].is_line; };
  const auto moves = [&](const mechanism::Driver& driver) {
    return mechanism.joints()[driver.joint].between == between;
  };
  return std::ranges::none_of(between, is_line) && std::ranges::none_of(mechanism.drivers(), moves);
}

}  // namespace

std::vector<FollowedAngle> followed_angles(const SolverScene& solver) {
  std::vector<FollowedAngle> angles;
  if (!solver.plan.request().want.forces && !solver.plan.request().want.dynamics) {
    return angles;
  }
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto add = [&](FollowedAngle angle) {
    if (turns_freely(mechanism, angle.between) &&
        std::ranges::none_of(angles,
                             [&](const FollowedAngle& known) { return is_same(known, angle); })) {
      angles.push_back(std::move(angle));
    }
  };
  for (const mechanism::Spring& spring : mechanism.loading().springs) {
    if (spring.at_joint) {
      add({{spring.between.begin(), spring.between.end()}, spring.rest});
    }
  }
  for (const mechanism::Load& load : mechanism.loading().loads) {
    for (const mechanism::NumberIndex number : {load.force_x, load.force_y, load.moment}) {
      if (!number.exists()) {
        continue;
      }
      for (const mechanism::JointIndex joint : mechanism.numbers()[number].formula.joints()) {
        add({mechanism.joints()[joint].between, {}});
      }
    }
  }
  return angles;
}

OptionalExpression last_followed(const SolverScene& solver, const FollowedAngle& angle) {
  const std::vector<FollowedAngle> angles = followed_angles(solver);
  const auto found = std::ranges::find_if(
      angles, [&](const FollowedAngle& known) { return is_same(known, angle); });
  if (found == angles.end()) {
    return std::nullopt;
  }
  return cpp::variable("placed")
      .member("followed")
      .item(static_cast<std::size_t>(found - angles.begin()));
}

cpp::Block following_statements(const SolverScene& solver) {
  FunctionBody body = solver.body();
  std::vector<cpp::Expression> continued;
  for (const FollowedAngle& angle : followed_angles(solver)) {
    const auto frame_of = [&](mechanism::FeatureIndex feature) {
      return nested_frames({solver.placed(solver.mechanism().features()[feature].link)});
    };
    cpp::Expression position = cpp::call(cpp::scalar_only("support::angle_between"),
                                         {frame_of(angle.between[0]), frame_of(angle.between[1])})
                                   .member("position");
    if (angle.rest.exists()) {
      position =
          cpp::sum({position, cpp::negative(body.number(solver.numbers.number(angle.rest)))});
    }
    continued.push_back(cpp::call(cpp::scalar_only("support::continued_angle"),
                                  {position, *last_followed(solver, angle)}));
  }
  if (continued.empty()) {
    return {};
  }
  body.add(cpp::returned(cpp::braces("", {cpp::braces("", std::move(continued))})));
  return body.block();
}

}  // namespace assur::generator::emission::scene
