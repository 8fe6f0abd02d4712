#include <algorithm>
#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>

#include "description/unmeasured_joint.hpp"
#include "drawn/drawn_joints.hpp"
#include "drawn/implied_pins.hpp"
#include "drawn/link_places.hpp"

namespace assur::mechanism::drawn {

namespace {

/// A pin that is drawn farther beside its slot than this part of the drawing's size is told: the
/// digits of a drawing close joints to less.
constexpr double told_gap = 1e-6;

bool is_ground(const DrawnParts& parts, DrawnLinkIndex link) {
  return parts.links[link].name == "ground";
}

/// The key of the distance of two points, in whatever order they are named.
auto length_key(DrawnLinkIndex link, DrawnPointIndex one, DrawnPointIndex other) {
  return std::tuple(link, std::min(one, other), std::max(one, other));
}

}  // namespace

}  // namespace assur::mechanism::drawn

namespace assur::mechanism {

std::optional<ParameterIndex> DrawnParts::length(DrawnLinkIndex link, DrawnPointIndex one,
                                                 DrawnPointIndex other) const {
  const auto found = lengths.find(drawn::length_key(link, one, other));
  return found == lengths.end() ? std::nullopt : std::optional(found->second);
}

bool DrawnParts::lists(DrawnLinkIndex link, DrawnPointIndex point) const {
  return std::ranges::find(links[link].points, point) != links[link].points.end();
}

DrawnPointIndex DrawnMechanism::point_named(const std::string& name,
                                            const std::string& part) const {
  const auto found = point_of_name_.find(name);
  if (found == point_of_name_.end()) {
    throw MechanismError(part, "no point named " + text::in_quotes(name) +
                                   text::suggestion_or_choice(name, names_of(parts_.points)));
  }
  return found->second;
}

DrawnLinkIndex DrawnMechanism::link_named(const std::string& name, const std::string& part) const {
  const auto found = link_of_name_.find(name);
  if (found != link_of_name_.end()) {
    return found->second;
  }
  if (index_of(mechanism_.links(), name).exists()) {
    throw MechanismError(part, "the link " + text::in_quotes(name) +
                                   " has a frame of its own; join it with 'between', or list its "
                                   "drawn points");
  }
  throw MechanismError(part, "no link named " + text::in_quotes(name) +
                                 text::suggestion_or_choice(name, names_of(mechanism_.links())));
}

drawn::DrawnEnd DrawnMechanism::end_named(const std::string& name) const {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    return {};
  }
  const auto link = link_of_name_.find(name.substr(0, dot));
  const auto point = point_of_name_.find(name.substr(dot + 1));
  return {link == link_of_name_.end() ? DrawnLinkIndex() : link->second,
          link == link_of_name_.end() || point == point_of_name_.end() ? DrawnPointIndex()
                                                                       : point->second};
}

void DrawnMechanism::add_point(const std::string& name, const Given& x, const Given& y) {
  const std::string part = "points." + name;
  if (name.find('.') != std::string::npos) {
    throw MechanismError("points", text::in_quotes(name) +
                                       " has a dot, which stands between the names of a link and "
                                       "its feature; write another letter");
  }
  if (name.empty() || text::first_control_character(name) < name.size()) {
    throw MechanismError("points",
                         "a name is empty or has a control character; choose another one");
  }
  if (point_of_name_.contains(name)) {
    throw MechanismError("points",
                         "the name " + text::in_quotes(name) + " is taken; choose another one");
  }
  Formula at_x = mechanism_.formula_of(x, part + "[0]");
  Formula at_y = mechanism_.formula_of(y, part + "[1]");
  point_of_name_[name] = parts_.points.add({name, std::move(at_x), std::move(at_y)});
}

