#include "audit/scene_values.hpp"

#include <algorithm>

#include "error.hpp"
#include "scene/parameters.hpp"
#include "scene/report_values.hpp"
#include "scene/solve.hpp"

namespace assur::generator {

namespace {

Scene scene_with(const std::string& file, const std::vector<std::string>& settings) {
  const Scene as_written = read_scene(file, {});
  std::vector<std::string> its_own;
  for (const std::string& setting : settings) {
    const std::string name = setting.substr(0, setting.find('='));
    const bool has = std::any_of(as_written.parameters.begin(), as_written.parameters.end(),
                                 [&](const SceneParameter& one) { return one.name == name; });
    if (has) {
      its_own.push_back(setting);
    }
  }
  return read_scene(file, its_own);
}

}  // namespace

std::map<std::string, double> scene_values(const std::string& file, int configuration,
                                           const std::vector<std::string>& settings) {
  const Scene scene = scene_with(file, settings);
  const Solution solution = solve(scene, ParameterValues(scene));
  if (configuration < 1 || configuration > static_cast<int>(solution.configurations.size())) {
    throw InputError(file + ": no configuration " + std::to_string(configuration) + "; there are " +
                     std::to_string(solution.configurations.size()));
  }
  const AssemblyConfiguration& found =
      solution.configurations[static_cast<std::size_t>(configuration - 1)];
  std::map<std::string, double> values;
  const auto add = [&](const std::string& name, const auto& state) {
    values[name + "_x"] = state.x.value();
    values[name + "_y"] = state.y.value();
    values[name + "_vx"] = state.velocity(0);
    values[name + "_vy"] = state.velocity(1);
    values[name + "_ax"] = state.acceleration(0);
    values[name + "_ay"] = state.acceleration(1);
  };
  for (std::size_t link = 0; link < scene.links.size(); ++link) {
    const std::string& name = scene.links[link].name;
    const LinkState& state = found.links[link];
    add(name, state);
    values[name + "_theta"] = angle(state.direction);
    values[name + "_omega"] = state.velocity(2);
    values[name + "_alpha"] = state.acceleration(2);
  }
  for (std::size_t output = 0; output < scene.outputs.size(); ++output) {
    add(scene.outputs[output].name, found.outputs[output]);
  }
  for (const JointState& joint : found.joints) {
    values[joint.name + "_displacement"] = joint.displacement.value();
    values[joint.name + "_velocity"] = joint.velocity;
    values[joint.name + "_acceleration"] = joint.acceleration;
  }
  return values;
}

}  // namespace assur::generator
