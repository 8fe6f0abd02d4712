#include "scene/group_pose.hpp"

#include <algorithm>

#include "scene/names.hpp"

namespace assur::generator {

namespace {

/// What stands in the way of the links' normal forms, or nothing.
std::string normal_forms(const Mechanism& mechanism, const Group& group,
                         const RoleAssignment& roles, const ParameterValues& values,
                         GroupProblem& problem) {
  for (int link = 0; link < group.link_count(); ++link) {
    const int played = roles.links[static_cast<std::size_t>(link)];
    std::array<LinkFeature<Dual>, 3> features;
    int count = 0;
    std::vector<std::string> names;
    for (const int index : group.joints_of(link)) {
      const MechanismJoint& at = played_joint(mechanism, roles, index);
      features[static_cast<std::size_t>(count++)] = at.on(played);
      names.push_back(at.name);
    }
    NormalForm<Dual> form;
    form.shift.fill(values.constant(0.0));
    if (normal_form(features, count, form) != Status::ok) {
      return "link " + mechanism.links[static_cast<std::size_t>(played)] +
             ": its features at the joints " + listed(names) + " coincide or are parallel";
    }
    problem.links.push_back(form);
  }
  return "";
}

/// Where the placed neighbours hold the external joints, and how these move.
void pose_inputs(const Mechanism& mechanism, const Group& group, const RoleAssignment& roles,
                 const PlacedLinks& placed, const ParameterValues& values, GroupProblem& problem) {
  std::vector<double> rates;
  std::vector<double> second_rates;
  for (int index = 0; index < group.joint_count(); ++index) {
    const Joint& wanted = group.joints()[static_cast<std::size_t>(index)];
    if (!wanted.external()) {
      continue;
    }
    const MechanismJoint& at = played_joint(mechanism, roles, index);
    const int inner = roles.links[static_cast<std::size_t>(wanted.second)];
    const int base = at.first == inner ? at.second : at.first;
    const LinkState& state = *placed[static_cast<std::size_t>(base)];
    const LinkFeature<Dual>& feature = at.on(base);
    const PointState point = point_of(state, feature.x, feature.y);
    problem.inputs.push_back({false, point.x, {}});
    problem.inputs.push_back({false, point.y, {}});
    rates.insert(rates.end(), {point.velocity.x(), point.velocity.y()});
    second_rates.insert(second_rates.end(), {point.acceleration.x(), point.acceleration.y()});
    if (at.prismatic) {
      problem.inputs.push_back(
          {true, values.constant(0.0), turned(state.direction, feature.along)});
      rates.push_back(state.velocity(2));
      second_rates.push_back(state.acceleration(2));
    }
  }
  problem.input_rates =
      Eigen::Map<Eigen::VectorXd>(rates.data(), static_cast<Eigen::Index>(rates.size()));
  problem.input_second_rates = Eigen::Map<Eigen::VectorXd>(
      second_rates.data(), static_cast<Eigen::Index>(second_rates.size()));
}

}  // namespace

const MechanismJoint& played_joint(const Mechanism& mechanism, const RoleAssignment& roles,
                                   int joint) {
  return mechanism.joints[static_cast<std::size_t>(roles.joints[static_cast<std::size_t>(joint)])];
}

std::optional<PosedGroup> in_normal_form(const Mechanism& mechanism, const FoundGroup& found,
                                         const ParameterValues& values, std::string& obstacle) {
  for (const RoleAssignment& roles : found.assignments) {
    PosedGroup result{&found, &roles, {}};
    obstacle = normal_forms(mechanism, *found.model->group, roles, values, result.problem);
    if (obstacle.empty()) {
      return result;
    }
  }
  return std::nullopt;
}

std::optional<PosedGroup> posed(const Mechanism& mechanism, const FoundGroup& found,
                                const PlacedLinks& placed, const ParameterValues& values,
                                std::string& obstacle) {
  std::optional<PosedGroup> result = in_normal_form(mechanism, found, values, obstacle);
  if (result) {
    pose_inputs(mechanism, *found.model->group, *result->roles, placed, values, result->problem);
  }
  return result;
}

Pose<Dual> own_frame(const Pose<Dual>& local) {
  return {-(local.direction.cos * local.x) - local.direction.sin * local.y,
          local.direction.sin * local.x - local.direction.cos * local.y, reversed(local.direction)};
}

void place_links(const PosedGroup& posed, const GroupState& group_state, PlacedLinks& placed) {
  for (std::size_t link = 0; link < group_state.frames.size(); ++link) {
    const LinkState& frame = group_state.frames[link];
    const Pose<Dual> own = own_frame(posed.problem.links[link].frame);
    const PointState origin = point_of(frame, own.x, own.y);
    LinkState state;
    state.x = origin.x;
    state.y = origin.y;
    state.direction = turned(frame.direction, own.direction);
    state.velocity << origin.velocity, frame.velocity(2);
    state.acceleration << origin.acceleration, frame.acceleration(2);
    placed[static_cast<std::size_t>(posed.roles->links[link])] = state;
  }
}

SlideMeasure slide_measure(const Mechanism& mechanism, const PosedGroup& posed, int model_joint,
                           const ParameterValues& values) {
  const Group& group = *posed.group->model->group;
  const Joint& wanted = group.joints()[static_cast<std::size_t>(model_joint)];
  const MechanismJoint& at = played_joint(mechanism, *posed.roles, model_joint);
  const auto shift_on = [&](int link) -> Dual {
    if (link == base_link) {
      return values.constant(0.0);
    }
    const std::vector<int> joints = group.joints_of(link);
    const auto place = std::find(joints.begin(), joints.end(), model_joint) - joints.begin();
    return posed.problem.links[static_cast<std::size_t>(link)]
        .shift[static_cast<std::size_t>(place)];
  };
  const bool same_sense = at.second == posed.roles->links[static_cast<std::size_t>(wanted.second)];
  return {same_sense ? 1.0 : -1.0, shift_on(wanted.second) - shift_on(wanted.first)};
}

SlideState mechanism_slide(const Mechanism& mechanism, const PosedGroup& posed,
                           const SlideState& slide, const ParameterValues& values) {
  const auto [sense, shift] = slide_measure(mechanism, posed, slide.joint, values);
  return {posed.roles->joints[static_cast<std::size_t>(slide.joint)],
          sense * (slide.displacement + shift), sense * slide.velocity, sense * slide.acceleration};
}

}  // namespace assur::generator
