#include "solver.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/plan.hpp>
#include <assur/text/names.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "branch_motions.hpp"
#include "configuration_order.hpp"
#include "group_solver.hpp"
#include "limits.hpp"
#include "plan/plan_data.hpp"
#include "redundant_joints.hpp"
#include "reference.hpp"

namespace assur::mechanism::solve {

namespace {

/// What a search takes at most: groups that are solved, families that are told, and numbers that
/// the list of configurations holds (800 MB).
constexpr std::size_t most_steps = 300000;
constexpr std::size_t most_families = 1000;
constexpr double most_numbers = 1e8;

std::string whole_number(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), number < 1e15 ? "%.0f" : "%.3g", number);
  return text.data();
}

std::string short_number(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

}  // namespace

double most_configurations(const Structure& structure) {
  double product = 1;
  for (const FoundGroup& group : structure.groups) {
    product *= std::max(1, group.model->max_configurations);
  }
  return product;
}

/// Walks depth first through the configurations of the groups: what is placed stays placed while
/// the groups behind it are solved, and is overwritten by the next configuration.
class ConfigurationWalk {
 public:
  explicit ConfigurationWalk(const Values& values)
      : plan_(values.shared_plan()),
        structure_(plan_->structure),
        given_(values),
        settled_(structure_.reading.empty() ? std::nullopt : std::optional(values)),
        values_(settled_ ? *settled_ : given_),
        order_(plan_->named_parts),
        failures_(structure_.groups.size()),
        chosen_(structure_.groups.size(), 0),
        limited_(structure_.groups.size() + 1),
        referred_(structure_.groups.size() + 1) {
    const auto parameters = static_cast<Eigen::Index>(values.columns().size());
    placed_.links.resize(structure_.linkage.links.size());
    placed_.links[structure_.linkage.ground] = Frame::identity(parameters, values.second_order());
    placed_.displaced.assign(structure_.linkage.links.size(), {});
    placed_.groups.resize(structure_.groups.size());
    if (plan_->request.sweep) {
      placed_.determinants.resize(structure_.groups.size());
    }
    std::size_t slides = 0;
    for (const DrivenLink& link : structure_.driven) {
      slides += structure_.linkage.joints[link.joint].prismatic ? 1 : 0;
    }
    solvers_.reserve(structure_.groups.size());
    for (const GroupIndex group : structure_.groups.keys()) {
      solvers_.add(GroupSolver(values_, group));
      first_slide_.add(slides);
      for (const ModelUnknown& unknown : structure_.groups[group].model->unknowns) {
        slides += unknown.is_angle ? 0 : 1;
      }
    }
    placed_.slides.resize(slides);
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
    const Mechanism& mechanism = plan_->mechanism;
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
    for (const ReferenceAngle& angle : plan_->request.reference) {
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
    if (settled_) {
      *settled_ = given_;
    }
    solution_ = &result;
    result.status = SolutionStatus::ok;
    result.mobility = 0;
    result.reason.clear();
    result.families.clear();
    result.left_out = cuts_ ? std::nullopt : std::optional<std::size_t>(0);
    placed_.regularity = Status::ok;
    placed_.derivatives_known = true;
    placed_.rates_known = true;
    placed_.residual = 0;
    is_inconsistent_ = false;
    listed_ = 0;
    steps_ = 0;
    has_cut_ = false;
    for (Failures& failures : failures_) {
      failures = Failures();
    }
    square_ = 0;
    least_square_ = next_square_ = std::numeric_limits<double>::infinity();
  }

  /// What drivers say and move once the groups before one are placed, unless it is against links
  /// that are left unplaced, or by what those say.
  void move_driven_links(std::size_t groups, Table<LinkIndex, bool>* unplaced = nullptr) {
    const auto is_missing = [unplaced](LinkIndex link) {
      return unplaced != nullptr && (*unplaced)[link];
    };
    const auto is_unread = [&](const ReadingDriver& one) {
      return std::ranges::any_of(one.reads, is_missing);
    };
    auto reading =
        std::ranges::lower_bound(structure_.reading, groups, {}, &ReadingDriver::groups_before);
    const auto settle_what_reads = [&](std::size_t links) {
      for (; reading != structure_.reading.end() && reading->groups_before == groups &&
             reading->links_before <= links;
           ++reading) {
        if (!is_unread(*reading)) {
          settled_->settle(reading->driver, [this](JointIndex joint) {
            return coordinate_of(values_, placed_.links, placed_.slides, joint);
          });
          if (!values_.motion(reading->driver).is_known()) {
            placed_.regularity = Status::near_singular;
            placed_.derivatives_known = placed_.rates_known = false;
          }
        }
      }
    };
    std::size_t slide = 0;
    for (std::size_t place = 0; place < structure_.driven.size(); ++place) {
      settle_what_reads(place);
      const DrivenLink& link = structure_.driven[place];
      const bool slides = structure_.linkage.joints[link.joint].prismatic;
      if (link.groups_before == groups) {
        const bool reads_nothing = std::ranges::any_of(
            structure_.reading,
            [&](const ReadingDriver& one) { return one.driver == link.driver && is_unread(one); });
        if (is_missing(link.from) || reads_nothing) {
          (*unplaced)[link.to] = true;
        } else {
          place_driven_link(place, slides ? &placed_.slides[slide] : nullptr);
        }
      }
      slide += slides ? 1 : 0;
    }
    settle_what_reads(structure_.driven.size());
  }

  void place_driven_link(std::size_t place, SlideState* slide) {
    const DrivenLink& link = structure_.driven[place];
    const JointMotion& motion = values_.motion(link.driver);
    const ElementaryJoint& at = structure_.linkage.joints[link.joint];
    set_motion(motion, at.prismatic, at.first == link.from ? 1.0 : -1.0);
    compose(placed_.links[link.from], values_.frame(at.on(link.from)), joint_);
    compose(joint_, motion_, moved_);
    compose(moved_, values_.driven_frame(place), placed_.links[link.to]);
    const Pose<double>& near = values_.frame(at.on(link.from)).pose;
    const Pose<double>& back = values_.driven_frame(place).pose;
    const double position = motion.position.value();
    placed_.displaced[link.to] =
        placed_.displaced[link.from]
            .carries(near.x, near.y, values_.rounding(at.on(link.from)))
            .carries(0, 0,
                     at.prismatic ? support::Displacement::of_slide(position)
                                  : support::Displacement::of_turn(position))
            .carries(back.x, back.y, values_.rounding(at.on(link.to)));
    if (slide != nullptr) {
      set_slide(motion, at.joint, *slide);
    }
  }

  /// The moved frame in that of the joint: turned about its origin, or slid along its x-axis.
  void set_motion(const JointMotion& motion, bool prismatic, double sense) {
    const Dual& position = motion.position;
    const Eigen::Index moved = prismatic ? 0 : 2;
    const double by = sense * position.value();
    motion_.pose =
        prismatic ? Pose<double>{by, 0, {1, 0}} : Pose<double>{0, 0, {std::cos(by), std::sin(by)}};
    motion_.velocity(moved) = sense * motion.velocity;
    motion_.acceleration(moved) = sense * motion.acceleration;
    motion_.velocity(2 - moved) = motion_.acceleration(2 - moved) = 0;
    motion_.follows.set_zero(position.derivatives().size(), values_.second_order());
    motion_.follows.first.row(moved) = sense * position.derivatives().transpose();
    if (values_.second_order()) {
      motion_.follows.second[static_cast<std::size_t>(moved)] = sense * position.hessian();
    }
  }

  void set_slide(const JointMotion& motion, JointIndex joint, SlideState& slide) const {
    slide.joint = joint;
    slide.displacement = motion.position.value();
    slide.velocity = motion.velocity;
    slide.acceleration = motion.acceleration;
    slide.follows.first = motion.position.derivatives().transpose();
    if (values_.second_order()) {
      slide.follows.second = {motion.position.hessian()};
    }
  }

  /// Solves the groups from one on, where all before it are placed.
  void descend(std::size_t depth) {
    move_driven_links(depth);
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
    GroupSolver& solver = solvers_[group];
    const GroupModel& model = *structure_.groups[group].model;
    if (!solver.has_normal_form()) {
      add_family(group, 0, values_.group(group).obstacle, nothing_unplaced());
      return;
    }
    solver.hold(placed_);
    if (!model.rigid) {
      const bool compatible = solver.is_compatible();
      add_family(group, compatible ? model.mobility : 0, reason_of_model(group, compatible),
                 nothing_unplaced());
      return;
    }
    const models::GroupAssemblies& found = assembled(group);
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility),
                 nothing_unplaced());
    } else if (found.count == 0) {
      measure_gap(group);
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
      place(group, visits[visit]);
      if (plan_->request.sweep) {
        placed_.determinants[group] = solver.determinant();
      }
      descend(depth + 1);
    }
  }

  /// Finds the configurations of a group where it is held.
  const models::GroupAssemblies& assembled(GroupIndex group) {
    if (++steps_ > most_steps) {
      refuse("to find them takes more than " + std::to_string(most_steps) + " steps");
    }
    const models::GroupAssemblies& found = solvers_[group].assemble();
    if (search_.measures_gap) {
      failures_[group].met.insert(choices_of(holders_of(group)));
    }
    return found;
  }

  void place(GroupIndex group, std::size_t index) {
    solvers_[group].place(index, first_slide_[group], placed_);
    placed_.groups[group] = {solvers_[group].configuration(index), solvers_[group].displaced()};
    chosen_[group] = index;
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
        place(group, index);
        squares[index] = square_of_differences(referred_[group.place() + 1]);
      }
      std::stable_sort(
          order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
          [&](std::size_t one, std::size_t other) { return squares[one] < squares[other]; });
    }
    return order;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw MechanismError("", "there may be " + whole_number(most_configurations(structure_)) +
                                 " configurations, and " + what +
                                 "; give joints limits, or ask for the one that is nearest to a "
                                 "reference of more links");
  }

  /// Reports a group that moves where it is held, once for each choice of the groups that hold it.
  /// If a later group that does not depend on it cannot be assembled, nothing is reported: the
  /// answer must not depend on which of the two comes first. Nor may it hide another that moves.
  void add_family(GroupIndex group, int mobility, std::string reason,
                  Table<LinkIndex, bool> unplaced) {
    if (seeks_nearest_ && !solution_->families.empty()) {
      return;
    }
    leave_out(group, unplaced);
    const PlacedLinks placed = placed_;
    if (rest_assembles(group.place() + 1, unplaced)) {
      placed_ = placed;
      Family family{group, mobility, std::move(reason), structure_.placed_by_drivers(),
                    placed_.links};
      place_what_holds(group, family.is_placed);
      if (!is_listed(family)) {
        if (solution_->families.size() == most_families) {
          refuse("more than " + std::to_string(most_families) + " families");
        }
        solution_->families.push_back(std::move(family));
      }
      find_families(group.place() + 1, std::move(unplaced));
    }
    placed_ = placed;
  }

  /// Marks the links of the groups that hold a group, and of those that hold these.
  void place_what_holds(GroupIndex group, Table<LinkIndex, bool>& is_placed) const {
    for (const GroupIndex before : structure_.holders_of(group)) {
      if (!is_placed[structure_.groups[before].links.front()]) {
        for (const LinkIndex link : structure_.groups[before].links) {
          is_placed[link] = true;
        }
        place_what_holds(before, is_placed);
      }
    }
  }
  [[nodiscard]] bool is_of(GroupIndex group, LinkIndex link) const {
    const std::vector<LinkIndex>& links = structure_.groups[group].links;
    return std::ranges::find(links, link) != links.end();
  }

  /// Whether the group's family is listed with the same links where they are now: the choices of
  /// groups that do not hold it make no other family of it.
  [[nodiscard]] bool is_listed(const Family& family) const {
    const auto stands_as = [&](const Family& other) {
      for (const LinkIndex link : family.is_placed.keys()) {
        const Pose<double>& one = family.links[link].pose;
        const Pose<double>& two = other.links[link].pose;
        if (family.is_placed[link] &&
            (one.x != two.x || one.y != two.y || one.direction.cos != two.direction.cos ||
             one.direction.sin != two.direction.sin)) {
          return false;
        }
      }
      return family.group == other.group;
    };
    return std::ranges::any_of(solution_->families, stands_as);
  }

  /// Reports the groups from `depth` on that move, whatever becomes of the links left unplaced.
  void find_families(std::size_t depth, Table<LinkIndex, bool> unplaced) {
    move_driven_links(depth, &unplaced);
    if (depth == structure_.groups.size()) {
      return;
    }
    const GroupIndex group(depth);
    GroupSolver& solver = solvers_[group];
    const bool is_asked = can_be_solved(group, unplaced);
    if (!is_asked) {
      leave_out(group, unplaced);
      find_families(depth + 1, std::move(unplaced));
      return;
    }
    solver.hold(placed_);
    const models::GroupAssemblies& found = assembled(group);
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility), unplaced);
    }
    for (std::size_t index = 0; index < found.count; ++index) {
      place(group, index);
      find_families(depth + 1, unplaced);
    }
  }

  /// Whether a group is held, and shaped, by links that are placed.
  [[nodiscard]] bool can_be_solved(GroupIndex group, const Table<LinkIndex, bool>& unplaced) const {
    const auto shapes_it = [&](const ReadingDriver& reading) {
      return std::ranges::any_of(reading.reads, [&](LinkIndex link) { return unplaced[link]; }) &&
             std::ranges::any_of(structure_.driven, [&](const DrivenLink& link) {
               return link.driver == reading.driver && is_of(group, link.to);
             });
    };
    return std::ranges::none_of(structure_.reading, shapes_it) &&
           solvers_[group].has_normal_form() && structure_.groups[group].model->rigid &&
           !values_.numbers_of(group).is_held_by(unplaced);
  }

  [[nodiscard]] Table<LinkIndex, bool> nothing_unplaced() const {
    return Table<LinkIndex, bool>(structure_.linkage.links.size(), false);
  }

  void leave_out(GroupIndex group, Table<LinkIndex, bool>& unplaced) const {
    for (const LinkIndex link : structure_.groups[group].links) {
      unplaced[link] = true;
    }
  }

  /// Whether the groups from `depth` on can be assembled together. Groups that `unplaced` links
  /// hold are left out, and so are groups that move.
  [[nodiscard]] bool rest_assembles(std::size_t depth, Table<LinkIndex, bool> unplaced) {
    move_driven_links(depth, &unplaced);
    if (depth == structure_.groups.size()) {
      return true;
    }
    const GroupIndex group(depth);
    GroupSolver& solver = solvers_[group];
    const bool is_asked = can_be_solved(group, unplaced);
    if (!is_asked) {
      leave_out(group, unplaced);
      return rest_assembles(depth + 1, std::move(unplaced));
    }
    solver.hold(placed_);
    const models::GroupAssemblies& found = assembled(group);
    for (std::size_t index = 0; index < found.count; ++index) {
      place(group, index);
      if (rest_assembles(depth + 1, unplaced)) {
        return true;
      }
    }
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      leave_out(group, unplaced);
      return rest_assembles(depth + 1, std::move(unplaced));
    }
    if (found.count == 0) {
      measure_gap(group);
    }
    return false;
  }

  /// With which configurations of the groups that hold it a group was met, with which it fails to
  /// close, and by how much at least.
  struct Failures {
    std::set<std::vector<std::size_t>> met, failed;
    double least_gap = std::numeric_limits<double>::infinity();
    std::vector<std::string> holders;  ///< then: what holds it, and how it stands
  };

  void measure_gap(GroupIndex group) {
    double gap = 0;
    if (!search_.measures_gap || listed_ > 0 || solvers_[group].gap(gap) != Status::ok) {
      return;
    }
    Failures& failures = failures_[group];
    failures.failed.insert(choices_of(holders_of(group)));
    if (gap < failures.least_gap) {
      failures.least_gap = gap;
      failures.holders = stance_of_holders(group);
    }
  }

  /// The groups that hold a group, and those that hold these, in order.
  [[nodiscard]] std::vector<GroupIndex> holders_of(GroupIndex group) const {
    Table<LinkIndex, bool> is_placed = structure_.placed_by_drivers();
    place_what_holds(group, is_placed);
    std::vector<GroupIndex> holders;
    for (std::size_t place = 0; place < group.place(); ++place) {
      if (is_placed[structure_.groups[GroupIndex(place)].links.front()]) {
        holders.emplace_back(place);
      }
    }
    return holders;
  }

  [[nodiscard]] std::vector<std::size_t> choices_of(const std::vector<GroupIndex>& groups) const {
    std::vector<std::size_t> choices;
    for (const GroupIndex group : groups) {
      choices.push_back(chosen_[group]);
    }
    return choices;
  }

  /// The links of groups that hold a group themselves, each with its angle.
  [[nodiscard]] std::vector<std::string> stance_of_holders(GroupIndex group) const {
    std::vector<std::string> holders;
    for (const LinkIndex link : plan_->mechanism.links().keys()) {
      const bool holds = std::ranges::any_of(
          values_.numbers_of(group).held,
          [link](const values::HeldJoint& joint) { return joint.base == link; });
      const bool is_of_group =
          std::ranges::any_of(structure_.groups, [link](const FoundGroup& other) {
            return std::ranges::find(other.links, link) != other.links.end();
          });
      if (holds && is_of_group) {
        const double degrees =
            angle_of(placed_.links[link].pose.direction) * 180 / std::numbers::pi;
        holders.push_back(structure_.linkage.links[link] + " at " + short_number(degrees) + " deg");
      }
    }
    return holders;
  }

  /// Of the groups that cannot be assembled the one that fails by least is told.
  [[nodiscard]] std::string reason_of_failure() const {
    const auto least = std::ranges::min_element(failures_, {}, &Failures::least_gap);
    if (least == failures_.end() || least->failed.empty()) {
      return "";
    }
    const GroupIndex group(static_cast<std::size_t>(least - failures_.begin()));
    const FoundGroup& found = structure_.groups[group];
    std::string reason = "group " + std::to_string(group.place() + 1) + " (" +
                         found.model->group->name + " " + found.kind + ": " +
                         text::listed(structure_.names_of(found.links)) + "): the joints " +
                         text::listed(joint_names(group, false)) + " fail to close by " +
                         short_number(least->least_gap) + " at least";
    std::vector<std::string> holders;
    for (const GroupIndex holder : holders_of(group)) {
      holders.push_back(std::to_string(holder.place() + 1));
    }
    if (!holders.empty()) {
      reason += ", in " + std::to_string(least->failed.size()) + " of " +
                std::to_string(least->met.size()) + " configurations of " +
                (holders.size() == 1 ? "group " : "the groups ") + text::listed(holders) +
                " (by so little with " + text::listed(least->holders) + ")";
    }
    if (const std::string& flaw = values_.group(group).flaw; !flaw.empty()) {
      reason += "; " + flaw;
    }
    return reason;
  }

  [[nodiscard]] std::vector<std::string> joint_names(GroupIndex group, bool slides_only) const {
    const RoleAssignment& roles = *values_.group(group).roles;
    std::vector<std::string> names;
    for (const ElementaryJointIndex joint : roles.joints) {
      const ElementaryJoint& at = structure_.linkage.joints[joint];
      if (at.prismatic || !slides_only) {
        names.push_back(at.name);
      }
    }
    return names;
  }

  [[nodiscard]] std::string reason_of_freedom(GroupIndex group, int mobility) const {
    return "the closure of the joints " + text::listed(joint_names(group, false)) +
           (mobility > 0 ? " leaves an angle or a displacement free: infinitely many positions"
                         : " does not determine a position, and no assembly was found");
  }

  [[nodiscard]] std::string reason_of_model(GroupIndex group, bool compatible) const {
    return "prismatic joints close a loop and over-determine its angles (among the joints " +
           text::listed(joint_names(group, true)) + "); " +
           (compatible ? "they are compatible here, and the group moves"
                       : "they are not compatible here, and the group cannot be assembled");
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
    const Mechanism& mechanism = plan_->mechanism;
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
    result.plan = plan_;
    const Want& want = plan_->request.want;
    if (!result.rates_known && (want.velocity || want.acceleration)) {
      find_branches(values_, placed_, result);
    }
    if (!result.derivatives_known && plan_->request.sweep) {
      find_derivatives(values_, placed_, plan_->request.sweep->parameter, result);
    }
  }

  /// Of a configuration with its derivatives to each parameter.
  void expect_room() const {
    const double parameters = 1 + static_cast<double>(values_.columns().size());
    const double numbers = static_cast<double>(structure_.linkage.links.size()) *
                           (12 + 3 * parameters * (values_.second_order() ? parameters : 1));
    if (listed_ == Plan::most_listed || static_cast<double>(listed_) * numbers > most_numbers) {
      refuse("no more than " + std::to_string(listed_) + " can be listed");
    }
  }

  void conclude() {
    if (is_inconsistent_ && solution_->configurations.empty() && solution_->families.empty()) {
      throw OverConstrained(*plan_->excess);
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
                              : reason_of_failure();
      return;
    }
    solution_->status = SolutionStatus::degenerate;
    const auto freest = std::max_element(
        solution_->families.begin(), solution_->families.end(),
        [](const Family& one, const Family& other) { return one.mobility < other.mobility; });
    solution_->mobility = freest->mobility;
    solution_->reason = freest->reason;
  }

  std::shared_ptr<const PlanData> plan_;
  const Structure& structure_;
  const Values& given_;
  std::optional<Values> settled_;  ///< with the laws that read links, wherever these are placed
  const Values& values_;           ///< one or the other
  ConfigurationOrder order_;
  Table<GroupIndex, GroupSolver> solvers_;
  Table<GroupIndex, std::size_t> first_slide_;
  PlacedLinks placed_;
  Frame joint_, motion_, moved_;  ///< room for what drivers move
  Search search_;
  bool seeks_nearest_ = false;
  bool cuts_ = false;             ///< whether what is beyond limits is left as soon as it is placed
  bool has_cut_ = false;          ///< whether something was
  Solution* solution_ = nullptr;  ///< that is being written
  bool is_inconsistent_ = false;  ///< constraints that are too many did not hold somewhere
  std::size_t listed_ = 0;        ///< configurations; those behind are of an earlier solution
  std::size_t steps_ = 0;
  Table<GroupIndex, Failures> failures_;
  Table<GroupIndex, std::size_t> chosen_;         ///< which of its configurations each group is in
  std::vector<std::vector<JointIndex>> limited_;  ///< by the groups before them
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
