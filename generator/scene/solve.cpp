#include "scene/solve.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"
#include "scene/configuration_order.hpp"
#include "scene/group_pose.hpp"
#include "scene/names.hpp"
#include "scene/placement.hpp"

namespace assur::generator {

namespace {

/// A configuration while groups are still to come.
struct PartialConfiguration {
  PlacedLinks links;
  std::vector<JointState> joints;
  Status regularity = Status::ok;
  double residual = 0;
  double displaced = 0;  ///< how far rounding may have moved the links
};

class MechanismSolver {
 public:
  MechanismSolver(const Scene& scene, const ParameterValues& values)
      : scene_(scene), values_(values), order_(placement_order(scene, values)) {}

  Solution run() {
    place_driven_links();
    solution_.groups = order_.groups;
    solution_.group_links = order_.group_links;
    std::vector<PartialConfiguration> partial = {start_};
    for (const FoundGroup& group : solution_.groups) {
      std::vector<PartialConfiguration> next;
      for (const PartialConfiguration& configuration : partial) {
        if (!extend(configuration, group, next)) {
          return std::move(solution_);
        }
      }
      partial = std::move(next);
    }
    for (const PartialConfiguration& configuration : partial) {
      solution_.configurations.push_back(completed(configuration));
    }
    conclude();
    return std::move(solution_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    throw InputError(scene_.file + ": " + where + ": " + what);
  }
  [[nodiscard]] const MechanismJoint& joint(int index) const {
    return order_.mechanism.joints[static_cast<std::size_t>(index)];
  }

  /// The ground, and what drivers move against placed links.
  void place_driven_links() {
    start_.links.resize(order_.mechanism.links.size());
    start_.links[static_cast<std::size_t>(order_.mechanism.ground)] = fixed_link(values_);
    for (const DrivenLink& link : order_.driven) {
      const SceneDriver& driver = scene_.drivers[static_cast<std::size_t>(link.driver)];
      const MechanismJoint& at = joint(link.joint);
      const DriverState law{values_.value(driver.position), values_.value(driver.velocity).value(),
                            values_.value(driver.acceleration).value()};
      start_.links[static_cast<std::size_t>(link.to)] =
          driven_link(at, link.from, *start_.links[static_cast<std::size_t>(link.from)], law);
      if (at.prismatic) {
        start_.joints.push_back({at.name, law.position, law.velocity, law.acceleration});
      }
    }
  }

  /// Adds what the group makes of one configuration; false where that is degenerate.
  bool extend(const PartialConfiguration& configuration, const FoundGroup& group,
              std::vector<PartialConfiguration>& next) {
    std::string obstacle;
    std::optional<PosedGroup> question =
        posed(order_.mechanism, group, configuration.links, values_, obstacle);
    if (!question) {
      solution_.status = SolutionStatus::degenerate;
      solution_.reason = obstacle;
      return false;
    }
    question->problem.displaced = configuration.displaced;
    const ModelVerdict verdict = verdict_of(*group.model);
    if (!verdict.rigid) {
      describe_degenerate(*question, verdict);
      return false;
    }
    const GroupSolution found = solve_group(*group.model, question->problem);
    if (found.status == AssemblyStatus::not_finite) {
      fail("links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.status == AssemblyStatus::degenerate) {
      describe_free(*question, found);
      return false;
    }
    solution_.undecided += found.undecided;
    for (const GroupState& state : found.states) {
      PartialConfiguration extended = configuration;
      place_links(*question, state, extended.links);
      for (const SlideState& slide : state.slides) {
        const SlideState own = mechanism_slide(order_.mechanism, *question, slide, values_);
        extended.joints.push_back(
            {joint(own.joint).name, own.displacement, own.velocity, own.acceleration});
      }
      if (state.regularity != Status::ok) {
        extended.regularity = state.regularity;
      }
      extended.residual = std::max(extended.residual, state.residual);
      extended.displaced = state.displaced;
      next.push_back(std::move(extended));
    }
    return true;
  }

  void describe_free(const PosedGroup& question, const GroupSolution& found) {
    solution_.status = SolutionStatus::degenerate;
    solution_.mobility = found.mobility;
    std::vector<std::string> names;
    for (const int index : question.roles->joints) {
      names.push_back(joint(index).name);
    }
    solution_.reason =
        "the closure of the joints " + listed(names) +
        (found.mobility > 0 ? " leaves an angle or a displacement free: infinitely many positions"
                            : " does not determine a position, and no assembly was found");
  }

  void describe_degenerate(const PosedGroup& question, const ModelVerdict& verdict) {
    const Model& model = *question.group->model;
    solution_.status = SolutionStatus::degenerate;
    std::vector<std::string> slides;
    for (std::size_t index = 0; index < question.roles->joints.size(); ++index) {
      if (model.representative[index] == JointType::prismatic) {
        slides.push_back(joint(question.roles->joints[index]).name);
      }
    }
    const bool compatible = is_compatible(model, question.problem);
    solution_.mobility = compatible ? verdict.mobility : 0;
    solution_.reason =
        "prismatic joints close a loop and over-determine its angles (among the joints " +
        listed(slides) + "); " +
        (compatible ? "they are compatible here, and the group moves"
                    : "they are not compatible here, and the group cannot be assembled");
  }

  [[nodiscard]] AssemblyConfiguration completed(const PartialConfiguration& configuration) const {
    AssemblyConfiguration result;
    for (std::size_t link = 0; link < scene_.links.size(); ++link) {
      result.links.push_back(*configuration.links[link]);
    }
    result.joints = configuration.joints;
    for (const SceneOutput& output : scene_.outputs) {
      const SceneFeature& feature = scene_.feature(output.point);
      result.outputs.push_back(point_of(result.links[static_cast<std::size_t>(output.point.link)],
                                        values_.value(feature.x), values_.value(feature.y)));
    }
    result.regularity = configuration.regularity;
    result.residual = configuration.residual;
    return result;
  }

  void conclude() {
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
    std::vector<bool> moving = order_.placed_by_drivers();
    moving.resize(scene_.links.size());
    moving.flip();
    put_in_order(solution_.configurations, moving);
  }

  const Scene& scene_;
  const ParameterValues& values_;
  PlacementOrder order_;
  PartialConfiguration start_;  ///< the ground and the driven links
  Solution solution_;
};

}  // namespace

Solution solve(const Scene& scene, const ParameterValues& values) {
  return MechanismSolver(scene, values).run();
}

}  // namespace assur::generator
