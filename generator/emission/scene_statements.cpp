#include "emission/scene_statements.hpp"

#include "emission/cpp_text.hpp"
#include "emission/group_numbers.hpp"
#include "equations/closure.hpp"

namespace assur::generator {

namespace {

std::string on(const SolverScene& solver, const std::string& feature, int link) {
  return feature + "_on_" + solver.link_name(link);
}

/// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
Pose<Dual> feature_frame(const MechanismJoint& at, int link) {
  const LinkFeature<Dual>& feature = at.on(link);
  return {feature.x, feature.y, at.prismatic ? feature.along : Direction<Dual>{Dual(1), Dual(0)}};
}

}  // namespace

PlacingStatements driving_statements(const SolverScene& solver) {
  SceneLines lines(solver.parameters);
  std::vector<std::string> slides;
  for (const DrivenLink& link : solver.order.driven) {
    const MechanismJoint& at = solver.joint(link.joint);
    const auto driver = static_cast<std::size_t>(link.driver);
    const std::string sign = at.first == link.from ? "" : "-";
    const double sense = at.first == link.from ? 1 : -1;
    const Dual position = solver.values.value(solver.scene.drivers[driver].position);
    const std::string state = "drivers." + solver.members.drivers[driver];
    const std::string gradient = lines.gradient(at.name + "_gradient", sense * position);
    const std::string moved = (at.prismatic ? "sliding" : "turning") +
                              std::string("<double, order, parameter_count>(") + sign + state +
                              ".position, " + sign + "rates_of(" + state + "), " + gradient + ")";
    const std::string near =
        lines.frame(on(solver, at.name, link.from), feature_frame(at, link.from));
    const std::string far = lines.frame(solver.link_name(link.to) + "_on_" + at.name,
                                        own_frame(feature_frame(at, link.to)));
    lines.add(solver.placed(link.to) + " = " +
              nested_frames({solver.placed(link.from), near, moved, far}) + ";");
    if (at.prismatic) {
      const std::string& slide = solver.slide_member(at);
      lines.add("placed.slide_" + slide + " = {" + state + ".position, rates_of(" + state + ")};");
      slides.push_back(slide);
    }
  }
  return {lines.lines(), slides};
}

std::vector<std::string> holding_statements(const SolverScene& solver, const PosedGroup& group) {
  SceneLines held(solver.parameters);
  int first = 0;
  for (const auto& [joint, base] : external_joints(solver, group)) {
    const MechanismJoint& at = *joint;
    if (solver.is_ground(base)) {
      continue;
    }
    const std::string place = "<" + std::to_string(first) + ">(";
    const LinkFeature<Dual>& feature = at.on(base);
    if (at.prismatic) {
      const std::string line = held.frame(on(solver, at.name, base), feature_frame(at, base));
      held.add("held.hold_line" + place + nested_frames({solver.placed(base), line}) + ");");
    } else {
      const std::string point = held.point(on(solver, at.name, base), feature.x, feature.y);
      held.add("held.hold_point" + place + "point_in(" + solver.placed(base) + ", " + point +
               "));");
    }
    first += at.prismatic ? 3 : 2;
  }
  return held.lines();
}

PlacingStatements placing_statements(const SolverScene& solver, const PosedGroup& group) {
  SceneLines lines(solver.parameters);
  std::vector<std::string> slides;
  for (std::size_t link = 0; link < group.problem.links.size(); ++link) {
    const int played = group.roles->links[link];
    if (solver.lists(played)) {
      const std::string own = lines.frame(solver.link_name(played) + "_in_its_normal_frame",
                                          own_frame(group.problem.links[link].frame));
      lines.add("next." + solver.members.links[static_cast<std::size_t>(played)] + " = " +
                nested_frames({"group.frames[" + std::to_string(link) + "]", own}) + ";");
    }
  }
  const ClosureEquations equations = closure_equations(*group.group->model);
  for (std::size_t index = 0; index < equations.unknowns.size(); ++index) {
    if (equations.unknowns[index].is_angle()) {
      continue;
    }
    const int owner = equations.owners[index];
    const MechanismJoint& at = played_joint(solver.order.mechanism, *group.roles, owner);
    const auto [sense, shift] = slide_measure(solver.order.mechanism, group, owner, solver.values);
    const std::string sign = sense < 0 ? "-" : "";
    const std::string& slide = solver.slide_member(at);
    const std::string unknown = "Group::unit * q." + equations.unknowns[index].name;
    const std::string shifted =
        shift.value() == 0 ? unknown : "(" + unknown + " + " + round_trip(shift.value()) + ")";
    lines.add("next.slide_" + slide + ".displacement = " + sign + shifted + ";");
    lines.add("next.slide_" + slide + ".rates = " + sign + "Group::unit * group.rates.row(" +
              std::to_string(index) + ");");
    slides.push_back(slide);
  }
  return {lines.lines(), slides};
}

std::vector<std::string> listing_statements(const SolverScene& solver,
                                            const std::vector<std::string>& slides) {
  SceneLines lines(solver.parameters);
  for (std::size_t link = 0; link < solver.scene.links.size(); ++link) {
    const std::string& member = solver.members.links[link];
    if (!solver.is_ground(static_cast<int>(link))) {
      lines.add("state.links." + member + " = state_of(placed." + member + ");");
    }
  }
  for (const std::string& slide : slides) {
    lines.add("state.slides." + slide + " = state_of(placed.slide_" + slide + ");");
  }
  for (std::size_t index = 0; index < solver.scene.outputs.size(); ++index) {
    const SceneOutput& output = solver.scene.outputs[index];
    const SceneFeature& feature = solver.scene.feature(output.point);
    const std::string point =
        lines.point(on(solver, feature.name, output.point.link), solver.values.value(feature.x),
                    solver.values.value(feature.y));
    const std::string& base = solver.placed(output.point.link);
    lines.add("state.outputs." + solver.members.outputs[index] + " = state_of(" +
              (base.empty() ? point : "point_in(" + base + ", " + point + ")") + ");");
  }
  return lines.lines();
}

}  // namespace assur::generator
