#include "audit/scene/scene_values.hpp"

#include <assur/directions.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <iterator>

namespace assur::generator::audit::scene {

namespace {

mechanism::Scene scene_with(const std::string& file, const std::vector<std::string>& settings) {
  const mechanism::Scene as_written = mechanism::read_scene(file);
  std::vector<std::string> its_own;
  for (const std::string& setting : settings) {
    const std::string name = setting.substr(0, setting.find('='));
    if (index_of(as_written.mechanism.parameters(), name).exists()) {
      its_own.push_back(setting);
    }
  }
  return mechanism::read_scene(file, its_own);
}

}  // namespace

std::map<std::string, double> scene_values(const std::string& file, int configuration,
                                           const std::vector<std::string>& settings) {
  const mechanism::Plan plan(scene_with(file, settings));
  const mechanism::Solution solution = plan.solve(plan.values());
  if (configuration < 1 || configuration > std::ssize(solution.configurations)) {
    throw text::InputError(file + ": " +
                           mechanism::no_configuration(static_cast<std::size_t>(configuration),
                                                       solution.configurations.size()));
  }
  const mechanism::Configuration& found =
      *std::next(solution.configurations.begin(), configuration - 1);
  std::map<std::string, double> values;
  const auto add = [&](const std::string& name, double x, double y, const auto& velocity,
                       const auto& acceleration) {
    values[name + "_x"] = x;
    values[name + "_y"] = y;
    values[name + "_vx"] = velocity(0);
    values[name + "_vy"] = velocity(1);
    values[name + "_ax"] = acceleration(0);
    values[name + "_ay"] = acceleration(1);
  };
  const mechanism::Mechanism& mechanism = plan.mechanism();
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    const std::string& name = mechanism.links()[link].name;
    const mechanism::Frame& frame = found.links[link];
    add(name, frame.pose.x, frame.pose.y, frame.velocity, frame.acceleration);
    values[name + "_theta"] = angle_of(frame.pose.direction);
    values[name + "_omega"] = frame.velocity(2);
    values[name + "_alpha"] = frame.acceleration(2);
  }
  for (const mechanism::OutputIndex output : mechanism.outputs().keys()) {
    const mechanism::Point& point = found.outputs[output];
    add(mechanism.outputs()[output].name, point.position.x(), point.position.y(), point.velocity,
        point.acceleration);
  }
  for (const mechanism::SlideState& slide : found.slides) {
    const std::string& name = mechanism.joints()[slide.joint].name;
    values[name + "_displacement"] = slide.displacement;
    values[name + "_velocity"] = slide.velocity;
    values[name + "_acceleration"] = slide.acceleration;
  }
  return values;
}

}  // namespace assur::generator::audit::scene
