// Masses, forces, couples and springs, added to a mechanism.
#include <algorithm>
#include <assur/mechanism/mechanism.hpp>
#include <assur/text/quoted.hpp>

#include "refusals.hpp"

namespace assur::mechanism::description {

namespace {

void expect_new_name(bool is_known, const std::string& name, const std::string& part) {
  if (name.empty()) {
    throw MechanismError(part, "a name is empty; give each part a name");
  }
  if (is_known) {
    throw MechanismError(part,
                         "the name " + text::in_quotes(name) + " is taken; choose another one");
  }
}

template <typename Part>
bool is_named(const std::vector<Part>& parts, const std::string& name) {
  return std::ranges::any_of(parts, [&](const Part& part) { return part.name == name; });
}

}  // namespace

}  // namespace assur::mechanism::description

namespace assur::mechanism {

LinkIndex Mechanism::link_named(const std::string& name, const std::string& part) const {
  return description::part_named(links_, name, "link", part);
}

FeatureIndex Mechanism::point_named(const std::string& name, const std::string& part) const {
  const FeatureIndex point = feature_named(name, part);
  if (features_[point].is_line) {
    throw MechanismError(part, text::in_quotes(name) + " is a line; name a point");
  }
  return point;
}

NumberIndex Mechanism::number_not_negative(const Given& given, const std::string& part) {
  Number made = number(given, part);
  if (made.formula.parameters().empty() &&
      made.formula.evaluate<double>([](ParameterIndex) { return 0.0; }) < 0) {
    throw MechanismError(part, "the number is negative; give zero or more");
  }
  return numbers_.add(std::move(made));
}

void Mechanism::add_mass(const std::string& link, const Given& mass, const GivenPlace& at,
                         const Given& inertia) {
  const std::string part = "masses." + link;
  Mass added;
  added.at.link = link_named(link, "masses");
  if (std::ranges::any_of(loading_.masses,
                          [&](const Mass& other) { return other.at.link == added.at.link; })) {
    throw MechanismError(part, "the link has a mass already; give it only one");
  }
  if (const auto* point = std::get_if<std::string>(&at)) {
    const Feature& feature = features_[point_named(link + "." + *point, part + ".at")];
    added.at.x = feature.x;
    added.at.y = feature.y;
  } else if (const auto* place = std::get_if<std::array<Given, 2>>(&at)) {
    added.at.x = add_number((*place)[0], part + ".at[0]");
    added.at.y = add_number((*place)[1], part + ".at[1]");
  }
  added.mass = number_not_negative(mass, part + ".mass");
  added.inertia = number_not_negative(inertia, part + ".inertia");
  loading_.masses.push_back(added);
}

void Mechanism::set_gravity(const Given& x, const Given& y) {
  put_number(x, "gravity[0]", loading_.gravity[0]);
  put_number(y, "gravity[1]", loading_.gravity[1]);
}

void Mechanism::expect_new_load(const std::string& name, const std::string& part) const {
  description::expect_new_name(description::is_named(loading_.loads, name), name, part);
}

void Mechanism::expect_new_spring(const std::string& name, const std::string& part) const {
  description::expect_new_name(description::is_named(loading_.springs, name), name, part);
}

void Mechanism::add_force(const std::string& name, const std::string& at,
                          const std::array<Given, 2>& force, const std::string& frame) {
  const std::string part = "loads." + name;
  expect_new_load(name, "loads");
  const Feature& point = features_[point_named(at, part + ".at")];
  Load load{name, {point.link, point.x, point.y}, {}, {}, {}, {}};
  if (!frame.empty()) {
    load.frame = link_named(frame, part + ".frame");
  }
  load.force_x = numbers_.add(number(force[0], part + ".force[0]", Reads::joints));
  load.force_y = numbers_.add(number(force[1], part + ".force[1]", Reads::joints));
  loading_.loads.push_back(std::move(load));
}

void Mechanism::add_moment(const std::string& name, const std::string& link, const Given& moment) {
  const std::string part = "loads." + name;
  expect_new_load(name, "loads");
  Load load{name, {link_named(link, part + ".on"), {}, {}}, {}, {}, {}, {}};
  load.moment = numbers_.add(number(moment, part + ".moment", Reads::joints));
  loading_.loads.push_back(std::move(load));
}

void Mechanism::add_spring(const std::string& name, const std::array<std::string, 2>& between,
                           const Given& stiffness, const Given& length, const Given& damping) {
  const std::string part = "springs." + name;
  expect_new_spring(name, "springs");
  Spring spring{name, false, {}, {}, {}, {}};
  for (const std::size_t end : {0U, 1U}) {
    spring.between[end] = point_named(between[end], part + ".between[" + std::to_string(end) + "]");
  }
  if (features_[spring.between[0]].link == features_[spring.between[1]].link) {
    throw MechanismError(part + ".between",
                         "both ends are on the same link; name points of two links");
  }
  spring.stiffness = number_not_negative(stiffness, part + ".stiffness");
  spring.rest = number_not_negative(length, part + ".length");
  spring.damping = number_not_negative(damping, part + ".damping");
  loading_.springs.push_back(std::move(spring));
}

void Mechanism::add_joint_spring(const std::string& name, const std::string& joint,
                                 const Given& stiffness, const Given& rest, const Given& damping) {
  const std::string part = "springs." + name;
  expect_new_spring(name, "springs");
  const Joint& at = joints_[joint_named(joint, part + ".joint")];
  Spring spring{name, true, {at.between[0], at.between[1]}, {}, {}, {}};
  spring.stiffness = number_not_negative(stiffness, part + ".stiffness");
  spring.rest = add_number(rest, part + ".rest");
  spring.damping = number_not_negative(damping, part + ".damping");
  loading_.springs.push_back(std::move(spring));
}

void Mechanism::renumber_loading(const Table<LinkIndex, LinkIndex>& link_of,
                                 const Table<FeatureIndex, FeatureIndex>& feature_of) {
  const Loading before = std::move(loading_);
  loading_ = {{}, before.gravity, {}, {}};
  for (Mass mass : before.masses) {
    mass.at.link = link_of[mass.at.link];
    if (mass.at.link.exists()) {
      loading_.masses.push_back(mass);
    }
  }
  for (Load load : before.loads) {
    load.at.link = link_of[load.at.link];
    const bool turns = load.frame.exists();
    load.frame = turns ? link_of[load.frame] : load.frame;
    if (load.at.link.exists() && load.frame.exists() == turns) {
      loading_.loads.push_back(std::move(load));
    }
  }
  for (Spring spring : before.springs) {
    for (FeatureIndex& end : spring.between) {
      end = feature_of[end];
    }
    if (spring.between[0].exists() && spring.between[1].exists()) {
      loading_.springs.push_back(std::move(spring));
    }
  }
}

void Mechanism::renumber_loads(const Table<JointIndex, JointIndex>& joint_of) {
  for (const Load& load : loading_.loads) {
    for (const NumberIndex index : {load.force_x, load.force_y, load.moment}) {
      if (index.exists()) {
        numbers_[index].formula = numbers_[index].formula.renumbered(joint_of);
      }
    }
  }
}

}  // namespace assur::mechanism
