#include "drawn/drawn_joints.hpp"

#include <algorithm>
#include <assur/text/quoted.hpp>

namespace assur::mechanism::drawn {

namespace {

constexpr const char* no_line =
    R"(a line is missing: "along": ["A", "D"], or "direction": [dx, dy] with "at")";

/// The line that a joint between `links` names.
DrawnLine named_line(const DrawnJoint& joint, DrawnPointIndex at, const DrawnParts& parts,
                     const Mechanism& mechanism, const DrawnNames& names) {
  const std::string part = "joints." + joint.name;
  if (!joint.along.empty() && joint.direction) {
    throw MechanismError(part, "'along' and 'direction' both give a line; leave one out");
  }
  if (!joint.along.empty()) {
    if (joint.along.size() != 2) {
      throw MechanismError(part + ".along", R"(expected two drawn points ["A", "D"])");
    }
    const DrawnPointIndex first = names.point(joint.along[0], part + ".along[0]");
    const DrawnPointIndex second = names.point(joint.along[1], part + ".along[1]");
    return {first, second, place_of(parts, first), place_of(parts, second), part};
  }
  if (!joint.direction || !at.exists()) {
    throw MechanismError(part, no_line);
  }
  const auto component = [&](std::size_t place) {
    return mechanism.formula_of((*joint.direction)[place],
                                part + ".direction[" + std::to_string(place) + "]");
  };
  const Vector from = place_of(parts, at);
  return {at, {}, from, from + Vector{component(0), component(1)}, part};
}

/// A name for a line of a joint that no point and no other feature of the link has.
std::string name_of_line(const std::string& joint, LinkIndex link, const DrawnParts& parts,
                         const Mechanism& mechanism) {
  std::string name = joint + "_line";
  const auto is_taken = [&] {
    return index_of(parts.points, name).exists() ||
           std::ranges::any_of(mechanism.links()[link].features, [&](FeatureIndex feature) {
             return mechanism.features()[feature].name == name;
           });
  };
  while (is_taken()) {
    name += '_';
  }
  return name;
}

/// Adds a line to a link, and returns the feature's name, preceded by the link's.
std::string add_line(const std::string& joint, const std::string& link, const PlacedLine& line,
                     const DrawnParts& parts, Mechanism& mechanism) {
  const LinkIndex index = index_of(mechanism.links(), link);
  const std::string name = link + "." + name_of_line(joint, index, parts, mechanism);
  mechanism.add_line(name, line.through.x, line.through.y, line.along.x, line.along.y);
  return name;
}

bool is_cylinder(const ResolvedJoint& joint) {
  return joint.joint->type == JointType::prismatic && joint.ends.size() == 2 &&
         std::ranges::all_of(joint.ends, [](const DrawnEnd& end) { return end.point.exists(); });
}

void resolve_between(ResolvedJoint& result, const DrawnParts& parts, const DrawnNames& names) {
  const DrawnJoint& joint = *result.joint;
  for (const std::string& feature : joint.between) {
    result.ends.push_back(names.end(feature));
  }
  if (result.ends.size() != 2) {
    return;
  }
  const auto& [one, other] = std::pair(result.ends[0], result.ends[1]);
  if (joint.type == JointType::revolute && one.link.exists() && other.link.exists()) {
    result.coordinate = angle_between(parts, one.link, other.link);
  } else if (is_cylinder(result)) {
    result.line = DrawnLine{one.point, other.point, place_of(parts, one.point),
                            place_of(parts, other.point), "joints." + joint.name};
    result.coordinate = length(result.line->to - result.line->from);
  }
}

}  // namespace

ResolvedJoint resolved(const DrawnJoint& joint, const DrawnParts& parts, const Mechanism& mechanism,
                       const DrawnNames& names) {
  ResolvedJoint result{&joint, {}, {}, {}, {}, {}};
  if (!joint.between.empty()) {
    resolve_between(result, parts, names);
    return result;
  }
  const std::string part = "joints." + joint.name;
  if (joint.links.size() < 2) {
    throw MechanismError(part + ".links", R"(expected the links that the joint joins, ["a", "b"])");
  }
  for (std::size_t place = 0; place < joint.links.size(); ++place) {
    const std::string link_part = part + ".links[" + std::to_string(place) + "]";
    result.links.push_back(names.link(joint.links[place], link_part));
    if (std::count(result.links.begin(), result.links.end(), result.links.back()) > 1) {
      throw MechanismError(link_part, "the link " + text::in_quotes(joint.links[place]) +
                                          " occurs twice in one joint");
    }
  }
  const bool needs_point = joint.type != JointType::prismatic;
  if (!joint.at.empty()) {
    result.at = names.point(joint.at, part + ".at");
  } else if (needs_point || names.has_point(joint.name)) {
    result.at = names.point(joint.name, part + ".at");
  }
  if (joint.type == JointType::revolute) {
    if (result.links.size() == 2) {
      result.coordinate = angle_between(parts, result.links[0], result.links[1]);
    }
    return result;
  }
  if (result.links.size() != 2) {
    throw MechanismError(part + ".links", "expected two links");
  }
  result.line = named_line(joint, result.at, parts, mechanism, names);
  if (joint.type == JointType::prismatic) {
    result.coordinate = 0;
  } else {
    const Vector along = result.line->to - result.line->from;
    const Vector unit = {along.x / length(along), along.y / length(along)};
    result.coordinate = turned_back(place_of(parts, result.at) - result.line->from, unit).x;
  }
  return result;
}

double gap_of(const ResolvedJoint& joint, const DrawnParts& parts, const LinkPlaces& places) {
  if (joint.joint->type != JointType::pin_in_slot || !joint.line) {
    return 0;
  }
  const Vector pin = place_of(parts, joint.at);
  return std::abs(places.value(places.from_line(pin, *joint.line).y, joint.line->part));
}

void add_resolved(const ResolvedJoint& joint, const DrawnParts& parts, const LinkPlaces* places,
                  Mechanism& mechanism) {
  const DrawnJoint& own = *joint.joint;
  std::vector<std::string> features = own.between;
  if (is_cylinder(joint)) {
    for (std::size_t place = 0; place < 2; ++place) {
      const DrawnEnd& end = joint.ends[place];
      PlacedLine line = places->line(end.link, *joint.line);
      line.through = places->place(end.link, end.point);
      features[place] = add_line(own.name, parts.links[end.link].name, line, parts, mechanism);
    }
  }
  for (std::size_t place = 0; place < joint.links.size(); ++place) {
    const std::string& link = own.links[place];
    const bool is_pin =
        own.type == JointType::revolute || (own.type == JointType::pin_in_slot && place == 0);
    features.push_back(is_pin
                           ? link + "." + parts.points[joint.at].name
                           : add_line(own.name, link, places->line(joint.links[place], *joint.line),
                                      parts, mechanism));
  }
  mechanism.add_joint(own.name, own.type, features);
  if (own.limits) {
    mechanism.set_limits(own.name, (*own.limits)[0], (*own.limits)[1]);
  }
}

}  // namespace assur::mechanism::drawn
