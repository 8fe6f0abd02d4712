#include "emission/scene/scene_statements.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <deque>

#include "emission/cpp/cpp_text.hpp"
#include "emission/scene/specialised_numbers.hpp"
#include "equations/closure.hpp"

namespace assur::generator::emission::scene {

namespace {

SceneLines lines_of(const SolverScene& solver) {
  return {solver.parameters, solver.numbers, solver.derivative_order};
}

std::string on(const SolverScene& solver, const std::string& feature, mechanism::LinkIndex link) {
  return feature + "_on_" + solver.link_name(link);
}

/// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
Pose<SceneNumber> feature_frame(const SolverScene& solver, const mechanism::ElementaryJoint& at,
                                mechanism::LinkIndex link) {
  const LinkFeature<SceneNumber> feature = solver.numbers.feature(at, link);
  return {feature.x, feature.y, feature.along};
}

/// The rates of a driver as a row; empty if none are wanted.
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

/// The values of those members of a part of a state that are wanted: `{pose, velocity}`.
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

/// Holds the dimensions that drivers move, or else those that only variable parameters change: they
/// are the inputs of the group from `first` on.
void add_varying_dimensions(const SolverScene& solver, mechanism::GroupIndex group, bool that_move,
                            int& first, SceneLines& held) {
  const std::vector<bool> dimension_moves = moving_dimensions(solver, group);
  const structure::Model& model = derived_model(solver.group(group));
  const std::deque<equations::Variable> dimensions = equations::closure_equations(model).dimensions;
  std::size_t index = 0;
  for (const DimensionValue<SceneNumber>& value : solver.numbers.group(group).dimensions()) {
    const bool moves = dimension_moves[index];
    const std::string name = dimensions[index++].name;
    if (moves != that_move) {
      continue;
    }
    const auto hold = [&](const std::string& function, const std::string& text,
                          const std::string& gradient, const std::string& rates) {
      held.add("held.template " + function + "<" + std::to_string(first++) + ">(" + text +
               (gradient.empty() && rates.empty() ? ""
                : gradient.empty()                ? ", ParameterRow::Zero()"
                                                  : ", " + gradient) +
               (rates.empty() ? "" : ", " + rates) + ");");
    };
    if (value.is_angle && (moves || solver.numbers.varies(value.angle))) {
      const std::string gradient = held.gradient(name + "_gradient", value.angle);
      hold("hold_angle", held.direction(value.angle), gradient, held.rates(value.angle));
    } else if (!value.is_angle && (moves || solver.numbers.varies(value.length))) {
      const std::string gradient = held.gradient(name + "_gradient", value.length);
      hold("hold_length", held.number(value.length), gradient, held.rates(value.length));
    }
  }
}

/// A driver as statements read it.
struct DriverText {
  std::string position, rates;  ///< the rates are empty if none are wanted
  SceneNumber law;              ///< how the position follows the parameters
};

/// An argument of the solver, or the formula of a law in the joints that it reads.
DriverText driver_text(const SolverScene& solver, mechanism::DriverIndex index, SceneLines& lines) {
  if (solver.is_argument(index)) {
    const std::string state = "drivers." + solver.members.drivers[index];
    return {state + ".position", rates_of(solver, state), solver.numbers.law(index)};
  }
  const SceneNumber& position = solver.numbers.position(index);
  const mechanism::Driver& driver = solver.mechanism().drivers()[index];
  std::vector<std::string> rates = solver.numbers.rates(position, solver.derivative_order);
  const std::array<mechanism::NumberIndex, 2> given = {driver.velocity, driver.acceleration};
  for (std::size_t order = 0; order < rates.size(); ++order) {
    if (given[order].exists()) {
      rates[order] = cpp::round_trip(solver.values.number(given[order]).value());
    }
  }
  const auto as_it_is = [](const std::string& rate) { return rate; };
  return {lines.number(position),
          rates.empty() ? "" : "Rates(" + text::joined(rates, ", ", as_it_is) + ")", position};
}

/// Whether one of the lines contains a name; true if there are no lines.
bool may_be_read_by(const std::vector<std::string>& lines, const std::string& name) {
  return lines.empty() || std::ranges::any_of(lines, [&](const std::string& line) {
           return line.find(name) != std::string::npos;
         });
}

/// How far along its line a slide is, where the links stand.
std::string displacement_text(const SolverScene& solver, mechanism::JointIndex slide,
                              SceneLines& lines) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto frame_of = [&](mechanism::FeatureIndex index) {
    const mechanism::Feature& described = mechanism.features()[index];
    const LinkFeature<SceneNumber> feature = solver.numbers.feature(index, described.is_line);
    const std::string own = lines.frame(on(solver, described.name, described.link),
                                        {feature.x, feature.y, feature.along});
    return nested_frames({solver.placed(described.link), own});
  };
  const std::vector<mechanism::FeatureIndex>& between = mechanism.joints()[slide].between;
  const std::size_t line = mechanism.features()[between[0]].is_line ? 0 : 1;
  const std::string from = frame_of(between[line]);
  return "support::displacement_along(" + from + ", " + frame_of(between[1 - line]) + ")";
}

/// Declares the coordinates of the joints that a driver's law reads and that groups place. With
/// `others`, it declares only those that these lines read.
void add_joints_read(const SolverScene& solver, mechanism::DriverIndex driver, SceneLines& lines,
                     const std::vector<std::string>& others = {}) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto link_of = [&](mechanism::FeatureIndex feature) {
    return mechanism.features()[feature].link;
  };
  for (const mechanism::JointIndex joint : mechanism::joints_in_laws(mechanism, driver)) {
    const mechanism::Joint& at = mechanism.joints()[joint];
    const std::string name = "joint_" + solver.members.joints[joint];
    if (mechanism.driver_of(joint).exists() || lines.declares("const LinkCoordinate " + name) ||
        !may_be_read_by(others, name + ".")) {
      continue;
    }
    std::string value;
    if (at.type == mechanism::JointType::revolute) {
      value = "support::angle_between(" + nested_frames({solver.placed(link_of(at.between[0]))}) +
              ", " + nested_frames({solver.placed(link_of(at.between[1]))}) + ")";
    } else {
      value = displacement_text(solver, joint, lines);
    }
    lines.add("const LinkCoordinate " + name + " = " + value + ";");
  }
}

