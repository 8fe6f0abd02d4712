#include "emission/scene/scene_statements.hpp"

#include <algorithm>
#include <deque>

#include "emission/scene/carried_links.hpp"
#include "emission/scene/specialised_numbers.hpp"
#include "equations/closure.hpp"

namespace assur::generator::emission::scene {

namespace {

/// A direction rotated by another.
cpp::Expression turned_direction(const FunctionBody& body, const cpp::Expression& direction,
                                 const Direction<SceneNumber>& by) {
  const cpp::Expression angle = body.direction(by);
  return angle.parts[0].is_number(1) && angle.parts[1].is_number(0)
             ? direction
             : cpp::call("turned", {direction, angle});
}

/// `held.template hold_point<2>(arguments)`
cpp::Statement hold(const std::string& function, int first,
                    std::vector<cpp::Expression> arguments) {
  const std::string instance = "template " + function + "<" + std::to_string(first) + ">";
  return cpp::called(cpp::variable("held").member(instance).at(std::move(arguments)));
}

/// Holds the dimensions that drivers move, or else those that only variable parameters change: the
/// inputs of the group from `first` on.
void add_varying_dimensions(const SolverScene& solver, mechanism::GroupIndex group, bool that_move,
                            int& first, FunctionBody& held) {
  const std::vector<bool> dimension_moves = moving_dimensions(solver, group);
  const structure::Model& model = symbolic_model(solver.group(group));
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

/// Adds a part of a function for a group, preceded by the joint coordinates that it reads if laws
/// that read joints change the shape of the group's links or of links that hold it. A law that is
/// computed after the group is omitted: it may read the group itself.
template <typename Add>
void add_part(const SolverScene& solver, mechanism::GroupIndex group, FunctionBody& body,
              const Add& add) {
  const std::size_t before = body.size();
  add();
  const cpp::Block own = body.take_from(before);
  std::set<std::string> read = body.variables_read(own);
  const mechanism::Structure& structure = solver.plan.structure();
  for (const mechanism::ReadingDriver& reading : structure.reading) {
    if (reading.groups_before <= group.place()) {
      add_joints_read(solver, reading.driver, body, [&](const std::string& name) {
        return !cpp::declares(own, name) && read.erase(name) > 0;
      });
    }
  }
  body.add(own);
}

/// Holds a group's external joints, and sets its moving dimensions.
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
          held.frame(feature_name(solver, at.name, base), feature_frame(solver, at, base));
      held.add(hold("hold_line", first, {nested_frames({external.frame(solver), line})}));
    } else {
      held.add(hold("hold_point", first,
                    {held.point(feature_name(solver, at.name, base), external.frame(solver),
                                feature.x, feature.y)}));
    }
    first += at.prismatic ? 3 : 2;
  }
  add_varying_dimensions(solver, group, true, first, held);
  add_varying_dimensions(solver, group, false, first, held);
}

/// Measures the slides of second pins in slots whose links are placed by the last of these groups.
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
      add_measured_slide(solver, pin, body);
      slides.push_back(solver.members.joints[pin]);
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
  const std::deque<equations::Variable> members =
      equations::closure_equations(symbolic_model(solver.group(group))).unknowns;
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
        cpp::product({unit, of_group.member("q").member(members[index].name)});
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
  FunctionBody body = solver.body();
  std::vector<std::string> slides;
  for (const mechanism::CarriedLink& link : solver.plan.structure().carried) {
    if (link.groups_before == 0) {
      add_carried_link(solver, link, body, slides);
    }
  }
  return {body.block(true), slides};
}

cpp::Block holding_statements(const SolverScene& solver, mechanism::GroupIndex group) {
  FunctionBody body = solver.body();
  add_part(solver, group, body, [&] { add_holding(solver, group, body); });
  return body.block();
}

PlacingStatements placing_statements(const SolverScene& solver, mechanism::GroupIndex group,
                                     const SpecialisedGroup& special) {
  FunctionBody body = solver.body();
  std::vector<std::string> slides;
  const std::size_t placed = group.place() + 1;
  add_part(solver, group, body, [&] { add_group(solver, group, body, slides); });
  if (solver.keeps_groups()) {
    const cpp::Expression of_group = cpp::variable("group");
    std::vector<cpp::Expression> kept = {of_group.member("q"), of_group.member("regularity")};
    if (special.shares_reciprocals) {
      kept.push_back(of_group.member("reciprocals"));
    }
    body.add(cpp::assigned(cpp::variable("placed").member(solver.members.solved[group]),
                           cpp::braces("", std::move(kept))));
  }
  for (const mechanism::CarriedLink& link : solver.plan.structure().carried) {
    if (link.groups_before == placed) {
      add_part(solver, group, body, [&] { add_carried_link(solver, link, body, slides); });
    }
  }
  add_part(solver, group, body, [&] { add_second_pins(solver, placed, body, slides); });
  return {body.block(), slides};
}

}  // namespace assur::generator::emission::scene
