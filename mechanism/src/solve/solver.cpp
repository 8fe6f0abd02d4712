#include "solver.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <cstdio>
#include <limits>
#include <optional>

#include "branch_motions.hpp"
#include "configuration_order.hpp"
#include "group_solver.hpp"

namespace assur::mechanism::solve {

namespace {

/// Walks depth first through the configurations of the groups: what is placed stays placed while
/// the groups behind it are solved, and is overwritten by the next configuration.
class MechanismSolver {
 public:
  MechanismSolver(const std::shared_ptr<const PlanData>& plan, const Values& values,
                  bool measures_gap, Solution& result)
      : plan_(plan),
        structure_(plan->structure),
        values_(values),
        measures_gap_(measures_gap),
        solution_(result) {
    solution_.status = SolutionStatus::ok;
    solution_.mobility = 0;
    solution_.reason.clear();
    solution_.families.clear();
    placed_.links.resize(structure_.linkage.links.size());
    placed_.displaced.assign(structure_.linkage.links.size(), 0);
    placed_.groups.resize(structure_.groups.size());
    if (plan_->request.sweep) {
      placed_.determinants.resize(structure_.groups.size());
    }
    solvers_.reserve(structure_.groups.size());
    for (const GroupIndex group : structure_.groups.keys()) {
      if (values.group(group).roles == nullptr) {
        solvers_.add(std::nullopt);
        continue;
      }
      solvers_.add(std::optional<GroupSolver>(std::in_place, values, group));
    }
  }

  void run() {
    place_driven_links();
    std::size_t slides = placed_.slides.size();
    for (const GroupIndex group : structure_.groups.keys()) {
      first_slide_.add(slides);
      slides += solvers_[group] ? solvers_[group]->slide_count() : 0;
    }
    placed_.slides.resize(slides);
    descend(0);
    solution_.configurations.resize(listed_);
    conclude();
  }

 private:
  /// The ground, and what drivers move against placed links.
  void place_driven_links() {
    const auto parameters = static_cast<Eigen::Index>(values_.columns().size());
    const Frame still = Frame::identity(parameters, values_.second_order());
    placed_.links[structure_.linkage.ground] = still;
    for (const DrivenLink& link : structure_.driven) {
      const Driver& driver = plan_->mechanism.drivers()[link.driver];
      const ElementaryJoint& at = structure_.linkage.joints[link.joint];
      const double sense = at.first == link.from ? 1.0 : -1.0;
      const Dual position = sense * values_.number(driver.position);
      const double velocity = values_.number(driver.velocity).value();
      const double acceleration = values_.number(driver.acceleration).value();
      // The moved frame in that of the joint: turned about its origin, or slid along its x-axis.
      const int moved = at.prismatic ? 0 : 2;
      const Dual zero = values_.constant(0.0);
      Frame motion =
          Frame::at(at.prismatic ? Pose<Dual>{position, zero, {values_.constant(1.0), zero}}
                                 : Pose<Dual>{zero, zero, {cos(position), sin(position)}});
      motion.velocity(moved) = sense * velocity;
      motion.acceleration(moved) = sense * acceleration;
      const LinkFeature<Dual> far = values_.feature(at.on(link.to), at.prismatic);
      const Frame back = Frame::at(inverse<Dual>(
          {far.x, far.y, at.prismatic ? far.along : Direction<Dual>{values_.constant(1.0), zero}}));
      placed_.links[link.to] = composed(
          composed(composed(placed_.links[link.from], values_.frame(at.on(link.from))), motion),
          back);
      if (at.prismatic) {
        SlideState slide{
            at.joint, values_.number(driver.position).value(), velocity, acceleration, {}};
        slide.follows.first = values_.number(driver.position).derivatives().transpose();
        if (values_.second_order()) {
          slide.follows.second = {values_.number(driver.position).hessian()};
        }
        placed_.slides.push_back(std::move(slide));
      }
    }
  }

