#include "scene/scene.hpp"

#include "error.hpp"
#include "input_file.hpp"
#include "scene/scene_parts.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

namespace {

void read_parameters(const SceneJson& root, JsonValues& values, Scene& scene) {
  const SceneJson empty = SceneJson::object();
  const SceneJson& parameters = root.contains("parameters") ? root["parameters"] : empty;
  values.expect_object(parameters, "parameters");
  for (const auto& [name, value] : parameters.items()) {
    if (!is_identifier(name)) {
      values.fail("parameters", quoted(name) + " is not a name (letters, digits, underscores)");
    }
    if (is_reserved_name(name)) {
      values.fail("parameters", quoted(name) + " is the name of a function or constant");
    }
    values.add_parameter(name);
  }
  for (const auto& [name, value] : parameters.items()) {
    const std::string where = "parameters." + name;
    SceneParameter parameter{name, {}, {}};
    if (value.is_object()) {
      values.expect_keys(value, where, {"value", "tolerance"});
      parameter.value = values.number(values.required(value, "value", where), where + ".value");
      if (value.contains("tolerance")) {
        parameter.tolerance = values.number(value["tolerance"], where + ".tolerance");
      }
    } else {
      parameter.value = values.number(value, where);
    }
    scene.parameters.push_back(std::move(parameter));
  }
}

void apply_settings(const std::vector<std::string>& settings, const JsonValues& values,
                    Scene& scene) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const int index = index_of(scene.parameters, name);
    if (equals == std::string::npos) {
      values.fail("--set", "expected NAME=EXPR, found " + quoted(setting));
    }
    if (index < 0) {
      values.fail("--set", "no parameter named " + quoted(name) +
                               suggestion(name, values.parameter_names()));
    }
    scene.parameters[static_cast<std::size_t>(index)].value =
        values.number_of(setting.substr(equals + 1), "--set " + name);
  }
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file,
                  const std::vector<std::string>& settings) {
  Scene scene;
  scene.file = file;
  JsonValues values(file);
  const SceneJson root = values.parsed(text);
  values.expect_object(root, "");
  values.expect_keys(root, "",
                     {"name", "parameters", "links", "joints", "drivers", "outputs", "want",
                      "sweep", "covariance"});
  if (root.contains("name")) {
    scene.name = values.text_of(root["name"], "name");
  }
  read_parameters(root, values, scene);
  apply_settings(settings, values, scene);
  read_linkage(root, values, scene);
  read_requests(root, values, scene);
  return scene;
}

Scene read_scene(const std::string& file, const std::vector<std::string>& settings) {
  return parse_scene(read_input_file(file), file, settings);
}

}  // namespace assur::generator
