// Frames of carried links, and of their features, in the frames of the links that carry them.
#include <assur/mechanism/values.hpp>
#include <cmath>
#include <limits>

#include "plan/plan_data.hpp"

namespace assur::mechanism {

void Values::evaluate_carried_frames() {
  carried_frames_.clear();
  carried_roundings_.assign(plan_->structure.carried.size(), {});
  for (const CarriedLink& link : plan_->structure.carried) {
    if (link.group.exists()) {
      carried_frames_.push_back(
          Frame::identity(static_cast<Eigen::Index>(columns().size()), second_order()));
      carried_frames_.back().pose.x = carried_frames_.back().pose.y =
          std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    const ElementaryJoint& at = plan_->structure.linkage.joints[link.joint];
    const LinkFeature<Dual> on = feature(at.on(link.to), at.prismatic);
    carried_frames_.push_back(Frame::at(inverse<Dual>({on.x, on.y, on.along})));
    if (moves(at.on(link.to))) {
      const LinkFeature<Dual> moving = in_time(at.on(link.to), at.prismatic);
      carried_frames_.back().move(inverse<Dual>({moving.x, moving.y, moving.along}));
    }
  }
}

std::size_t Values::place_of(const CarriedLink& link) const {
  return static_cast<std::size_t>(&link - plan_->structure.carried.data());
}

LinkFeature<Dual> Values::feature(const ElementaryJoint& at, LinkIndex link) const {
  const auto feature_of = [this](FeatureIndex feature, bool is_line) {
    return this->feature(feature, is_line);
  };
  return carried_feature<Dual>(
      plan_->structure, at, link, feature_of,
      [&](const LinkFeature<Dual>& feature, const CarriedLink& carried) {
        return carried.group.exists()
                   ? placed_feature(feature, carried_frames_[place_of(carried)].to_parameters())
                   : moved_feature(feature, plan_->structure, carried, feature_of,
                                   motions_[carried.driver].position);
      });
}

support::Displacement Values::rounding(const ElementaryJoint& at, LinkIndex link) const {
  const LinkIndex holder = at.holder(link);
  if (holder == link) {
    return rounding(at.on(link));
  }
  using support::Displacement;
  const CarriedLink& carried = *plan_->structure.carried_link(holder);
  const auto size_of = [this](FeatureIndex feature) {
    const Pose<double>& pose = frame(feature).pose;
    return std::abs(pose.x) + std::abs(pose.y);
  };
  ElementaryJoint nearer = at;
  (link == at.first ? nearer.holder_first : nearer.holder_second) = carried.from;
  if (carried.group.exists()) {
    return carried_roundings_[place_of(carried)].carries(size_of(at.on(link)), 0,
                                                         rounding(nearer, link));
  }
  const ElementaryJoint& joint = plan_->structure.linkage.joints[carried.joint];
  const double position = std::abs(motions_[carried.driver].position.value());
  // The longest lever about which the driver turns the link, and its sliding distance.
  const double lever = size_of(at.on(link)) + size_of(joint.on(carried.to));
  return (joint.prismatic ? Displacement::of_slide(position) : Displacement::of_turn(position))
      .carries(lever, 0, rounding(joint.on(carried.from)))
      .carries(0, 0, rounding(joint.on(carried.to)))
      .carries(0, 0, rounding(nearer, link));
}

void Values::settle(DriverIndex driver,
                    const std::function<JointMotion(JointIndex)>& coordinate_of) {
  evaluate_driver(driver, coordinate_of);
  for (const GroupIndex group : plan::groups_carried_by(driver, *plan_)) {
    evaluate_group(group);
  }
}

void Values::settle(GroupIndex group, const Table<LinkIndex, Frame>& links,
                    const Table<LinkIndex, support::Displacement>& displaced) {
  for (const CarriedLink& link : plan_->structure.carried) {
    if (link.group == group) {
      carried_frames_[place_of(link)] = links[link.to];
      carried_roundings_[place_of(link)] = displaced[link.to];
    }
  }
  for (const GroupIndex shaped : plan::groups_carried_by(group, *plan_)) {
    evaluate_group(shaped);
  }
}

}  // namespace assur::mechanism