  /// Solves the groups from one on, where all before it are placed.
  void descend(std::size_t depth) {
    if (depth == structure_.groups.size()) {
      list();
      return;
    }
    const GroupIndex group(depth);
    std::optional<GroupSolver>& solver = solvers_[group];
    const GroupModel& model = *structure_.groups[group].model;
    if (!solver) {
      add_family(group, 0, values_.group(group).obstacle, nothing_unplaced());
      return;
    }
    solver->hold(placed_);
    if (!model.rigid) {
      const bool compatible = solver->is_compatible();
      add_family(group, compatible ? model.mobility : 0, reason_of_model(group, compatible),
                 nothing_unplaced());
      return;
    }
    const models::GroupAssemblies& found = solver->assemble();
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility),
                 nothing_unplaced());
    } else if (found.count == 0 && !values_.group(group).flaw.empty()) {
      add_family(group, 0, values_.group(group).flaw, nothing_unplaced());
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
      placed_.groups[group] = {found.configurations[index], solver->displaced()};
      solver->place(index, first_slide_[group], placed_);
      if (plan_->request.sweep) {
        placed_.determinants[group] = solver->determinant();
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
        solution_.families.push_back(std::move(family));
      }
      find_families(group.place() + 1, std::move(unplaced));
    }
    placed_ = placed;
  }

  /// Marks the links of the groups that hold a group, and of those that hold these.
  void place_what_holds(GroupIndex group, Table<LinkIndex, bool>& is_placed) const {
    if (!solvers_[group]) {
      return;
    }
    for (const values::HeldJoint& joint : values_.numbers_of(group).held) {
      for (const GroupIndex before : structure_.groups.keys()) {
        const std::vector<LinkIndex>& links = structure_.groups[before].links;
        if (!is_placed[joint.base] && std::ranges::find(links, joint.base) != links.end()) {
          for (const LinkIndex link : links) {
            is_placed[link] = true;
          }
          place_what_holds(before, is_placed);
        }
      }
    }
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
    return std::ranges::any_of(solution_.families, stands_as);
  }

  /// Reports the groups from `depth` on that move, whatever becomes of the links left unplaced.
  void find_families(std::size_t depth, Table<LinkIndex, bool> unplaced) {
    if (depth == structure_.groups.size()) {
      return;
    }
    const GroupIndex group(depth);
    std::optional<GroupSolver>& solver = solvers_[group];
    const bool is_asked = solver && structure_.groups[group].model->rigid &&
                          !values_.numbers_of(group).is_held_by(unplaced);
    if (!is_asked) {
      leave_out(group, unplaced);
      find_families(depth + 1, std::move(unplaced));
      return;
    }
    solver->hold(placed_);
    const models::GroupAssemblies& found = solver->assemble();
    if (found.mobility > 0 || found.status == AssemblyStatus::degenerate) {
      add_family(group, found.mobility, reason_of_freedom(group, found.mobility), unplaced);
    }
    for (std::size_t index = 0; index < found.count; ++index) {
      placed_.groups[group] = {found.configurations[index], solver->displaced()};
      solver->place(index, first_slide_[group], placed_);
      find_families(depth + 1, unplaced);
    }
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
    if (depth == structure_.groups.size()) {
      return true;
    }
    const GroupIndex group(depth);
    std::optional<GroupSolver>& solver = solvers_[group];
    const bool is_asked = solver && structure_.groups[group].model->rigid &&
                          !values_.numbers_of(group).is_held_by(unplaced);
    if (!is_asked) {
      leave_out(group, unplaced);
      return rest_assembles(depth + 1, std::move(unplaced));
    }
    solver->hold(placed_);
    const models::GroupAssemblies& found = solver->assemble();
    for (std::size_t index = 0; index < found.count; ++index) {
      placed_.groups[group] = {found.configurations[index], solver->displaced()};
      solver->place(index, first_slide_[group], placed_);
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
    if (solvers_[group]->gap(gap) == Status::ok && gap < least_gap_) {
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
    if (listed_ == solution_.configurations.size()) {
      solution_.configurations.emplace_back();
    }
    Configuration& result = solution_.configurations[listed_++];
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
    result.residual = placed_.residual;
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
    if (solution_.configurations.empty()) {
      conclude_without_configurations();
      return;
    }
    put_in_order(solution_.configurations, plan_->named_parts);
  }

  void conclude_without_configurations() {
    if (solution_.families.empty()) {
      solution_.status = SolutionStatus::no_assembly;
      if (!unreached_.exists()) {
        return;
      }
      std::array<char, 32> gap{};
      (void)std::snprintf(gap.data(), gap.size(), "%.3g", least_gap_);
      solution_.reason = "the joints " + text::listed(joint_names(unreached_, false)) +
                         " fail to close by " + gap.data() + " at least";
      return;
    }
    solution_.status = SolutionStatus::degenerate;
    const auto freest = std::max_element(
        solution_.families.begin(), solution_.families.end(),
        [](const Family& one, const Family& other) { return one.mobility < other.mobility; });
    solution_.mobility = freest->mobility;
    solution_.reason = freest->reason;
  }

  const std::shared_ptr<const PlanData>& plan_;
  const Structure& structure_;
  const Values& values_;
  bool measures_gap_;
  Table<GroupIndex, std::optional<GroupSolver>> solvers_;
  Table<GroupIndex, std::size_t> first_slide_;
  PlacedLinks placed_;
  Solution& solution_;
  std::size_t listed_ = 0;  ///< configurations; those behind are of an earlier solution
  GroupIndex unreached_;
  double least_gap_ = std::numeric_limits<double>::infinity();
};

}  // namespace

void solve(const std::shared_ptr<const PlanData>& plan, const Values& values, bool measure_gap,
           Solution& result) {
  MechanismSolver(plan, values, measure_gap, result).run();
}

}  // namespace assur::mechanism::solve
