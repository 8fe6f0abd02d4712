// Turns the links, joints and drivers of a scene's JSON into those of the scene.
#include <array>
#include <set>

#include "scene/scene_parts.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

namespace {

class LinkageReader {
 public:
  LinkageReader(const JsonValues& values, Scene& scene) : values_(values), scene_(scene) {}

  void read(const SceneJson& root) {
    read_links(root);
    read_joints(root);
    read_drivers(root);
  }

 private:
  [[nodiscard]] SceneFeature feature(const std::string& name, const SceneJson& value,
                                     const std::string& where) const {
    SceneFeature result;
    result.name = name;
    result.where = where;
    if (value.is_object()) {
      values_.expect_keys(value, where, {"through", "along"});
      result.line = true;
      auto [x, y] = values_.pair(values_.required(value, "through", where), where + ".through");
      auto [dx, dy] = values_.pair(values_.required(value, "along", where), where + ".along");
      result.x = std::move(x);
      result.y = std::move(y);
      result.along_x = std::move(dx);
      result.along_y = std::move(dy);
    } else if (value.is_array()) {
      auto [x, y] = values_.pair(value, where);
      result.x = std::move(x);
      result.y = std::move(y);
    } else {
      values_.fail(where,
                   R"(expected a point [x, y] or a line {"through": [x, y], "along": [dx, dy]})");
    }
    return result;
  }

  void read_links(const SceneJson& root) {
    const SceneJson& links = values_.required(root, "links", "");
    values_.expect_object(links, "links");
    for (const auto& [name, value] : links.items()) {
      const std::string where = "links." + name;
      if (name.empty() || name.find('.') != std::string::npos) {
        values_.fail("links", quoted(name) + " is not a name: it is empty or has a dot");
      }
      values_.expect_object(value, where);
      SceneLink link{name, {}};
      for (const auto& [feature_name, feature_value] : value.items()) {
        link.features.push_back(feature(feature_name, feature_value, where + "." + feature_name));
      }
      scene_.links.push_back(std::move(link));
    }
  }

  void read_joints(const SceneJson& root) {
    const SceneJson& joints = values_.required(root, "joints", "");
    values_.expect_object(joints, "joints");
    const std::vector<std::string> types = {"revolute", "prismatic", "pin-in-slot"};
    for (const auto& [name, value] : joints.items()) {
      const std::string where = "joints." + name;
      values_.expect_object(value, where);
      values_.expect_keys(value, where, {"type", "between"});
      SceneJoint joint;
      joint.name = name;
      const std::string type =
          values_.text_of(values_.required(value, "type", where), where + ".type");
      const auto found = std::find(types.begin(), types.end(), type);
      if (found == types.end()) {
        values_.fail(where + ".type", "no joint type " + quoted(type) + suggestion(type, types) +
                                          "; the types are revolute, prismatic, pin-in-slot");
      }
      joint.type = static_cast<SceneJointType>(found - types.begin());
      const SceneJson& between = values_.required(value, "between", where);
      if (!between.is_array() || between.size() < 2) {
        values_.fail(where + ".between", "expected two or more features [\"link.feature\", ...]");
      }
      for (std::size_t index = 0; index < between.size(); ++index) {
        joint.between.push_back(feature_reference(
            between[index], where + ".between[" + std::to_string(index) + "]", values_, scene_));
      }
      check_joint(joint, where + ".between");
      scene_.joints.push_back(std::move(joint));
    }
  }

  void check_joint(const SceneJoint& joint, const std::string& where) const {
    if (joint.type != SceneJointType::revolute && joint.between.size() != 2) {
      values_.fail(where, "only a revolute joint may join more than two links");
    }
    int lines = 0;
    std::set<int> links;
    for (const FeatureReference& part : joint.between) {
      lines += scene_.feature(part).line ? 1 : 0;
      if (!links.insert(part.link).second) {
        values_.fail(where, "link '" + scene_.links[static_cast<std::size_t>(part.link)].name +
                                "' stands twice in one joint");
      }
    }
    if (joint.type == SceneJointType::revolute && lines != 0) {
      values_.fail(where, "a revolute joint joins points, and one of these features is a line");
    }
    if (joint.type == SceneJointType::prismatic && lines != 2) {
      values_.fail(where,
                   "a prismatic joint joins two lines, and one of these features is a point");
    }
    if (joint.type == SceneJointType::pin_in_slot && lines != 1) {
      values_.fail(where, "a pin-in-slot joint joins a point and a line");
    }
  }

  void read_drivers(const SceneJson& root) {
    if (!root.contains("drivers")) {
      return;
    }
    values_.expect_object(root["drivers"], "drivers");
    for (const auto& [name, value] : root["drivers"].items()) {
      const std::string where = "drivers." + name;
      SceneDriver driver;
      driver.joint = index_of(scene_.joints, name);
      if (driver.joint < 0) {
        values_.fail("drivers",
                     "no joint named " + quoted(name) + suggestion(name, names_of(scene_.joints)));
      }
      values_.expect_object(value, where);
      values_.expect_keys(value, where, {"position", "velocity", "acceleration"});
      driver.position =
          values_.number(values_.required(value, "position", where), where + ".position");
      const SceneJson zero = 0;
      driver.velocity = values_.number(value.contains("velocity") ? value["velocity"] : zero,
                                       where + ".velocity");
      driver.acceleration = values_.number(
          value.contains("acceleration") ? value["acceleration"] : zero, where + ".acceleration");
      scene_.drivers.push_back(std::move(driver));
    }
  }

  const JsonValues& values_;
  Scene& scene_;
};

}  // namespace

FeatureReference feature_reference(const SceneJson& value, const std::string& where,
                                   const JsonValues& values, const Scene& scene) {
  const std::string text = values.text_of(value, where);
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) {
    values.fail(where, "expected 'link.feature', found " + quoted(text));
  }
  const std::string link_name = text.substr(0, dot);
  const std::string feature_name = text.substr(dot + 1);
  const int link = index_of(scene.links, link_name);
  if (link < 0) {
    values.fail(
        where, "no link named " + quoted(link_name) + suggestion(link_name, names_of(scene.links)));
  }
  const std::vector<SceneFeature>& features = scene.links[static_cast<std::size_t>(link)].features;
  const int index = index_of(features, feature_name);
  if (index < 0) {
    values.fail(where, "link '" + link_name + "' has no feature " + quoted(feature_name) +
                           suggestion(feature_name, names_of(features)));
  }
  return {link, index};
}

void read_linkage(const SceneJson& root, const JsonValues& values, Scene& scene) {
  LinkageReader(values, scene).read(root);
}

}  // namespace assur::generator
