#include "scene/report_values.hpp"

#include <cmath>
#include <limits>

namespace assur::generator {

const char* status_text(SolutionStatus status) {
  switch (status) {
    case SolutionStatus::ok:
      return "ok";
    case SolutionStatus::no_assembly:
      return "no-assembly";
    case SolutionStatus::degenerate:
      return "degenerate";
  }
  return "unknown";
}

const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

double angle(const Direction<Dual>& direction) {
  return std::atan2(direction.sin.value(), direction.cos.value());
}

double worst_case(const Dual& coordinate, const Eigen::VectorXd& tolerances) {
  return coordinate.derivatives().cwiseAbs().dot(tolerances);
}
double root_sum_square(const Dual& coordinate, const Eigen::VectorXd& tolerances) {
  return coordinate.derivatives().cwiseProduct(tolerances).norm();
}

PathAcceleration path_acceleration(const PointState& point) {
  const double speed = std::hypot(point.velocity.x(), point.velocity.y());
  if (speed == 0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  const Eigen::Vector2d along = point.velocity / speed;
  const Eigen::Vector2d& a = point.acceleration;
  return {along.dot(a), along.x() * a.y() - along.y() * a.x()};
}

}  // namespace assur::generator
