// Links, joints, drivers and outputs, added to a mechanism with checks.
#include <algorithm>
#include <array>
#include <assur/mechanism/mechanism.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <set>

#include "refusals.hpp"

namespace assur::mechanism::description {

namespace {

/// Names and titles appear in lines of messages and comments of emitted code.
void expect_no_control_character(const std::string& text, const std::string& part) {
  if (const std::size_t at = text::first_control_character(text); at < text.size()) {
    throw MechanismError(part, "the byte at offset " + std::to_string(at) + " of " +
                                   text::in_quotes(text) + " is a control character; remove it");
  }
}

void expect_new(bool is_known, const std::string& name, const std::string& part) {
  expect_no_control_character(name, part);
  if (name.empty()) {
    throw MechanismError(part, "a name is empty; give each part a name");
  }
  if (is_known) {
    throw MechanismError(part,
                         "the name " + text::in_quotes(name) + " is taken; choose another one");
  }
}

/// Whether a number is zero for all parameters: no parameter occurs in it.
bool is_always_zero(const Number& number) {
  return number.formula.parameters().empty() &&
         number.formula.evaluate<double>([](ParameterIndex) { return 0.0; }) == 0;
}

}  // namespace

}  // namespace assur::mechanism::description

namespace assur::mechanism {

void Mechanism::set_name(const std::string& name) {
  description::expect_no_control_character(name, "name");
  name_ = name;
}

void Mechanism::set_unit(const std::string& unit) {
  description::expect_no_control_character(unit, "unit");
  unit_ = unit;
}

ParameterIndex Mechanism::parameter_named(const std::string& name, const std::string& part) const {
  const auto found = parameter_of_name_.find(name);
  if (found == parameter_of_name_.end()) {
    throw description::refusal_of_name(part, "parameter", name, names_of(parameters_));
  }
  return found->second;
}

JointIndex Mechanism::joint_named(const std::string& name, const std::string& part) const {
  const JointIndex joint = description::part_named(joints_, name, "joint", part);
  if (joints_[joint].between.size() != 2) {
    throw MechanismError(
        part,
        "the joint " + text::in_quotes(name) +
            " joins more than two links and has no coordinate; give each link a pin of its own");
  }
  expect_measured(joints_[joint], part);
  return joint;
}

Formula Mechanism::formula(const std::string& text, const std::string& part, Reads reads) const {
  using text::Operation;
  static constexpr std::array<text::ExpressionFunction, 4> own = {
      {{"joint", 1},
       {"abs", 1, Operation::absolute, true},
       {"min", 2, Operation::minimum, true},
       {"max", 2, Operation::maximum, true}}};
  try {
    return {text::parse_expression(text, own),
            {[&](const std::string& name) { return parameter_named(name, part); },
             [&](const std::string& name) {
               if (reads == Reads::parameters) {
                 throw MechanismError(
                     part,
                     "joint(" + name + ") may stand only in the position of a driver or in a load");
               }
               return joint_named(name, part);
             }}};
  } catch (const text::ExpressionError& error) {
    throw MechanismError(part, std::string(error.what()) + " at column " +
                                   std::to_string(error.column) + " of " + text::in_quotes(text));
  }
}

Number Mechanism::number(const Given& given, const std::string& part, Reads reads) const {
  return {given.text_ ? formula(*given.text_, part, reads) : given.formula_, part};
}

Formula Mechanism::formula_of(const Given& given, const std::string& part) const {
  return number(given, part).formula;
}

NumberIndex Mechanism::add_number(const Given& given, const std::string& part) {
  return numbers_.add(number(given, part));
}

void Mechanism::put_number(const Given& given, const std::string& part, NumberIndex& place) {
  if (place.exists()) {
    numbers_[place] = number(given, part);
  } else {
    place = add_number(given, part);
  }
}

void Mechanism::expect_new_parameter(const std::string& name) const {
  if (!text::is_identifier(name)) {
    throw MechanismError(
        "parameters",
        text::in_quotes(name) +
            " is not a name; use letters, digits and underscores, but no digit first");
  }
  if (text::is_reserved_name(name)) {
    throw MechanismError(
        "parameters",
        text::in_quotes(name) + " is the name of a function or constant; choose another one");
  }
  description::expect_new(parameter_of_name_.contains(name), name, "parameters");
}

ParameterIndex Mechanism::declare_parameter(const std::string& name) {
  expect_new_parameter(name);
  return add({name, {}, {}, {}, {}});
}

void Mechanism::set_parameter(const std::string& name, const Given& value,
                              const std::string& part) {
  const ParameterIndex parameter = parameter_named(name, part);
  put_number(value, part.empty() ? "parameters." + name : part, parameters_[parameter].value);
}

void Mechanism::set_tolerance(const std::string& name, const Given& half_width) {
  const std::string part = "parameters." + name + ".tolerance";
  const ParameterIndex parameter = parameter_named(name, part);
  put_number(half_width, part, parameters_[parameter].tolerance);
}

void Mechanism::set_velocity(const std::string& name, const Given& velocity) {
  const std::string part = "parameters." + name + ".velocity";
  const ParameterIndex parameter = parameter_named(name, part);
  put_number(velocity, part, parameters_[parameter].velocity);
}

void Mechanism::set_acceleration(const std::string& name, const Given& acceleration) {
  const std::string part = "parameters." + name + ".acceleration";
  const ParameterIndex parameter = parameter_named(name, part);
  put_number(acceleration, part, parameters_[parameter].acceleration);
}

ParameterIndex Mechanism::add_parameter(const std::string& name, const Given& value) {
  expect_new_parameter(name);
  return add({name, add_number(value, "parameters." + name), {}, {}, {}});
}

ParameterIndex Mechanism::add(Parameter parameter) {
  const std::string name = parameter.name;
  return parameter_of_name_[name] = parameters_.add(std::move(parameter));
}

LinkIndex Mechanism::add_link(const std::string& name) {
  if (name.find('.') != std::string::npos) {
    throw MechanismError("links", text::in_quotes(name) +
                                      " has a dot, which stands between the names of a link and "
                                      "its feature; write another letter");
  }
  description::expect_new(index_of(links_, name).exists(), name, "links");
  if (links_.size() == most_links) {
    throw MechanismError(
        "links", "a mechanism has at most " + std::to_string(most_links) + " links; remove some");
  }
  return links_.add({name, {}, false});
}

LinkIndex Mechanism::add_drawn_link(const std::string& name) {
  const LinkIndex link = add_link(name);
  links_[link].is_drawn = true;
  return link;
}

Feature Mechanism::on_link(const std::string& name, const std::string& part) const {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    const auto meant = std::ranges::find(features_, name, &Feature::name);
    throw MechanismError(
        part, "expected 'link.feature', found " + text::in_quotes(name) +
                  (meant == features_.end()
                       ? ""
                       : " (did you mean " +
                             text::in_quotes(links_[meant->link].name + "." + name) + "?)"));
  }
  const std::string link_name = name.substr(0, dot);
  Feature feature;
  feature.name = name.substr(dot + 1);
  feature.link = link_named(link_name, part);
  return feature;
}

