#include "scene/solve.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "error.hpp"

namespace assur::generator {

namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

class MechanismSolver {
 public:
  MechanismSolver(const Scene& scene, const ParameterValues& values)
      : scene_(scene), values_(values), mechanism_(mechanism_of(scene, values)) {
    states_.resize(mechanism_.links.size());
    spent_.assign(mechanism_.joints.size(), false);
  }

  Solution run() {
    place_driven_links();
    const std::vector<int> moving = moving_links();
    if (moving.empty()) {
      expect_no_joint_left();
      solution_.configurations.push_back(completed({}, {}));
      return std::move(solution_);
    }
    solve_group(moving);
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
    return states_[static_cast<std::size_t>(link)].has_value();
  }

  /// The ground, and what drivers move against placed links.
  void place_driven_links() {
    if (mechanism_.ground < 0) {
      fail("links", "no link is named 'ground', so nothing holds the mechanism");
    }
    states_[static_cast<std::size_t>(mechanism_.ground)] = fixed_link(values_);
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
      states_[static_cast<std::size_t>(to)] =
          driven_link(at, from, *states_[static_cast<std::size_t>(from)], law);
      spent_[static_cast<std::size_t>(index)] = true;
      if (at.prismatic) {
        driven_slides_.push_back({at.name, law.position, law.velocity, law.acceleration});
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

  [[nodiscard]] std::vector<int> moving_links() const {
    std::vector<int> moving;
    for (std::size_t link = 0; link < states_.size(); ++link) {
      if (!states_[link]) {
        moving.push_back(static_cast<int>(link));
      }
    }
    return moving;
  }

  [[nodiscard]] std::vector<int> open_joints() const {
    std::vector<int> open;
    for (std::size_t index = 0; index < spent_.size(); ++index) {
      if (!spent_[index]) {
        open.push_back(static_cast<int>(index));
      }
    }
    return open;
  }

  void expect_no_joint_left() const {
    const std::vector<int> open = open_joints();
    if (!open.empty()) {
      fail("joints." + joint(open[0]).name,
           "over-constrained: the drivers already place the links that it joins");
    }
  }

  void solve_group(const std::vector<int>& moving) {
    const std::vector<int> open = open_joints();
    std::vector<std::string> names;
    names.reserve(moving.size());
    for (const int link : moving) {
      names.push_back(mechanism_.links[static_cast<std::size_t>(link)]);
    }
    const auto freedom = 3 * static_cast<int>(moving.size()) - 2 * static_cast<int>(open.size());
    if (freedom != 0) {
      fail("joints", std::string(freedom > 0 ? "under" : "over") + "-constrained: the " +
                         std::to_string(moving.size()) + " links without a driver (" +
                         listed(names) + ") have " + std::to_string(open.size()) +
                         " joints, and a structure of so many links has " +
                         (moving.size() % 2 == 0 ? std::to_string(3 * moving.size() / 2)
                                                 : std::string("no whole number of them")));
    }
    const std::vector<FoundGroup> found = find_group(mechanism_, moving, open);
    if (found.empty()) {
      fail("links", "the links without a driver (" + listed(names) +
                        ") form no group that is known here; known is the tetrad");
    }
    solution_.groups = found;
    solution_.group_links.push_back(names);
    const FoundGroup& group = found.front();
    const ModelVerdict verdict = tetrad_verdict(group.model->number);

    std::string obstacle;
    for (const RoleAssignment& roles : group.assignments) {
      GroupProblem problem;
      obstacle = posed(group, roles, problem);
      if (!obstacle.empty()) {
        continue;
      }
      if (!verdict.rigid) {
        describe_degenerate(group, roles, problem, verdict);
        return;
      }
      list_configurations(group, roles, problem);
      return;
    }
    solution_.status = SolutionStatus::degenerate;
    solution_.reason = obstacle;
  }

  void list_configurations(const FoundGroup& group, const RoleAssignment& roles,
                           const GroupProblem& problem) {
    const GroupSolution found = solve_tetrad(group.model->number, problem);
    if (found.status == AssemblyStatus::not_finite) {
      fail("links", "the lengths differ by more powers of ten than double precision can hold");
    }
    if (found.status == AssemblyStatus::degenerate) {
      solution_.status = SolutionStatus::degenerate;
      solution_.mobility = found.mobility;
      std::vector<std::string> names;
      for (const int index : roles.joints) {
        names.push_back(joint(index).name);
      }
      solution_.reason =
          "the closure of the joints " + listed(names) +
          (found.mobility > 0 ? " leaves an angle or a displacement free: infinitely many positions"
                              : " does not determine a position, and no assembly was found");
      return;
    }
    solution_.undecided = found.undecided;
    if (found.states.empty() && found.undecided > 0) {
      solution_.status = SolutionStatus::degenerate;
      solution_.reason =
          "the links are at the very limit of their reach: no arithmetic here tells whether they "
          "can be assembled";
      return;
    }
    if (found.states.empty()) {
      solution_.status = SolutionStatus::no_assembly;
    }
    for (const GroupState& state : found.states) {
      AssemblyConfiguration configuration = completed(state.frames, problem.links, &roles, &group);
      configuration.regularity = state.regularity;
      configuration.residual = state.residual;
      for (const SlideState& slide : state.slides) {
        configuration.joints.push_back(scene_slide(group, roles, problem, slide));
      }
      solution_.configurations.push_back(std::move(configuration));
    }
    put_in_order();
  }

  /// Orders configurations by what depends on the mechanism alone, not on where it stands, how it
  /// is reflected or in which order the scene lists it: sums over all pairs of moving links of the
  /// cosines of the angles between them. Equal sums fall back on sines and displacements.
  void put_in_order() {
    std::vector<std::pair<std::vector<double>, AssemblyConfiguration>> keyed;
    for (AssemblyConfiguration& configuration : solution_.configurations) {
      keyed.emplace_back(order_key(configuration), std::move(configuration));
    }
    const auto before = [](const auto& left, const auto& right) {
      for (std::size_t place = 0; place < left.first.size(); ++place) {
        const double difference = left.first[place] - right.first[place];
        if (std::abs(difference) > 1e-9 * (1 + std::abs(left.first[place]))) {
          return difference < 0;
        }
      }
      return false;
    };
    std::stable_sort(keyed.begin(), keyed.end(), before);
    solution_.configurations.clear();
    for (auto& [key, configuration] : keyed) {
      solution_.configurations.push_back(std::move(configuration));
    }
  }

  [[nodiscard]] std::vector<double> order_key(const AssemblyConfiguration& configuration) const {
    std::vector<double> key(4, 0.0);
    for (std::size_t one = 0; one < configuration.links.size(); ++one) {
      for (std::size_t other = one + 1; other < configuration.links.size(); ++other) {
        if (states_[one] || states_[other]) {
          continue;  // placed by the ground or a driver
        }
        const Direction<Dual> between = turned(configuration.links[other].direction,
                                               reversed(configuration.links[one].direction));
        const double cosine = between.cos.value();
        key[0] += cosine;
        key[1] += cosine * cosine;
        key[2] += cosine * cosine * cosine;
        key[3] += between.sin.value();
      }
    }
    for (const JointState& slide : configuration.joints) {
      key.push_back(slide.displacement.value());
    }
    return key;
  }

  /// Fills the problem; returns what stands in the way of a normal form, or nothing.
  std::string posed(const FoundGroup& found, const RoleAssignment& roles,
                    GroupProblem& problem) const {
    const Group& group = *found.model->group;
    for (int link = 0; link < group.link_count(); ++link) {
      const int played = roles.links[static_cast<std::size_t>(link)];
      std::array<LinkFeature<Dual>, 3> features;
      int count = 0;
      std::vector<std::string> names;
      for (const int index : group.joints_of(link)) {
        const MechanismJoint& at = joint(roles.joints[static_cast<std::size_t>(index)]);
        features[static_cast<std::size_t>(count++)] = at.on(played);
        names.push_back(at.name);
      }
      NormalForm<Dual> form;
      form.shift.fill(values_.constant(0.0));
      if (normal_form(features, count, form) != Status::ok) {
        return "link " + mechanism_.links[static_cast<std::size_t>(played)] +
               ": its features at the joints " + listed(names) + " coincide or are parallel";
      }
      problem.links.push_back(form);
    }
    pose_inputs(group, roles, problem);
    return "";
  }

  void pose_inputs(const Group& group, const RoleAssignment& roles, GroupProblem& problem) const {
    std::vector<double> rates;
    std::vector<double> second_rates;
    for (int index = 0; index < group.joint_count(); ++index) {
      const Joint& wanted = group.joints()[static_cast<std::size_t>(index)];
      if (!wanted.external()) {
        continue;
      }
      const MechanismJoint& at = joint(roles.joints[static_cast<std::size_t>(index)]);
      const int inner = roles.links[static_cast<std::size_t>(wanted.second)];
      const int base = at.first == inner ? at.second : at.first;
      const LinkState& state = *states_[static_cast<std::size_t>(base)];
      const LinkFeature<Dual>& feature = at.on(base);
      const PointState point = point_of(state, feature.x, feature.y);
      problem.inputs.push_back({false, point.x, {}});
      problem.inputs.push_back({false, point.y, {}});
      rates.insert(rates.end(), {point.velocity.x(), point.velocity.y()});
      second_rates.insert(second_rates.end(), {point.acceleration.x(), point.acceleration.y()});
      if (at.prismatic) {
        problem.inputs.push_back(
            {true, values_.constant(0.0), turned(state.direction, feature.along)});
        rates.push_back(state.velocity(2));
        second_rates.push_back(state.acceleration(2));
      }
    }
    problem.input_rates =
        Eigen::Map<Eigen::VectorXd>(rates.data(), static_cast<Eigen::Index>(rates.size()));
    problem.input_second_rates = Eigen::Map<Eigen::VectorXd>(
        second_rates.data(), static_cast<Eigen::Index>(second_rates.size()));
  }

  void describe_degenerate(const FoundGroup& found, const RoleAssignment& roles,
                           const GroupProblem& problem, const ModelVerdict& verdict) {
    solution_.status = SolutionStatus::degenerate;
    std::vector<std::string> slides;
    for (std::size_t index = 0; index < roles.joints.size(); ++index) {
      if (found.model->representative[index] == JointType::prismatic) {
        slides.push_back(joint(roles.joints[index]).name);
      }
    }
    const bool compatible = tetrad_is_compatible(found.model->number, problem);
    solution_.mobility = compatible ? verdict.mobility : 0;
    solution_.reason =
        "prismatic joints close a loop and over-determine its angles (among the joints " +
        listed(slides) + "); " +
        (compatible ? "they are compatible here, and the group moves"
                    : "they are not compatible here, and the group cannot be assembled");
  }

  [[nodiscard]] JointState scene_slide(const FoundGroup& found, const RoleAssignment& roles,
                                       const GroupProblem& problem, const SlideState& slide) const {
    const Joint& wanted = found.model->group->joints()[static_cast<std::size_t>(slide.joint)];
    const MechanismJoint& at = joint(roles.joints[static_cast<std::size_t>(slide.joint)]);
    const auto shift_on = [&](int link) -> Dual {
      if (link == base_link) {
        return values_.constant(0.0);
      }
      const std::vector<int> joints = found.model->group->joints_of(link);
      const auto place = std::find(joints.begin(), joints.end(), slide.joint) - joints.begin();
      return problem.links[static_cast<std::size_t>(link)].shift[static_cast<std::size_t>(place)];
    };
    const bool same_sense = at.second == roles.links[static_cast<std::size_t>(wanted.second)];
    const double sense = same_sense ? 1.0 : -1.0;
    const Dual between_points =
        slide.displacement + shift_on(wanted.second) - shift_on(wanted.first);
    return {at.name, sense * between_points, sense * slide.velocity, sense * slide.acceleration};
  }

  /// A configuration from the normal frames of a group's links, in the scene's own frames.
  AssemblyConfiguration completed(const std::vector<LinkState>& frames,
                                  const std::vector<NormalForm<Dual>>& forms,
                                  const RoleAssignment* roles = nullptr,
                                  const FoundGroup* group = nullptr) const {
    std::vector<std::optional<LinkState>> states = states_;
    for (std::size_t link = 0; group != nullptr && link < frames.size(); ++link) {
      const LinkState& frame = frames[link];
      const Pose<Dual>& local = forms[link].frame;
      // The link's own origin and axes, seen from its normal frame.
      const Dual x = -(local.direction.cos * local.x) - local.direction.sin * local.y;
      const Dual y = local.direction.sin * local.x - local.direction.cos * local.y;
      const PointState origin = point_of(frame, x, y);
      LinkState state;
      state.x = origin.x;
      state.y = origin.y;
      state.direction = turned(frame.direction, reversed(local.direction));
      state.velocity << origin.velocity, frame.velocity(2);
      state.acceleration << origin.acceleration, frame.acceleration(2);
      states[static_cast<std::size_t>(roles->links[link])] = state;
    }
    AssemblyConfiguration result;
    for (std::size_t link = 0; link < scene_.links.size(); ++link) {
      result.links.push_back(*states[link]);
    }
    result.joints = driven_slides_;
    for (const SceneOutput& output : scene_.outputs) {
      const SceneFeature& feature = scene_.feature(output.point);
      result.outputs.push_back(point_of(*states[static_cast<std::size_t>(output.point.link)],
                                        values_.value(feature.x), values_.value(feature.y)));
    }
    return result;
  }

  const Scene& scene_;
  const ParameterValues& values_;
  Mechanism mechanism_;
  std::vector<std::optional<LinkState>> states_;
  std::vector<bool> spent_;
  std::vector<JointState> driven_slides_;
  Solution solution_;
};

}  // namespace

Solution solve(const Scene& scene, const ParameterValues& values) {
  return MechanismSolver(scene, values).run();
}

}  // namespace assur::generator
