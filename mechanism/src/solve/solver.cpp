#include "solver.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/plan.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "closing_gaps.hpp"
#include "configuration_order.hpp"
#include "family_search.hpp"
#include "group_order.hpp"
#include "group_words.hpp"
#include "listed_configuration.hpp"
#include "plan/plan_data.hpp"
#include "plan/refusals.hpp"
#include "redundant_joints.hpp"
#include "search_bounds.hpp"
#include "settled_redundancy.hpp"
#include "watched_limits.hpp"

namespace assur::mechanism::solve {

namespace {

/// A number for each configuration of a group.
using Squares = std::array<double, models::most_configurations>;

}  // namespace

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
        nearness_(placement_),
        order_(plan_.named_parts),
        group_order_(placement_),
        limits_(placement_),
        watched_(values_),
        redundancy_(SettledRedundancy::made_for(values_)),
        is_ordered_by_groups_(most_configurations(structure_) > Plan::most_listed) {}

  void run(const Search& search, Solution& result) {
    nearness_.seek_nothing();
    number_ = 0;
    walk(search, search.within_limits && limits_.exist() && is_ordered_by_groups_, result);
  }

  void count_from(std::vector<NearbyConfigurations> nearby) {
    placement_.count_from(std::move(nearby));
  }
  [[nodiscard]] bool is_count_ambiguous() const { return placement_.is_count_ambiguous(); }
  [[nodiscard]] bool is_count_in_doubt() const { return placement_.is_count_in_doubt(); }
  /// Whether, since the last search began, a place that groups hardly determine was found not to be
  /// a configuration: rounding may have moved it away from one.
  [[nodiscard]] bool is_unsure() const { return is_unsure_; }
  /// See `MechanismSolver::refusal`; of the last search.
  [[nodiscard]] const std::optional<OverConstrained>& refusal() const { return refusal_; }

  std::size_t run_to(std::size_t number, Solution& result) {
    nearness_.seek_nothing();
    number_ = number;
    walk({}, limits_.exist(), result);
    return passed_;
  }

  std::optional<Nearest> run_to_nearest(Solution& result) {
    nearness_.seek_reference();
    number_ = 0;
    walk({}, limits_.exist(), result);
    return nearest();
  }

  std::optional<Nearest> run_near(const SoughtPoint& point, Solution& result) {
    nearness_.seek(point);
    number_ = 0;
    farthest_square_ = point.farthest * point.farthest;
    walk({.within_limits = false}, false, result);
    farthest_square_ = std::numeric_limits<double>::infinity();
    return nearest();
  }

 private:
  /// Returns what a search for the nearest configuration has found, if anything.
  [[nodiscard]] std::optional<Nearest> nearest() const {
    if (listed_ == 0) {
      return std::nullopt;
    }
    const bool has_runner_up = std::isfinite(next_square_);
    return Nearest{0, std::sqrt(least_square_),
                   has_runner_up ? std::optional(std::sqrt(next_square_)) : std::nullopt};
  }

  /// Solves all groups and lists the configurations. If `cuts` is set, a placement beyond the
  /// limits of joints is abandoned at once.
  void walk(const Search& search, bool cuts, Solution& result) {
    search_ = search;
    cuts_ = cuts;
    only_consistent_ = search.within_limits || !plan_.request.redundancy_tolerance.exists();
    leaves_inconsistent_ = only_consistent_;
    walk_on(result);
    if (has_left_inconsistent_ && lacks_all()) {  // the error tells by how much they fail to hold
      leaves_inconsistent_ = false;
      walk_on(result);
    }
    conclude();
  }

  void walk_on(Solution& result) {
    begin(result);
    descend(0);
    solution_->configurations.resize(listed_);
  }

  /// Whether neither a configuration nor a family was found, not even beyond limits.
  [[nodiscard]] bool lacks_all() const {
    return passed_ == 0 && listed_ == 0 && solution_->families.empty() &&
           solution_->left_out.value_or(0) == 0;
  }

