#include "solver.hpp"

#include <assur/text/names.hpp>
#include <optional>

#include "configuration_order.hpp"
#include "group_solver.hpp"

namespace assur::mechanism {

namespace {

/// Walks depth first through the configurations of the groups: what is placed stays placed while
/// the groups behind it are solved, and is overwritten by the next configuration.
class MechanismSolver {
 public:
  MechanismSolver(const std::shared_ptr<const PlanData>& plan, const Values& values)
      : plan_(plan), structure_(plan->structure), values_(values) {
    placed_.links.resize(structure_.linkage.links.size());
    solvers_.reserve(structure_.groups.size());
    for (const GroupIndex group : structure_.groups.keys()) {
      if (values.group(group).roles == nullptr) {
        solvers_.add(std::nullopt);
        continue;
      }
      solvers_.add(std::optional<GroupSolver>(std::in_place, values, group));
    }
  }

  Solution run() {
    place_driven_links();
    std::size_t slides = placed_.slides.size();
    for (const GroupIndex group : structure_.groups.keys()) {
      first_slide_.add(slides);
      slides += solvers_[group] ? solvers_[group]->slide_count() : 0;
    }
    placed_.slides.resize(slides);
    descend(0);
    conclude();
    return std::move(solution_);
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
      const Frame back = Frame::at(inverse(
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

  /// Solves the groups from one on, where all before it are placed; false ends the search.
  bool descend(std::size_t depth) {
    if (depth == structure_.groups.size()) {
      list();
      return true;
    }
    const GroupIndex group(depth);
    std::optional<GroupSolver>& solver = solvers_[group];
    const GroupModel& model = *structure_.groups[group].model;
    if (!solver) {
      return refuse(values_.group(group).obstacle);
    }
    solver->hold(placed_);
    if (!model.rigid) {
      const bool compatible = solver->is_compatible();
      solution_.mobility = compatible ? model.mobility : 0;
      return refuse(reason_of_model(group, compatible));
    }
    const GroupAssemblies& found = solver->assemble();
    if (found.status == AssemblyStatus::not_finite) {
      throw MechanismError(
          "links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.status == AssemblyStatus::degenerate) {
      solution_.mobility = found.mobility;
      return refuse(reason_of_freedom(group, found.mobility));
    }
    solution_.undecided += found.undecided;
    const Status regularity = placed_.regularity;
    const double residual = placed_.residual;
    const double displaced = placed_.displaced;
    for (std::size_t index = 0; index < found.count; ++index) {
      placed_.regularity = regularity;
      placed_.residual = residual;
      placed_.displaced = displaced;
      solver->place(index, first_slide_[group], placed_);
      if (!descend(depth + 1)) {
        return false;
      }
    }
    return true;
  }

  bool refuse(const std::string& reason) {
    solution_.status = SolutionStatus::degenerate;
    solution_.reason = reason;
    return false;
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
    Configuration& result = solution_.configurations.emplace_back();
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
    result.residual = placed_.residual;
    result.plan = plan_;
  }

  void conclude() {
    if (solution_.status == SolutionStatus::degenerate) {
      solution_.configurations.clear();
      return;
    }
    if (solution_.configurations.empty()) {
      solution_.status = SolutionStatus::no_assembly;
      if (solution_.undecided > 0) {
        solution_.status = SolutionStatus::degenerate;
        solution_.reason =
            "the links are at the very limit of their reach: no arithmetic here tells whether they "
            "can be assembled";
      }
      return;
    }
    std::vector<LinkIndex> moving;
    const Table<LinkIndex, bool> driven = structure_.placed_by_drivers();
    for (const LinkIndex link : plan_->mechanism.links().keys()) {
      if (!driven[link]) {
        moving.push_back(link);
      }
    }
    put_in_order(solution_.configurations, moving);
  }

  const std::shared_ptr<const PlanData>& plan_;
  const Structure& structure_;
  const Values& values_;
  Table<GroupIndex, std::optional<GroupSolver>> solvers_;
  Table<GroupIndex, std::size_t> first_slide_;
  PlacedLinks placed_;
  Solution solution_;
};

}  // namespace

Solution solve(const std::shared_ptr<const PlanData>& plan, const Values& values) {
  return MechanismSolver(plan, values).run();
}

}  // namespace assur::mechanism
