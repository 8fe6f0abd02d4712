// Reads a scene: parameters, links or a drawing, joints, drivers and outputs.
#include <algorithm>
#include <array>
#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <assur/text/utf8.hpp>

#include "description/refusals.hpp"
#include "json_values.hpp"
#include "loads_and_requests.hpp"
#include "scene_keys.hpp"

namespace assur::mechanism::file {

namespace {

/// Reads a document from its parameters to its outputs, its loads and its requests, in an order in
/// which each part refers to earlier ones only.
class SceneReader {
 public:
  SceneReader(const SceneJson& root, const std::vector<std::string>& settings,
              const std::string& settings_name, Scene& scene)
      : root_(root),
        settings_(settings),
        settings_name_(settings_name),
        mechanism_(scene.mechanism),
        drawn_(scene.mechanism),
        request_(scene.request),
        points_(scene.points) {}

  void read() {
    expect_object(root_, "");
    expect_keys(root_, "", scene_keys);
    if (root_.contains("name")) {
      mechanism_.set_name(text_of(root_["name"], "name"));
    }
    if (root_.contains("unit")) {
      mechanism_.set_unit(text_of(root_["unit"], "unit"));
    }
    read_parameters();
    apply_settings();
    read_points();
    read_links();
    read_lengths();
    read_joints();
    points_ = drawn_.points();
    drawn_.place();
    read_drivers();
    read_outputs();
    read_loads(root_, mechanism_, drawn_);
    read_request(root_, mechanism_, drawn_, request_);
  }

 private:
  void read_parameters() {
    if (!root_.contains("parameters")) {
      return;
    }
    const SceneJson& parameters = root_["parameters"];
    expect_object(parameters, "parameters");
    for (const auto& [name, value] : parameters.items()) {
      mechanism_.declare_parameter(name);
    }
    for (const auto& [name, value] : parameters.items()) {
      const std::string part = "parameters." + name;
      if (!value.is_object()) {
        mechanism_.set_parameter(name, number_of(value, part), part);
        continue;
      }
      expect_keys(value, part, parameter_keys);
      const std::string value_part = part + ".value";
      if (value.contains("value") || !value.contains("drawn")) {
        mechanism_.set_parameter(name, number_of(required(value, "value", part), value_part),
                                 value_part);
      }
      if (value.contains("tolerance")) {
        mechanism_.set_tolerance(name, number_of(value["tolerance"], part + ".tolerance"));
      }
      if (value.contains("velocity")) {
        mechanism_.set_velocity(name, number_of(value["velocity"], part + ".velocity"));
      }
      if (value.contains("acceleration")) {
        mechanism_.set_acceleration(name, number_of(value["acceleration"], part + ".acceleration"));
      }
      if (value.contains("variable") && truth_of(value["variable"], part + ".variable")) {
        request_.variable.push_back(mechanism_.parameter_named(name));
      }
    }
  }

  /// Throws MechanismError for a setting that names a driver instead of a parameter.
  void expect_no_driver(const std::string& name) const {
    const bool is_driver = root_.contains("drivers") && root_["drivers"].is_object() &&
                           root_["drivers"].contains(name);
    if (is_driver && !index_of(mechanism_.parameters(), name).exists()) {
      throw MechanismError(settings_name_,
                           text::in_quotes(name) +
                               " is a driver, not a parameter; let its 'position' be a "
                               "formula in a parameter, and set that");
    }
  }

  void apply_settings() {
    for (const std::string& setting : settings_) {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos) {
        throw MechanismError(settings_name_,
                             "expected NAME=EXPR, found " + text::in_quotes(setting));
      }
      const std::string name = setting.substr(0, equals);
      expect_no_driver(name);
      (void)mechanism_.parameter_named(name, settings_name_);
      mechanism_.set_parameter(name, setting.substr(equals + 1), settings_name_ + " " + name);
    }
  }

  void read_points() {
    if (!root_.contains("points")) {
      return;
    }
    expect_object(root_["points"], "points");
    for (const auto& [name, value] : root_["points"].items()) {
      const auto place = pair_of(value, "points." + name);
      drawn_.add_point(name, place[0], place[1]);
    }
  }

