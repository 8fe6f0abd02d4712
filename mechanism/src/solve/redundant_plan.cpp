#include "redundant_plan.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// What is requested of a mechanism of which a part has some joints less.
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

/// Whether a plan without redundant joints can be assembled, whether these hold in a configuration
/// then, and if not, what is said of it.
struct Trial {
  bool holds;
  bool assembles = true;
  std::optional<OverConstrained> refusal = {};
};

Trial tried(const std::shared_ptr<const PlanData>& plan) {
  try {
    const Values values(plan, {});
    Solution solution;
    MechanismSolver solver(values);
    solver.solve({}, solution);
    if (solution.status == SolutionStatus::no_assembly) {
      solver.solve({.measures_gap = true}, solution);
      return {false, false, refusal_without_assembly(*plan, solution.reason)};
    }
    return {!solution.configurations.empty()};
  } catch (const OverConstrained& refusal) {
    return {false, true, refusal};
  }
}

/// A mechanism without the constraints that it has too many, if these hold at its own numbers and
/// where the drivers have gone on: what holds at one instant alone locks the mechanism. Else null,
/// and the refusal is that of the way that fails by least, or of the first that says anything.
std::shared_ptr<const PlanData> planned_without(const plan::BalancedMechanism& part,
                                                const Request& request,
                                                const OverConstrained& excess,
                                                OverConstrained& refusal) {
  std::vector<FeatureIndex> features;
  for (const RedundantJoint& joint : part.redundant) {
    features.insert(features.end(), {joint.one, joint.other});
  }
  const auto planned_with = [&](const Mechanism& whole) {
    PlanData data = *planned_whole(whole, request, part.structure, features);
    data.redundant = part.redundant;
    data.excess = excess;
    return std::make_shared<const PlanData>(std::move(data));
  };
  constexpr double on = 0.01;
  constexpr double rounding = 1e-9;  // of ways that are alike the first is told
  const std::shared_ptr<const PlanData> plan = planned_with(part.mechanism);
  Trial trial = tried(plan);
  if (trial.holds) {
    if (part.mechanism.drivers().empty()) {
      return plan;
    }
    bool assembles = false;
    for (const double by : {on, -on}) {
      const Trial further = tried(planned_with(part.mechanism.driven_on(by)));
      if (further.holds) {
        return plan;
      }
      assembles = assembles || further.assembles;
    }
    trial.refusal = refusal_where_driven_on(*plan, assembles);
  }
  if (trial.refusal && (trial.refusal->gap < refusal.gap * (1 - rounding) ||
                        std::string(refusal.what()) == excess.what())) {
    refusal = *trial.refusal;
  }
  return nullptr;
}

}  // namespace

std::shared_ptr<const PlanData> planned_whole(const Mechanism& mechanism, const Request& request,
                                              Structure structure,
                                              const std::vector<FeatureIndex>& more) {
  plan::EvaluationOrder order = plan::evaluation_order(mechanism, request, more);
  NamedParts parts = structure.named_parts(mechanism);
  return std::make_shared<const PlanData>(PlanData{
      mechanism, request, std::move(structure), std::move(order), std::move(parts), {}, {}});
}

std::shared_ptr<const PlanData> planned_with_redundancy(const Mechanism& mechanism,
                                                        const Request& request,
                                                        const OverConstrained& excess) {
  OverConstrained refusal = excess;
  const std::vector<std::string> kept = reported_joints(mechanism, request);
  std::optional<MechanismError> flaw;
  bool is_tried = false;
  for (const plan::LeftOut most :
       {plan::LeftOut::joints, plan::LeftOut::doubles, plan::LeftOut::constraints}) {
    for (const plan::BalancedMechanism& part : plan::balanced(mechanism, excess, most, kept)) {
      const Request asked = request_of_part(mechanism, request, part.mechanism);
      try {
        if (auto plan = planned_without(part, asked, excess, refusal)) {
          return plan;
        }
        is_tried = true;
      } catch (const MechanismError& error) {
        flaw = error;  // as where a slot would lead from a pin to another one in its place
      }
    }
  }
  if (flaw && !is_tried) {
    throw MechanismError(*flaw);
  }
  throw OverConstrained(refusal);
}

}  // namespace assur::mechanism::solve