Feature Mechanism::new_feature(const std::string& name, const std::string& part) const {
  Feature feature = on_link(name, part);
  const std::vector<FeatureIndex>& others = links_[feature.link].features;
  const bool is_known = std::ranges::any_of(
      others, [&](FeatureIndex other) { return features_[other].name == feature.name; });
  description::expect_new(is_known, feature.name, part);
  return feature;
}

FeatureIndex Mechanism::add_feature(Feature feature) {
  const LinkIndex link = feature.link;
  const FeatureIndex added = features_.add(std::move(feature));
  links_[link].features.push_back(added);
  return added;
}

FeatureIndex Mechanism::add_point(const std::string& name, const Given& x, const Given& y) {
  const std::string part = "links." + name;
  Feature feature = new_feature(name, part);
  Number first = number(x, part + "[0]");
  Number second = number(y, part + "[1]");
  feature.x = numbers_.add(std::move(first));
  feature.y = numbers_.add(std::move(second));
  return add_feature(std::move(feature));
}

FeatureIndex Mechanism::add_line(const std::string& name, const Given& x, const Given& y,
                                 const Given& along_x, const Given& along_y) {
  const std::string part = "links." + name;
  Feature feature = new_feature(name, part);
  Number through_x = number(x, part + ".through[0]");
  Number through_y = number(y, part + ".through[1]");
  Number sense_x = number(along_x, part + ".along[0]");
  Number sense_y = number(along_y, part + ".along[1]");
  if (description::is_always_zero(sense_x) && description::is_always_zero(sense_y)) {
    throw description::refusal_of_direction(part);
  }
  feature.is_line = true;
  feature.x = numbers_.add(std::move(through_x));
  feature.y = numbers_.add(std::move(through_y));
  feature.along_x = numbers_.add(std::move(sense_x));
  feature.along_y = numbers_.add(std::move(sense_y));
  return add_feature(std::move(feature));
}

