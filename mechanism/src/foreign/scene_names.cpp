#include "foreign/scene_names.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>
#include <assur/text/identifiers.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/utf8.hpp>
#include <map>

namespace assur::mechanism::foreign {

namespace {

constexpr std::size_t longest_name = 60;

/// Whether a scene accepts the name of a point or a link: a dot stands between a link and its
/// feature.
bool is_usable(const std::string& name) {
  return !name.empty() && name.size() <= longest_name &&
         name.find_first_of(".\t\r\n\v\f") == std::string::npos && name.front() != ' ' &&
         name.back() != ' ' && text::first_control_character(name) == name.size() &&
         text::first_byte_outside_utf8(name) == name.size();
}

/// Names of the parts of a table: `taken` holds the reserved names, and in the end all.
template <typename Key, typename Part>
Table<Key, std::string> names_of_parts(const Table<Key, Part>& parts, const std::string& what,
                                       std::set<std::string>& taken, ForeignMechanism& mechanism) {
  std::map<std::string, int> parts_of_name;
  for (const Part& part : parts) {
    ++parts_of_name[part.name];
  }
  Table<Key, std::string> names(parts.size());
  // Parts with unique names come first, so that no identifier takes one of these.
  for (const Key key : parts.keys()) {
    const std::string& name = parts[key].name;
    if (is_usable(name) && parts_of_name[name] == 1 && !taken.contains(name)) {
      names[key] = new_name(name, taken);
    }
  }
  for (const Key key : parts.keys()) {
    const Part& part = parts[key];
    if (!names[key].empty()) {
      continue;
    }
    if (part.name.find_first_not_of(' ') == std::string::npos || part.name == part.id) {
      names[key] = new_name(part.id, taken);
    } else if (is_usable(part.name)) {
      names[key] = new_name(part.name + "_" + part.id, taken);
      mechanism.remark("the " + what + " " + text::in_quotes(part.id) + ", called " +
                       text::in_quotes(part.name) + " like another, is " +
                       text::in_quotes(names[key]) + " in the scene");
    } else {
      names[key] = new_name(part.id, taken);
      mechanism.remark("the name " + text::in_quotes(part.name) + " of the " + what + " " +
                       text::in_quotes(part.id) + " cannot be used; it is " +
                       text::in_quotes(names[key]) + " in the scene");
    }
  }
  return names;
}

std::string suffix_of(const ForeignMechanism& mechanism, const ForeignJoint& joint,
                      const std::string& second) {
  switch (joint.type) {
    case JointType::pin_in_slot:
      return "_slot";
    case JointType::prismatic:
      return joint.to.exists() ? "_cylinder" : "_slide";
    case JointType::revolute:
      break;
  }
  return mechanism.pinned_at(joint.at).size() > 2 ? "_" + second : "_pin";
}

}  // namespace

std::string new_name(std::string name, std::set<std::string>& taken) {
  while (!taken.insert(name).second) {
    name += '_';
  }
  return name;
}

SceneNames::SceneNames(ForeignMechanism& mechanism) {
  points_ = names_of_parts(mechanism.points, "point", taken_points_, mechanism);
  std::set<std::string> taken;
  Table<ForeignLinkIndex, ForeignLink> moving = mechanism.links;
  moving[mechanism.ground()].name = moving[mechanism.ground()].id = "ground";
  links_ = names_of_parts(moving, "link", taken, mechanism);
  // A moving link must not be mistaken for the ground.
  for (const ForeignLinkIndex link : links_.keys()) {
    if (link != mechanism.ground() && links_[link] == "ground") {
      links_[link] = new_name("ground", taken);
    }
  }
  links_[mechanism.ground()] = "ground";
  name_joints(mechanism);
}

void SceneNames::name_joints(const ForeignMechanism& mechanism) {
  const std::size_t count = mechanism.joints.size();
  joints_ = Table<ForeignJointIndex, std::string>(count);
  coordinates_ = Table<ForeignJointIndex, std::string>(count);
  implied_ = Table<ForeignJointIndex, bool>(count);
  std::set<std::string> taken(points_.begin(), points_.end());
  std::set<std::string> parameters(mechanism.hand_parameters.begin(),
                                   mechanism.hand_parameters.end());
  parameters.insert("t");
  for (const ForeignJointIndex key : mechanism.joints.keys()) {
    const ForeignJoint& joint = mechanism.joints[key];
    const std::string& point = points_[joint.at];
    // A law can name a joint by an identifier only.
    implied_[key] = joint.type == JointType::revolute && joint.first == mechanism.ground() &&
                    mechanism.pinned_at(joint.at).size() == 2 && text::is_identifier(point);
    joints_[key] =
        implied_[key]
            ? point
            : new_name(
                  text::c_identifier(point + suffix_of(mechanism, joint, links_[joint.second])),
                  taken);
    coordinates_[key] = new_name(text::c_identifier(joints_[key]) + "_drawn", parameters);
  }
}

std::string SceneNames::new_point(const std::string& words) {
  return new_name(words, taken_points_);
}

}  // namespace assur::mechanism::foreign
