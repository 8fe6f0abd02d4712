#include "redundancy.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "point_places.hpp"

namespace assur::mechanism::plan {

namespace {

/// The largest number of choices for the last constraint to leave out. Each is solved to test
/// whether the left-out constraints hold.
constexpr std::size_t most_ways = 32;

/// The largest number of rounds in search of further sets of left-out constraints: a mechanism may
/// have thousands of such sets.
constexpr int most_rounds = 100;

/// A mechanism with one or two constraints less. It has either a structure or a smaller excess of
/// constraints.
struct RelaxedMechanism {
  RedundantJoint redundant;
  std::string from = {};   ///< the joint towards which the replacing slot leads
  std::size_t points = 0;  ///< number of points to which that slot could lead
  Mechanism mechanism = Mechanism();
  std::optional<Structure> structure = {};
  std::optional<OverConstrained> fault = {};
  std::string link = {};    ///< the link with the feature at which a constraint is left out
  bool loses_kept = false;  ///< whether the joint is one to keep
  /// Whether the joint is on a link that a driver turns or shifts: from there the groups that
  /// follow are placed, and they are larger without it.
  bool is_on_driven = false;

  [[nodiscard]] int surplus() const { return fault ? fault->surplus : 0; }
  /// A step precedes those of a larger rank. Slots on bars come early: a slot on a bar leaves out
  /// the bar's length alone, whatever the bar's direction is. A slot on a link with more joints
  /// leaves out no single length.
  using Rank =
      std::tuple<int, bool, std::size_t, bool, std::string, std::size_t, std::string, std::string>;
  [[nodiscard]] Rank rank() const {
    return {surplus(),
            loses_kept,
            structure ? largest_group(*structure) : 0,
            is_on_driven,
            redundant.name,
            points,
            link,
            from};
  }
};

/// The mechanism with a joint replaced, or without the joint if it has no replacement.
Mechanism relaxed(const Mechanism& mechanism, const RedundantJoint& redundant) {
  const JointIndex joint = index_of(mechanism.joints(), redundant.name);
  return !redundant.stand_in.exists() ? mechanism.without(joint, redundant.other)
         : mechanism.features()[redundant.other].is_line
             ? mechanism.with_pin(joint, redundant.other)
             : mechanism.with_slot(joint, redundant.other, redundant.from);
}

class Balancer {
 public:
  /// `described` is the number of described features; the further ones belong to replacements.
  Balancer(const Mechanism& mechanism, std::size_t described, const PointPlaces& places,
           LeftOut most, const std::vector<std::string>& kept)
      : mechanism_(mechanism), described_(described), places_(places), most_(most), kept_(kept) {}

  /// Returns the steps from a mechanism with this fault, the best one first.
  [[nodiscard]] std::vector<RelaxedMechanism> steps(const OverConstrained& fault) {
    surplus_ = fault.surplus;
    for (const JointIndex joint : mechanism_.joints().keys()) {
      const Joint& at = mechanism_.joints()[joint];
      if (is_stand_in(at) || mechanism_.driver_of(joint).exists() || is_read(mechanism_, joint) ||
          at.lowest.exists() || std::ranges::find(fault.joints, at.name) == fault.joints.end()) {
        continue;
      }
      for (const FeatureIndex feature : at.between) {
        relax(joint, feature);
      }
    }
    std::ranges::stable_sort(steps_,
                             [](const RelaxedMechanism& one, const RelaxedMechanism& other) {
                               return one.rank() < other.rank();
                             });
    return std::move(steps_);
  }

 private:
  [[nodiscard]] bool is_stand_in(const Joint& joint) const {
    return std::ranges::any_of(joint.between,
                               [&](FeatureIndex feature) { return feature.place() >= described_; });
  }
  [[nodiscard]] const std::string& link_name(FeatureIndex feature) const {
    return mechanism_.links()[mechanism_.features()[feature].link].name;
  }