  /// Resets the solver and the result, whatever state the last position left them in.
  void begin(Solution& result) {
    placement_.begin();
    gaps_.begin(search_.measures_gap);
    families_.begin(result.families, seeks_one());
    solution_ = &result;
    result.status = SolutionStatus::ok;
    result.mobility = 0;
    result.reason.clear();
    result.incomplete.clear();
    result.dropped = 0;
    result.drop_reason.clear();
    result.breaches.clear();
    result.nearest_to_limits.reset();
    result.left_out = cuts_ ? std::nullopt : std::optional<std::size_t>(0);
    refusal_.reset();
    is_inconsistent_ = has_settled_ = is_unsure_ = has_left_inconsistent_ = false;
    least_gap_ = std::numeric_limits<double>::infinity();
    listed_ = passed_ = 0;
    has_cut_ = false;
    square_ = 0;
    least_square_ = std::numeric_limits<double>::infinity();
    next_square_ = farthest_square_;
  }

  /// Whether a single configuration is sought, in the memory of one.
  [[nodiscard]] bool seeks_one() const { return nearness_.is_sought() || number_ > 0; }
  [[nodiscard]] bool is_found() const { return number_ > 0 && passed_ == number_; }

  /// Solves the groups from one on, where all before it are placed.
  void descend(std::size_t depth) {
    if (!placement_.move_carried_links(depth)) {
      ++solution_->dropped;
      solution_->drop_reason = placement_.flaw();
      return;
    }
    if (cuts_ && !limits_.are_kept_at(depth, solution_->breaches)) {
      has_cut_ = true;
      return;
    }
    if (leaves_inconsistent_ && placed_.regularity == Status::ok &&
        !watched_.may_hold_at(depth, placed_.links)) {
      has_left_inconsistent_ = true;
      return;
    }
    const double square = square_;
    if (nearness_.is_sought()) {
      square_ += nearness_.square_at(depth);
    }
    if (square_ < next_square_) {
      descend_on(depth);
    }
    square_ = square;
  }

