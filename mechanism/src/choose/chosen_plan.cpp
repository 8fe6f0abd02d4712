#include "chosen_plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "plan/mechanism_parts.hpp"
#include "plan/other_plans.hpp"
#include "plan/refusals.hpp"
#include "plan/usable_request.hpp"
#include "solve/longest_on_links.hpp"
#include "solve/solver.hpp"

namespace assur::mechanism::choose {

namespace {

/// The use of the families in a trial.
enum class Families : unsigned char {
  unexamined,  ///< the constraints that are left out may block them
  examined     ///< the solver lists those that persist under all constraints
};

/// Whether a plan without redundant joints can be assembled, whether these hold in some
/// configuration, and if not, the error to report.
struct PlanTrial {
  bool holds = false;
  bool assembles = true;
  bool moves = false;  ///< without those joints; whether they leave a motion was not examined
  std::optional<OverConstrained> refusal = {};
};

PlanTrial tried(const std::shared_ptr<const PlanData>& plan, Families families) {
  const Values values(plan, {});
  Solution solution;
  solve::MechanismSolver solver(values);
  solve::Answer answer = solver.solve({}, solve::SoughtAll{}, solution);
  if (answer.refusal) {
    return {.refusal = std::move(answer.refusal)};
  }
  if (solution.left_out.value_or(0) > 0) {  // a configuration exists, beyond limits
    return {.holds = true};
  }
  if (solution.status == SolutionStatus::no_assembly) {
    (void)solver.solve({.measures_gap = true}, solve::SoughtAll{}, solution);
    return {.assembles = false, .refusal = plan::refusal_without_assembly(*plan, solution.reason)};
  }
  if (!solution.configurations.empty()) {
    return {.holds = true};
  }
  if (families == Families::unexamined) {
    return {.moves = true};
  }
  return {.holds = std::ranges::any_of(solution.families,
                                       [](const Family& one) { return one.mobility > 0; })};
}

/// Searches for the same mechanism without its redundant constraints.
class Chooser {
 public:
  Chooser(const Mechanism& mechanism, const Request& request, const OverConstrained& excess)
      : described_(
            std::make_shared<const plan::Described>(plan::Described{mechanism, request, excess})),
        refusal_(excess) {}

  /// Null if no choice of redundant constraints succeeds; `refuse` then gives the reason.
  [[nodiscard]] std::shared_ptr<const PlanData> choose() {
    for (const plan::BalancedMechanism& part : plan::ways_to_balance(*described_)) {
      has_groups_ = true;
      if (auto plan = planned_without(part, Families::unexamined)) {
        return plan;
      }
    }
    if (moving_) {
      if (auto plan = planned_without(*moving_, Families::examined)) {
        return plan;
      }
    }
    return planned_by_parts();
  }

  [[noreturn]] void refuse() const {
    if (flaw_ && !is_tried_) {
      throw MechanismError(*flaw_);
    }
    if (!has_groups_ && described_->excess.lack == 0) {
      throw plan::refusal_without_groups(described_->mechanism, described_->excess);
    }
    throw OverConstrained(refusal_);
  }

 private:
  /// Plans the mechanism without the constraints that are left out of each over-constrained part
  /// when planned separately. Null if there is only one such part, or if these constraints do not
  /// hold.
  [[nodiscard]] std::shared_ptr<const PlanData> planned_by_parts() {
    const Mechanism& mechanism = described_->mechanism;
    const auto parts = plan::overloaded_parts(mechanism, described_->excess);
    if (parts.size() < 2) {
      return nullptr;
    }
    std::vector<RedundantJoint> redundant;
    for (const Table<LinkIndex, bool>& kept : parts) {
      auto left_out = left_out_of(mechanism.only(kept));
      if (!left_out) {
        return nullptr;
      }
      const auto own = plan::of_whole(mechanism, kept, std::move(*left_out));
      redundant.insert(redundant.end(), own.begin(), own.end());
    }
    const auto whole = plan::without_all(mechanism, std::move(redundant));
    return whole ? planned_without(*whole, Families::unexamined) : nullptr;
  }

  /// The constraints left out of a part that is planned separately; nothing if it cannot be
  /// planned.
  [[nodiscard]] std::optional<std::vector<RedundantJoint>> left_out_of(
      const Mechanism& part) const {
    const plan::FoundStructure found = plan::found_structure(part);
    const auto* const excess = std::get_if<OverConstrained>(&found);
    if (excess == nullptr) {
      return std::vector<RedundantJoint>();
    }
    Request request;
    request.redundancy_tolerance = described_->request.redundancy_tolerance;
    request.reported = {std::nullopt, std::vector<JointIndex>{}};
    for (const std::string& name : described_->reported_joints()) {
      if (const JointIndex joint = index_of(part.joints(), name); joint.exists()) {
        request.reported.joints->push_back(joint);
      }
    }
    const std::shared_ptr<const PlanData> plan = Chooser(part, request, *excess).choose();
    return plan ? std::optional(plan->redundant) : std::nullopt;
  }