  /// Whether a driver moves the link of a feature against another one, if it is not the ground.
  [[nodiscard]] bool is_driven(FeatureIndex feature) const {
    const LinkIndex link = mechanism_.features()[feature].link;
    return link != mechanism_.ground() &&
           std::ranges::any_of(mechanism_.drivers(), [&](const Driver& driver) {
             return std::ranges::any_of(
                 mechanism_.joints()[driver.joint].between,
                 [&](FeatureIndex at) { return mechanism_.features()[at].link == link; });
           });
  }

  /// Whether no other joint holds the two links of a redundant one.
  [[nodiscard]] bool is_alone(const RedundantJoint& redundant) const {
    const auto holds = [&](const Joint& joint, FeatureIndex at) {
      return std::ranges::any_of(joint.between, [&](FeatureIndex feature) {
        return mechanism_.features()[feature].link == mechanism_.features()[at].link;
      });
    };
    return std::ranges::count_if(mechanism_.joints(), [&](const Joint& joint) {
             return holds(joint, redundant.one) && holds(joint, redundant.other);
           }) == 1;
  }

  void relax(JointIndex joint, FeatureIndex feature) {
    const Joint& at = mechanism_.joints()[joint];
    const FeatureIndex other = at.between[0] == feature ? at.between[1] : at.between[0];
    const RedundantJoint whole{at.name, other, feature, {}, {}, at.between[0] == feature};
    if (at.type == JointType::pin_in_slot) {
      if (!mechanism_.features()[feature].is_line) {  // its one constraint is left out once
        consider({whole}, 1);
      }
      return;
    }
    const bool may_be_whole =
        most_ == LeftOut::joints || (most_ == LeftOut::doubles && !is_alone(whole));
    if (may_be_whole && surplus_ > 1) {
      consider({whole}, 2);
    }
    RedundantJoint half = whole;
    half.stand_in = FeatureIndex(mechanism_.features().size());  // the feature that is added
    if (at.type == JointType::prismatic) {
      consider({half}, 1);
      return;
    }
    const auto points = points_of(feature);
    for (const auto& [from, name] : points) {
      half.from = from;
      consider({half, name, points.size()}, 1);
    }
  }

  /// The other points of a feature's link at which joints are, and the names of these joints. A
  /// slot to a point at the same place is excluded.
  [[nodiscard]] std::vector<std::pair<FeatureIndex, std::string>> points_of(
      FeatureIndex feature) const {
    std::vector<std::pair<FeatureIndex, std::string>> points;
    for (const Joint& joint : mechanism_.joints()) {
      for (const FeatureIndex other : joint.between) {
        const Feature& at = mechanism_.features()[other];
        const bool is_described = other.place() < described_;
        if (other != feature && is_described && !at.is_line &&
            at.link == mechanism_.features()[feature].link && !places_.coincide(feature, other)) {
          points.emplace_back(other, joint.name);
        }
      }
    }
    return points;
  }

  /// Lists a step after which the mechanism has `less` constraints less. If its surplus does not
  /// decrease by `less`, the step has freed other links and is not listed.
  void consider(RelaxedMechanism step, int less) {
    step.mechanism = relaxed(mechanism_, step.redundant);
    FoundStructure found = found_structure(step.mechanism);
    if (auto* const structure = std::get_if<Structure>(&found)) {
      step.structure = std::move(*structure);
    } else if (const auto* const fault = std::get_if<OverConstrained>(&found)) {
      step.fault = *fault;
    } else {
      return;
    }
    if (step.surplus() > surplus_ - less) {
      return;
    }
    step.link = link_name(step.redundant.other);
    step.is_on_driven = is_driven(step.redundant.one) || is_driven(step.redundant.other);
    step.loses_kept = std::ranges::find(kept_, step.redundant.name) != kept_.end();
    steps_.push_back(std::move(step));
  }

