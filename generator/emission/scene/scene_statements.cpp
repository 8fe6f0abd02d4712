#include "emission/scene/scene_statements.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <deque>

#include "emission/scene/specialised_numbers.hpp"
#include "equations/closure.hpp"

namespace assur::generator::emission::scene {

namespace {

FunctionBody body_of(const SolverScene& solver) {
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

/// Rates as a row; nothing if none are wanted.
OptionalExpression row_of(std::vector<cpp::Expression> rates) {
  return rates.empty() ? std::nullopt
                       : OptionalExpression(cpp::call(cpp::alias("Rates"), std::move(rates)));
}

/// A direction that is turned by another.
cpp::Expression turned_direction(const FunctionBody& body, const cpp::Expression& direction,
                                 const Direction<SceneNumber>& by) {
  const cpp::Expression angle = body.direction(by);
  return angle.parts[0].is_number(1) && angle.parts[1].is_number(0)
             ? direction
             : cpp::call("turned", {direction, angle});
}

/// The expression, or its negative.
cpp::Expression with_sense(double sense, const cpp::Expression& expression) {
  return sense < 0 ? cpp::negative(expression) : expression;
}

/// The values of those members of a part of a state that are wanted: `{pose, velocity}`.
cpp::Expression state_of(const mechanism::Want& want, const cpp::Expression& position,
                         const cpp::Expression& rates,
                         const std::vector<cpp::Expression>& more = {}) {
  std::vector<cpp::Expression> values;
  const auto rate = [&](std::size_t order) { return rates.at({cpp::word(order)}); };
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
  return cpp::braces("", std::move(values));
}

/// `held.template hold_point<2>(arguments)`
cpp::Statement hold(const std::string& function, int first,
                    std::vector<cpp::Expression> arguments) {
  const std::string instance = "template " + function + "<" + std::to_string(first) + ">";
  return cpp::called(cpp::variable("held").member(instance).at(std::move(arguments)));
}

/// Holds the dimensions that drivers move, or else those that only variable parameters change: they
/// are the inputs of the group from `first` on.
void add_varying_dimensions(const SolverScene& solver, mechanism::GroupIndex group, bool that_move,
                            int& first, FunctionBody& held) {
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
    const auto hold_at = [&](const std::string& function, const cpp::Expression& place,
                             const OptionalExpression& gradient, const OptionalExpression& rates) {
      std::vector<cpp::Expression> arguments = {place};
      if (gradient || rates) {
        arguments.push_back(gradient ? *gradient
                                     : cpp::call({"ParameterRow::Zero", "ParameterRow"}));
      }
      if (rates) {
        arguments.push_back(*rates);
      }
      held.add(hold(function, first++, std::move(arguments)));
    };
    if (value.is_angle && (moves || solver.numbers.varies(value.angle))) {
      const OptionalExpression gradient = held.gradient(name + "_gradient", value.angle);
      hold_at("hold_angle", held.direction(value.angle), gradient, held.rates(value.angle));
    } else if (!value.is_angle && (moves || solver.numbers.varies(value.length))) {
      const OptionalExpression gradient = held.gradient(name + "_gradient", value.length);
      hold_at("hold_length", held.number(value.length), gradient, held.rates(value.length));
    }
  }
}

/// A driver as statements read it.
struct DriverValue {
  cpp::Expression position;
  OptionalExpression rates;  ///< nothing if none are wanted
  SceneNumber law;           ///< how the position follows the parameters
};

/// An argument of the solver, or the formula of a law in the joints that it reads.
DriverValue driver_value(const SolverScene& solver, mechanism::DriverIndex index,
                         const FunctionBody& body) {
  if (solver.is_argument(index)) {
    const cpp::Expression state = cpp::variable("drivers").member(solver.members.drivers[index]);
    std::vector<cpp::Expression> rates = {state.member("velocity"), state.member("acceleration")};
    rates.resize(static_cast<std::size_t>(solver.derivative_order));
    return {state.member("position"), row_of(std::move(rates)), solver.numbers.law(index)};
  }
  const SceneNumber& position = solver.numbers.position(index);
  const mechanism::Driver& driver = solver.mechanism().drivers()[index];
  std::vector<cpp::Expression> rates = solver.numbers.rates(position, solver.derivative_order);
  const std::array<mechanism::NumberIndex, 2> given = {driver.velocity, driver.acceleration};
  for (std::size_t order = 0; order < rates.size(); ++order) {
    if (given[order].exists()) {
      rates[order] = cpp::number(solver.values.number(given[order]).value());
    }
  }
  return {body.number(position), row_of(std::move(rates)), position};
}

/// How far along its line a slide is, where the links stand.
cpp::Expression displacement(const SolverScene& solver, mechanism::JointIndex slide,
                             FunctionBody& body) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto frame_of = [&](mechanism::FeatureIndex index) {
    const mechanism::Feature& described = mechanism.features()[index];
    const LinkFeature<SceneNumber> feature = solver.numbers.feature(index, described.is_line);
    const OptionalExpression own = body.frame(on(solver, described.name, described.link),
                                              {feature.x, feature.y, feature.along});
    return nested_frames({solver.placed(described.link), own});
  };
  const std::vector<mechanism::FeatureIndex>& between = mechanism.joints()[slide].between;
  const std::size_t line = mechanism.features()[between[0]].is_line ? 0 : 1;
  const cpp::Expression from = frame_of(between[line]);
  return cpp::call("support::displacement_along", {from, frame_of(between[1 - line])});
}

std::string coordinate_of(const SolverScene& solver, mechanism::JointIndex joint) {
  return "joint_" + solver.members.joints[joint];
}

/// Declares the coordinates of the joints that a driver's law reads and that groups place, as far
/// as `is_read` tells for their names.
template <typename IsRead>
void add_joints_read(const SolverScene& solver, mechanism::DriverIndex driver, FunctionBody& body,
                     const IsRead& is_read) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto link_of = [&](mechanism::FeatureIndex feature) {
    return mechanism.features()[feature].link;
  };
  for (const mechanism::JointIndex joint : mechanism::joints_in_laws(mechanism, driver)) {
    const mechanism::Joint& at = mechanism.joints()[joint];
    const std::string name = coordinate_of(solver, joint);
    if (mechanism.driver_of(joint).exists() || body.declares(name) || !is_read(name)) {
      continue;
    }
    const cpp::Expression value =
        at.type == mechanism::JointType::revolute
            ? cpp::call(cpp::scalar_only("support::angle_between"),
                        {nested_frames({solver.placed(link_of(at.between[0]))}),
                         nested_frames({solver.placed(link_of(at.between[1]))})})
            : displacement(solver, joint, body);
    body.add(cpp::declared({"const LinkCoordinate", "LinkCoordinate"}, cpp::variable(name), value));
  }
}