  /// A plan without the redundant constraints, if these hold at the mechanism's own numbers and
  /// after the drivers advance: constraints that hold in one position alone lock the mechanism.
  /// Otherwise null, and `refusal_` is that of the choice with the least gap, or of the first with
  /// a reason.
  [[nodiscard]] std::shared_ptr<const PlanData> planned_without(const plan::BalancedMechanism& part,
                                                                Families families) {
    try {
      auto plan = held_without(part, families);
      is_tried_ = true;
      return plan;
    } catch (const MechanismError& error) {
      flaw_ = error;  // such as a slot from a pin to another one at the same place
      return nullptr;
    }
  }

  [[nodiscard]] std::shared_ptr<const PlanData> held_without(const plan::BalancedMechanism& part,
                                                             Families families) {
    constexpr double on = 0.01;
    constexpr double finer = 1e-4;     // where drivers have less room than `on`
    constexpr double rounding = 1e-9;  // among choices that fail alike, the first is reported
    const auto with_others = [&](PlanData data, std::shared_ptr<const plan::Described> described) {
      data.others = std::make_shared<const plan::OtherPlans>(std::move(described), data.redundant);
      return std::make_shared<const PlanData>(std::move(data));
    };
    const auto reduced = [&](const Mechanism& own, std::shared_ptr<const plan::Described> whole) {
      PlanData data = plan::reduced_plan(*described_, part, own);
      return families == Families::examined ? with_others(std::move(data), std::move(whole))
                                            : std::make_shared<const PlanData>(std::move(data));
    };
    const std::shared_ptr<const PlanData> plan = reduced(part.mechanism, described_);
    PlanTrial trial = tried(plan, families);
    if (trial.moves && !moving_) {
      moving_ = part;
    }
    if (trial.holds) {
      if (part.mechanism.drivers().empty()) {
        return with_others(*plan, described_);
      }
      bool assembles = false;
      const double length = solve::longest_on_links(Values(plan, {}));
      for (const double by : {on, -on, finer, -finer}) {
        if (assembles && std::abs(by) < on) {
          break;
        }
        const auto driven = std::make_shared<const plan::Described>(plan::Described{
            described_->mechanism.driven_on(by, length), described_->request, described_->excess});
        const PlanTrial further =
            tried(reduced(part.mechanism.driven_on(by, length), driven), families);
        if (further.holds) {
          return with_others(*plan, described_);
        }
        assembles = assembles || further.assembles;
      }
      trial.refusal = plan::refusal_where_driven_on(*plan, assembles);
    }
    if (trial.refusal && (trial.refusal->gap < refusal_.gap * (1 - rounding) ||
                          std::string(refusal_.what()) == described_->excess.what())) {
      refusal_ = *trial.refusal;
    }
    return nullptr;
  }

  std::shared_ptr<const plan::Described> described_;
  OverConstrained refusal_;
  std::optional<MechanismError> flaw_;             ///< of a choice with unusable numbers
  bool has_groups_ = false;                        ///< whether some choice leaves supported groups
  bool is_tried_ = false;                          ///< whether some choice has usable numbers
  std::optional<plan::BalancedMechanism> moving_;  ///< the first that moves at its own numbers
};

}  // namespace

std::shared_ptr<const PlanData> chosen_plan(const Mechanism& mechanism, const Request& request) {
  plan::expect_usable(mechanism, request);
  const plan::FoundStructure found = plan::found_structure(mechanism);
  if (const auto* const excess = std::get_if<OverConstrained>(&found)) {
    Chooser chooser(mechanism, request, *excess);
    std::shared_ptr<const PlanData> plan = chooser.choose();
    return plan ? plan : (chooser.refuse(), nullptr);
  }
  if (const auto* const fault = std::get_if<MechanismError>(&found)) {
    throw MechanismError(*fault);
  }
  const Structure& structure = std::get<Structure>(found);
  if (request.reported.everything()) {
    return std::make_shared<const PlanData>(plan::plan_of(mechanism, request, structure));
  }
  const plan::ReportedPart part = plan::reported_part(mechanism, structure, request);
  return std::make_shared<const PlanData>(
      plan::plan_of(part.mechanism, part.request, structure_of(part.mechanism)));
}

}  // namespace assur::mechanism::choose
