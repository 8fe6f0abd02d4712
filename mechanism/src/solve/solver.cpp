#include "solver.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "branch_motions.hpp"
#include "configuration_order.hpp"
#include "group_solver.hpp"
#include "limits.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

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
        order_(plan_->named_parts) {
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
  }

  void run(bool measures_gap, Solution& result) {
    begin(measures_gap, result);
    descend(0);
    solution_->configurations.resize(listed_);
    conclude();
  }

 private:
  /// Whatever the last position was left in.
  void begin(bool measures_gap, Solution& result) {
    measures_gap_ = measures_gap;
    if (settled_) {
      *settled_ = given_;
    }
    solution_ = &result;
    result.status = SolutionStatus::ok;
    result.mobility = 0;
    result.reason.clear();
    result.families.clear();
    placed_.regularity = Status::ok;
    placed_.derivatives_known = true;
    placed_.rates_known = true;
    placed_.residual = 0;
    listed_ = 0;
    unreached_ = GroupIndex();
    least_gap_ = std::numeric_limits<double>::infinity();
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
    const models::GroupAssemblies& found = solver.assemble();
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility),
                 nothing_unplaced());
    } else if (found.count == 0 && measures_gap_ && listed_ == 0) {
      measure_gap(group);
    }
    const Status regularity = placed_.regularity;
    const double residual = placed_.residual;
    const bool derivatives_known = placed_.derivatives_known;
    const bool rates_known = placed_.rates_known;
    for (std::size_t index = 0; index < found.count; ++index) {
      placed_.regularity = regularity;
      placed_.residual = residual;
      placed_.derivatives_known = derivatives_known;
      placed_.rates_known = rates_known;
      solver.place(index, first_slide_[group], placed_);
      placed_.groups[group] = {found.configurations[index], solver.displaced()};
      if (plan_->request.sweep) {
        placed_.determinants[group] = solver.determinant();
      }
      descend(depth + 1);
    }
  }

  /// Reports a group that moves where it is held, once for each choice of the groups that hold it.
  /// If a later group that does not depend on it cannot be assembled, nothing is reported: the
  /// answer must not depend on which of the two comes first. Nor may it hide another that moves.
  void add_family(GroupIndex group, int mobility, std::string reason,
                  Table<LinkIndex, bool> unplaced) {
    leave_out(group, unplaced);
    const PlacedLinks placed = placed_;
    if (rest_assembles(group.place() + 1, unplaced)) {
      placed_ = placed;
      Family family{group, mobility, std::move(reason), structure_.placed_by_drivers(),
                    placed_.links};
      place_what_holds(group, family.is_placed);
      if (!is_listed(family)) {
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
    const models::GroupAssemblies& found = solver.assemble();
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility), unplaced);
    }
    for (std::size_t index = 0; index < found.count; ++index) {
      solver.place(index, first_slide_[group], placed_);
      placed_.groups[group] = {found.configurations[index], solver.displaced()};
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
    const models::GroupAssemblies& found = solver.assemble();
    for (std::size_t index = 0; index < found.count; ++index) {
      solver.place(index, first_slide_[group], placed_);
      placed_.groups[group] = {found.configurations[index], solver.displaced()};
      if (rest_assembles(depth + 1, unplaced)) {
        return true;
      }
    }
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      leave_out(group, unplaced);
      return rest_assembles(depth + 1, std::move(unplaced));
    }
    if (found.count == 0 && measures_gap_ && listed_ == 0) {
      measure_gap(group);
    }
    return false;
  }

  /// Of the groups that cannot be assembled the one that fails by least is told.
  void measure_gap(GroupIndex group) {
    double gap = 0;
    if (solvers_[group].gap(gap) == Status::ok && gap < least_gap_) {
      least_gap_ = gap;
      unreached_ = group;
    }
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
    result.within_limits = keeps_limits(values_, result);
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

  void conclude() {
    if (solution_->configurations.empty()) {
      conclude_without_configurations();
      return;
    }
    order_.sort(solution_->configurations);
  }

  void conclude_without_configurations() {
    if (solution_->families.empty()) {
      solution_->status = SolutionStatus::no_assembly;
      if (!unreached_.exists()) {
        return;
      }
      std::array<char, 32> gap{};
      (void)std::snprintf(gap.data(), gap.size(), "%.3g", least_gap_);
      solution_->reason = "the joints " + text::listed(joint_names(unreached_, false)) +
                          " fail to close by " + gap.data() + " at least";
      if (const std::string& flaw = values_.group(unreached_).flaw; !flaw.empty()) {
        solution_->reason += "; " + flaw;
      }
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
  bool measures_gap_ = false;
  Solution* solution_ = nullptr;  ///< that is being written
  std::size_t listed_ = 0;        ///< configurations; those behind are of an earlier solution
  GroupIndex unreached_;
  double least_gap_ = 0;
};

MechanismSolver::MechanismSolver(const Values& values)
    : walk_(std::make_unique<ConfigurationWalk>(values)) {}
MechanismSolver::~MechanismSolver() = default;

void MechanismSolver::solve(bool measure_gap, Solution& result) { walk_->run(measure_gap, result); }

}  // namespace assur::mechanism::solve