cpp::Expression placed_slide(const std::string& member) {
  return cpp::variable("placed").member("slide_" + member);
}

/// A slide's displacement with its rates, if they are wanted.
cpp::Expression slide_of(const cpp::Expression& displacement, const OptionalExpression& rates) {
  return rates ? cpp::braces("", {displacement, *rates}) : cpp::braces("", {displacement});
}

/// Places a link that another one carries.
void add_carried_link(const SolverScene& solver, const mechanism::CarriedLink& link,
                      FunctionBody& body, std::vector<std::string>& slides) {
  if (link.group.exists()) {
    body.add(
        cpp::assigned(*solver.placed(link.to),
                      nested_frames({solver.placed(link.from), solver.placed_by_group(link.to)})));
    return;
  }
  const mechanism::ElementaryJoint& at = solver.joint(link.joint);
  add_joints_read(solver, link.driver, body, [](const std::string&) { return true; });
  const DriverValue driver = driver_value(solver, link.driver, body);
  const double sense = at.first == link.from ? 1 : -1;
  const OptionalExpression gradient =
      body.gradient(at.name + "_gradient", SceneNumber(sense) * driver.law);
  const bool is_formula = !solver.is_argument(link.driver) && sense < 0;
  std::vector<cpp::Expression> law = {
      with_sense(sense, is_formula ? cpp::parentheses(driver.position) : driver.position)};
  if (driver.rates || gradient) {
    law.push_back(driver.rates ? with_sense(sense, *driver.rates) : cpp::braces(""));
  }
  if (gradient) {
    law.push_back(*gradient);
  }
  const std::string kind = at.prismatic ? "support::sliding" : "support::turning";
  const cpp::Expression moved =
      cpp::call(kind + "<Scalar, order, parameter_count>", std::move(law));
  const OptionalExpression near =
      body.frame(on(solver, at.name, link.from), feature_frame(solver, at, link.from));
  const OptionalExpression far = body.frame(solver.link_name(link.to) + "_on_" + at.name,
                                            mechanism::inverse(feature_frame(solver, at, link.to)));
  body.add(cpp::assigned(*solver.placed(link.to),
                         nested_frames({solver.placed(link.from), near, moved, far})));
  if (at.prismatic) {
    const std::string& slide = solver.slide_member(at);
    body.add(cpp::assigned(placed_slide(slide), slide_of(driver.position, driver.rates)));
    slides.push_back(slide);
  }
}

