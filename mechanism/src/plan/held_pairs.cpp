#include <algorithm>
#include <assur/mechanism/held_pairs.hpp>
#include <utility>

namespace assur::mechanism::plan {

namespace {

void add_held_by(const Mechanism& mechanism, const Joint& joint, DriverIndex driver,
                 std::vector<HeldPair>& pairs) {
  for (std::size_t other = 1; other < joint.between.size(); ++other) {
    HeldPair pair{joint.between[0], joint.between[other], {true, true, driver.exists()}, driver, 2};
    if (joint.type != JointType::revolute) {
      pair.holds = {driver.exists(), true, joint.type == JointType::prismatic};
      pair.driven = 0;
    }
    if (joint.type == JointType::pin_in_slot && !mechanism.features()[pair.first].is_line) {
      std::swap(pair.first, pair.second);
    }
    pairs.push_back(pair);
  }
}

}  // namespace

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

bool is_stand_in(const Joint& joint, const std::vector<RedundantJoint>& redundant) {
  return std::ranges::any_of(redundant, [&](const RedundantJoint& one) {
    return std::ranges::find(joint.between, one.stand_in) != joint.between.end();
  });
}

HeldPair held_by(const Mechanism& mechanism, const RedundantJoint& joint) {
  const bool is_line = mechanism.features()[joint.one].is_line;
  const bool are_lines = is_line && mechanism.features()[joint.other].is_line;
  return {joint.one, joint.other, {!is_line, true, are_lines}};
}

std::vector<HeldPair> held_pairs(const Mechanism& mechanism,
                                 const std::vector<RedundantJoint>& redundant) {
  std::vector<HeldPair> pairs;
  for (const JointIndex joint : mechanism.joints().keys()) {
    const Joint& at = mechanism.joints()[joint];
    if (!is_stand_in(at, redundant)) {
      plan::add_held_by(mechanism, at, mechanism.driver_of(joint), pairs);
    }
  }
  for (const RedundantJoint& joint : redundant) {
    pairs.push_back(held_by(mechanism, joint));
  }
  return pairs;
}

}  // namespace assur::mechanism