  /// The parameters that the drawing defines: distances of points, and coordinates of joints.
  void read_lengths() {
    if (!root_.contains("parameters")) {
      return;
    }
    for (const auto& [name, value] : root_["parameters"].items()) {
      if (!value.is_object() || !value.contains("drawn")) {
        continue;
      }
      const SceneJson& drawn = value["drawn"];
      const std::string part = "parameters." + name + ".drawn";
      if (drawn.is_string()) {
        if (value.contains("value")) {
          throw MechanismError(
              "parameters." + name,
              "'drawn' names a joint, so 'value' would not be used; leave one out");
        }
        drawn_.set_coordinate(name, drawn.get<std::string>());
        continue;
      }
      std::vector<std::array<std::string, 2>> pairs;
      const bool is_list = drawn.is_array() && !drawn.empty() && drawn[0].is_array();
      for (const SceneJson& pair : is_list ? drawn : SceneJson::array({drawn})) {
        if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) {
          throw MechanismError(part, "expected two points of one link, or the name of a joint");
        }
        pairs.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
      }
      drawn_.set_length(name, pairs);
    }
  }

  /// A list of names.
  static std::vector<std::string> names_in(const SceneJson& list, const std::string& part,
                                           const std::string& expected) {
    if (!list.is_array()) {
      throw MechanismError(part, expected);
    }
    std::vector<std::string> names;
    for (std::size_t index = 0; index < list.size(); ++index) {
      names.push_back(text_of(list[index], part + "[" + std::to_string(index) + "]"));
    }
    return names;
  }

  void read_links() {
    const SceneJson& links = required(root_, "links", "");
    expect_object(links, "links");
    for (const auto& [name, value] : links.items()) {
      if (value.is_array()) {
        drawn_.add_link(name, names_in(value, "links." + name, ""));
        continue;
      }
      mechanism_.add_link(name);
      expect_object(value, "links." + name);
      for (const auto& [feature, place] : value.items()) {
        if (!joins_points(place)) {
          read_feature(name, feature, place);
        }
      }
      for (const auto& [feature, place] : value.items()) {
        if (joins_points(place)) {
          read_line_through_points(name + "." + feature, place);
        }
      }
    }
  }

  /// Whether a feature is a line that names two points of its link.
  static bool joins_points(const SceneJson& feature) {
    return feature.is_object() && (feature.contains("from") || feature.contains("to"));
  }

  void read_line_through_points(const std::string& name, const SceneJson& value) {
    const std::string part = "links." + name;
    expect_keys(value, part, line_through_points_keys);
    mechanism_.add_line(name, text_of(required(value, "from", part), part + ".from"),
                        text_of(required(value, "to", part), part + ".to"));
  }

  void read_feature(const std::string& link, const std::string& name, const SceneJson& value) {
    const std::string whole = link + "." + name;
    const std::string part = "links." + whole;
    if (value.is_object()) {
      expect_keys(value, part, line_keys);
      const auto through = pair_of(required(value, "through", part), part + ".through");
      const auto along = pair_of(required(value, "along", part), part + ".along");
      mechanism_.add_line(whole, through[0], through[1], along[0], along[1]);
    } else if (value.is_array()) {
      const auto point = pair_of(value, part);
      mechanism_.add_point(whole, point[0], point[1]);
    } else {
      throw MechanismError(
          part, R"(expected a point [x, y] or a line {"through": [x, y], "along": [dx, dy]})");
    }
  }

  void read_joints() {
    if (drawn_.is_drawn() && !root_.contains("joints")) {
      return;
    }
    const SceneJson& joints = required(root_, "joints", "");
    expect_object(joints, "joints");
    for (const auto& [name, value] : joints.items()) {
      drawn_.add_joint(joint_of(name, value));
    }
  }