void DrawnMechanism::add_link(const std::string& name, const std::vector<std::string>& points) {
  const std::string part = "links." + name;
  DrawnLink link{name, {}};
  if (points.empty() && name != "ground") {
    throw MechanismError(part, "expected one or more drawn points");
  }
  for (std::size_t place = 0; place < points.size(); ++place) {
    const std::string point_part = part + "[" + std::to_string(place) + "]";
    const DrawnPointIndex point = point_named(points[place], point_part);
    if (std::ranges::find(link.points, point) != link.points.end()) {
      throw MechanismError(point_part,
                           "the point " + text::in_quotes(points[place]) + " is listed twice");
    }
    link.points.push_back(point);
  }
  mechanism_.add_drawn_link(name);
  link_of_name_[name] = parts_.links.add(std::move(link));
}

void DrawnMechanism::add_joint(DrawnJoint joint) {
  if (!joint.between.empty() &&
      (!joint.links.empty() || !joint.at.empty() || !joint.along.empty() || joint.direction)) {
    throw MechanismError("joints." + joint.name,
                         "'between' names features that say all; leave it out, or 'links', 'at', "
                         "'along' and 'direction'");
  }
  joints_.push_back(std::move(joint));
}

void DrawnMechanism::set_length(const std::string& parameter,
                                const std::vector<std::array<std::string, 2>>& of) {
  const std::string part = "parameters." + parameter + ".drawn";
  Length length{parameter, {}};
  for (const auto& [one, other] : of) {
    if (one == other) {
      throw MechanismError(part, "expected two points of one link, or the name of a joint");
    }
    length.of.push_back({point_named(one, part), point_named(other, part)});
  }
  if (of.empty()) {
    throw MechanismError(part, "expected two points of one link, or the name of a joint");
  }
  (void)mechanism_.parameter_named(parameter, part);
  lengths_.push_back(std::move(length));
}

void DrawnMechanism::set_coordinate(const std::string& parameter, const std::string& joint) {
  (void)mechanism_.parameter_named(parameter, "parameters." + parameter + ".drawn");
  coordinates_of_parameters_.push_back({parameter, joint});
}

void DrawnMechanism::add_left_out_ground() {
  const bool all_drawn = std::ranges::all_of(mechanism_.links(), &Link::is_drawn);
  if (is_drawn() && all_drawn && !mechanism_.ground().exists()) {
    add_link("ground", {});
  }
}

/// Notes which distance is which parameter, and gives each parameter without a value the drawn one.
void DrawnMechanism::set_lengths() {
  for (const auto& [parameter, pairs] : lengths_) {
    const std::string whole = "parameters." + parameter;
    const std::string part = whole + ".drawn";
    const ParameterIndex index = mechanism_.parameter_named(parameter, part);
    for (const auto& [one, other] : pairs) {
      const auto [first_name, second_name] =
          std::pair(parts_.points[one].name, parts_.points[other].name);
      bool is_listed = false;
      for (const DrawnLinkIndex link : parts_.links.keys()) {
        if (!parts_.lists(link, one) || !parts_.lists(link, other)) {
          continue;
        }
        is_listed = true;
        const std::vector<DrawnPointIndex>& points = parts_.links[link].points;
        if (std::ranges::none_of(std::array{points[0], points[1]}, [&](DrawnPointIndex point) {
              return point == one || point == other;
            })) {
          throw MechanismError(part, "neither " + first_name + " nor " + second_name +
                                         " is the first or second point of the link " +
                                         parts_.links[link].name + "; list one of them there");
        }
        const auto [entry, is_new] =
            parts_.lengths.emplace(drawn::length_key(link, one, other), index);
        if (!is_new) {
          throw MechanismError(part, "the distance of " + first_name + " and " + second_name +
                                         " is the parameter " +
                                         mechanism_.parameters()[entry->second].name + " already");
        }
      }
      if (!is_listed) {
        throw MechanismError(part, "no link lists both " + first_name + " and " + second_name);
      }
    }
    if (!mechanism_.parameters()[index].value.exists()) {
      if (pairs.size() > 1) {
        throw MechanismError(whole, "several distances share the parameter; give its 'value'");
      }
      const auto place = [&](DrawnPointIndex point) { return drawn::place_of(parts_, point); };
      mechanism_.set_parameter(parameter, length(place(pairs[0][1]) - place(pairs[0][0])));
    }
  }
}

