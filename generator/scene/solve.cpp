#include "scene/solve.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"
#include "scene/configuration_order.hpp"
#include "scene/decomposition.hpp"
#include "scene/group_pose.hpp"
#include "scene/names.hpp"

namespace assur::generator {

namespace {

/// A configuration while groups are still to come.
struct PartialConfiguration {
  PlacedLinks links;
  std::vector<JointState> joints;
  Status regularity = Status::ok;
  double residual = 0;
};

class MechanismSolver {
 public:
  MechanismSolver(const Scene& scene, const ParameterValues& values)
      : scene_(scene), values_(values), mechanism_(mechanism_of(scene, values)) {
    start_.links.resize(mechanism_.links.size());
    spent_.assign(mechanism_.joints.size(), false);
  }

  Solution run() {
    place_driven_links();
    find_groups();
    std::vector<PartialConfiguration> partial = {start_};
    for (std::size_t group = 0; group < solution_.groups.size(); ++group) {
      std::vector<PartialConfiguration> next;
      for (const PartialConfiguration& configuration : partial) {
        if (!extend(configuration, solution_.groups[group], next)) {
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
    return mechanism_.joints[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] bool placed(int link) const {
    return start_.links[static_cast<std::size_t>(link)].has_value();
  }

  /// The ground, and what drivers move against placed links.
  void place_driven_links() {
    if (mechanism_.ground < 0) {
      fail("links", "no link is named 'ground', so nothing holds the mechanism");
    }
    start_.links[static_cast<std::size_t>(mechanism_.ground)] = fixed_link(values_);
    std::vector<const SceneDriver*> waiting;
    for (const SceneDriver& driver : scene_.drivers) {
      const SceneJoint& at = scene_.joints[static_cast<std::size_t>(driver.joint)];
      if (at.type == SceneJointType::pin_in_slot || at.between.size() != 2) {
        fail("drivers." + at.name, "a driver moves a revolute or prismatic joint of two links");
      }
      waiting.push_back(&driver);
    }
    while (!waiting.empty()) {
      const auto ready =
          std::find_if(waiting.begin(), waiting.end(), [&](const SceneDriver* driver) {
            const MechanismJoint& at = joint(joint_of(*driver));
            return placed(at.first) != placed(at.second);
          });
      if (ready == waiting.end()) {
        fail("drivers." + scene_.joints[static_cast<std::size_t>(waiting[0]->joint)].name,
             "the driven joint must join the ground, or a driven link, to a link that nothing else "
             "drives");
      }
      const SceneDriver& driver = **ready;
      const int index = joint_of(driver);
      const MechanismJoint& at = joint(index);
      const int from = placed(at.first) ? at.first : at.second;
      const int to = placed(at.first) ? at.second : at.first;
      const DriverState law{values_.value(driver.position), values_.value(driver.velocity).value(),
                            values_.value(driver.acceleration).value()};
      start_.links[static_cast<std::size_t>(to)] =
          driven_link(at, from, *start_.links[static_cast<std::size_t>(from)], law);
      spent_[static_cast<std::size_t>(index)] = true;
      if (at.prismatic) {
        start_.joints.push_back({at.name, law.position, law.velocity, law.acceleration});
      }
      waiting.erase(ready);
    }
  }

  [[nodiscard]] int joint_of(const SceneDriver& driver) const {
    const auto found = std::find_if(
        mechanism_.joints.begin(), mechanism_.joints.end(),
        [&](const MechanismJoint& candidate) { return candidate.scene_joint == driver.joint; });
    return static_cast<int>(found - mechanism_.joints.begin());
  }

  [[nodiscard]] std::vector<std::string> names_of(const std::vector<int>& links) const {
    std::vector<std::string> names;
    for (const int link : links) {
      names.push_back(mechanism_.links[static_cast<std::size_t>(link)]);
    }
    return names;
  }

  void find_groups() {
    std::vector<bool> placed_links;
    for (const std::optional<LinkState>& state : start_.links) {
      placed_links.push_back(state.has_value());
    }
    Decomposition decomposition = decompose(mechanism_, placed_links, spent_);
    expect_balance(decomposition);
    mechanism_ = std::move(decomposition.mechanism);
    for (const Component& component : decomposition.components) {
      std::optional<FoundGroup> found = find_group(mechanism_, component.links, component.joints);
      if (!found) {
        std::vector<std::string> known;
        for (const Group& group : known_groups()) {
          known.push_back(group.name());
        }
        fail("links",
             "the links " + listed(names_of(component.links)) +
                 " can only be solved together, as a group of class " +
                 std::to_string(assur_class_of(mechanism_, component.links, component.joints)) +
                 " with " + std::to_string(component.links.size()) +
                 " links, which is not known here (known: " + listed(known) + ")");
      }
      solution_.groups.push_back(std::move(*found));
      solution_.group_links.push_back(names_of(component.links));
    }
  }

  void expect_balance(const Decomposition& decomposition) const {
    const Imbalance& over = decomposition.overloaded;
    const Imbalance& under = decomposition.free;
    const std::string excess = "over-constrained by " + std::to_string(over.surplus) +
                               ": the joints " + listed(over.joints) +
                               (over.links.empty() ? " join links that are placed already"
                                                   : " hold the links " + listed(over.links) +
                                                         " more often than they can move") +
                               "; take a joint or a driver away";
    const std::string lack = "under-constrained by " + std::to_string(under.surplus) +
                             ": the links " + listed(under.links) +
                             " keep a freedom; drive one of their joints, or add a joint";
    if (over.surplus > 0) {
      fail("joints", excess + (under.surplus > 0 ? "; elsewhere " + lack : ""));
    }
    if (under.surplus > 0) {
      fail("links", lack);
    }
  }

  /// Adds what the group makes of one configuration; false where that is degenerate.
  bool extend(const PartialConfiguration& configuration, const FoundGroup& group,
              std::vector<PartialConfiguration>& next) {
    std::string obstacle;
    const std::optional<PosedGroup> question =
        posed(mechanism_, group, configuration.links, values_, obstacle);
    if (!question) {
      solution_.status = SolutionStatus::degenerate;
      solution_.reason = obstacle;
      return false;
    }
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
        const SlideState own = mechanism_slide(mechanism_, *question, slide, values_);
        extended.joints.push_back(
            {joint(own.joint).name, own.displacement, own.velocity, own.acceleration});
      }
      if (state.regularity != Status::ok) {
        extended.regularity = state.regularity;
      }
      extended.residual = std::max(extended.residual, state.residual);
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
    std::vector<bool> moving;
    for (std::size_t link = 0; link < scene_.links.size(); ++link) {
      moving.push_back(!placed(static_cast<int>(link)));
    }
    put_in_order(solution_.configurations, moving);
  }

  const Scene& scene_;
  const ParameterValues& values_;
  Mechanism mechanism_;
  PartialConfiguration start_;  ///< the ground and the driven links
  std::vector<bool> spent_;
  Solution solution_;
};

}  // namespace

Solution solve(const Scene& scene, const ParameterValues& values) {
  return MechanismSolver(scene, values).run();
}

}  // namespace assur::generator