/// Places the links that others carry and that need `groups_before` groups to be placed.
void add_carried_links(const SolverScene& solver, std::size_t groups_before, SceneLines& lines,
                       std::vector<std::string>& slides) {
  for (const mechanism::CarriedLink& link : solver.plan.structure().carried) {
    if (link.groups_before != groups_before) {
      continue;
    }
    if (link.group.exists()) {
      lines.add(solver.placed(link.to) + " = " +
                nested_frames({solver.placed(link.from), solver.placed_by_group(link.to)}) + ";");
      continue;
    }
    const mechanism::ElementaryJoint& at = solver.joint(link.joint);
    add_joints_read(solver, link.driver, lines);
    const DriverText driver = driver_text(solver, link.driver, lines);
    const double sense = at.first == link.from ? 1 : -1;
    const std::string sign = sense > 0 ? "" : "-";
    const std::string gradient =
        lines.gradient(at.name + "_gradient", SceneNumber(sense) * driver.law);
    const bool is_sum = !solver.is_argument(link.driver) && !sign.empty();
    std::string law = sign + (is_sum ? "(" + driver.position + ")" : driver.position);
    if (!driver.rates.empty() || !gradient.empty()) {
      law += ", " + (driver.rates.empty() ? "{}" : sign + driver.rates);
    }
    if (!gradient.empty()) {
      law += ", " + gradient;
    }
    const std::string moved = (at.prismatic ? "support::sliding" : "support::turning") +
                              std::string("<Scalar, order, parameter_count>(") + law + ")";
    const std::string near =
        lines.frame(on(solver, at.name, link.from), feature_frame(solver, at, link.from));
    const std::string far = lines.frame(solver.link_name(link.to) + "_on_" + at.name,
                                        mechanism::inverse(feature_frame(solver, at, link.to)));
    lines.add(solver.placed(link.to) + " = " +
              nested_frames({solver.placed(link.from), near, moved, far}) + ";");
    if (at.prismatic) {
      const std::string& slide = solver.slide_member(at);
      lines.add("placed.slide_" + slide + " = {" + driver.position +
                (driver.rates.empty() ? "" : ", " + driver.rates) + "};");
      slides.push_back(slide);
    }
  }
}