FeatureIndex Mechanism::add_line(const std::string& name, const std::string& from,
                                 const std::string& to) {
  const std::string part = "links." + name;
  const std::string link = links_[on_link(name, part).link].name;
  const auto point = [&](const std::string& point_name, const std::string& end) {
    const FeatureIndex index = feature_named(link + "." + point_name, part + "." + end);
    const Feature& feature = features_[index];
    if (feature.is_line) {
      throw MechanismError(part + "." + end,
                           "expected a point, and '" + point_name + "' is a line");
    }
    return std::array{numbers_[feature.x].formula, numbers_[feature.y].formula};
  };
  const std::array<Formula, 2> begin = point(from, "from");
  const std::array<Formula, 2> end = point(to, "to");
  const std::array<Formula, 2> along = {end[0] - begin[0], end[1] - begin[1]};
  if (along[0].constant() == 0 && along[1].constant() == 0) {
    throw MechanismError(
        part, "the points " + from + " and " + to + " coincide, so that the line has no direction");
  }
  return add_line(name, begin[0], begin[1], along[0], along[1]);
}

FeatureIndex Mechanism::feature_named(const std::string& name, const std::string& part) const {
  const Feature wanted = on_link(name, part);
  const Link& link = links_[wanted.link];
  std::vector<std::string> names;
  for (const FeatureIndex feature : link.features) {
    if (features_[feature].name == wanted.name) {
      return feature;
    }
    names.push_back(features_[feature].name);
  }
  throw MechanismError(part, "link '" + link.name + "' has no feature " +
                                 text::in_quotes(wanted.name) +
                                 text::suggestion_or_choice(wanted.name, names));
}

JointIndex Mechanism::add_joint(const std::string& name, JointType type,
                                const std::vector<std::string>& between) {
  const std::string part = "joints." + name + ".between";
  description::expect_new(index_of(joints_, name).exists(), name, "joints");
  if (between.size() < 2) {
    throw MechanismError(part, "expected two or more features [\"link.feature\", ...]");
  }
  Joint joint{name, type, {}, {}, {}, true};
  for (std::size_t place = 0; place < between.size(); ++place) {
    joint.between.push_back(
        feature_named(between[place], part + "[" + std::to_string(place) + "]"));
  }
  expect_fitting(joint, part);
  return joints_.add(std::move(joint));
}

JointIndex Mechanism::add_unmeasured_joint(const std::string& name,
                                           const std::vector<std::string>& between) {
  const JointIndex joint = add_joint(name, JointType::revolute, between);
  joints_[joint].is_measured = false;
  return joint;
}

