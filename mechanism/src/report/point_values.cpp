// Worst case, root sum square, spread and path acceleration of a point.
#include <assur/mechanism/point_values.hpp>
#include <cmath>
#include <limits>

namespace assur::mechanism::report {

namespace {

void expect_derivatives(const Point& point, const Spread& spread) {
  if (point.follows.first.cols() != spread.tolerances.size()) {
    throw MechanismError("",
                         "the point has no derivatives with respect to the parameters; let the "
                         "request want sensitivities");
  }
}

/// The deviations due to the tolerances; a derivative may be unknown if its tolerance is zero.
Eigen::Matrix2Xd by_tolerances(const Point& point, const Spread& spread) {
  Eigen::Matrix2Xd result = point.follows.first * spread.tolerances.asDiagonal();
  for (Eigen::Index column = 0; column < result.cols(); ++column) {
    if (spread.tolerances(column) == 0) {
      result.col(column).setZero();
    }
  }
  return result;
}

}  // namespace

}  // namespace assur::mechanism::report

namespace assur::mechanism {

Eigen::Vector2d worst_case(const Point& point, const Spread& spread) {
  report::expect_derivatives(point, spread);
  return report::by_tolerances(point, spread).cwiseAbs().rowwise().sum();
}

Eigen::Vector2d root_sum_square(const Point& point, const Spread& spread) {
  report::expect_derivatives(point, spread);
  return report::by_tolerances(point, spread).rowwise().norm();
}

PointSpread spread_of(const Point& point, const Spread& spread) {
  report::expect_derivatives(point, spread);
  if (!point.follows.has_second() || spread.covariance.size() == 0) {
    throw MechanismError("", "the point has no second derivatives; give the request a covariance");
  }
  const auto& sensitivity = point.follows.first;
  const Eigen::Matrix2d product = sensitivity * spread.covariance * sensitivity.transpose();
  PointSpread result;
  result.covariance = (product + product.transpose()) / 2;  // symmetric to the last digit
  for (Eigen::Index row = 0; row < 2; ++row) {
    const Eigen::MatrixXd& second = point.follows.second[static_cast<std::size_t>(row)];
    result.mean_shift(row) = 0.5 * spread.covariance.cwiseProduct(second).sum();
  }
  return result;
}

PathAcceleration path_acceleration(const Point& point) {
  const double speed = std::hypot(point.velocity.x(), point.velocity.y());
  if (speed == 0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  const Eigen::Vector2d along = point.velocity / speed;
  const Eigen::Vector2d& a = point.acceleration;
  return {along.dot(a), along.x() * a.y() - along.y() * a.x()};
}

}  // namespace assur::mechanism
