#include "scene/mechanism.hpp"

#include <algorithm>

#include "error.hpp"

namespace assur::generator {

namespace {

LinkFeature<Dual> local_feature(const Scene& scene, const SceneFeature& feature,
                                const ParameterValues& values) {
  LinkFeature<Dual> result;
  result.line = feature.line;
  result.x = values.value(feature.x);
  result.y = values.value(feature.y);
  result.along = {values.constant(1.0), values.constant(0.0)};
  if (feature.line) {
    const Dual dx = values.value(feature.along_x);
    const Dual dy = values.value(feature.along_y);
    // Scaled first, so that no length overflows or underflows when squared.
    const double scale = std::max(std::abs(dx.value()), std::abs(dy.value()));
    if (scale == 0) {
      throw InputError(scene.file + ": " + feature.where +
                       ".along: a direction [0, 0] has no sense");
    }
    const Dual unit_x = dx / scale;
    const Dual unit_y = dy / scale;
    const Dual length = sqrt(unit_x * unit_x + unit_y * unit_y);
    result.along = {unit_x / length, unit_y / length};
  }
  return result;
}

}  // namespace

Mechanism mechanism_of(const Scene& scene, const ParameterValues& values) {
  Mechanism mechanism;
  for (const SceneLink& link : scene.links) {
    if (link.name == "ground") {
      mechanism.ground = static_cast<int>(mechanism.links.size());
    }
    mechanism.links.push_back(link.name);
  }
  const auto local = [&](const FeatureReference& reference) {
    return local_feature(scene, scene.feature(reference), values);
  };
  for (std::size_t index = 0; index < scene.joints.size(); ++index) {
    const SceneJoint& joint = scene.joints[index];
    const auto number = static_cast<int>(index);
    if (joint.type == SceneJointType::pin_in_slot) {
      const bool line_first = scene.feature(joint.between[0]).line;
      const FeatureReference& line = joint.between[line_first ? 0 : 1];
      const FeatureReference& pin = joint.between[line_first ? 1 : 0];
      const auto block = static_cast<int>(mechanism.links.size());
      mechanism.links.push_back(joint.name);
      LinkFeature<Dual> centre;
      centre.x = values.constant(0.0);
      centre.y = values.constant(0.0);
      centre.along = {values.constant(1.0), values.constant(0.0)};
      LinkFeature<Dual> axis = centre;
      axis.line = true;
      mechanism.joints.push_back({joint.name, number, true, line.link, block, local(line), axis});
      mechanism.joints.push_back({joint.name, number, false, pin.link, block, local(pin), centre});
      continue;
    }
    if (joint.between.size() > 2) {
      MechanismPin pin{joint.name, number, {}, {}};
      for (const FeatureReference& reference : joint.between) {
        pin.links.push_back(reference.link);
        pin.features.push_back(local(reference));
      }
      mechanism.pins.push_back(std::move(pin));
      continue;
    }
    mechanism.joints.push_back({joint.name, number, joint.type == SceneJointType::prismatic,
                                joint.between[0].link, joint.between[1].link,
                                local(joint.between[0]), local(joint.between[1])});
  }
  return mechanism;
}

}  // namespace assur::generator