void Mechanism::expect_measured(const Joint& joint, const std::string& part) const {
  if (joint.is_measured || joint.between.size() != 2) {
    return;
  }
  const auto link = [&](std::size_t place) {
    return links_[features_[joint.between[place]].link].name;
  };
  throw description::refusal_of_measure(part, joint.name, link(0), link(1));
}

void Mechanism::expect_fitting(const Joint& joint, const std::string& part) const {
  if (joint.type != JointType::revolute && joint.between.size() != 2) {
    throw MechanismError(part, "only a revolute joint may join more than two links");
  }
  int lines = 0;
  std::set<LinkIndex> links;
  for (const FeatureIndex index : joint.between) {
    const Feature& feature = features_[index];
    lines += feature.is_line ? 1 : 0;
    if (!links.insert(feature.link).second) {
      throw MechanismError(part,
                           "link '" + links_[feature.link].name + "' occurs twice in one joint");
    }
  }
  const auto first = [&](bool is_line) {
    const auto found = std::ranges::find_if(
        joint.between, [&](FeatureIndex feature) { return features_[feature].is_line == is_line; });
    return "'" + links_[features_[*found].link].name + "." + features_[*found].name + "'";
  };
  if (joint.type == JointType::revolute && lines != 0) {
    throw MechanismError(part, "a revolute joint joins points, and " + first(true) + " is a line");
  }
  if (joint.type == JointType::prismatic && lines != 2) {
    throw MechanismError(part,
                         "a prismatic joint joins two lines, and " + first(false) + " is a point");
  }
  if (joint.type == JointType::pin_in_slot && lines != 1) {
    throw MechanismError(part,
                         std::string("a pin-in-slot joint joins a point and a line; found two ") +
                             (lines == 0 ? "points" : "lines"));
  }
}

void Mechanism::set_limits(const std::string& joint, const Given& lowest, const Given& highest) {
  const std::string part = "joints." + joint + ".limits";
  const JointIndex index = joint_named(joint, part);
  (void)number(highest, part + "[1]");  // If this throws, the lowest limit is unchanged.
  put_number(lowest, part + "[0]", joints_[index].lowest);
  put_number(highest, part + "[1]", joints_[index].highest);
}

DriverIndex Mechanism::add_driver(const std::string& joint, const Given& position,
                                  const std::optional<Given>& velocity,
                                  const std::optional<Given>& acceleration) {
  const std::string part = "drivers." + joint;
  Driver driver;
  driver.joint = description::part_named(joints_, joint, "joint", "drivers");
  expect_measured(joints_[driver.joint], part);
  for (const Driver& other : drivers_) {
    if (other.joint == driver.joint) {
      throw MechanismError(part, "the joint has a driver already; give it only one");
    }
  }
  Number law = number(position, part + ".position", Reads::joints);
  std::vector<std::pair<NumberIndex*, Number>> rates;
  if (velocity) {
    rates.emplace_back(&driver.velocity, number(*velocity, part + ".velocity"));
  }
  if (acceleration) {
    rates.emplace_back(&driver.acceleration, number(*acceleration, part + ".acceleration"));
  }
  driver.position = numbers_.add(std::move(law));
  for (auto& [place, rate] : rates) {
    *place = numbers_.add(std::move(rate));
  }
  return drivers_.add(driver);
}

DriverIndex Mechanism::driver_of(JointIndex joint) const {
  for (const DriverIndex driver : drivers_.keys()) {
    if (drivers_[driver].joint == joint) {
      return driver;
    }
  }
  return {};
}

OutputIndex Mechanism::add_output(const std::string& name, const std::string& point) {
  const std::string part = "outputs." + name;
  description::expect_new(index_of(outputs_, name).exists(), name, "outputs");
  const FeatureIndex feature = feature_named(point, part);
  if (features_[feature].is_line) {
    throw MechanismError(part, "an output is a point, and this feature is a line");
  }
  return outputs_.add({name, feature});
}

}  // namespace assur::mechanism