/// The statements of a function for a group. If laws that read joints change the shape of its
/// links, the coordinates of these joints come first, as far as the statements read them. A law
/// that is computed after the group is left out: it may read the group itself.
template <typename Add>
SceneLines lines_of_group(const SolverScene& solver, mechanism::GroupIndex group, const Add& add) {
  SceneLines alone = lines_of(solver);
  add(alone);
  const mechanism::Structure& structure = solver.plan.structure();
  const auto shapes_it = [&](mechanism::DriverIndex driver) {
    return std::ranges::any_of(structure.carried, [&](const mechanism::CarriedLink& link) {
      const std::vector<mechanism::LinkIndex>& links = structure.groups[group].links;
      return link.driver == driver && std::ranges::find(links, link.to) != links.end();
    });
  };
  SceneLines lines = lines_of(solver);
  for (const mechanism::ReadingDriver& reading : structure.reading) {
    if (const std::vector<std::string> others = alone.lines();
        reading.groups_before <= group.place() && shapes_it(reading.driver) && !others.empty()) {
      add_joints_read(solver, reading.driver, lines, others);
    }
  }
  add(lines);
  return lines;
}

/// Holds a group's external joints, and moves its dimensions.
void add_holding(const SolverScene& solver, mechanism::GroupIndex group, SceneLines& held) {
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
      held.add("held.template hold_line" + place + nested_frames({external.frame(solver), line}) +
               ");");
    } else {
      held.add("held.template hold_point" + place +
               held.point(on(solver, at.name, base), external.frame(solver), feature.x, feature.y) +
               ");");
    }
    first += at.prismatic ? 3 : 2;
  }
  add_varying_dimensions(solver, group, true, first, held);
  add_varying_dimensions(solver, group, false, first, held);
}

/// Measures the slides of second pins in slots whose links are placed with the last of a number of
/// groups.
void add_second_pins(const SolverScene& solver, std::size_t groups, SceneLines& lines,
                     std::vector<std::string>& slides) {
  const mechanism::Structure& structure = solver.plan.structure();
  const mechanism::Table<mechanism::LinkIndex, std::size_t> before = structure.groups_before();
  for (const mechanism::JointIndex pin : structure.linkage.second_pins) {
    std::size_t placed_with = 0;
    for (const mechanism::FeatureIndex feature : solver.mechanism().joints()[pin].between) {
      placed_with = std::max(placed_with, before[solver.mechanism().features()[feature].link]);
    }
    if (placed_with == groups) {
      const std::string& member = solver.members.joints[pin];
      const std::string along = lines.declared("along_" + member);
      lines.add("const auto " + along + " = " + displacement_text(solver, pin, lines) + ";");
      lines.add("placed.slide_" + member + " = {" + along + ".position" +
                (solver.derivative_order > 0 ? ", " + along + ".rates" : "") + "};");
      slides.push_back(member);
    }
  }
}

