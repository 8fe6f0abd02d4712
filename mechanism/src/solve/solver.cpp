#include "solver.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/plan.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "branch_motions.hpp"
#include "closing_gaps.hpp"
#include "configuration_order.hpp"
#include "family_search.hpp"
#include "group_words.hpp"
#include "limits.hpp"
#include "placement.hpp"
#include "plan/plan_data.hpp"
#include "redundant_joints.hpp"
#include "reference.hpp"
#include "search_bounds.hpp"

namespace assur::mechanism::solve {

/// Walks depth first through the configurations of the groups: what is placed stays placed while
/// the groups behind it are solved, and is overwritten by the next configuration.
class ConfigurationWalk {
 public:
  explicit ConfigurationWalk(const Values& values)
      : placement_(values),
        placed_(placement_.placed()),
        plan_(placement_.plan()),
        structure_(placement_.structure()),
        values_(placement_.values()),
        gaps_(placement_),
        families_(placement_, gaps_),
        order_(plan_.named_parts),
        limited_(structure_.groups.size() + 1),
        referred_(structure_.groups.size() + 1) {
    find_what_is_placed_when();
  }

  void run(const Search& search, Solution& result) {
    search_ = search;
    seeks_nearest_ = false;
    cuts_ =
        search.within_limits && has_limits_ && most_configurations(structure_) > Plan::most_listed;
    walk(result);
  }

  std::optional<Nearest> run_to_nearest(Solution& result) {
    search_ = Search();
    seeks_nearest_ = true;
    cuts_ = has_limits_;
    walk(result);
    if (result.configurations.empty()) {
      return std::nullopt;
    }
    const bool has_runner_up = std::isfinite(next_square_);
    return Nearest{0, std::sqrt(least_square_),
                   has_runner_up ? std::optional(std::sqrt(next_square_)) : std::nullopt};
  }

 private:
  /// After how many groups each limited joint has its coordinate, and each link of the reference
  /// its angle.
  void find_what_is_placed_when() {
    Table<LinkIndex, std::size_t> groups_before(structure_.linkage.links.size(), 0);
    for (const GroupIndex group : structure_.groups.keys()) {
      for (const LinkIndex link : structure_.groups[group].links) {
        groups_before[link] = group.place() + 1;
      }
    }
    for (const DrivenLink& link : structure_.driven) {
      groups_before[link.to] = link.groups_before;
    }
    const Mechanism& mechanism = plan_.mechanism;
    for (const JointIndex joint : mechanism.joints().keys()) {
      if (mechanism.joints()[joint].lowest.exists()) {
        std::size_t groups = 0;
        for (const FeatureIndex feature : mechanism.joints()[joint].between) {
          groups = std::max(groups, groups_before[mechanism.features()[feature].link]);
        }
        limited_[groups].push_back(joint);
        has_limits_ = true;
      }
    }
    for (const ReferenceAngle& angle : plan_.request.reference) {
      referred_[groups_before[angle.link]].push_back(angle);
    }
  }

  void walk(Solution& result) {
    begin(result);
    descend(0);
    solution_->configurations.resize(listed_);
    conclude();
  }

  /// Whatever the last position was left in.
  void begin(Solution& result) {
    placement_.begin();
    gaps_.begin(search_.measures_gap);
    families_.begin(result.families, seeks_nearest_);
    solution_ = &result;
    result.status = SolutionStatus::ok;
    result.mobility = 0;
    result.reason.clear();
    result.left_out = cuts_ ? std::nullopt : std::optional<std::size_t>(0);
    is_inconsistent_ = false;
    listed_ = 0;
    has_cut_ = false;
    square_ = 0;
    least_square_ = next_square_ = std::numeric_limits<double>::infinity();
  }

  /// Solves the groups from one on, where all before it are placed.
  void descend(std::size_t depth) {
    placement_.move_driven_links(depth);
    if (cuts_ && !keeps_limits_at(depth)) {
      has_cut_ = true;
      return;
    }
    const double square = square_;
    if (seeks_nearest_) {
      square_ += square_of_differences(referred_[depth]);
    }
    if (square_ < next_square_) {
      descend_on(depth);
    }
    square_ = square;
  }