/// Adds a part of a function for a group. If laws that read joints change the shape of the group's
/// links, the coordinates of these joints come before it, as far as it reads them. A law that is
/// computed after the group is left out: it may read the group itself.
template <typename Add>
void add_part(const SolverScene& solver, mechanism::GroupIndex group, FunctionBody& body,
              const Add& add) {
  const std::size_t before = body.size();
  add();
  const cpp::Block own = body.take_from(before);
  const std::set<std::string> read = body.variables_read(own);
  const mechanism::Structure& structure = solver.plan.structure();
  const auto shapes_it = [&](mechanism::DriverIndex driver) {
    return std::ranges::any_of(structure.carried, [&](const mechanism::CarriedLink& link) {
      const std::vector<mechanism::LinkIndex>& links = structure.groups[group].links;
      return link.driver == driver && std::ranges::find(links, link.to) != links.end();
    });
  };
  for (const mechanism::ReadingDriver& reading : structure.reading) {
    if (reading.groups_before <= group.place() && shapes_it(reading.driver)) {
      add_joints_read(solver, reading.driver, body, [&](const std::string& name) {
        return read.contains(name) && !cpp::declares(own, name);
      });
    }
  }
  body.add(own);
}

/// Holds a group's external joints, and moves its dimensions.
void add_holding(const SolverScene& solver, mechanism::GroupIndex group, FunctionBody& held) {
  int first = 0;
  for (const ExternalJoint& external : external_joints(solver, group)) {
    const mechanism::ElementaryJoint& at = *external.joint;
    const mechanism::LinkIndex base = external.base;
    if (external.is_fixed(solver)) {
      continue;
    }
    const LinkFeature<SceneNumber> feature = external.feature(solver);
    if (at.prismatic) {
      const OptionalExpression line =
          held.frame(on(solver, at.name, base), feature_frame(solver, at, base));
      held.add(hold("hold_line", first, {nested_frames({external.frame(solver), line})}));
    } else {
      held.add(hold(
          "hold_point", first,
          {held.point(on(solver, at.name, base), external.frame(solver), feature.x, feature.y)}));
    }
    first += at.prismatic ? 3 : 2;
  }
  add_varying_dimensions(solver, group, true, first, held);
  add_varying_dimensions(solver, group, false, first, held);
}

/// Measures the slides of second pins in slots whose links are placed with the last of a number of
/// groups.
void add_second_pins(const SolverScene& solver, std::size_t groups, FunctionBody& body,
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
      const cpp::Expression along = body.local("along_" + member);
      body.add(cpp::declared("const auto", along, displacement(solver, pin, body)));
      body.add(cpp::assigned(
          placed_slide(member),
          slide_of(along.member("position"), solver.derivative_order > 0
                                                 ? OptionalExpression(along.member("rates"))
                                                 : std::nullopt)));
      slides.push_back(member);
    }
  }
}

/// Places a group's links and slides.
void add_group(const SolverScene& solver, mechanism::GroupIndex group, FunctionBody& body,
               std::vector<std::string>& slides) {
  const mechanism::GroupGeometry<SceneNumber>& geometry = solver.numbers.group(group);
  const std::vector<FrameNeed> needs = frame_needs(solver, group);
  const cpp::Expression of_group = cpp::variable("group");
  std::size_t frames = 0;
  std::size_t directions = 0;
  for (const std::size_t link : framed_links(needs)) {
    const mechanism::LinkIndex played = geometry.roles->links[link];
    const bool whole = needs[link] == FrameNeed::everything;
    const Pose<SceneNumber> own = mechanism::inverse(geometry.links[link].frame);
    const cpp::Expression member = solver.placed_by_group(played);
    if (whole) {
      const OptionalExpression normal =
          body.frame(solver.link_name(played) + "_in_its_normal_frame", own);
      body.add(
          cpp::assigned(member, nested_frames({of_group.member("frames").item(frames++), normal})));
    } else {
      body.add(cpp::assigned(
          member,
          turned_direction(body, of_group.member("directions").item(directions++), own.direction)));
    }
  }
  const std::vector<ModelUnknown>& unknowns = solver.group(group).model->unknowns;
  for (std::size_t index = 0; index < unknowns.size(); ++index) {
    const mechanism::ElementaryJoint& at = solver.played_joint(group, unknowns[index].owner);
    if (unknowns[index].is_angle || !at.joint.exists()) {
      continue;
    }
    const auto [sense, shift] = solver.numbers.slide_measure(group, unknowns[index].owner);
    const cpp::Expression slide = placed_slide(solver.slide_member(at));
    const cpp::Expression unit =
        cpp::call("Scalar", {cpp::word(solver.group_struct(group) + "::unit")});
    const cpp::Expression unknown =
        cpp::product({unit, of_group.member("q").member(unknowns[index].name)});
    const cpp::Expression by = body.number(shift);
    const cpp::Expression shifted =
        by.is_number(0) ? unknown : cpp::parentheses(cpp::sum({unknown, by}));
    body.add(cpp::assigned(slide.member("displacement"), with_sense(sense, shifted)));
    if (solver.derivative_order > 0 && solver.reports(at.joint)) {
      const cpp::Expression rates =
          cpp::product({unit, of_group.member("rates").member("row").at({cpp::word(index)})});
      const OptionalExpression by_drivers = body.rates(shift);
      body.add(cpp::assigned(
          slide.member("rates"),
          with_sense(sense,
                     by_drivers ? cpp::parentheses(cpp::sum({rates, *by_drivers})) : rates)));
    }
    slides.push_back(solver.slide_member(at));
  }
}

}  // namespace