/// Places a group's links and slides, and then the links that it allows to be carried.
void add_placing(const SolverScene& solver, mechanism::GroupIndex group, SceneLines& lines,
                 std::vector<std::string>& slides) {
  const mechanism::GroupGeometry<SceneNumber>& geometry = solver.numbers.group(group);
  const std::vector<FrameNeed> needs = frame_needs(solver, group);
  std::size_t frames = 0;
  std::size_t directions = 0;
  for (const std::size_t link : framed_links(needs)) {
    const mechanism::LinkIndex played = geometry.roles->links[link];
    const bool whole = needs[link] == FrameNeed::everything;
    const std::string place = "[" + std::to_string(whole ? frames++ : directions++) + "]";
    const Pose<SceneNumber> own = mechanism::inverse(geometry.links[link].frame);
    const std::string member = solver.placed_by_group(played);
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
    const mechanism::ElementaryJoint& at = solver.played_joint(group, unknowns[index].owner);
    if (unknowns[index].is_angle || !at.joint.exists()) {
      continue;
    }
    const auto [sense, shift] = solver.numbers.slide_measure(group, unknowns[index].owner);
    const std::string sign = sense < 0 ? "-" : "";
    const std::string slide = "placed.slide_" + solver.slide_member(at);
    const std::string unknown =
        "Scalar(" + solver.group_struct(group) + "::unit) * group.q." + unknowns[index].name;
    const std::string by = lines.number(shift);
    const std::string sum = by.starts_with("-") ? " - " + by.substr(1) : " + " + by;
    const std::string shifted = by == "0.0" ? unknown : "(" + unknown + sum + ")";
    lines.add(slide + ".displacement = " + sign + shifted + ";");
    if (solver.derivative_order > 0 && solver.reports(at.joint)) {
      const std::string rates = "Scalar(" + solver.group_struct(group) +
                                "::unit) * group.rates.row(" + std::to_string(index) + ")";
      const std::string by_drivers = lines.rates(shift);
      lines.add(slide + ".rates = " + sign +
                (by_drivers.empty() ? rates : "(" + rates + " + " + by_drivers + ")") + ";");
    }
    slides.push_back(solver.slide_member(at));
  }
  add_carried_links(solver, group.place() + 1, lines, slides);
  add_second_pins(solver, group.place() + 1, lines, slides);
}

}  // namespace

PlacingStatements driving_statements(const SolverScene& solver) {
  SceneLines lines = lines_of(solver);
  std::vector<std::string> slides;
  add_carried_links(solver, 0, lines, slides);
  return {lines.lines(true), slides};
}

std::vector<std::string> holding_statements(const SolverScene& solver,
                                            mechanism::GroupIndex group) {
  return lines_of_group(solver, group, [&](SceneLines& held) { add_holding(solver, group, held); })
      .lines();
}

PlacingStatements placing_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  std::vector<std::string> slides;
  const SceneLines lines = lines_of_group(solver, group, [&](SceneLines& placing) {
    slides.clear();
    add_placing(solver, group, placing, slides);
  });
  return {lines.lines(), slides};
}

std::vector<std::string> listing_statements(const SolverScene& solver,
                                            const std::vector<std::string>& slides) {
  const mechanism::Want& want = solver.plan.request().want;
  SceneLines lines = lines_of(solver);
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
  const bool is_sensitive = solver.parameters.count() > 0 || solver.has_tolerances();
  if (!want.position && !want.velocity && !want.acceleration && !is_sensitive) {
    return lines.lines();
  }
  for (const mechanism::OutputIndex index : solver.mechanism().outputs().keys()) {
    const mechanism::FeatureIndex output = solver.mechanism().outputs()[index].point;
    const mechanism::Feature& feature = solver.mechanism().features()[output];
    const LinkFeature<SceneNumber> place = solver.numbers.feature(output, false);
    const std::string point = lines.point(on(solver, feature.name, feature.link),
                                          solver.placed(feature.link), place.x, place.y);
    const std::string name = lines.declared("point_" + solver.members.outputs[index]);
    lines.add("const LinkPoint " + name + " = " + point + ";");
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