  [[nodiscard]] bool keeps_limits_at(std::size_t depth) const {
    return std::ranges::all_of(limited_[depth], [this](JointIndex joint) {
      return keeps_limits(values_, placed_.links, placed_.slides, joint);
    });
  }

  [[nodiscard]] double square_of_differences(const std::vector<ReferenceAngle>& angles) const {
    double square = 0;
    for (const ReferenceAngle& angle : angles) {
      const double difference = difference_from(values_, placed_.links[angle.link], angle);
      square += difference * difference;
    }
    return square;
  }

  void descend_on(std::size_t depth) {
    if (depth == structure_.groups.size()) {
      list();
      return;
    }
    const GroupIndex group(depth);
    const GroupModel& model = *structure_.groups[group].model;
    if (!placement_.solver(group).has_normal_form()) {
      families_.add(group, 0, values_.group(group).obstacle);
      return;
    }
    placement_.hold(group);
    if (!model.rigid) {
      const bool compatible = placement_.solver(group).is_compatible();
      families_.add(group, compatible ? model.mobility : 0,
                    reason_of_model(values_, group, compatible));
      return;
    }
    const models::GroupAssemblies& found = placement_.assemble(group);
    gaps_.meet(group);
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.mobility > 0) {
      families_.add(group, found.mobility, reason_of_freedom(values_, group));
    } else if (found.count == 0 && listed_ == 0) {
      gaps_.fail(group);
    }
    const Status regularity = placed_.regularity;
    const double residual = placed_.residual;
    const bool derivatives_known = placed_.derivatives_known;
    const bool rates_known = placed_.rates_known;
    const Visits visits = order_of_visits(group, found.count);
    for (std::size_t visit = 0; visit < found.count; ++visit) {
      placed_.regularity = regularity;
      placed_.residual = residual;
      placed_.derivatives_known = derivatives_known;
      placed_.rates_known = rates_known;
      placement_.place(group, visits[visit]);
      descend(depth + 1);
    }
  }

  using Visits = std::array<std::size_t, models::most_configurations>;

  /// The configurations of a group as they are found; where the nearest one is sought, those first
  /// that are nearer.
  [[nodiscard]] Visits order_of_visits(GroupIndex group, std::size_t count) {
    Visits order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (seeks_nearest_) {
      std::array<double, models::most_configurations> squares{};
      for (std::size_t index = 0; index < count; ++index) {
        placement_.place(group, index);
        squares[index] = square_of_differences(referred_[group.place() + 1]);
      }
      std::stable_sort(
          order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
          [&](std::size_t one, std::size_t other) { return squares[one] < squares[other]; });
    }
    return order;
  }

  /// A configuration in which everything is placed.
  void list() {
    const bool is_consistent =
        holds_redundantly(values_, placed_.links, placed_.regularity, placed_.rates_known);
    if (!is_consistent && search_.within_limits) {
      is_inconsistent_ = true;
      return;
    }
    if (seeks_nearest_) {
      if (square_ >= least_square_) {
        next_square_ = square_;
        return;
      }
      next_square_ = least_square_;
      least_square_ = square_;
      listed_ = 0;
    }
    bool keeps = true;
    if (has_limits_ && !cuts_) {
      for (std::size_t depth = 0; depth < limited_.size() && keeps; ++depth) {
        keeps = keeps_limits_at(depth);
      }
    }
    if (!keeps && search_.within_limits) {
      ++*solution_->left_out;
      return;
    }
    expect_room();
    if (listed_ == solution_->configurations.size()) {
      solution_->configurations.emplace_back();
    }
    Configuration& result = solution_->configurations[listed_++];
    const Mechanism& mechanism = plan_.mechanism;
    result.links.resize(mechanism.links().size());
    for (const LinkIndex link : mechanism.links().keys()) {
      result.links[link] = placed_.links[link];
    }
    result.slides = placed_.slides;
    result.outputs.resize(mechanism.outputs().size());
    for (const OutputIndex output : mechanism.outputs().keys()) {
      const FeatureIndex point = mechanism.outputs()[output].point;
      carry(placed_.links[mechanism.features()[point].link], values_.frame(point),
            result.outputs[output]);
    }
    result.regularity = placed_.regularity;
    result.derivatives_known = placed_.derivatives_known;
    result.rates_known = placed_.rates_known;
    result.path_known = placed_.derivatives_known;
    result.residual = placed_.residual;
    result.is_consistent = is_consistent;
    result.within_limits = keeps;
    result.branches.clear();
    result.determinants = placed_.determinants;
    result.plan = placement_.shared_plan();
    const Want& want = plan_.request.want;
    if (!result.rates_known && (want.velocity || want.acceleration)) {
      find_branches(values_, placed_, result);
    }
    if (!result.derivatives_known && plan_.request.sweep) {
      find_derivatives(values_, placed_, plan_.request.sweep->parameter, result);
    }
  }