void DrawnMechanism::set_coordinates() {
  for (const auto& [parameter, joint] : coordinates_of_parameters_) {
    const std::string part = "parameters." + parameter + ".drawn";
    const Formula drawn = coordinate_of(joint, part);
    if (!mechanism_.parameters()[mechanism_.parameter_named(parameter, part)].value.exists()) {
      mechanism_.set_parameter(parameter, drawn);
    }
  }
}

Formula DrawnMechanism::coordinate_of(const std::string& joint, const std::string& part) const {
  const auto found = coordinates_.find(joint);
  if (found == coordinates_.end()) {
    std::vector<std::string> names;
    for (const auto& [name, coordinate] : coordinates_) {
      names.push_back(name);
    }
    throw MechanismError(part, "no joint named " + text::in_quotes(joint) +
                                   text::suggestion_or_choice(joint, names));
  }
  if (const auto links = unmeasured_.find(joint); links != unmeasured_.end()) {
    throw description::refusal_of_measure(part, joint, links->second[0], links->second[1]);
  }
  if (!found->second) {
    throw MechanismError(part, "the joint " + text::in_quotes(joint) +
                                   " has no coordinate in the drawing; give a value");
  }
  return *found->second;
}

std::vector<drawn::ResolvedJoint> DrawnMechanism::resolved_joints() const {
  const drawn::DrawnNames names = {
      [this](const std::string& name, const std::string& part) { return link_named(name, part); },
      [this](const std::string& name) { return end_named(name); },
      [this](const std::string& name, const std::string& part) { return point_named(name, part); },
      [this](const std::string& name) { return point_of_name_.contains(name); }};
  std::vector<drawn::ResolvedJoint> result;
  result.reserve(joints_.size());
  for (const DrawnJoint& joint : joints_) {
    result.push_back(drawn::resolved(joint, parts_, mechanism_, names));
  }
  return result;
}

void DrawnMechanism::place() {
  add_left_out_ground();
  set_lengths();
  // Coordinates are formulas of the points, and parameters may be these coordinates: no number
  // decides before all parameters have their values.
  const std::vector<drawn::ResolvedJoint> joints = resolved_joints();
  for (const drawn::ResolvedJoint& joint : joints) {
    coordinates_[joint.joint->name] = joint.coordinate;
  }
  const std::vector<drawn::ImpliedPin> pins = drawn::implied_pins(parts_, joints_);
  const auto link_name = [this](DrawnLinkIndex link) { return parts_.links[link].name; };
  for (const drawn::ImpliedPin& pin : pins) {
    const std::string& name = parts_.points[pin.point].name;
    const bool has_coordinate = pin.links.size() == 2;
    coordinates_[name] =
        has_coordinate ? std::optional(drawn::angle_between(parts_, pin.links[0], pin.links[1]))
                       : std::nullopt;
    if (has_coordinate && !drawn::is_ground(parts_, pin.links[0])) {
      unmeasured_[name] = {link_name(pin.links[0]), link_name(pin.links[1])};
    }
  }
  set_coordinates();

  if (is_drawn()) {
    places_ = std::make_shared<const drawn::LinkPlaces>(parts_, mechanism_);
  }
  for (const DrawnLink& link : parts_.links) {
    for (const DrawnPointIndex point : link.points) {
      make_feature(link.name + "." + parts_.points[point].name, "links." + link.name);
    }
  }
  for (const drawn::ResolvedJoint& joint : joints) {
    const DrawnJoint& own = *joint.joint;
    for (std::size_t place = 0; place < own.between.size(); ++place) {
      make_feature(own.between[place],
                   "joints." + own.name + ".between[" + std::to_string(place) + "]");
    }
    if (own.type != JointType::prismatic && joint.at.exists()) {
      const std::size_t pinned = own.type == JointType::revolute ? own.links.size() : 1;
      for (std::size_t place = 0; place < pinned; ++place) {
        make_feature(own.links[place] + "." + parts_.points[joint.at].name,
                     "joints." + own.name + ".at");
      }
    }
    if (joint.line) {
      const double gap = drawn::gap_of(joint, parts_, *places_);
      if (gap > drawn::told_gap * places_->size() && (!gap_ || gap > gap_->length)) {
        gap_ = DrawnGap{own.name, gap};
      }
    }
    drawn::add_resolved(joint, parts_, places_.get(), mechanism_);
  }
  for (const drawn::ImpliedPin& pin : pins) {
    const std::string& name = parts_.points[pin.point].name;
    std::vector<std::string> between;
    for (const DrawnLinkIndex link : pin.links) {
      between.push_back(link_name(link) + "." + name);
    }
    if (unmeasured_.contains(name)) {
      mechanism_.add_unmeasured_joint(name, between);
    } else {
      mechanism_.add_joint(name, JointType::revolute, between);
    }
  }
}

