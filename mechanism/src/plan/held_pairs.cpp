// Pairs of features held by joints, including redundant ones.
#include <algorithm>
#include <assur/mechanism/held_pairs.hpp>
#include <iterator>
#include <utility>

namespace assur::mechanism::plan {

namespace {

void add_held_by(const Mechanism& mechanism, const Joint& joint, DriverIndex driver,
                 std::vector<HeldPair>& pairs) {
  for (std::size_t other = 1; other < joint.between.size(); ++other) {
    const std::array<FeatureIndex, 2> between = {joint.between[0], joint.between[other]};
    HeldPair pair{between[0], between[1], {true, true, driver.exists()}, driver, 2,
                  between,    joint.name};
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
  std::array<FeatureIndex, 2> between = {joint.one, joint.other};
  if (joint.is_turned) {
    std::swap(between[0], between[1]);
  }
  const auto is_line = [&](FeatureIndex feature) { return mechanism.features()[feature].is_line; };
  const bool has_line = is_line(joint.one);
  const bool are_lines = has_line && is_line(joint.other);
  HeldPair pair{between[0], between[1], {!has_line, true, are_lines}, {}, 0, between, joint.name};
  if (has_line && !are_lines) {
    pair.first = joint.one;
    pair.second = joint.other;
  }
  return pair;
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

std::vector<HeldPair> pairs_of_two_links(const Mechanism& mechanism,
                                         const std::vector<RedundantJoint>& redundant) {
  const std::vector<HeldPair> all = held_pairs(mechanism, redundant);
  std::vector<HeldPair> result;
  std::ranges::copy_if(all, std::back_inserter(result), [&](const HeldPair& pair) {
    return std::ranges::count(all, pair.joint, &HeldPair::joint) == 1;
  });
  return result;
}

}  // namespace assur::mechanism
