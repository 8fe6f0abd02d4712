#include "scene/scene.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "error.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

namespace {

// Ordered, because the order of links and joints decides how a group is spelled.
using Json = nlohmann::ordered_json;

template <typename Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) {
    names.push_back(item.name);
  }
  return names;
}

template <typename Items>
int index_of(const Items& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

/// Printable, short, on one line: what a message may quote.
std::string quoted(const std::string& text) {
  std::string shown;
  for (const char letter : text.substr(0, 40)) {
    shown += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
  }
  return "'" + shown + (text.size() > 40 ? "..." : "") + "'";
}

class SceneReader {
 public:
  explicit SceneReader(const std::string& file) { scene_.file = file; }

  Scene read(const std::string& text, const std::vector<std::string>& settings) {
    const Json root = parsed(text);
    expect_object(root, "");
    expect_keys(root, "",
                {"name", "parameters", "links", "joints", "drivers", "outputs", "want", "sweep",
                 "covariance"});
    read_name(root);
    read_parameters(root, settings);
    read_links(root);
    read_joints(root);
    read_drivers(root);
    read_outputs(root);
    read_want(root);
    read_sweep(root);
    read_covariance(root);
    return std::move(scene_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    throw InputError(scene_.file + ": " + where + (where.empty() ? "" : ": ") + what);
  }

  [[nodiscard]] Json parsed(const std::string& text) const {
    // The library keeps the last of two equal keys without a word; a scene must not.
    std::vector<std::set<std::string>> open;
    const auto watch = [&](int /*depth*/, Json::parse_event_t event, Json& value) {
      if (event == Json::parse_event_t::object_start) {
        open.emplace_back();
      } else if (event == Json::parse_event_t::object_end) {
        open.pop_back();
      } else if (event == Json::parse_event_t::key) {
        const auto key = value.get<std::string>();
        if (!open.back().insert(key).second) {
          fail("", "the key " + quoted(key) + " stands twice in one object");
        }
      }
      return true;
    };
    try {
      return Json::parse(text, watch);
    } catch (const Json::exception& error) {
      std::string what = error.what();
      what = what.substr(what.find("] ") == std::string::npos ? 0 : what.find("] ") + 2);
      std::replace_if(
          what.begin(), what.end(),
          [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, ' ');
      fail("", "not JSON: " + what);
    }
  }

  void expect_object(const Json& value, const std::string& where) const {
    if (!value.is_object()) {
      fail(where, std::string("expected an object {...}, found ") + value.type_name());
    }
  }
  void expect_keys(const Json& value, const std::string& where,
                   const std::vector<std::string>& known) const {
    for (const auto& [key, ignored] : value.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        fail(where, "unknown key " + quoted(key) + suggestion(key, known));
      }
    }
  }
  [[nodiscard]] const Json& required(const Json& value, const std::string& key,
                                     const std::string& where) const {
    if (!value.contains(key)) {
      fail(where, "the key '" + key + "' is missing");
    }
    return value.at(key);
  }
  [[nodiscard]] std::string text_of(const Json& value, const std::string& where) const {
    if (!value.is_string()) {
      fail(where, std::string("expected a text, found ") + value.type_name());
    }
    return value.get<std::string>();
  }

  [[nodiscard]] SceneNumber number_of(const std::string& text, const std::string& where) const {
    SceneNumber number{{}, where};
    try {
      number.expression = parse_expression(text);
    } catch (const ExpressionError& error) {
      fail(where, std::string(error.what()) + " at column " + std::to_string(error.column) +
                      " of " + quoted(text));
    }
    expect_names(number.expression, where);
    return number;
  }
  [[nodiscard]] SceneNumber number(const Json& value, const std::string& where) const {
    if (value.is_string()) {
      return number_of(value.get<std::string>(), where);
    }
    if (!value.is_number()) {
      fail(where, std::string("expected a number or an expression, found ") + value.type_name());
    }
    return {{Expression::Kind::number, value.get<double>(), value.dump(), {}, 1}, where};
  }
  void expect_names(const Expression& expression, const std::string& where) const {
    if (expression.kind == Expression::Kind::name &&
        std::find(parameter_names_.begin(), parameter_names_.end(), expression.name) ==
            parameter_names_.end()) {
      fail(where, "no parameter named " + quoted(expression.name) +
                      suggestion(expression.name, parameter_names_));
    }
    for (const Expression& argument : expression.arguments) {
      expect_names(argument, where);
    }
  }
  [[nodiscard]] std::array<SceneNumber, 2> pair(const Json& value, const std::string& where) const {
    if (!value.is_array() || value.size() != 2) {
      fail(where, "expected two numbers [x, y]");
    }
    return {number(value[0], where + "[0]"), number(value[1], where + "[1]")};
  }

  void read_name(const Json& root) {
    if (root.contains("name")) {
      scene_.name = text_of(root["name"], "name");
    }
  }

  void read_parameters(const Json& root, const std::vector<std::string>& settings) {
    const Json empty = Json::object();
    const Json& parameters = root.contains("parameters") ? root["parameters"] : empty;
    expect_object(parameters, "parameters");
    for (const auto& [name, value] : parameters.items()) {
      if (!is_identifier(name)) {
        fail("parameters", quoted(name) + " is not a name (letters, digits, underscores)");
      }
      if (is_reserved_name(name)) {
        fail("parameters", quoted(name) + " is the name of a function or constant");
      }
      parameter_names_.push_back(name);
    }
    for (const auto& [name, value] : parameters.items()) {
      const std::string where = "parameters." + name;
      SceneParameter parameter{name, {}, {}};
      if (value.is_object()) {
        expect_keys(value, where, {"value", "tolerance"});
        parameter.value = number(required(value, "value", where), where + ".value");
        if (value.contains("tolerance")) {
          parameter.tolerance = number(value["tolerance"], where + ".tolerance");
        }
      } else {
        parameter.value = number(value, where);
      }
      scene_.parameters.push_back(std::move(parameter));
    }
    for (const std::string& setting : settings) {
      const std::size_t equals = setting.find('=');
      const std::string name = setting.substr(0, equals);
      const int index = index_of(scene_.parameters, name);
      if (equals == std::string::npos) {
        fail("--set", "expected NAME=EXPR, found " + quoted(setting));
      }
      if (index < 0) {
        fail("--set", "no parameter named " + quoted(name) + suggestion(name, parameter_names_));
      }
      scene_.parameters[static_cast<std::size_t>(index)].value =
          number_of(setting.substr(equals + 1), "--set " + name);
    }
  }

  [[nodiscard]] SceneFeature feature(const std::string& name, const Json& value,
                                     const std::string& where) const {
    SceneFeature result;
    result.name = name;
    result.where = where;
    if (value.is_object()) {
      expect_keys(value, where, {"through", "along"});
      result.line = true;
      auto [x, y] = pair(required(value, "through", where), where + ".through");
      auto [dx, dy] = pair(required(value, "along", where), where + ".along");
      result.x = std::move(x);
      result.y = std::move(y);
      result.along_x = std::move(dx);
      result.along_y = std::move(dy);
    } else if (value.is_array()) {
      auto [x, y] = pair(value, where);
      result.x = std::move(x);
      result.y = std::move(y);
    } else {
      fail(where, R"(expected a point [x, y] or a line {"through": [x, y], "along": [dx, dy]})");
    }
    return result;
  }

  void read_links(const Json& root) {
    const Json& links = required(root, "links", "");
    expect_object(links, "links");
    for (const auto& [name, value] : links.items()) {
      const std::string where = "links." + name;
      if (name.empty() || name.find('.') != std::string::npos) {
        fail("links", quoted(name) + " is not a name: it is empty or has a dot");
      }
      expect_object(value, where);
      SceneLink link{name, {}};
      for (const auto& [feature_name, feature_value] : value.items()) {
        link.features.push_back(feature(feature_name, feature_value, where + "." + feature_name));
      }
      scene_.links.push_back(std::move(link));
    }
  }

  [[nodiscard]] FeatureReference reference(const Json& value, const std::string& where) const {
    const std::string text = text_of(value, where);
    const std::size_t dot = text.find('.');
    if (dot == std::string::npos) {
      fail(where, "expected 'link.feature', found " + quoted(text));
    }
    const std::string link_name = text.substr(0, dot);
    const std::string feature_name = text.substr(dot + 1);
    const int link = index_of(scene_.links, link_name);
    if (link < 0) {
      fail(where,
           "no link named " + quoted(link_name) + suggestion(link_name, names_of(scene_.links)));
    }
    const std::vector<SceneFeature>& features =
        scene_.links[static_cast<std::size_t>(link)].features;
    const int index = index_of(features, feature_name);
    if (index < 0) {
      fail(where, "link '" + link_name + "' has no feature " + quoted(feature_name) +
                      suggestion(feature_name, names_of(features)));
    }
    return {link, index};
  }

  void read_joints(const Json& root) {
    const Json& joints = required(root, "joints", "");
    expect_object(joints, "joints");
    const std::vector<std::string> types = {"revolute", "prismatic", "pin-in-slot"};
    for (const auto& [name, value] : joints.items()) {
      const std::string where = "joints." + name;
      expect_object(value, where);
      expect_keys(value, where, {"type", "between"});
      SceneJoint joint;
      joint.name = name;
      const std::string type = text_of(required(value, "type", where), where + ".type");
      const auto found = std::find(types.begin(), types.end(), type);
      if (found == types.end()) {
        fail(where + ".type", "no joint type " + quoted(type) + suggestion(type, types) +
                                  "; the types are revolute, prismatic, pin-in-slot");
      }
      joint.type = static_cast<SceneJointType>(found - types.begin());
      const Json& between = required(value, "between", where);
      if (!between.is_array() || between.size() < 2) {
        fail(where + ".between", "expected two or more features [\"link.feature\", ...]");
      }
      for (std::size_t index = 0; index < between.size(); ++index) {
        joint.between.push_back(
            reference(between[index], where + ".between[" + std::to_string(index) + "]"));
      }
      check_joint(joint, where + ".between");
      scene_.joints.push_back(std::move(joint));
    }
  }

  void check_joint(const SceneJoint& joint, const std::string& where) const {
    if (joint.type != SceneJointType::revolute && joint.between.size() != 2) {
      fail(where, "only a revolute joint may join more than two links");
    }
    int lines = 0;
    std::set<int> links;
    for (const FeatureReference& part : joint.between) {
      lines += scene_.feature(part).line ? 1 : 0;
      if (!links.insert(part.link).second) {
        fail(where, "link '" + scene_.links[static_cast<std::size_t>(part.link)].name +
                        "' stands twice in one joint");
      }
    }
    if (joint.type == SceneJointType::revolute && lines != 0) {
      fail(where, "a revolute joint joins points, and one of these features is a line");
    }
    if (joint.type == SceneJointType::prismatic && lines != 2) {
      fail(where, "a prismatic joint joins two lines, and one of these features is a point");
    }
    if (joint.type == SceneJointType::pin_in_slot && lines != 1) {
      fail(where, "a pin-in-slot joint joins a point and a line");
    }
  }

  void read_drivers(const Json& root) {
    if (!root.contains("drivers")) {
      return;
    }
    expect_object(root["drivers"], "drivers");
    for (const auto& [name, value] : root["drivers"].items()) {
      const std::string where = "drivers." + name;
      SceneDriver driver;
      driver.joint = index_of(scene_.joints, name);
      if (driver.joint < 0) {
        fail("drivers",
             "no joint named " + quoted(name) + suggestion(name, names_of(scene_.joints)));
      }
      expect_object(value, where);
      expect_keys(value, where, {"position", "velocity", "acceleration"});
      driver.position = number(required(value, "position", where), where + ".position");
      const Json zero = 0;
      driver.velocity =
          number(value.contains("velocity") ? value["velocity"] : zero, where + ".velocity");
      driver.acceleration = number(value.contains("acceleration") ? value["acceleration"] : zero,
                                   where + ".acceleration");
      scene_.drivers.push_back(std::move(driver));
    }
  }

  void read_outputs(const Json& root) {
    if (!root.contains("outputs")) {
      return;
    }
    expect_object(root["outputs"], "outputs");
    for (const auto& [name, value] : root["outputs"].items()) {
      const std::string where = "outputs." + name;
      const FeatureReference point = reference(value, where);
      if (scene_.feature(point).line) {
        fail(where, "an output is a point, and this feature is a line");
      }
      scene_.outputs.push_back({name, point});
    }
  }

  void read_want(const Json& root) {
    if (!root.contains("want")) {
      return;
    }
    if (!root["want"].is_array()) {
      fail("want", "expected a list of position, velocity, acceleration, sensitivity");
    }
    scene_.want = {false, false, false, false};
    const std::vector<std::string> known = {"position", "velocity", "acceleration", "sensitivity"};
    for (std::size_t index = 0; index < root["want"].size(); ++index) {
      const std::string where = "want[" + std::to_string(index) + "]";
      const std::string wish = text_of(root["want"][index], where);
      const std::array<bool*, 4> flags = {&scene_.want.position, &scene_.want.velocity,
                                          &scene_.want.acceleration, &scene_.want.sensitivity};
      const auto found = std::find(known.begin(), known.end(), wish);
      if (found == known.end()) {
        fail(where, "no such result " + quoted(wish) + suggestion(wish, known));
      }
      *flags[static_cast<std::size_t>(found - known.begin())] = true;
    }
  }

  void read_sweep(const Json& root) {
    if (!root.contains("sweep")) {
      return;
    }
    const Json& value = root["sweep"];
    expect_object(value, "sweep");
    expect_keys(value, "sweep", {"parameter", "from", "to", "count"});
    SceneSweep sweep;
    const std::string name = text_of(required(value, "parameter", "sweep"), "sweep.parameter");
    sweep.parameter = index_of(scene_.parameters, name);
    if (sweep.parameter < 0) {
      fail("sweep.parameter",
           "no parameter named " + quoted(name) + suggestion(name, parameter_names_));
    }
    sweep.from = number(required(value, "from", "sweep"), "sweep.from");
    sweep.to = number(required(value, "to", "sweep"), "sweep.to");
    const Json& count = required(value, "count", "sweep");
    if (!count.is_number_integer() || count.get<double>() < 1 || count.get<double>() > 1e7) {
      fail("sweep.count", "expected a whole number from 1 to 10000000");
    }
    sweep.count = count.get<int>();
    scene_.sweep = std::move(sweep);
  }

  void read_covariance(const Json& root) {
    if (!root.contains("covariance")) {
      return;
    }
    const Json& value = root["covariance"];
    expect_object(value, "covariance");
    expect_keys(value, "covariance", {"parameters", "matrix"});
    SceneCovariance covariance;
    const Json& parameters = required(value, "parameters", "covariance");
    if (!parameters.is_array() || parameters.empty()) {
      fail("covariance.parameters", "expected one or more names of parameters [\"AB\", ...]");
    }
    for (std::size_t index = 0; index < parameters.size(); ++index) {
      const std::string where = "covariance.parameters[" + std::to_string(index) + "]";
      const std::string name = text_of(parameters[index], where);
      const int parameter = index_of(scene_.parameters, name);
      if (parameter < 0) {
        fail(where, "no parameter named " + quoted(name) + suggestion(name, parameter_names_));
      }
      if (std::find(covariance.parameters.begin(), covariance.parameters.end(), parameter) !=
          covariance.parameters.end()) {
        fail(where, "the parameter " + quoted(name) + " stands twice");
      }
      covariance.parameters.push_back(parameter);
    }
    const Json& matrix = required(value, "matrix", "covariance");
    const std::string size = std::to_string(parameters.size());
    if (!matrix.is_array() || matrix.size() != parameters.size()) {
      fail("covariance.matrix", "expected a row for each of the parameters, " + size + " in all");
    }
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      const std::string where = "covariance.matrix[" + std::to_string(row) + "]";
      if (!matrix[row].is_array() || matrix[row].size() != parameters.size()) {
        fail(where, "expected a number for each of the parameters, " + size + " in all");
      }
      covariance.matrix.emplace_back();
      for (std::size_t column = 0; column < parameters.size(); ++column) {
        covariance.matrix.back().push_back(
            number(matrix[row][column], where + "[" + std::to_string(column) + "]"));
      }
    }
    scene_.covariance = std::move(covariance);
  }

  Scene scene_;
  std::vector<std::string> parameter_names_;
};

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file,
                  const std::vector<std::string>& settings) {
  return SceneReader(file).read(text, settings);
}

Scene read_scene(const std::string& file, const std::vector<std::string>& settings) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InputError(file + ": cannot be read (does it exist, and is it a file?)");
  }
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse_scene(text, file, settings);
}

}  // namespace assur::generator
