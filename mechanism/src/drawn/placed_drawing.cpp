// Placement of a drawing's points, links and joints in a mechanism.
#include <algorithm>
#include <assur/mechanism/drawn_mechanism.hpp>

#include "drawn/drawn_joints.hpp"
#include "drawn/implied_pins.hpp"
#include "drawn/link_places.hpp"

namespace assur::mechanism::drawn {

namespace {

/// A pin drawn farther beside its slot than this part of the drawing's size is reported: rounded
/// coordinates of a drawing leave smaller gaps.
constexpr double told_gap = 1e-6;

}  // namespace

}  // namespace assur::mechanism::drawn

namespace assur::mechanism {

void DrawnMechanism::add_left_out_ground() {
  const bool all_drawn = std::ranges::all_of(mechanism_.links(), &Link::is_drawn);
  if (is_drawn() && all_drawn && !mechanism_.ground().exists()) {
    add_link("ground", {});
  }
}

/// Records which distances are parameters, and gives each parameter without a value the drawn one.
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
        const std::array defining{points[0], points[1]};
        if (std::ranges::count(defining, one) + std::ranges::count(defining, other) == 0) {
          throw MechanismError(part, "neither " + first_name + " nor " + second_name +
                                         " is the first or second point of the link " +
                                         parts_.links[link].name + "; list one of them there");
        }
        const auto [entry, is_new] =
            parts_.lengths.try_emplace({link, std::min(one, other), std::max(one, other)}, index);
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

void DrawnMechanism::find_coordinates(const std::vector<drawn::ResolvedJoint>& joints,
                                      const std::vector<drawn::ImpliedPin>& pins) {
  for (const drawn::ResolvedJoint& joint : joints) {
    coordinates_[joint.joint->name] = joint.coordinate;
  }
  for (const drawn::ImpliedPin& pin : pins) {
    std::optional<Formula>& coordinate = coordinates_[parts_.points[pin.point].name];
    if (pin.links.size() != 2) {
      continue;
    }
    coordinate = drawn::angle_between(parts_, pin.links[0], pin.links[1]);
    const auto [first, second] =
        std::pair(parts_.links[pin.links[0]].name, parts_.links[pin.links[1]].name);
    if (first != "ground") {
      unmeasured_[parts_.points[pin.point].name] = {first, second};
    }
  }
}

void DrawnMechanism::add_features(const std::vector<drawn::ResolvedJoint>& joints) {
  for (const DrawnLink& link : parts_.links) {
    for (const DrawnPointIndex point : link.points) {
      make_feature(link.name + "." + parts_.points[point].name, "links." + link.name);
    }
  }
  for (const drawn::ResolvedJoint& joint : joints) {
    const DrawnJoint& own = *joint.joint;
    const std::string part = "joints." + own.name;
    for (std::size_t place = 0; place < own.between.size(); ++place) {
      make_feature(own.between[place], part + ".between[" + std::to_string(place) + "]");
    }
    if (own.type == JointType::prismatic || !joint.at.exists()) {
      continue;
    }
    const std::size_t pinned = own.type == JointType::revolute ? own.links.size() : 1;
    for (std::size_t place = 0; place < pinned; ++place) {
      make_feature(own.links[place] + "." + parts_.points[joint.at].name, part + ".at");
    }
  }
}

void DrawnMechanism::add_joints(const std::vector<drawn::ResolvedJoint>& joints,
                                const std::vector<drawn::ImpliedPin>& pins) {
  for (const drawn::ResolvedJoint& joint : joints) {
    if (joint.line) {
      const double gap = drawn::gap_of(joint, parts_, *places_);
      if (gap > drawn::told_gap * places_->size() && (!gap_ || gap > gap_->length)) {
        gap_ = DrawnGap{joint.joint->name, gap};
      }
    }
    drawn::add_resolved(joint, parts_, places_.get(), mechanism_);
  }
  for (const drawn::ImpliedPin& pin : pins) {
    const std::string& name = parts_.points[pin.point].name;
    std::vector<std::string> between;
    for (const DrawnLinkIndex link : pin.links) {
      between.push_back(parts_.links[link].name + "." + name);
    }
    if (unmeasured_.contains(name)) {
      mechanism_.add_unmeasured_joint(name, between);
    } else {
      mechanism_.add_joint(name, JointType::revolute, between);
    }
  }
}

void DrawnMechanism::place() {
  add_left_out_ground();
  set_lengths();
  const std::vector<drawn::ResolvedJoint> joints = resolved_joints();
  const std::vector<drawn::ImpliedPin> pins = drawn::implied_pins(parts_, joints_);
  // Coordinates are formulas of the points, and parameters may be these coordinates: numbers decide
  // only after all parameters have their values.
  find_coordinates(joints, pins);
  set_coordinates();
  if (is_drawn()) {
    places_ = std::make_shared<const drawn::LinkPlaces>(parts_, mechanism_);
  }
  add_features(joints);
  add_joints(joints, pins);
}

}  // namespace assur::mechanism
