// Names and checks of a drawing's points, links, joints, drivers and outputs.
#include <algorithm>
#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>

#include "description/refusals.hpp"
#include "drawn/drawn_joints.hpp"
#include "drawn/link_places.hpp"

namespace assur::mechanism::drawn {

namespace {

bool is_ground(const DrawnParts& parts, DrawnLinkIndex link) {
  return parts.links[link].name == "ground";
}

/// The error where `part` reads the coordinate of an implied pin. If no fixed pivot is listed, one
/// of the links may have been intended as the ground.
MechanismError refusal_of_pin(const DrawnParts& parts, const std::string& part,
                              const std::string& joint, const std::array<std::string, 2>& links) {
  const bool is_bare = std::ranges::any_of(parts.links, [](const DrawnLink& link) {
    return link.name == "ground" && link.points.empty();
  });
  return description::refusal_of_measure(
      part, joint, links[0], links[1],
      is_bare ? "; or call the link that stands still 'ground'" : "");
}

}  // namespace

}  // namespace assur::mechanism::drawn

namespace assur::mechanism {

std::optional<ParameterIndex> DrawnParts::length(DrawnLinkIndex link, DrawnPointIndex one,
                                                 DrawnPointIndex other) const {
  const auto found = lengths.find({link, std::min(one, other), std::max(one, other)});
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
  throw description::refusal_of_name(part, "link", name, names_of(mechanism_.links()));
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

Formula DrawnMechanism::coordinate_of(const std::string& joint, const std::string& part) const {
  const auto found = coordinates_.find(joint);
  if (found == coordinates_.end()) {
    std::vector<std::string> names;
    for (const auto& [name, coordinate] : coordinates_) {
      names.push_back(name);
    }
    throw description::refusal_of_name(part, "joint", joint, names);
  }
  if (const auto links = unmeasured_.find(joint); links != unmeasured_.end()) {
    throw drawn::refusal_of_pin(parts_, part, joint, links->second);
  }
  if (!found->second) {
    throw MechanismError(part, "the joint " + text::in_quotes(joint) +
                                   " has no coordinate in the drawing; give a value");
  }
  return *found->second;
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
    throw drawn::refusal_of_pin(parts_, part, joint, links->second);
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
