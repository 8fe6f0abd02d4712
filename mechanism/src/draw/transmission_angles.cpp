#include "draw/transmission_angles.hpp"

#include <cmath>

namespace assur::mechanism::draw {

namespace {

/// Where a pin is, on one of the links that it joins.
Eigen::Vector2d place_of(const ElementaryJoint& pin, LinkIndex link, const Values& values,
                         const Configuration& configuration) {
  const Pose<double>& own = values.frame(pin.on(link)).pose;
  const Pose<double>& pose = configuration.links[pin.holder(link)].pose;
  const auto& [c, s] = pose.direction;
  return {pose.x + c * own.x - s * own.y, pose.y + s * own.x + c * own.y};
}

}  // namespace

std::vector<PinnedDyad> dyads_of_pins(const Structure& structure) {
  std::vector<PinnedDyad> dyads;
  for (const FoundGroup& group : structure.groups) {
    const RoleAssignment& roles = group.assignments.front();
    if (roles.links.size() != 2 || roles.joints.size() != 3) {
      continue;
    }
    const LinkIndex first = roles.links[0];
    const LinkIndex second = roles.links[1];
    PinnedDyad dyad;
    bool is_pinned = true;
    for (const ElementaryJointIndex index : roles.joints) {
      const ElementaryJoint& joint = structure.linkage.joints[index];
      is_pinned =
          is_pinned && !joint.prismatic && joint.on_first.exists() && joint.on_second.exists();
      (joint.joins(first, second) ? dyad.inner
       : joint.touches(first)     ? dyad.one
                                  : dyad.other) = joint;
    }
    if (is_pinned) {
      dyads.push_back(dyad);
    }
  }
  return dyads;
}

double transmission_angle(const PinnedDyad& dyad, const Values& values,
                          const Configuration& configuration) {
  const auto on = [&](const ElementaryJoint& pin) {
    return place_of(pin, pin.first, values, configuration);
  };
  const Eigen::Vector2d inner = on(dyad.inner);
  const Eigen::Vector2d one = on(dyad.one) - inner;
  const Eigen::Vector2d other = on(dyad.other) - inner;
  return std::atan2(std::abs(one.x() * other.y() - one.y() * other.x()), one.dot(other));
}

}  // namespace assur::mechanism::draw
