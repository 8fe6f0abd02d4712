#include "emission/scene/scene_statements.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <deque>

#include "emission/cpp/cpp_text.hpp"
#include "emission/scene/specialised_numbers.hpp"

namespace assur::generator::emission::scene {

namespace {

std::string on(const SolverScene& solver, const std::string& feature, mechanism::LinkIndex link) {
  return feature + "_on_" + solver.link_name(link);
}

/// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
Pose<SceneNumber> feature_frame(const SolverScene& solver, const mechanism::ElementaryJoint& at,
                                mechanism::LinkIndex link) {
  const LinkFeature<SceneNumber> feature = solver.numbers.feature(at.on(link), at.prismatic);
  return {feature.x, feature.y, feature.along};
}

/// The rates of a driver, a row; nothing where none are wanted.
std::string rates_of(const SolverScene& solver, const std::string& state) {
  switch (solver.derivative_order) {
    case 0:
      return "";
    case 1:
      return "Rates(" + state + ".velocity)";
    default:
      return "Rates(" + state + ".velocity, " + state + ".acceleration)";
  }
}

/// A direction that is turned by another.
std::string turned_direction(SceneLines& lines, const std::string& direction,
                             const Direction<SceneNumber>& by) {
  const std::string angle = lines.direction(by);
  return angle == "{1.0, 0.0}" ? direction : "turned(" + direction + ", " + angle + ")";
}

/// The values of a state's members, those of a part that is wanted: `{pose, velocity}`.
std::string state_of(const mechanism::Want& want, const std::string& position,
                     const std::string& rates, bool columns,
                     const std::vector<std::string>& more = {}) {
  std::vector<std::string> values;
  const auto rate = [&](int order) {
    return rates + (columns ? ".col(" : "(") + std::to_string(order) + ")";
  };
  if (want.position) {
    values.push_back(position);
  }
  if (want.velocity) {
    values.push_back(rate(0));
  }
  if (want.acceleration) {
    values.push_back(rate(1));
  }
  values.insert(values.end(), more.begin(), more.end());
  return "{" + text::joined(values, ", ", [](const std::string& value) { return value; }) + "}";
}

/// The dimensions that variable parameters change, inputs of the group from `first` on.
void add_varying_dimensions(const SolverScene& solver, mechanism::GroupIndex group, int first,
                            SceneLines& held) {
  const structure::Model& model = derived_model(solver.group(group));
  const std::deque<equations::Variable> dimensions = equations::closure_equations(model).dimensions;
  std::size_t index = 0;
  for (const DimensionValue<SceneNumber>& value : solver.numbers.group(group).dimensions()) {
    const std::string name = dimensions[index++].name;
    const auto hold = [&](const std::string& function, const std::string& text,
                          const std::string& gradient) {
      held.add("held." + function + "<" + std::to_string(first++) + ">(" + text +
               (gradient.empty() ? "" : ", " + gradient) + ");");
    };
    if (value.is_angle && solver.numbers.varies(value.angle)) {
      const std::string gradient = held.gradient(name + "_gradient", value.angle);
      hold("hold_angle", held.direction(value.angle), gradient);
    } else if (!value.is_angle && solver.numbers.varies(value.length)) {
      const std::string gradient = held.gradient(name + "_gradient", value.length);
      hold("hold_length", held.number(value.length), gradient);
    }
  }
}

}  // namespace

PlacingStatements driving_statements(const SolverScene& solver) {
  SceneLines lines(solver.parameters, solver.numbers);
  std::vector<std::string> slides;
  for (const mechanism::DrivenLink& link : solver.plan.structure().driven) {
    const mechanism::ElementaryJoint& at = solver.joint(link.joint);
    const std::string sign = at.first == link.from ? "" : "-";
    const double sense = at.first == link.from ? 1 : -1;
    const SceneNumber position =
        solver.numbers.number(solver.mechanism().drivers()[link.driver].position);
    const std::string state = "drivers." + solver.members.drivers[link.driver];
    const std::string gradient =
        lines.gradient(at.name + "_gradient", SceneNumber(sense) * position);
    const std::string rates = rates_of(solver, state);
    std::string law = sign + state + ".position";
    if (!rates.empty() || !gradient.empty()) {
      law += ", " + (rates.empty() ? "{}" : sign + rates);
    }
    if (!gradient.empty()) {
      law += ", " + gradient;
    }
    const std::string moved = (at.prismatic ? "support::sliding" : "support::turning") +
                              std::string("<double, order, parameter_count>(") + law + ")";
    const std::string near =
        lines.frame(on(solver, at.name, link.from), feature_frame(solver, at, link.from));
    const std::string far = lines.frame(solver.link_name(link.to) + "_on_" + at.name,
                                        mechanism::inverse(feature_frame(solver, at, link.to)));
    lines.add(solver.placed(link.to) + " = " +
              nested_frames({solver.placed(link.from), near, moved, far}) + ";");
    if (at.prismatic) {
      const std::string& slide = solver.slide_member(at);
      lines.add("placed.slide_" + slide + " = {" + state + ".position" +
                (rates.empty() ? "" : ", " + rates) + "};");
      slides.push_back(slide);
    }
  }
  return {lines.lines(), slides};
}

std::vector<std::string> holding_statements(const SolverScene& solver,
                                            mechanism::GroupIndex group) {
  SceneLines held(solver.parameters, solver.numbers);
  int first = 0;
  for (const ExternalJoint& external : external_joints(solver, group)) {
    const mechanism::ElementaryJoint& at = *external.joint;
    const mechanism::LinkIndex base = external.base;
    if (external.is_fixed(solver)) {
      continue;
    }
    const std::string place = "<" + std::to_string(first) + ">(";
    const LinkFeature<SceneNumber> feature = external.feature(solver);
    if (at.prismatic) {
      const std::string line =
          held.frame(on(solver, at.name, base), feature_frame(solver, at, base));
      held.add("held.hold_line" + place + nested_frames({solver.placed(base), line}) + ");");
    } else {
      const std::string point = held.point(on(solver, at.name, base), feature.x, feature.y);
      held.add("held.hold_point" + place +
               (solver.is_ground(base)
                    ? point
                    : "support::point_in(" + solver.placed(base) + ", " + point + ")") +
               ");");
    }
    first += at.prismatic ? 3 : 2;
  }
  add_varying_dimensions(solver, group, first, held);
  return held.lines();
}

PlacingStatements placing_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  SceneLines lines(solver.parameters, solver.numbers);
  std::vector<std::string> slides;
  const mechanism::GroupGeometry<SceneNumber>& geometry = solver.numbers.group(group);
  const std::vector<FrameNeed> needs = frame_needs(solver, group);
  std::size_t frames = 0;
  std::size_t directions = 0;
  for (const std::size_t link : framed_links(needs)) {
    const mechanism::LinkIndex played = geometry.roles->links[link];
    const bool whole = needs[link] == FrameNeed::everything;
    const std::string place = "[" + std::to_string(whole ? frames++ : directions++) + "]";
    if (!solver.lists(played)) {
      continue;
    }
    const Pose<SceneNumber> own = mechanism::inverse(geometry.links[link].frame);
    const std::string& member = "placed." + solver.members.links[played];
    if (whole) {
      lines.add(
          member + " = " +
          nested_frames({"group.frames" + place,
                         lines.frame(solver.link_name(played) + "_in_its_normal_frame", own)}) +
          ";");
    } else {
      lines.add(member + " = " +
                turned_direction(lines, "group.directions" + place, own.direction) + ";");
    }
  }
  const std::vector<ModelUnknown>& unknowns = solver.group(group).model->unknowns;
  for (std::size_t index = 0; index < unknowns.size(); ++index) {
    if (unknowns[index].is_angle) {
      continue;
    }
    const mechanism::ElementaryJoint& at = solver.played_joint(group, unknowns[index].owner);
    const auto [sense, shift] = solver.numbers.slide_measure(group, unknowns[index].owner);
    const std::string sign = sense < 0 ? "-" : "";
    const std::string slide = "placed.slide_" + solver.slide_member(at);
    const std::string unknown =
        solver.group_struct(group) + "::unit * group.q." + unknowns[index].name;
    const std::string by = lines.number(shift);
    const std::string sum = by.starts_with("-") ? " - " + by.substr(1) : " + " + by;
    const std::string shifted = by == "0.0" ? unknown : "(" + unknown + sum + ")";
    lines.add(slide + ".displacement = " + sign + shifted + ";");
    if (solver.derivative_order > 0 && solver.reports(at.joint)) {
      lines.add(slide + ".rates = " + sign + solver.group_struct(group) +
                "::unit * group.rates.row(" + std::to_string(index) + ");");
    }
    slides.push_back(solver.slide_member(at));
  }
  return {lines.lines(), slides};
}