  /// Of a configuration with its derivatives to each parameter.
  void expect_room() const {
    const double parameters = 1 + static_cast<double>(values_.columns().size());
    const double numbers = static_cast<double>(structure_.linkage.links.size()) *
                           (12 + 3 * parameters * (values_.second_order() ? parameters : 1));
    if (listed_ == Plan::most_listed || static_cast<double>(listed_) * numbers > most_numbers) {
      refuse_search(structure_, "no more than " + std::to_string(listed_) + " can be listed");
    }
  }

  void conclude() {
    if (is_inconsistent_ && solution_->configurations.empty() && solution_->families.empty()) {
      throw OverConstrained(*plan_.excess);
    }
    if (solution_->configurations.empty()) {
      conclude_without_configurations();
      return;
    }
    order_.sort(solution_->configurations);
  }

  void conclude_without_configurations() {
    if (solution_->families.empty()) {
      solution_->status = SolutionStatus::no_assembly;
      solution_->reason = has_cut_ ? "what can be assembled is beyond the limits of joints"
                          : solution_->left_out > 0
                              ? "of " + std::to_string(*solution_->left_out) +
                                    " configurations each is beyond the limits of a joint"
                              : gaps_.reason();
      return;
    }
    solution_->status = SolutionStatus::degenerate;
    const auto freest = std::max_element(
        solution_->families.begin(), solution_->families.end(),
        [](const Family& one, const Family& other) { return one.mobility < other.mobility; });
    solution_->mobility = freest->mobility;
    solution_->reason = freest->reason;
  }

  Placement placement_;
  PlacedLinks& placed_;  ///< those of the placement
  const PlanData& plan_;
  const Structure& structure_;
  const Values& values_;
  ClosingGaps gaps_;
  FamilySearch families_;
  ConfigurationOrder order_;
  Search search_;
  bool seeks_nearest_ = false;
  bool cuts_ = false;             ///< whether what is beyond limits is left as soon as it is placed
  bool has_cut_ = false;          ///< whether something was
  Solution* solution_ = nullptr;  ///< that is being written
  bool is_inconsistent_ = false;  ///< constraints that are too many did not hold somewhere
  std::size_t listed_ = 0;        ///< configurations; those behind are of an earlier solution
  std::vector<std::vector<JointIndex>> limited_;       ///< by the groups before them
  std::vector<std::vector<ReferenceAngle>> referred_;  ///< likewise
  bool has_limits_ = false;
  double square_ = 0;  ///< of the distance from the reference, of what is placed
  double least_square_ = 0, next_square_ = 0;  ///< of the nearest configuration, and the next one
};

MechanismSolver::MechanismSolver(const Values& values)
    : walk_(std::make_unique<ConfigurationWalk>(values)) {}
MechanismSolver::~MechanismSolver() = default;

void MechanismSolver::solve(const Search& search, Solution& result) { walk_->run(search, result); }

std::optional<Nearest> MechanismSolver::solve_nearest(Solution& result) {
  return walk_->run_to_nearest(result);
}

}  // namespace assur::mechanism::solve
