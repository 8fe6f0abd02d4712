#include "emission/scene/link_loads.hpp"

#include "emission/scene/carried_links.hpp"
#include "emission/scene/followed_angles.hpp"

namespace assur::generator::emission::scene {

namespace {

using mechanism::FeatureIndex;
using mechanism::LinkIndex;
using mechanism::NumberIndex;

/// Its force is NaN where the ends coincide; there all links are solved together.
const cpp::Name directed_pull = cpp::scalar_only("support::directed_pull");

cpp::Expression vector(cpp::Expression x, cpp::Expression y) {
  return cpp::braces("Vector<Scalar, 2>", {std::move(x), std::move(y)});
}

}  // namespace

LinkLoads::LinkLoads(const SolverScene& solver, FunctionBody& body)
    : solver_(solver), body_(body), bears_(solver.linkage().links.size(), false) {
  for (const LinkIndex link : solver.linkage().links.keys()) {
    on_.add(body.local("on_" + solver.link_name(link)));
    const OptionalExpression placed = solver.placed(link);
    body.add(cpp::declared(
        cpp::alias("LinkLoad"), on_[link],
        placed ? OptionalExpression(cpp::call("support::unloaded", {*placed})) : std::nullopt));
  }
}

void LinkLoads::add_all() {
  add_masses();
  add_loads_and_springs();
}

std::vector<DirectedPull> LinkLoads::add_all_known() {
  leaves_out_unknown_ = true;
  add_all();
  return pulls_;
}

void LinkLoads::add_applied() {
  add_weights();
  add_loads_and_springs();
}

void LinkLoads::add_loads_and_springs() {
  for (const mechanism::Load& load : solver_.mechanism().loading().loads) {
    add_load(load);
  }
  for (const mechanism::Spring& spring : solver_.mechanism().loading().springs) {
    if (!counts(spring.stiffness) && !counts(spring.damping)) {
      continue;
    }
    spring.at_joint ? add_joint_spring(spring) : add_spring(spring);
  }
}

cpp::Expression LinkLoads::together(const std::vector<LinkIndex>& links) const {
  std::vector<cpp::Expression> loads;
  for (const LinkIndex link : links) {
    loads.push_back(on_[link]);
  }
  return loads.size() == 1 ? loads.front() : cpp::call("support::together", std::move(loads));
}

cpp::Expression LinkLoads::place(FeatureIndex feature) {
  const auto known = places_.find(feature);
  if (known != places_.end()) {
    return known->second;
  }
  const mechanism::Feature& described = solver_.mechanism().features()[feature];
  const LinkFeature<SceneNumber> own = solver_.numbers.feature(feature, false);
  const cpp::Expression made =
      place(feature_name(solver_, described.name, described.link), described.link, own.x, own.y);
  places_.emplace(feature, made);
  return made;
}

cpp::Expression LinkLoads::place(const std::string& name, LinkIndex link, const SceneNumber& x,
                                 const SceneNumber& y) {
  const cpp::Expression value = body_.point("own_" + name, solver_.placed(link), x, y);
  cpp::Expression made = body_.local("at_" + name);
  body_.add(cpp::declared({"const LinkPoint", "LinkPoint"}, made, value));
  return made;
}

cpp::Expression LinkLoads::place(const std::string& name, const mechanism::PlaceOnLink& on) {
  return place(name, on.link, number(on.x), number(on.y));
}

cpp::Expression LinkLoads::centre(const mechanism::Mass& mass) {
  const LinkIndex link = mass.at.link;
  if (!centres_.contains(link)) {
    centres_.emplace(link, place("centre_of_" + solver_.link_name(link), mass.at));
  }
  return centres_.at(link);
}

cpp::Expression LinkLoads::direction(FeatureIndex line) const {
  const OptionalExpression link = solver_.placed(link_of(line));
  const Direction<SceneNumber> along = solver_.numbers.feature(line, true).along;
  const cpp::Expression own =
      cpp::braces("Direction<Scalar>", {body_.number(along.cos), body_.number(along.sin)});
  return link ? cpp::call("turned", {link->member("pose").member("direction"), own}) : own;
}

void LinkLoads::push(const std::vector<FeatureIndex>& between, const cpp::Expression& effort) {
  const auto is_line = [&](std::size_t end) {
    return solver_.mechanism().features()[between[end]].is_line;
  };
  if (!is_line(0) && !is_line(1)) {
    add(link_of(between[1]), "add_couple", {effort});
    add(link_of(between[0]), "add_couple", {cpp::negative(effort)});
    return;
  }
  const std::size_t line = is_line(0) ? 0 : 1;
  const FeatureIndex other = between[1 - line];
  const cpp::Expression at = place(other);
  const cpp::Expression force = body_.local("push");
  body_.add(
      cpp::declared("const Vector<Scalar, 2>", force,
                    cpp::call("support::force_along<Scalar>", {direction(between[line]), effort})));
  add(link_of(other), "add_force", {at, force});
  add(link_of(between[line]), "add_force", {at, opposite(force)});
}

SceneNumber LinkLoads::number(NumberIndex number) const {
  return number.exists() ? solver_.numbers.loading(number) : SceneNumber();
}

bool LinkLoads::counts(NumberIndex number) const {
  if (!number.exists()) {
    return false;
  }
  const SceneNumber value = solver_.numbers.loading(number);
  return solver_.numbers.varies(value) || value.value() != 0;
}

void LinkLoads::add(LinkIndex link, const std::string& function,
                    std::vector<cpp::Expression> arguments) {
  bears_[link] = true;
  body_.add(cpp::called(on_[link].member(function).at(std::move(arguments))));
}

cpp::Expression LinkLoads::gravity() {
  const mechanism::Loading& loading = solver_.mechanism().loading();
  const cpp::Expression gravity = body_.local("gravity");
  body_.add(cpp::declared("const Vector<Scalar, 2>", gravity,
                          vector(value(loading.gravity[0]), value(loading.gravity[1]))));
  return gravity;
}

void LinkLoads::add_weight(const mechanism::Mass& mass, const cpp::Expression& gravity) {
  const cpp::Expression size = value(mass.mass);
  const auto weight = [&](std::size_t axis) {
    return cpp::product({size, gravity.at({cpp::word(axis)})});
  };
  add(mass.at.link, "add_force", {centre(mass), vector(weight(0), weight(1))});
}

void LinkLoads::add_weights() {
  const mechanism::Loading& loading = solver_.mechanism().loading();
  if (loading.masses.empty() || (!counts(loading.gravity[0]) && !counts(loading.gravity[1]))) {
    return;
  }
  const cpp::Expression pull = gravity();
  for (const mechanism::Mass& mass : loading.masses) {
    if (counts(mass.mass)) {
      add_weight(mass, pull);
    }
  }
}

void LinkLoads::add_masses() {
  const mechanism::Loading& loading = solver_.mechanism().loading();
  if (loading.masses.empty()) {
    return;
  }
  const cpp::Expression pull = gravity();
  for (const mechanism::Mass& mass : loading.masses) {
    const LinkIndex link = mass.at.link;
    if (counts(mass.mass) && solver_.is_ground(link)) {
      add_weight(mass, pull);
    } else if (counts(mass.mass)) {
      add(link, "add_mass", {centre(mass), value(mass.mass), pull});
    }
    if (const OptionalExpression placed = solver_.placed(link); placed && counts(mass.inertia)) {
      add(link, "add_couple",
          {cpp::negative(cpp::product(
              {value(mass.inertia), placed->member("rates").at({cpp::word(std::size_t{2}),
                                                                cpp::word(std::size_t{1})})}))});
    }
  }
}

void LinkLoads::add_load(const mechanism::Load& load) {
  if (load.moment.exists()) {
    add(load.at.link, "add_couple", {value(load.moment)});
    return;
  }
  cpp::Expression force = vector(value(load.force_x), value(load.force_y));
  if (load.frame.exists()) {
    if (const OptionalExpression frame = solver_.placed(load.frame)) {
      force = cpp::call("support::rotated<Scalar>",
                        {frame->member("pose").member("direction"), std::move(force)});
    }
  }
  add(load.at.link, "add_force", {place(load.name, load.at), std::move(force)});
}

void LinkLoads::add_spring(const mechanism::Spring& spring) {
  std::vector<cpp::Expression> given = {place(spring.between[0]), place(spring.between[1]),
                                        value(spring.stiffness)};
  // A spring of zero free length without a damper needs no direction.
  const bool is_directed =
      (counts(spring.stiffness) && counts(spring.rest)) || counts(spring.damping);
  if (is_directed) {
    given.push_back(value(spring.rest));
    given.push_back(value(spring.damping));
  }
  const cpp::Expression pull = body_.local("pull_of_" + spring.name);
  const std::vector<cpp::Expression> ends = {given[0], given[1]};
  body_.add(cpp::declared("const Vector<Scalar, 2>", pull,
                          cpp::call(is_directed ? directed_pull : cpp::Name("support::spring_pull"),
                                    std::move(given))));
  const LinkIndex first = link_of(spring.between[0]);
  const LinkIndex second = link_of(spring.between[1]);
  cpp::Expression known = pull;
  if (is_directed) {
    pulls_.push_back({pull, ends[0], first, second});
    known = leaves_out_unknown_ ? cpp::call("support::known_pull", {pull}) : pull;
  }
  add(first, "add_force", {ends[0], known});
  add(second, "add_force", {ends[1], opposite(known)});
}

void LinkLoads::add_joint_spring(const mechanism::Spring& spring) {
  const mechanism::Mechanism& mechanism = solver_.mechanism();
  const std::vector<FeatureIndex> between(spring.between.begin(), spring.between.end());
  mechanism::JointIndex joint;
  for (const mechanism::JointIndex index : mechanism.joints().keys()) {
    if (mechanism.joints()[index].between == between) {
      joint = index;
    }
  }
  const cpp::Expression coordinate = body_.local("coordinate_of_" + spring.name);
  // The features of a redundant joint exist, though no joint may use them.
  const bool turns = std::ranges::none_of(
      between, [&](FeatureIndex feature) { return mechanism.features()[feature].is_line; });
  const mechanism::DriverIndex driver =
      joint.exists() ? mechanism.driver_of(joint) : mechanism::DriverIndex();
  const auto frame_of = [&](std::size_t end) {
    return nested_frames({solver_.placed(link_of(between[end]))});
  };
  const bool by_law = turns && driver.exists();
  if (!by_law || counts(spring.damping)) {
    const cpp::Expression measured =
        turns ? cpp::call(cpp::scalar_only("support::angle_between"), {frame_of(0), frame_of(1)})
              : displacement(solver_, between, body_);
    body_.add(cpp::declared({"const LinkCoordinate", "LinkCoordinate"}, coordinate, measured));
  }
  const cpp::Expression position =
      by_law ? driver_position(solver_, driver, body_) : coordinate.member("position");
  cpp::Expression deflection = position;
  if (counts(spring.rest)) {
    deflection = cpp::sum({position, cpp::negative(value(spring.rest))});
  }
  if (turns && !by_law) {
    deflection = cpp::call(cpp::scalar_only("support::continued_angle"),
                           {deflection, *last_followed(solver_, {between, spring.rest})});
  }
  std::vector<cpp::Expression> terms;
  if (counts(spring.stiffness)) {
    terms.push_back(cpp::negative(cpp::product({value(spring.stiffness), deflection})));
  }
  if (counts(spring.damping)) {
    terms.push_back(cpp::negative(cpp::product(
        {value(spring.damping), coordinate.member("rates").at({cpp::word(std::size_t{0})})})));
  }
  const cpp::Expression effort = body_.local("effort_of_" + spring.name);
  body_.add(cpp::declared("const Scalar", effort, cpp::sum(std::move(terms))));
  push(between, effort);
}

bool has_directed_springs(const cpp::Block& statements) {
  return cpp::any_part(
      statements, [](const cpp::Expression& part) { return part.name.text == directed_pull.text; });
}

void add_ground_resultant(const cpp::Expression& on_all_links, FunctionBody& body) {
  const cpp::Expression all = body.local("on_all");
  body.add(cpp::declared({"const LinkLoad", "LinkLoad"}, all, on_all_links));
  const cpp::Expression force = cpp::braces("", {all.member("x"), all.member("y")});
  body.add(cpp::assigned(cpp::variable("state").member("ground"),
                         cpp::braces("", {force, all.member("moment")})));
}

}  // namespace assur::generator::emission::scene