  [[nodiscard]] DrawnJoint joint_of(const std::string& name, const SceneJson& value) {
    const std::vector<std::string> types = {"revolute", "prismatic", "pin-in-slot"};
    const std::string part = "joints." + name;
    expect_object(value, part);
    expect_keys(value, part, joint_keys);
    const std::string type = text_of(required(value, "type", part), part + ".type");
    const auto found = std::find(types.begin(), types.end(), type);
    if (found == types.end()) {
      throw MechanismError(part + ".type", "no joint type " + text::in_quotes(type) +
                                               text::suggestion(type, types) +
                                               "; the types are revolute, prismatic, pin-in-slot");
    }
    DrawnJoint joint;
    joint.name = name;
    joint.type = static_cast<JointType>(found - types.begin());
    if (value.contains("between") || !drawn_.is_drawn()) {
      const std::string expected = "expected two or more features [\"link.feature\", ...]";
      joint.between = names_in(required(value, "between", part), part + ".between", expected);
      if (joint.between.empty()) {
        mechanism_.add_joint(name, joint.type, {});  // throws for this joint
      }
    }
    if (value.contains("links")) {
      joint.links = names_in(value["links"], part + ".links",
                             R"(expected the links that the joint joins, ["a", "b"])");
    }
    if (value.contains("at")) {
      joint.at = text_of(value["at"], part + ".at");
    }
    if (value.contains("along")) {
      const std::string expected = R"(expected two drawn points ["A", "D"])";
      joint.along = names_in(value["along"], part + ".along", expected);
      if (joint.along.size() != 2) {
        throw MechanismError(part + ".along", expected);
      }
    }
    if (value.contains("direction")) {
      joint.direction = pair_of(value["direction"], part + ".direction");
    }
    if (value.contains("limits")) {
      if (!value["limits"].is_array() || value["limits"].size() != 2) {
        throw MechanismError(part + ".limits", "expected the limits [lowest, highest]");
      }
      joint.limits = pair_of(value["limits"], part + ".limits");
    }
    return joint;
  }

  void read_drivers() {
    if (!root_.contains("drivers")) {
      return;
    }
    expect_object(root_["drivers"], "drivers");
    for (const auto& [name, value] : root_["drivers"].items()) {
      const std::string part = "drivers." + name;
      (void)description::part_named(mechanism_.joints(), name, "joint", "drivers");
      expect_object(value, part);
      expect_keys(value, part, driver_keys);
      const auto number = [&, &driver = value](const std::string& key) {
        return driver.contains(key) ? std::optional(number_of(driver[key], part + "." + key))
                                    : std::nullopt;
      };
      drawn_.add_driver(name, number("position"), number("velocity"), number("acceleration"));
    }
  }

  void read_outputs() {
    if (!root_.contains("outputs")) {
      return;
    }
    const SceneJson& outputs = root_["outputs"];
    if (outputs.is_array()) {
      for (const std::string& point : names_in(outputs, "outputs", "")) {
        drawn_.add_output(point, point);
      }
      return;
    }
    if (!outputs.is_object()) {
      throw MechanismError("outputs",
                           std::string("expected a list of drawn points, [\"P\"], or an object "
                                       "{...}, found ") +
                               outputs.type_name());
    }
    for (const auto& [name, value] : outputs.items()) {
      drawn_.add_output(name, text_of(value, "outputs." + name));
    }
  }

  const SceneJson& root_;
  const std::vector<std::string>& settings_;
  const std::string& settings_name_;
  Mechanism& mechanism_;
  DrawnMechanism drawn_;
  Request& request_;
  Table<DrawnPointIndex, DrawnPoint>& points_;
};

/// Holds idle links in their drawn position, or at angle 0.
void hold_idle_links(Scene& scene) {
  scene.mechanism.hold_idle_links([&](LinkIndex link) {
    const auto found = std::ranges::find(scene.request.reference, link, &ReferenceAngle::link);
    return found == scene.request.reference.end() ? Formula(0)
                                                  : scene.mechanism.numbers()[found->theta].formula;
  });
}

}  // namespace

}  // namespace assur::mechanism::file

namespace assur::mechanism {

Scene parse_scene(const std::string& text, const std::string& file,
                  const std::vector<std::string>& settings, const std::string& settings_name) {
  text::expect_no_nul(text, file);
  Scene scene{file, Mechanism(), {}};
  try {
    file::SceneReader(file::parsed(text), settings, settings_name, scene).read();
    file::hold_idle_links(scene);
  } catch (const MechanismError& error) {
    throw InputError(file + ": " + error.what());
  }
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings,
                 const std::string& settings_name) {
  return parse_scene(text::read_input_file(file), file.string(), settings, settings_name);
}

}  // namespace assur::mechanism
