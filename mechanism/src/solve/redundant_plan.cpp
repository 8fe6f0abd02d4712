#include "redundant_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "longest_on_links.hpp"
#include "plan/overloaded_parts.hpp"
#include "redundant_joints.hpp"
#include "solver.hpp"

namespace assur::mechanism::solve {

namespace {

/// The names of the joints that the request lists to be reported.
std::vector<std::string> reported_joints(const Mechanism& mechanism, const Request& request) {
  std::vector<std::string> names;
  for (const JointIndex joint : request.reported.joints.value_or(std::vector<JointIndex>{})) {
    names.push_back(mechanism.joints()[joint].name);
  }
  return names;
}

/// The request for a part of a mechanism that lacks some joints.
Request request_of_part(const Mechanism& mechanism, const Request& request, const Mechanism& part) {
  Request result = request;
  if (result.reported.joints) {
    result.reported.joints->clear();
    for (const std::string& name : reported_joints(mechanism, request)) {
      if (const JointIndex joint = index_of(part.joints(), name); joint.exists()) {
        result.reported.joints->push_back(joint);
      }
    }
  }
  return result;
}

constexpr std::array left_out_at_most = {plan::LeftOut::joints, plan::LeftOut::doubles,
                                         plan::LeftOut::constraints};

/// The plan of a mechanism with constraints left out. `mechanism` is that of the part, with its
/// drivers possibly moved on.
PlanData planned_part(const plan::Described& described, const plan::BalancedMechanism& part,
                      const OverConstrained& excess, const Mechanism& mechanism) {
  std::vector<FeatureIndex> features;
  for (const RedundantJoint& joint : part.redundant) {
    features.insert(features.end(), {joint.one, joint.other});
  }
  PlanData data = *planned_whole(
      mechanism, request_of_part(described.mechanism, described.request, part.mechanism),
      part.structure, features);
  data.redundant = part.redundant;
  data.excess = excess;
  return data;
}

/// Whether a plan without redundant joints can be assembled, whether these then hold in some
/// configuration, and if not, the error to report.
struct Trial {
  bool holds;
  bool assembles = true;
  bool moves = false;  ///< without those joints; whether they leave a motion was not examined
  std::optional<OverConstrained> refusal = {};
};

/// Tries a plan. Families count only if it has `described`: they then remain under all constraints.
Trial tried(const std::shared_ptr<const PlanData>& plan) {
  try {
    const Values values(plan, {});
    Solution solution;
    MechanismSolver solver(values);
    solver.solve({}, solution);
    if (solution.left_out.value_or(0) > 0) {  // it holds, beyond limits
      return {true};
    }
    if (solution.status == SolutionStatus::no_assembly) {
      solver.solve({.measures_gap = true}, solution);
      return {false, false, false, refusal_without_assembly(*plan, solution.reason)};
    }
    if (!solution.configurations.empty()) {
      return {true};
    }
    const bool is_known = plan->described != nullptr;
    return {is_known && std::ranges::any_of(solution.families,
                                            [](const Family& one) { return one.mobility > 0; }),
            true, !is_known};
  } catch (const OverConstrained& refusal) {
    return {false, true, false, refusal};
  }
}

/// The excess of constraints of a mechanism; empty where it has groups, or another fault.
std::optional<OverConstrained> excess_of(const Mechanism& mechanism) {
  try {
    (void)structure_of(mechanism);
  } catch (const OverConstrained& excess) {
    return excess;
  } catch (const MechanismError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

/// Looks for the same mechanism without its redundant constraints.
class Planner {
 public:
  Planner(const Mechanism& mechanism, const Request& request, const OverConstrained& excess)
      : described_(std::make_shared<const plan::Described>(plan::Described{mechanism, request})),
        excess_(excess),
        refusal_(excess),
        kept_(reported_joints(mechanism, request)) {}

  /// Throws OverConstrained where no way is found.
  [[nodiscard]] std::shared_ptr<const PlanData> plan() {
    bool has_groups = false;
    bool is_tried = false;
    std::optional<MechanismError> flaw;
    for (const plan::BalancedMechanism& part : ways()) {
      has_groups = true;
      try {
        if (auto plan = planned_without(part, false)) {
          return plan;
        }
        is_tried = true;
      } catch (const MechanismError& error) {
        flaw = error;  // as where a slot would lead from a pin to another one at the same place
      }
    }
    if (moving_) {
      if (auto plan = planned_without(*moving_, true)) {
        return plan;
      }
    }
    if (auto plan = planned_by_parts()) {
      return plan;
    }
    if (flaw && !is_tried) {
      throw MechanismError(*flaw);
    }
    if (!has_groups && excess_.lack == 0) {
      throw refusal_without_groups(excess_);
    }
    throw OverConstrained(refusal_);
  }

 private:
  /// The ways to leave out what is too much, those with the smallest groups first.
  [[nodiscard]] std::vector<plan::BalancedMechanism> ways() const {
    std::vector<plan::BalancedMechanism> result;
    for (const plan::LeftOut most : left_out_at_most) {
      for (plan::BalancedMechanism& part :
           plan::balanced(described_->mechanism, excess_, most, kept_)) {
        result.push_back(std::move(part));
      }
    }
    std::ranges::stable_sort(result, {}, [](const plan::BalancedMechanism& part) {
      return plan::largest_group(part.structure);
    });
    return result;
  }

  /// Plans without the constraints that are left out of each over-constrained part when it is
  /// planned alone. Null where there is only one such part, or where these do not hold.
  [[nodiscard]] std::shared_ptr<const PlanData> planned_by_parts() {
    const Mechanism& mechanism = described_->mechanism;
    const auto parts = plan::overloaded_parts(mechanism, excess_);
    if (parts.size() < 2) {
      return nullptr;
    }
    try {
      std::vector<RedundantJoint> redundant;
      for (const Table<LinkIndex, bool>& kept : parts) {
        const auto own = plan::of_whole(mechanism, kept, left_out_of(mechanism.only(kept)));
        redundant.insert(redundant.end(), own.begin(), own.end());
      }
      return planned_without(plan::without_all(mechanism, std::move(redundant)), false);
    } catch (const MechanismError&) {
      return nullptr;  // the refusal describes the mechanism as a whole
    }
  }

  [[nodiscard]] std::vector<RedundantJoint> left_out_of(const Mechanism& part) const {
    Request request;
    request.redundancy_tolerance = described_->request.redundancy_tolerance;
    request.reported = {std::nullopt, std::vector<JointIndex>{}};
    for (const std::string& name : kept_) {
      if (const JointIndex joint = index_of(part.joints(), name); joint.exists()) {
        request.reported.joints->push_back(joint);
      }
    }
    const std::optional<OverConstrained> excess = excess_of(part);
    return excess ? Planner(part, request, *excess).plan()->redundant
                  : std::vector<RedundantJoint>();
  }

  /// A plan without the redundant constraints, if these hold at the mechanism's own numbers and
  /// where the drivers have gone on: constraints that hold in one position alone lock it. Otherwise
  /// null, and `refusal_` is that of the way that fails by least, or of the first with a reason.
  /// `moves`: the remaining constraints may leave the mechanism free, since all other ways failed.
  [[nodiscard]] std::shared_ptr<const PlanData> planned_without(const plan::BalancedMechanism& part,
                                                                bool moves) {
    constexpr double on = 0.01;
    constexpr double finer = 1e-4;     // where drivers have less room than `on`
    constexpr double rounding = 1e-9;  // of ways that fail alike, the first is reported
    const auto planned = [&](const Mechanism& own, std::shared_ptr<const plan::Described> whole) {
      PlanData data = planned_part(*described_, part, excess_, own);
      if (moves) {
        data.described = std::move(whole);
      }
      return std::make_shared<PlanData>(std::move(data));
    };
    const std::shared_ptr<PlanData> plan = planned(part.mechanism, described_);
    Trial trial = tried(plan);
    if (trial.moves && !moving_) {
      moving_ = part;
    }
    if (trial.holds) {
      plan->described = described_;
      if (part.mechanism.drivers().empty()) {
        return plan;
      }
      bool assembles = false;
      const double length = longest_on_links(Values(plan, {}));
      for (const double by : {on, -on, finer, -finer}) {
        if (assembles && std::abs(by) < on) {
          break;
        }
        const auto driven = std::make_shared<const plan::Described>(
            plan::Described{described_->mechanism.driven_on(by, length), described_->request});
        const Trial further = tried(planned(part.mechanism.driven_on(by, length), driven));
        if (further.holds) {
          return plan;
        }
        assembles = assembles || further.assembles;
      }
      trial.refusal = refusal_where_driven_on(*plan, assembles);
    }
    if (trial.refusal && (trial.refusal->gap < refusal_.gap * (1 - rounding) ||
                          std::string(refusal_.what()) == excess_.what())) {
      refusal_ = *trial.refusal;
    }
    return nullptr;
  }

  std::shared_ptr<const plan::Described> described_;
  const OverConstrained& excess_;
  OverConstrained refusal_;
  std::vector<std::string> kept_;
  std::optional<plan::BalancedMechanism> moving_;  ///< the first that moves at its own numbers
};

}  // namespace

std::shared_ptr<const PlanData> planned_whole(const Mechanism& mechanism, const Request& request,
                                              Structure structure,
                                              const std::vector<FeatureIndex>& more) {
  plan::EvaluationOrder order = plan::evaluation_order(mechanism, request, more);
  NamedParts parts = structure.named_parts(mechanism);
  return std::make_shared<const PlanData>(PlanData{
      mechanism, request, std::move(structure), std::move(order), std::move(parts), {}, {}, {}});
}

std::shared_ptr<const PlanData> planned_with_redundancy(const Mechanism& mechanism,
                                                        const Request& request,
                                                        const OverConstrained& excess) {
  return Planner(mechanism, request, excess).plan();
}

// Among the constraints that are left out, the last one varies and the others are the best choice.
// The next round keeps the joints whose constraints were such a choice in this round.
std::vector<std::shared_ptr<const PlanData>> other_plans(const PlanData& plan) {
  constexpr int most_rounds = 6;
  std::set<std::string> kept;
  for (const RedundantJoint& joint : plan.redundant) {
    kept.insert(joint.name);
  }
  std::vector<std::shared_ptr<const PlanData>> plans;
  std::size_t known = 0;
  for (int round = 0; round < most_rounds && kept.size() > known; ++round) {
    known = kept.size();
    const std::vector<std::string> names(kept.begin(), kept.end());
    for (const plan::LeftOut most : left_out_at_most) {
      for (const plan::BalancedMechanism& part :
           plan::balanced(plan.described->mechanism, *plan.excess, most, names)) {
        plans.push_back(std::make_shared<const PlanData>(
            planned_part(*plan.described, part, *plan.excess, part.mechanism)));
        for (std::size_t place = 0; place + 1 < part.redundant.size(); ++place) {
          kept.insert(part.redundant[place].name);
        }
      }
    }
  }
  return plans;
}

}  // namespace assur::mechanism::solve