void DrawnMechanism::make_feature(const std::string& name, const std::string& part) {
  const drawn::DrawnEnd end = end_named(name);
  if (!end.link.exists()) {
    return;
  }
  const std::string feature_name = name.substr(name.find('.') + 1);
  const LinkIndex link = index_of(mechanism_.links(), parts_.links[end.link].name);
  const bool is_known = std::ranges::any_of(
      mechanism_.links()[link].features,
      [&](FeatureIndex feature) { return mechanism_.features()[feature].name == feature_name; });
  if (!is_known) {
    const drawn::Vector place = places_->place(end.link, point_named(feature_name, part));
    mechanism_.add_point(name, place.x, place.y);
  }
}

DriverIndex DrawnMechanism::add_driver(const std::string& joint,
                                       const std::optional<Given>& position,
                                       const std::optional<Given>& velocity,
                                       const std::optional<Given>& acceleration) {
  const std::string part = "drivers." + joint;
  if (const auto links = unmeasured_.find(joint); links != unmeasured_.end()) {
    throw description::refusal_of_measure(part, joint, links->second[0], links->second[1]);
  }
  return mechanism_.add_driver(
      joint, position ? *position : Given(coordinate_of(joint, part + ".position")), velocity,
      acceleration);
}

OutputIndex DrawnMechanism::add_output(const std::string& name, const std::string& point) {
  const std::string part = "outputs." + name;
  if (point.find('.') != std::string::npos || !is_drawn()) {
    make_feature(point, part);
    return mechanism_.add_output(name, point);
  }
  const DrawnPointIndex index = point_named(point, part);
  std::optional<std::string> owner;
  for (const DrawnLinkIndex link : parts_.links.keys()) {
    const std::string& own = parts_.links[link].name;
    const bool is_better = !owner || *owner == "ground" || (own != "ground" && own < *owner);
    if (parts_.lists(link, index) && is_better) {
      owner = own;
    }
  }
  if (!owner) {
    throw MechanismError(part, "no link lists the point " + text::in_quotes(point));
  }
  return mechanism_.add_output(name, *owner + "." + point);
}

void DrawnMechanism::refer(Request& request) const {
  for (const DrawnLinkIndex link : parts_.links.keys()) {
    if (!drawn::is_ground(parts_, link)) {
      const std::string& name = parts_.links[link].name;
      request.reference.push_back(
          {index_of(mechanism_.links(), name),
           mechanism_.add_number(drawn::angle_of(parts_, link), "reference." + name)});
      request.drawn = DrawnPose{gap_};
    }
  }
}

}  // namespace assur::mechanism
