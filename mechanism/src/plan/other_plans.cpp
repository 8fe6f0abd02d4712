#include "other_plans.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace assur::mechanism::plan {

namespace {

constexpr std::array left_out_at_most = {LeftOut::joints, LeftOut::doubles, LeftOut::constraints};

/// The request for a part of a mechanism without some joints.
Request request_of_part(const Described& described, const Mechanism& part) {
  Request result = described.request;
  if (result.reported.joints) {
    result.reported.joints->clear();
    for (const std::string& name : described.reported_joints()) {
      if (const JointIndex joint = index_of(part.joints(), name); joint.exists()) {
        result.reported.joints->push_back(joint);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<std::string> Described::reported_joints() const {
  std::vector<std::string> names;
  for (const JointIndex joint : request.reported.joints.value_or(std::vector<JointIndex>{})) {
    names.push_back(mechanism.joints()[joint].name);
  }
  return names;
}

PlanData reduced_plan(const Described& described, const BalancedMechanism& part,
                      const Mechanism& mechanism) {
  std::vector<FeatureIndex> features;
  for (const RedundantJoint& joint : part.redundant) {
    features.insert(features.end(), {joint.one, joint.other});
  }
  PlanData data =
      plan_of(mechanism, request_of_part(described, part.mechanism), part.structure, features);
  data.redundant = part.redundant;
  data.excess = described.excess;
  return data;
}

std::vector<BalancedMechanism> ways_to_balance(const Described& described) {
  const std::vector<std::string> kept = described.reported_joints();
  std::vector<BalancedMechanism> result;
  for (const LeftOut most : left_out_at_most) {
    for (BalancedMechanism& part : balanced(described.mechanism, described.excess, most, kept)) {
      result.push_back(std::move(part));
    }
  }
  std::ranges::stable_sort(
      result, {}, [](const BalancedMechanism& part) { return largest_group(part.structure); });
  return result;
}

OtherPlans::OtherPlans(std::shared_ptr<const Described> described,
                       const std::vector<RedundantJoint>& redundant)
    : described_(std::move(described)) {
  for (const RedundantJoint& joint : redundant) {
    kept_.push_back(joint.name);
  }
}

const std::vector<std::shared_ptr<const PlanData>>& OtherPlans::all() const {
  std::call_once(is_made_, [this] { plans_ = made(); });
  return plans_;
}

// Among the constraints that are left out, the last one varies and the others are the best choice.
// The next round keeps the joints whose constraints were such a choice in this round.
std::vector<std::shared_ptr<const PlanData>> OtherPlans::made() const {
  constexpr int most_rounds = 6;
  std::set<std::string> kept(kept_.begin(), kept_.end());
  std::vector<std::shared_ptr<const PlanData>> plans;
  std::size_t known = 0;
  for (int round = 0; round < most_rounds && kept.size() > known; ++round) {
    known = kept.size();
    const std::vector<std::string> names(kept.begin(), kept.end());
    for (const LeftOut most : left_out_at_most) {
      for (const BalancedMechanism& part :
           balanced(described_->mechanism, described_->excess, most, names)) {
        plans.push_back(
            std::make_shared<const PlanData>(reduced_plan(*described_, part, part.mechanism)));
        for (std::size_t place = 0; place + 1 < part.redundant.size(); ++place) {
          kept.insert(part.redundant[place].name);
        }
      }
    }
  }
  return plans;
}

}  // namespace assur::mechanism::plan