  const Mechanism& mechanism_;
  std::size_t described_;
  const PointPlaces& places_;
  LeftOut most_;
  const std::vector<std::string>& kept_;
  int surplus_ = 0;
  std::vector<RelaxedMechanism> steps_;
};

/// Depth-first search for constraints to leave out one after another. The best step is tried first,
/// and the next one only if the first leads nowhere.
class BalanceSearch {
 public:
  BalanceSearch(const Mechanism& mechanism, LeftOut most, const std::vector<std::string>& kept)
      : described_(mechanism.features().size()), places_(mechanism), most_(most), kept_(kept) {}

  /// Returns the choices of excess constraints to leave out of a mechanism, from which others may
  /// have been left out already.
  [[nodiscard]] std::vector<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                        const OverConstrained& fault) {
    std::vector<BalancedMechanism> result;
    if (rounds_ == most_rounds) {
      return result;
    }
    ++rounds_;
    std::vector<RelaxedMechanism> steps =
        Balancer(mechanism, described_, places_, most_, kept_).steps(fault);
    for (RelaxedMechanism& step : steps) {
      if (step.structure && result.size() < most_ways) {
        result.push_back({std::move(step.mechanism), std::move(*step.structure), {step.redundant}});
      }
    }
    for (auto step = steps.begin(); step != steps.end() && result.empty(); ++step) {
      result = balanced(step->mechanism, *step->fault);
      for (BalancedMechanism& rest : result) {
        rest.redundant.insert(rest.redundant.begin(), step->redundant);
      }
    }
    return result;
  }

 private:
  std::size_t described_;
  PointPlaces places_;
  LeftOut most_;
  const std::vector<std::string>& kept_;
  int rounds_ = 0;
};

}  // namespace

bool is_read(const Mechanism& mechanism, JointIndex joint) {
  const auto reads = [&](NumberIndex number) {
    return number.exists() &&
           std::ranges::count(mechanism.numbers()[number].formula.joints(), joint) > 0;
  };
  return std::ranges::any_of(mechanism.drivers(),
                             [&](const Driver& driver) { return reads(driver.position); }) ||
         std::ranges::any_of(mechanism.loading().loads, [&](const Load& load) {
           return reads(load.force_x) || reads(load.force_y) || reads(load.moment);
         });
}

std::size_t largest_group(const Structure& structure) {
  std::size_t largest = 0;
  for (const FoundGroup& group : structure.groups) {
    largest = std::max(largest, group.links.size());
  }
  return largest;
}

std::optional<BalancedMechanism> without_all(const Mechanism& mechanism,
                                             std::vector<RedundantJoint> redundant) {
  std::ranges::stable_sort(redundant, {}, &RedundantJoint::name);
  BalancedMechanism whole{mechanism, {}, {}};
  for (RedundantJoint& joint : redundant) {
    const bool is_told = std::ranges::any_of(whole.redundant, [&](const RedundantJoint& one) {
      return one.name == joint.name && one.other == joint.other;
    });
    if (is_told) {
      continue;
    }
    if (joint.stand_in.exists()) {
      joint.stand_in = FeatureIndex(whole.mechanism.features().size());
    }
    whole.mechanism = relaxed(whole.mechanism, joint);
    whole.redundant.push_back(std::move(joint));
  }
  FoundStructure found = found_structure(whole.mechanism);
  auto* const structure = std::get_if<Structure>(&found);
  if (structure == nullptr) {
    return std::nullopt;
  }
  whole.structure = std::move(*structure);
  return whole;
}

std::vector<BalancedMechanism> balanced(const Mechanism& mechanism, const OverConstrained& fault,
                                        LeftOut most, const std::vector<std::string>& kept) {
  if (fault.surplus > most_surplus) {
    return {};
  }
  return BalanceSearch(mechanism, most, kept).balanced(mechanism, fault);
}

}  // namespace assur::mechanism::plan
