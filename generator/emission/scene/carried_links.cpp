#include "emission/scene/carried_links.hpp"

#include "emission/scene/followed_angles.hpp"

namespace assur::generator::emission::scene {

namespace {

/// Rates as a row; empty if none are wanted.
OptionalExpression row_of(std::vector<cpp::Expression> rates) {
  return rates.empty() ? std::nullopt
                       : OptionalExpression(cpp::call(cpp::alias("Rates"), std::move(rates)));
}

/// The position and rates of a driver in statements.
struct DriverValue {
  cpp::Expression position;
  OptionalExpression rates;  ///< empty if none are wanted
  SceneNumber law;           ///< the position as a function of the parameters
};

/// An argument of the solver, or the formula of a law that reads joints.
DriverValue driver_value(const SolverScene& solver, mechanism::DriverIndex index,
                         const FunctionBody& body) {
  if (solver.is_argument(index)) {
    const cpp::Expression state = cpp::variable("drivers").member(solver.members.drivers[index]);
    std::vector<cpp::Expression> rates = {state.member("velocity"), state.member("acceleration")};
    rates.resize(static_cast<std::size_t>(solver.derivative_order));
    return {state.member("position"), row_of(std::move(rates)), solver.numbers.law(index)};
  }
  const SceneNumber& position = solver.numbers.position(index);
  return {body.number(position), row_of(solver.numbers.rates(position, solver.derivative_order)),
          position};
}

std::string coordinate_of(const SolverScene& solver, mechanism::JointIndex joint) {
  return "joint_" + solver.members.joints[joint];
}

}  // namespace

std::string feature_name(const SolverScene& solver, const std::string& feature,
                         mechanism::LinkIndex link) {
  return feature + "_on_" + solver.link_name(link);
}

Pose<SceneNumber> feature_frame(const SolverScene& solver, const mechanism::ElementaryJoint& at,
                                mechanism::LinkIndex link) {
  const LinkFeature<SceneNumber> feature = solver.numbers.feature(at, link);
  return {feature.x, feature.y, feature.along};
}

cpp::Expression pose_of(const SolverScene& solver, mechanism::FeatureIndex index,
                        const FunctionBody& body) {
  const mechanism::Feature& feature = solver.mechanism().features()[index];
  const LinkFeature<SceneNumber> place = solver.numbers.feature(index, feature.is_line);
  const cpp::Expression own = cpp::braces(
      "Pose<Scalar>", {body.number(place.x), body.number(place.y), body.direction(place.along)});
  const OptionalExpression link = solver.placed(feature.link);
  return link ? cpp::call("support::pose_in", {link->member("pose"), own}) : own;
}

cpp::Expression with_sense(double sense, const cpp::Expression& expression) {
  return sense < 0 ? cpp::negative(expression) : expression;
}

cpp::Expression placed_slide(const std::string& member) {
  return cpp::variable("placed").member("slide_" + member);
}

cpp::Expression displacement(const SolverScene& solver, mechanism::JointIndex slide,
                             FunctionBody& body) {
  return displacement(solver, solver.mechanism().joints()[slide].between, body);
}

cpp::Expression displacement(const SolverScene& solver,
                             const std::vector<mechanism::FeatureIndex>& between,
                             FunctionBody& body) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const auto frame_of = [&](mechanism::FeatureIndex index) {
    const mechanism::Feature& described = mechanism.features()[index];
    const LinkFeature<SceneNumber> feature = solver.numbers.feature(index, described.is_line);
    const OptionalExpression own = body.frame(feature_name(solver, described.name, described.link),
                                              {feature.x, feature.y, feature.along});
    return nested_frames({solver.placed(described.link), own});
  };
  const std::size_t line = mechanism.features()[between[0]].is_line ? 0 : 1;
  const cpp::Expression from = frame_of(between[line]);
  return cpp::call("support::displacement_along", {from, frame_of(between[1 - line])});
}

namespace {

/// A slide's displacement with its rates, if they are wanted.
cpp::Expression slide_of(const cpp::Expression& displacement, const OptionalExpression& rates) {
  return rates ? cpp::braces("", {displacement, *rates}) : cpp::braces("", {displacement});
}

}  // namespace

void add_measured_slide(const SolverScene& solver, mechanism::JointIndex slide,
                        FunctionBody& body) {
  const std::string& member = solver.members.joints[slide];
  const cpp::Expression along = body.local("along_" + member);
  body.add(cpp::declared("const auto", along, displacement(solver, slide, body)));
  body.add(cpp::assigned(
      placed_slide(member),
      slide_of(along.member("position"), solver.derivative_order > 0
                                             ? OptionalExpression(along.member("rates"))
                                             : std::nullopt)));
}

namespace {

/// Declares the coordinate of a joint, unless a driver prescribes it or it is declared already.
/// With `follows` an angle is that of the branch.
void add_joint_read(const SolverScene& solver, mechanism::JointIndex joint, bool follows,
                    FunctionBody& body) {
  const mechanism::Mechanism& mechanism = solver.mechanism();
  const mechanism::Joint& at = mechanism.joints()[joint];
  const std::string name = coordinate_of(solver, joint);
  if (mechanism.driver_of(joint).exists() || body.declares(name)) {
    return;
  }
  const auto frame_of = [&](std::size_t end) {
    return nested_frames({solver.placed(mechanism.features()[at.between[end]].link)});
  };
  cpp::Expression value =
      at.type == mechanism::JointType::revolute
          ? cpp::call(cpp::scalar_only("support::angle_between"), {frame_of(0), frame_of(1)})
          : displacement(solver, joint, body);
  const OptionalExpression last = follows ? last_followed(solver, {at.between, {}}) : std::nullopt;
  if (last) {
    value = cpp::call(cpp::scalar_only("support::continued"), {value, *last});
  }
  body.add(cpp::declared({"const LinkCoordinate", "LinkCoordinate"}, cpp::variable(name), value));
}

}  // namespace

void add_joints_read(const SolverScene& solver, mechanism::DriverIndex driver, FunctionBody& body,
                     const std::function<bool(const std::string&)>& is_read) {
  for (const mechanism::JointIndex joint : mechanism::joints_in_laws(solver.mechanism(), driver)) {
    if (is_read(coordinate_of(solver, joint))) {
      add_joint_read(solver, joint, false, body);
    }
  }
}

void add_joints_read(const SolverScene& solver, FunctionBody& body,
                     const std::function<bool(const std::string&)>& is_read) {
  for (const mechanism::JointIndex joint : solver.mechanism().joints().keys()) {
    if (is_read(coordinate_of(solver, joint))) {
      add_joint_read(solver, joint, true, body);
    }
  }
}

cpp::Block behind_joints_read(const SolverScene& solver, FunctionBody& body) {
  const cpp::Block all = body.take_from(0);
  const std::set<std::string> read = body.variables_read(all);
  add_joints_read(solver, body, [&](const std::string& name) { return read.contains(name); });
  body.add(all);
  return body.block();
}

cpp::Expression driver_position(const SolverScene& solver, mechanism::DriverIndex driver,
                                const FunctionBody& body) {
  return driver_value(solver, driver, body).position;
}

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
      body.frame(feature_name(solver, at.name, link.from), feature_frame(solver, at, link.from));
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

}  // namespace assur::generator::emission::scene
