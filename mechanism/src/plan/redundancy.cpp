#include "redundancy.hpp"

#include <algorithm>
#include <tuple>

namespace assur::mechanism::plan {

namespace {

/// A search through more would take longer than what is found is worth.
constexpr int most_surplus = 8;

/// What a mechanism with a constraint or two less is: solved for, or with fewer too many.
struct Step {
  Mechanism mechanism;
  RedundantJoint redundant;
  std::optional<Structure> structure;
  std::optional<OverConstrained> fault;

  [[nodiscard]] int surplus() const { return fault ? fault->surplus : 0; }
  [[nodiscard]] std::size_t largest_group() const {
    std::size_t largest = 0;
    for (const FoundGroup& group :
         structure ? structure->groups.items() : std::vector<FoundGroup>{}) {
      largest = std::max(largest, group.links.size());
    }
    return largest;
  }
};

class Balancer {
 public:
  Balancer(const Mechanism& mechanism, LeftOut most) : mechanism_(mechanism), most_(most) {}

  [[nodiscard]] std::optional<Step> best(const OverConstrained& fault) {
    surplus_ = fault.surplus;
    for (const JointIndex joint : mechanism_.joints().keys()) {
      const Joint& at = mechanism_.joints()[joint];
      if (mechanism_.driver_of(joint).exists() || is_read(joint) || at.lowest.exists() ||
          std::ranges::find(fault.joints, at.name) == fault.joints.end()) {
        continue;
      }
      for (const FeatureIndex feature : at.between) {
        relax(joint, feature);
      }
    }
    return std::move(best_);
  }

 private:
  /// Whether the law of a driver reads where the joint is.
  [[nodiscard]] bool is_read(JointIndex joint) const {
    return std::ranges::any_of(mechanism_.drivers(), [&](const Driver& driver) {
      const std::vector<JointIndex> read = mechanism_.numbers()[driver.position].formula.joints();
      return std::ranges::find(read, joint) != read.end();
    });
  }
  [[nodiscard]] const std::string& link_name(FeatureIndex feature) const {
    return mechanism_.links()[mechanism_.features()[feature].link].name;
  }

  void relax(JointIndex joint, FeatureIndex feature) {
    const Joint& at = mechanism_.joints()[joint];
    const FeatureIndex other = at.between[0] == feature ? at.between[1] : at.between[0];
    const RedundantJoint redundant{at.name, other, feature};
    if (most_ == LeftOut::joints && surplus_ > 1 && at.type != JointType::pin_in_slot) {
      consider({mechanism_.without(joint, feature), redundant, {}, {}}, feature);
    }
    if (at.type == JointType::revolute) {
      for (const FeatureIndex from : points_of(feature)) {
        consider({mechanism_.with_slot(joint, feature, from), redundant, {}, {}}, feature);
      }
    }
  }

  /// The other points of a feature's link at which joints are.
  [[nodiscard]] std::vector<FeatureIndex> points_of(FeatureIndex feature) const {
    std::vector<FeatureIndex> points;
    for (const Joint& joint : mechanism_.joints()) {
      for (const FeatureIndex other : joint.between) {
        const Feature& at = mechanism_.features()[other];
        if (other != feature && !at.is_line && at.link == mechanism_.features()[feature].link) {
          points.push_back(other);
        }
      }
    }
    return points;
  }

  void consider(Step step, FeatureIndex feature) {
    try {
      step.structure = structure_of(step.mechanism);
    } catch (const OverConstrained& fault) {
      step.fault = fault;
    } catch (const MechanismError&) {
      return;
    }
    if (step.surplus() >= surplus_) {
      return;
    }
    const auto rank = [&](const Step& of, const std::string& link) {
      return std::make_tuple(of.surplus(), of.largest_group(), of.redundant.name, link);
    };
    if (!best_ || rank(step, link_name(feature)) < rank(*best_, best_link_)) {
      best_link_ = link_name(feature);
      best_ = std::move(step);
    }
  }

  const Mechanism& mechanism_;
  LeftOut most_;
  int surplus_ = 0;
  std::optional<Step> best_;
  std::string best_link_;
};

}  // namespace

std::optional<BalancedMechanism> balanced(const Mechanism& mechanism, const OverConstrained& fault,
                                          LeftOut most) {
  if (fault.surplus > most_surplus) {
    return std::nullopt;
  }
  std::optional<Step> step = Balancer(mechanism, most).best(fault);
  if (!step) {
    return std::nullopt;
  }
  if (step->structure) {
    return BalancedMechanism{
        std::move(step->mechanism), std::move(*step->structure), {step->redundant}};
  }
  std::optional<BalancedMechanism> rest = balanced(step->mechanism, *step->fault, most);
  if (rest) {
    rest->redundant.insert(rest->redundant.begin(), step->redundant);
  }
  return rest;
}

}  // namespace assur::mechanism::plan
