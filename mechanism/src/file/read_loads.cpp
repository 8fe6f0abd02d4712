// Reads masses, gravity, forces, moments and springs.
#include "load_keys.hpp"
#include "loads_and_requests.hpp"

namespace assur::mechanism::file {

namespace {

/// The number of a key, or zero if the key is missing.
Mechanism::Given number_or_zero(const SceneJson& value, const std::string& key,
                                const std::string& part) {
  return value.contains(key) ? number_of(value[key], part + "." + key) : Mechanism::Given(0);
}

void read_mass(const std::string& link, const SceneJson& value, Mechanism& mechanism,
               DrawnMechanism& drawn) {
  const std::string part = "masses." + link;
  expect_object(value, part);
  expect_keys(value, part, mass_keys);
  Mechanism::GivenPlace at;
  if (value.contains("at") && value["at"].is_array()) {
    at = pair_of(value["at"], part + ".at");
  } else if (value.contains("at") && value["at"].is_string()) {
    const auto point = value["at"].get<std::string>();
    drawn.make_feature(link + "." + point, part + ".at");
    at = point;
  } else if (value.contains("at")) {
    throw MechanismError(part + ".at", "expected the name of a point of the link, or [x, y]");
  }
  mechanism.add_mass(link, number_of(required(value, "mass", part), part + ".mass"), at,
                     number_or_zero(value, "inertia", part));
}

void read_load(const std::string& name, const SceneJson& value, Mechanism& mechanism,
               DrawnMechanism& drawn) {
  const std::string part = "loads." + name;
  expect_object(value, part);
  if (value.contains("on") || value.contains("moment")) {
    expect_keys(value, part, moment_keys);
    const std::string link = text_of(required(value, "on", part), part + ".on");
    mechanism.add_moment(name, link, number_of(required(value, "moment", part), part + ".moment"));
    return;
  }
  expect_keys(value, part, force_keys);
  const std::string at = text_of(required(value, "at", part), part + ".at");
  drawn.make_feature(at, part + ".at");
  const auto force = pair_of(required(value, "force", part), part + ".force");
  mechanism.add_force(name, at, force,
                      value.contains("frame") ? text_of(value["frame"], part + ".frame") : "");
}

void read_spring(const std::string& name, const SceneJson& value, Mechanism& mechanism,
                 DrawnMechanism& drawn) {
  const std::string part = "springs." + name;
  expect_object(value, part);
  const Mechanism::Given stiffness = number_or_zero(value, "stiffness", part);
  const Mechanism::Given damping = number_or_zero(value, "damping", part);
  if (value.contains("joint")) {
    expect_keys(value, part, joint_spring_keys);
    mechanism.add_joint_spring(name, text_of(value["joint"], part + ".joint"), stiffness,
                               number_or_zero(value, "rest", part), damping);
    return;
  }
  expect_keys(value, part, spring_keys);
  const SceneJson& between = required(value, "between", part);
  if (!between.is_array() || between.size() != 2) {
    throw MechanismError(part + ".between", "expected two points [\"link.point\", \"link.point\"]");
  }
  std::array<std::string, 2> ends;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::string end_part = part + ".between[" + std::to_string(end) + "]";
    ends[end] = text_of(between[end], end_part);
    drawn.make_feature(ends[end], end_part);
  }
  mechanism.add_spring(name, ends, stiffness, number_or_zero(value, "length", part), damping);
}

/// Reads each entry of an object of named parts.
template <typename Read>
void read_each(const SceneJson& root, const std::string& key, const Read& read) {
  if (root.contains(key)) {
    expect_object(root[key], key);
    for (const auto& [name, value] : root[key].items()) {
      read(name, value);
    }
  }
}

}  // namespace

void read_loads(const SceneJson& root, Mechanism& mechanism, DrawnMechanism& drawn) {
  const auto with = [&](const auto& read) {
    return [&mechanism, &drawn, read](const std::string& name, const SceneJson& value) {
      read(name, value, mechanism, drawn);
    };
  };
  read_each(root, "masses", with(read_mass));
  if (root.contains("gravity")) {
    const auto gravity = pair_of(root["gravity"], "gravity");
    mechanism.set_gravity(gravity[0], gravity[1]);
  }
  read_each(root, "loads", with(read_load));
  read_each(root, "springs", with(read_spring));
}

}  // namespace assur::mechanism::file
