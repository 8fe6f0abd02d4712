#include "emission/solver_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "emission/scene_names.hpp"

namespace assur::generator {

namespace {

/// Those that have a tolerance, all if none has, and none if no sensitivity is wanted.
ModelledParameters modelled_parameters(const Scene& scene) {
  const bool any =
      std::any_of(scene.parameters.begin(), scene.parameters.end(),
                  [](const SceneParameter& parameter) { return parameter.tolerance.has_value(); });
  std::vector<int> indices;
  std::vector<std::string> names;
  for (std::size_t index = 0; index < scene.parameters.size(); ++index) {
    const SceneParameter& parameter = scene.parameters[index];
    if (scene.want.sensitivity && (parameter.tolerance.has_value() || !any)) {
      indices.push_back(static_cast<int>(index));
      names.push_back(parameter.name);
    }
  }
  return {indices, names};
}

template <typename Items, typename Name>
std::vector<std::string> members_of(const Items& items, const std::vector<std::string>& taken,
                                    Name name) {
  std::vector<std::string> names;
  std::transform(items.begin(), items.end(), std::back_inserter(names), name);
  return member_names(names, taken);
}

SceneMembers scene_members(const Scene& scene) {
  const auto name = [](const auto& item) { return item.name; };
  SceneMembers members;
  members.joints = members_of(scene.joints, {}, name);
  // In what is placed so far, slides and other things stand among the links.
  std::vector<std::string> taken = {"order", "regularity", "residual", "displaced"};
  for (const std::string& member : members.joints) {
    taken.push_back("slide_" + member);
  }
  members.links = members_of(scene.links, taken, name);
  members.drivers = members_of(scene.drivers, {}, [&](const SceneDriver& driver) {
    return scene.joints[static_cast<std::size_t>(driver.joint)].name;
  });
  members.outputs = members_of(scene.outputs, {}, name);
  return members;
}

}  // namespace

SolverScene::SolverScene(const Scene& described)
    : scene(described),
      values(described),
      order(placement_order(described, values)),
      parameters(modelled_parameters(described)),
      members(scene_members(described)),
      derivative_order(described.want.acceleration ? 2
                       : described.want.velocity   ? 1
                                                   : 0),
      file(std::filesystem::path(described.file).filename().string()),
      structure(struct_name(std::filesystem::path(described.file).stem().string())) {}

}  // namespace assur::generator
