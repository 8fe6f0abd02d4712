#include "scene/closure_error.hpp"

#include <algorithm>
#include <cmath>

namespace assur::generator {

namespace {

struct WorldFeature {
  bool line;
  Eigen::Vector2d point;
  Eigen::Vector2d along;
};

double across(const WorldFeature& line, const WorldFeature& other) {
  const Eigen::Vector2d arm = other.point - line.point;
  return std::abs(line.along.x() * arm.y() - line.along.y() * arm.x());
}

double miss(const WorldFeature& one, const WorldFeature& other, double length) {
  if (one.line && other.line) {
    const double sine = one.along.x() * other.along.y() - one.along.y() * other.along.x();
    return std::max({across(one, other), across(other, one), std::abs(sine) * length});
  }
  if (one.line || other.line) {
    return one.line ? across(one, other) : across(other, one);
  }
  return (one.point - other.point).norm();
}

}  // namespace

double closure_error(const Scene& scene, const ParameterValues& values,
                     const AssemblyConfiguration& configuration, double length) {
  const auto placed = [&](const FeatureReference& reference) {
    const SceneFeature& feature = scene.feature(reference);
    const LinkState& link = configuration.links[static_cast<std::size_t>(reference.link)];
    const double cosine = link.direction.cos.value();
    const double sine = link.direction.sin.value();
    const auto turned = [&](const SceneNumber& x, const SceneNumber& y) -> Eigen::Vector2d {
      const double local_x = values.value(x).value();
      const double local_y = values.value(y).value();
      return {cosine * local_x - sine * local_y, sine * local_x + cosine * local_y};
    };
    const Eigen::Vector2d origin(link.x.value(), link.y.value());
    WorldFeature world{feature.line, origin + turned(feature.x, feature.y),
                       Eigen::Vector2d::Zero()};
    if (feature.line) {
      world.along = turned(feature.along_x, feature.along_y).stableNormalized();
    }
    return world;
  };
  double largest = 0;
  for (const SceneJoint& joint : scene.joints) {
    const WorldFeature first = placed(joint.between[0]);
    for (std::size_t index = 1; index < joint.between.size(); ++index) {
      largest = std::max(largest, miss(first, placed(joint.between[index]), length));
    }
  }
  return largest;
}

}  // namespace assur::generator
