#include "emission/scene/scene_statements.hpp"

#include "emission/cpp/cpp_text.hpp"
#include "emission/scene/group_numbers.hpp"

namespace assur::generator::emission::scene {

namespace {

std::string on(const SolverScene& solver, const std::string& feature, mechanism::LinkIndex link) {
  return feature + "_on_" + solver.link_name(link);
}

/// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
Pose<mechanism::Dual> feature_frame(const SolverScene& solver, const mechanism::ElementaryJoint& at,
                                    mechanism::LinkIndex link) {
  const LinkFeature<mechanism::Dual> feature = solver.values.feature(at.on(link), at.prismatic);
  return {feature.x, feature.y, feature.along};
}

}  // namespace

PlacingStatements driving_statements(const SolverScene& solver) {
  SceneLines lines(solver.parameters);
  std::vector<std::string> slides;
  for (const mechanism::DrivenLink& link : solver.plan.structure().driven) {
    const mechanism::ElementaryJoint& at = solver.joint(link.joint);
    const std::string sign = at.first == link.from ? "" : "-";
    const double sense = at.first == link.from ? 1 : -1;
    const mechanism::Dual& position =
        solver.values.number(solver.mechanism().drivers()[link.driver].position);
    const std::string state = "drivers." + solver.members.drivers[link.driver];
    const std::string gradient = lines.gradient(at.name + "_gradient", sense * position);
    const std::string moved = (at.prismatic ? "support::sliding" : "support::turning") +
                              std::string("<double, order, parameter_count>(") + sign + state +
                              ".position, " + sign + "rates_of(" + state + "), " + gradient + ")";
    const std::string near =
        lines.frame(on(solver, at.name, link.from), feature_frame(solver, at, link.from));
    const std::string far = lines.frame(solver.link_name(link.to) + "_on_" + at.name,
                                        mechanism::inverse(feature_frame(solver, at, link.to)));
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

std::vector<std::string> holding_statements(const SolverScene& solver,
                                            mechanism::GroupIndex group) {
  SceneLines held(solver.parameters);
  int first = 0;
  for (const ExternalJoint& external : external_joints(solver, group)) {
    const mechanism::ElementaryJoint& at = *external.joint;
    const mechanism::LinkIndex base = external.base;
    if (solver.is_ground(base)) {
      continue;
    }
    const std::string place = "<" + std::to_string(first) + ">(";
    const LinkFeature<mechanism::Dual> feature = external.feature(solver);
    if (at.prismatic) {
      const std::string line =
          held.frame(on(solver, at.name, base), feature_frame(solver, at, base));
      held.add("held.hold_line" + place + nested_frames({solver.placed(base), line}) + ");");
    } else {
      const std::string point = held.point(on(solver, at.name, base), feature.x, feature.y);
      held.add("held.hold_point" + place + "support::point_in(" + solver.placed(base) + ", " +
               point + "));");
    }
    first += at.prismatic ? 3 : 2;
  }
  return held.lines();
}

PlacingStatements placing_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  SceneLines lines(solver.parameters);
  std::vector<std::string> slides;
  const mechanism::GroupGeometry& geometry = solver.values.group(group);
  for (std::size_t link = 0; link < geometry.links.size(); ++link) {
    const mechanism::LinkIndex played = geometry.roles->links[link];
    if (solver.lists(played)) {
      const std::string own = lines.frame(solver.link_name(played) + "_in_its_normal_frame",
                                          mechanism::inverse(geometry.links[link].frame));
      lines.add("next." + solver.members.links[played] + " = " +
                nested_frames({"group.frames[" + std::to_string(link) + "]", own}) + ";");
    }
  }
  const std::vector<ModelUnknown>& unknowns = solver.group(group).model->unknowns;
  for (std::size_t index = 0; index < unknowns.size(); ++index) {
    if (unknowns[index].is_angle) {
      continue;
    }
    const mechanism::ElementaryJoint& at = solver.played_joint(group, unknowns[index].owner);
    const auto [sense, shift] = solver.values.slide_measure(group, unknowns[index].owner);
    const std::string sign = sense < 0 ? "-" : "";
    const std::string& slide = solver.slide_member(at);
    const std::string unknown = std::string("Group::unit * q.") + unknowns[index].name;
    const std::string shifted =
        shift.value() == 0 ? unknown
                           : "(" + unknown + " + " + emission::cpp::round_trip(shift.value()) + ")";
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
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    const std::string& member = solver.members.links[link];
    if (!solver.is_ground(link)) {
      lines.add("state.links." + member + " = state_of(placed." + member + ");");
    }
  }
  for (const std::string& slide : slides) {
    lines.add("state.slides." + slide + " = state_of(placed.slide_" + slide + ");");
  }
  for (const mechanism::OutputIndex index : solver.mechanism().outputs().keys()) {
    const mechanism::FeatureIndex output = solver.mechanism().outputs()[index].point;
    const mechanism::Feature& feature = solver.mechanism().features()[output];
    const LinkFeature<mechanism::Dual> place = solver.values.feature(output, false);
    const std::string point = lines.point(on(solver, feature.name, feature.link), place.x, place.y);
    const std::string& base = solver.placed(feature.link);
    lines.add("state.outputs." + solver.members.outputs[index] + " = state_of(" +
              (base.empty() ? point : "point_in(" + base + ", " + point + ")") + ");");
  }
  return lines.lines();
}

}  // namespace assur::generator::emission::scene
