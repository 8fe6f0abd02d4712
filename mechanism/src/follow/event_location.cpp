#include "event_location.hpp"

#include <cmath>
#include <limits>

namespace assur::mechanism::follow {

Configuration unknown_configuration(const Plan& plan) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<Eigen::Index>(plan.values().columns().size());
  Frame link;
  link.pose = {unknown, unknown, {unknown, unknown}};
  link.velocity.setConstant(unknown);
  link.acceleration.setConstant(unknown);
  link.follows.first.setConstant(3, count, unknown);
  Point point;
  point.position.setConstant(unknown);
  point.velocity.setConstant(unknown);
  point.acceleration.setConstant(unknown);
  point.follows.first.setConstant(2, count, unknown);
  if (plan.values().second_order()) {
    const Eigen::MatrixXd blank = Eigen::MatrixXd::Constant(count, count, unknown);
    link.follows.second.assign(3, blank);
    point.follows.second.assign(2, blank);
  }
  Configuration configuration;
  configuration.links.assign(plan.mechanism().links().size(), link);
  configuration.outputs.assign(plan.mechanism().outputs().size(), point);
  configuration.regularity = Status::near_singular;
  configuration.residual = unknown;
  return configuration;
}

Eigen::VectorXd weights_at_zero(const Eigen::VectorXd& nodes) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(nodes.size());
  for (Eigen::Index one = 0; one < nodes.size(); ++one) {
    for (Eigen::Index other = 0; other < nodes.size(); ++other) {
      if (one != other) {
        weights(one) *= nodes(other) / (nodes(other) - nodes(one));
      }
    }
  }
  return weights;
}

Blend::Blend(const Plan& plan) : sum_(unknown_configuration(plan)) {
  for (Frame& link : sum_.links) {
    link.pose = {0, 0, {0, 0}};
  }
  for (Point& point : sum_.outputs) {
    point.position.setZero();
  }
  sum_.residual = 0;
}

void Blend::add(const Configuration& configuration, double weight) {
  for (const LinkIndex link : sum_.links.keys()) {
    Pose<double>& total = sum_.links[link].pose;
    const Pose<double>& part = configuration.links[link].pose;
    total.x += weight * part.x;
    total.y += weight * part.y;
    total.direction.cos += weight * part.direction.cos;
    total.direction.sin += weight * part.direction.sin;
  }
  for (const OutputIndex output : sum_.outputs.keys()) {
    sum_.outputs[output].position += weight * configuration.outputs[output].position;
  }
}

Configuration Blend::result() const {
  Configuration blended = sum_;
  for (Frame& link : blended.links) {
    Direction<double>& direction = link.pose.direction;
    const double length = std::hypot(direction.cos, direction.sin);
    direction = {direction.cos / length, direction.sin / length};
  }
  return blended;
}

PointIndex nearest(const Snapshot& set, const Eigen::VectorXd& place) {
  PointIndex best;
  double least = std::numeric_limits<double>::infinity();
  for (const PointIndex point : set.points.keys()) {
    const double distance = (set.points[point].at - place).norm();
    if (distance < least) {
      least = distance;
      best = point;
    }
  }
  return best;
}

}  // namespace assur::mechanism::follow
