#include "followed_angles.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/support/rigid_motion.hpp>

namespace assur::mechanism::follow {

FollowedAngles::FollowedAngles(const Mechanism& mechanism) {
  const auto add = [&](FeatureIndex first, FeatureIndex second, NumberIndex rest) {
    const Feature& one = mechanism.features()[first];
    const Feature& other = mechanism.features()[second];
    const bool is_driven = std::ranges::any_of(mechanism.drivers(), [&](const Driver& driver) {
      const std::vector<FeatureIndex>& between = mechanism.joints()[driver.joint].between;
      return between[0] == first && between[1] == second;
    });
    const bool is_known = std::ranges::any_of(angles_, [&](const FollowedAngle& angle) {
      return angle.one == one.link && angle.other == other.link && angle.rest == rest;
    });
    if (!one.is_line && !other.is_line && !is_driven && !is_known) {
      angles_.push_back({one.link, other.link, rest});
    }
  };
  for (const Spring& spring : mechanism.loading().springs) {
    if (spring.at_joint) {
      add(spring.between[0], spring.between[1], spring.rest);
    }
  }
  for (const Load& load : mechanism.loading().loads) {
    for (const NumberIndex number : {load.force_x, load.force_y, load.moment}) {
      if (!number.exists()) {
        continue;
      }
      for (const JointIndex joint : mechanism.numbers()[number].formula.joints()) {
        const std::vector<FeatureIndex>& between = mechanism.joints()[joint].between;
        add(between[0], between[1], NumberIndex());
      }
    }
  }
}

const Configuration& FollowedAngles::on(int branch, const Configuration& state,
                                        const Values& values) {
  std::vector<FollowedAngle>& angles = on_branches_.try_emplace(branch, angles_).first->second;
  for (FollowedAngle& followed : angles) {
    const double angle = angle_of(turned(state.links[followed.other].pose.direction,
                                         reversed(state.links[followed.one].pose.direction)));
    const double rest = followed.rest.exists() ? values.value_of(followed.rest) : 0;
    followed.angle = support::continued_angle(angle - rest, followed.angle);
  }
  followed_ = state;
  followed_.followed = angles;
  return followed_;
}

}  // namespace assur::mechanism::follow