  void descend_on(std::size_t depth) {
    if (depth == structure_.groups.size()) {
      list();
      return;
    }
    const GroupIndex group(depth);
    if (!placement_.solver(group).has_normal_form()) {
      families_.add(group, 0, values_.group(group).obstacle);
      return;
    }
    placement_.hold(group);
    const models::GroupAssemblies& found = placement_.assemble(group);
    gaps_.meet(group);
    is_unsure_ = is_unsure_ || (found.count == 0 && placed_.regularity != Status::ok);
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.status == AssemblyStatus::unsound_arithmetic) {
      throw MechanismError(
          "links",
          "the arithmetic of this build or of its process does not round as double precision "
          "does; compile without -ffast-math and its parts, and with -mfpmath=sse");
    }
    if (found.complex_count && solution_->incomplete.empty()) {
      solution_->incomplete = reason_of_incompleteness(values_, group, *found.complex_count);
    }
    if (found.mobility > 0) {
      families_.add(group, found.mobility, reason_of_freedom(values_, group));
    } else if (found.count == 0 && gaps_.is_in_doubt(group)) {
      families_.add(group, 0, reason_of_doubt(values_, group));
    } else if (!found.is_compatible) {
      families_.add(group, 0, reason_of_conflict(values_, group));
    } else if (found.count == 0 && listed_ == 0) {
      gaps_.fail(group);
    }
    const auto known = [&] {
      return std::tie(placed_.regularity, placed_.residual, placed_.derivatives_known,
                      placed_.path_known, placed_.rates_known);
    };
    const std::tuple<Status, double, bool, bool, bool> before = known();
    Squares squares{};
    const Visits visits = order_of_visits(group, found.count, squares);
    for (std::size_t visit = 0; visit < found.count && !is_found(); ++visit) {
      if (!(square_ + squares[visits[visit]] < next_square_)) {
        break;
      }
      known() = before;
      placement_.place(group, visits[visit]);
      descend(depth + 1);
    }
  }

  /// The order of visiting a group's configurations: nearer ones first if the nearest is sought; in
  /// the group's own order if they are numbered group by group; otherwise as they were found.
  /// `squares`: what each of them adds to the squared distance from what is sought, zero where that
  /// is not known yet.
  [[nodiscard]] Visits order_of_visits(GroupIndex group, std::size_t count, Squares& squares) {
    Visits order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (nearness_.is_sought()) {
      for (std::size_t index = 0; index < count; ++index) {
        placement_.stand(group, index);
        squares[index] = nearness_.square_of(group);
      }
      std::stable_sort(
          order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
          [&](std::size_t one, std::size_t other) { return squares[one] < squares[other]; });
    } else if (is_ordered_by_groups_ && count > 1) {
      group_order_.sort(group, count, order);
    }
    return order;
  }

  /// Lists the configuration that is placed. Where constraints are redundant and the others hardly
  /// determine it, all of them together do.
  void list() {
    placement_.note_listed();
    const double gap = gap_of_redundant(values_, placed_.links, placed_.regularity);
    // Rounding may leave regular groups further apart than it leaves all constraints together.
    const bool is_certain =
        placed_.regularity == Status::ok &&
        (gap == 0 || gap_of_redundant(values_, placed_.links, Status::near_singular) > 0);
    if (!redundancy_ || is_certain) {
      list_placed(gap, !placed_.rates_known ||
                           goes_on_redundantly(values_, placed_.links, placed_.regularity));
      return;
    }
    const PlacedLinks without = placed_;
    has_settled_ = true;
    const double left = redundancy_->settle(placed_);
    is_unsure_ = is_unsure_ || left > 0;
    list_placed(left, redundancy_->goes_on());
    placed_ = without;
  }

  /// `gap`: by how much redundant constraints are open; `goes_on`: whether they continue to hold.
  void list_placed(double gap, bool goes_on) {
    const bool is_consistent = gap == 0 && goes_on;
    if (!is_consistent && only_consistent_) {
      is_inconsistent_ = true;
      least_gap_ = std::min(least_gap_, gap);
      return;
    }
    if (has_settled_ && is_consistent && !is_told_apart()) {
      return;
    }
    if (nearness_.is_sought()) {
      if (square_ >= least_square_) {
        next_square_ = square_;
        return;
      }
      next_square_ = std::min(next_square_, least_square_);
      least_square_ = square_;
      listed_ = 0;
    }
    const bool keeps = !limits_.exist() || cuts_ || limits_.are_kept(solution_->breaches);
    if (!keeps && search_.within_limits) {
      ++*solution_->left_out;
      if (search_.measures_gap && listed_ == 0) {
        limits_.keep_nearest(solution_->nearest_to_limits);
      }
      return;
    }
    ++passed_;
    if (passed_ < number_) {
      return;
    }
    expect_room(values_, listed_);
    if (listed_ == solution_->configurations.size()) {
      solution_->configurations.emplace_back();
    }
    Configuration& result = solution_->configurations[listed_++];
    result.is_consistent = is_consistent;
    result.within_limits = keeps;
    write_configuration(placement_, result);
  }

  /// Removes listed configurations that the placed one rules out; false if it is itself ruled out.
  [[nodiscard]] bool is_told_apart() {
    using Comparison = SettledRedundancy::Comparison;
    std::vector<Configuration>& all = solution_->configurations;
    for (std::size_t place = 0; place < listed_; ++place) {
      const Comparison found =
          redundancy_->compared(poses_of(all[place].links), poses_of(placed_.links));
      if (found == Comparison::second_is_none) {
        return false;
      }
      if (found == Comparison::first_is_none && !seeks_one()) {
        std::swap(all[place--], all[--listed_]);
        --passed_;
      }
    }
    return true;
  }

  void conclude() {
    if (is_unsure_ && solution_->incomplete.empty()) {
      solution_->incomplete =
          "beside a singular position rounding decides whether some places are configurations";
    }
    if (passed_ > listed_) {  // a single configuration was sought, and there are others
      return;
    }
    if (is_inconsistent_ && lacks_all()) {
      const OverConstrained refusal = plan::refusal_of_redundant(plan_, least_gap_);
      solution_->status = SolutionStatus::no_assembly;
      solution_->reason = refusal.what();
      if (search_.within_limits) {
        refusal_ = refusal;
      }
      return;
    }
    if (solution_->configurations.empty() && solution_->dropped > 0 &&
        solution_->families.empty() && search_.within_limits && solution_->left_out == 0) {
      throw MechanismError("", solution_->drop_reason);
    }
    if (solution_->configurations.empty()) {
      conclude_without_configurations();
      return;
    }
    solution_->nearest_to_limits.reset();
    if (!is_ordered_by_groups_) {
      order_.sort(solution_->configurations);
    }
  }

  void conclude_without_configurations() {
    if (solution_->families.empty()) {
      solution_->status = SolutionStatus::no_assembly;
      const std::string breaches = breaches_text(plan_.mechanism, solution_->breaches);
      solution_->reason =
          has_cut_ ? "what can be assembled is beyond the limits of joints: " + breaches
          : solution_->left_out > 0 ? reason_of_limits(*solution_->left_out, breaches)
          : solution_->dropped > 0  ? solution_->drop_reason
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
  Nearness nearness_;
  ConfigurationOrder order_;
  GroupOrder group_order_;
  WatchedLimits limits_;
  WatchedRedundancy watched_;
  std::optional<SettledRedundancy> redundancy_;
  /// Where there may be more configurations than can be listed, they are numbered as they are met,
  /// so that the first of them are found without the others.
  bool is_ordered_by_groups_;
  Search search_;
  std::size_t number_ = 0;        ///< of the configuration that is sought; zero if none is
  std::size_t passed_ = 0;        ///< configurations so far
  bool cuts_ = false;             ///< whether what is beyond limits is left as soon as it is placed
  bool has_cut_ = false;          ///< whether something was left like that
  Solution* solution_ = nullptr;  ///< that is being written
  /// Whether places at which redundant constraints do not hold are left out. A sweep keeps them
  /// where a tolerance lets these hold in a part of its range.
  bool only_consistent_ = true;
  bool leaves_inconsistent_ = false;  ///< as soon as a redundant joint cannot hold
  bool has_left_inconsistent_ = false;
  std::optional<OverConstrained> refusal_;
  bool is_inconsistent_ = false;  ///< redundant constraints did not hold somewhere
  double least_gap_ = 0;          ///< by which they failed to hold
  bool has_settled_ = false;      ///< some of them by all constraints
  bool is_unsure_ = false;        ///< see `is_unsure`
  std::size_t listed_ = 0;        ///< configurations; those behind are of an earlier solution
  double square_ = 0;             ///< of the distance from what is sought, of what is placed
  double least_square_ = 0, next_square_ = 0;  ///< of the nearest configuration, and the next one
  /// Within which a configuration is sought.
  double farthest_square_ = std::numeric_limits<double>::infinity();
};

MechanismSolver::MechanismSolver(const Values& values)
    : walk_(std::make_unique<ConfigurationWalk>(values)), others_(values) {}
MechanismSolver::~MechanismSolver() = default;

template <typename Search, typename Question>
auto MechanismSolver::searched(const Search& search, const Question& question, Solution& result) {
  auto own = search(*walk_);
  refusal_ = walk_->refusal();
  decltype(own) other{};
  const auto ask = [&](MechanismSolver& solver, Solution& found) {
    other = question(solver, found);
  };
  return others_.settle(*this, ask, result, refusal_) ? other : own;
}

void MechanismSolver::solve(const Search& search, Solution& result) {
  (void)searched(
      [&](ConfigurationWalk& walk) {
        walk.run(search, result);
        return true;
      },
      [&](MechanismSolver& other, Solution& found) {
        other.solve(search, found);
        return true;
      },
      result);
}

std::size_t MechanismSolver::solve_one(std::size_t number, Solution& result) {
  return searched(
      [&](ConfigurationWalk& walk) { return walk.run_to(number, result); },
      [&](MechanismSolver& other, Solution& found) { return other.solve_one(number, found); },
      result);
}

std::optional<Nearest> MechanismSolver::solve_nearest(Solution& result) {
  return searched(
      [&](ConfigurationWalk& walk) { return walk.run_to_nearest(result); },
      [](MechanismSolver& other, Solution& found) { return other.solve_nearest(found); }, result);
}

std::optional<Nearest> MechanismSolver::solve_near(const SoughtPoint& point, Solution& result) {
  return searched(
      [&](ConfigurationWalk& walk) { return walk.run_near(point, result); },
      [&](MechanismSolver& other, Solution& found) { return other.solve_near(point, found); },
      result);
}

bool MechanismSolver::is_unsure() const { return walk_->is_unsure(); }

void MechanismSolver::count_from(std::vector<NearbyConfigurations> nearby) {
  others_.keep_own_choice(!nearby.empty());
  walk_->count_from(std::move(nearby));
}

bool MechanismSolver::is_count_ambiguous() const { return walk_->is_count_ambiguous(); }

bool MechanismSolver::is_count_in_doubt() const { return walk_->is_count_in_doubt(); }

}  // namespace assur::mechanism::solve