PlacingStatements driving_statements(const SolverScene& solver) {
  FunctionBody body = body_of(solver);
  std::vector<std::string> slides;
  for (const mechanism::CarriedLink& link : solver.plan.structure().carried) {
    if (link.groups_before == 0) {
      add_carried_link(solver, link, body, slides);
    }
  }
  return {body.block(true), slides};
}

cpp::Block holding_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  FunctionBody body = body_of(solver);
  add_part(solver, group, body, [&] { add_holding(solver, group, body); });
  return body.block();
}

PlacingStatements placing_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  FunctionBody body = body_of(solver);
  std::vector<std::string> slides;
  const std::size_t placed = group.place() + 1;
  add_part(solver, group, body, [&] { add_group(solver, group, body, slides); });
  for (const mechanism::CarriedLink& link : solver.plan.structure().carried) {
    if (link.groups_before == placed) {
      add_part(solver, group, body, [&] { add_carried_link(solver, link, body, slides); });
    }
  }
  add_part(solver, group, body, [&] { add_second_pins(solver, placed, body, slides); });
  return {body.block(), slides};
}

cpp::Block listing_statements(const SolverScene& solver, const std::vector<std::string>& slides) {
  const mechanism::Want& want = solver.plan.request().want;
  const cpp::Expression state = cpp::variable("state");
  FunctionBody body = body_of(solver);
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (solver.reports(link)) {
      const std::string& member = solver.members.links[link];
      const cpp::Expression frame = cpp::variable("placed").member(member);
      body.add(
          cpp::assigned(state.member("links").member(member),
                        state_of(want, frame.member("pose"), frame.member("rates").member("col"))));
    }
  }
  for (const std::string& slide : slides) {
    const cpp::Expression placed = placed_slide(slide);
    body.add(cpp::assigned(state.member("slides").member(slide),
                           state_of(want, placed.member("displacement"), placed.member("rates"))));
  }
  const bool is_sensitive = solver.parameters.count() > 0 || solver.has_tolerances();
  if (!want.position && !want.velocity && !want.acceleration && !is_sensitive) {
    return body.block();
  }
  for (const mechanism::OutputIndex index : solver.mechanism().outputs().keys()) {
    const mechanism::FeatureIndex output = solver.mechanism().outputs()[index].point;
    const mechanism::Feature& feature = solver.mechanism().features()[output];
    const LinkFeature<SceneNumber> place = solver.numbers.feature(output, false);
    const cpp::Expression value = body.point(on(solver, feature.name, feature.link),
                                             solver.placed(feature.link), place.x, place.y);
    const cpp::Expression point = body.local("point_" + solver.members.outputs[index]);
    body.add(cpp::declared({"const LinkPoint", "LinkPoint"}, point, value));
    std::vector<cpp::Expression> sensitive;
    const cpp::Expression gradient = point.member("gradient");
    if (solver.parameters.count() > 0) {
      sensitive.push_back(gradient);
    }
    if (solver.has_tolerances()) {
      for (const char* bound : {"support::worst_case", "support::root_sum_square"}) {
        sensitive.push_back(cpp::call(bound, {gradient, cpp::variable("tolerances")}));
      }
    }
    body.add(cpp::assigned(state.member("outputs").member(solver.members.outputs[index]),
                           state_of(want, cpp::braces("", {point.member("x"), point.member("y")}),
                                    point.member("rates").member("col"), sensitive)));
  }
  return body.block();
}

}  // namespace assur::generator::emission::scene
