#include "closure_error.hpp"

#include <algorithm>
#include <cmath>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

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

double closure_error(const Values& values, const Configuration& configuration, double length) {
  const Mechanism& mechanism = values.plan().mechanism;
  const auto placed = [&](FeatureIndex index) {
    const Feature& feature = mechanism.features()[index];
    const Frame world = composed(configuration.links[feature.link], values.frame(index));
    return WorldFeature{feature.is_line,
                        {world.pose.x, world.pose.y},
                        {world.pose.direction.cos, world.pose.direction.sin}};
  };
  double largest = 0;
  for (const Joint& joint : mechanism.joints()) {
    const WorldFeature first = placed(joint.between[0]);
    for (std::size_t index = 1; index < joint.between.size(); ++index) {
      largest = std::max(largest, miss(first, placed(joint.between[index]), length));
    }
  }
  return largest;
}

}  // namespace assur::mechanism::solve