std::vector<std::string> listing_statements(const SolverScene& solver,
                                            const std::vector<std::string>& slides) {
  const mechanism::Want& want = solver.plan.request().want;
  SceneLines lines(solver.parameters, solver.numbers);
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (solver.reports(link)) {
      const std::string& member = solver.members.links[link];
      const std::string frame = "placed." + member;
      lines.add("state.links." + member + " = " +
                state_of(want, frame + ".pose", frame + ".rates", true) + ";");
    }
  }
  for (const std::string& slide : slides) {
    const std::string placed = "placed.slide_" + slide;
    lines.add("state.slides." + slide + " = " +
              state_of(want, placed + ".displacement", placed + ".rates", false) + ";");
  }
  for (const mechanism::OutputIndex index : solver.mechanism().outputs().keys()) {
    const mechanism::FeatureIndex output = solver.mechanism().outputs()[index].point;
    const mechanism::Feature& feature = solver.mechanism().features()[output];
    const LinkFeature<SceneNumber> place = solver.numbers.feature(output, false);
    const std::string point = lines.point(on(solver, feature.name, feature.link), place.x, place.y);
    const std::string base = solver.placed(feature.link);
    const std::string name = lines.declared("point_" + solver.members.outputs[index]);
    lines.add("const LinkPoint " + name + " = " +
              (base.empty() ? point : "point_in(" + base + ", " + point + ")") + ";");
    std::vector<std::string> sensitive;
    if (solver.parameters.count() > 0) {
      sensitive.push_back(name + ".gradient");
    }
    if (solver.has_tolerances()) {
      sensitive.push_back("support::worst_case(" + name + ".gradient, tolerances)");
      sensitive.push_back("support::root_sum_square(" + name + ".gradient, tolerances)");
    }
    lines.add("state.outputs." + solver.members.outputs[index] + " = " +
              state_of(want, "{" + name + ".x, " + name + ".y}", name + ".rates", true, sensitive) +
              ";");
  }
  return lines.lines();
}

}  // namespace assur::generator::emission::scene
