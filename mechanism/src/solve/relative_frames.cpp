#include "relative_frames.hpp"

#include <assur/directions.hpp>
#include <assur/support/rigid_motion.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

using Eigen::Vector2d;

/// The vector rotated by a quarter turn: the velocity of the point `arm` in a frame that rotates at
/// unit speed.
Vector2d across(const Vector2d& arm) { return {-arm.y(), arm.x()}; }

Vector2d place_of(const Pose<double>& pose) { return {pose.x, pose.y}; }

/// The second derivative of c = R(-theta) d along i and j, from that of d and from first
/// derivatives: R(-theta) d_ij - theta_ij J c - theta_i J c_j - theta_j J c_i + theta_i theta_j c,
/// where J is a quarter turn.
Vector2d seen_twice(const Vector2d& d, double turn, const Vector2d& c, double turn_i,
                    const Vector2d& c_i, double turn_j, const Vector2d& c_j) {
  return d - turn * across(c) - turn_i * across(c_j) - turn_j * across(c_i) + turn_i * turn_j * c;
}

}  // namespace

Frame seen_from(const Frame& one, const Frame& other) {
  const Direction<double> back = reversed(one.pose.direction);
  const auto turned_back = [&](const Vector2d& v) { return support::rotated<double>(back, v); };
  const Vector2d c = turned_back(place_of(other.pose) - place_of(one.pose));
  Frame result;
  result.pose = {c.x(), c.y(), turned(other.pose.direction, back)};
  const auto rate = [&](const Eigen::Vector3d& of_one, const Eigen::Vector3d& of_other) {
    const Eigen::Vector3d apart = of_other - of_one;
    Eigen::Vector3d seen;
    seen << turned_back(apart.head<2>()) - of_one(2) * across(c), apart(2);
    return seen;
  };
  result.velocity = rate(one.velocity, other.velocity);
  const Eigen::Vector3d apart = other.acceleration - one.acceleration;
  const double omega = one.velocity(2);
  const Vector2d velocity = result.velocity.head<2>();
  result.acceleration << seen_twice(turned_back(apart.head<2>()), one.acceleration(2), c, omega,
                                    velocity, omega, velocity),
      apart(2);
  const Derivatives<3>& of_one = one.follows;
  const Derivatives<3>& of_other = other.follows;
  const Eigen::Index count = of_one.first.cols();
  result.follows.set_zero(count, of_one.has_second());
  for (Eigen::Index i = 0; i < count; ++i) {
    result.follows.first.col(i) = rate(of_one.first.col(i), of_other.first.col(i));
  }
  for (Eigen::Index i = 0; of_one.has_second() && i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto between = [&](std::size_t row) {
        return of_other.second[row](i, j) - of_one.second[row](i, j);
      };
      const Vector2d second =
          seen_twice(turned_back({between(0), between(1)}), of_one.second[2](i, j), c,
                     of_one.first(2, i), result.follows.first.col(i).head<2>(), of_one.first(2, j),
                     result.follows.first.col(j).head<2>());
      result.follows.second[0](i, j) = second.x();
      result.follows.second[1](i, j) = second.y();
      result.follows.second[2](i, j) = between(2);
    }
  }
  return result;
}

SlideFeatures features_of_slide(const Mechanism& mechanism, JointIndex slide) {
  const std::vector<FeatureIndex>& between = mechanism.joints()[slide].between;
  const bool is_line_first = mechanism.features()[between[0]].is_line;
  return {between[is_line_first ? 0 : 1], between[is_line_first ? 1 : 0]};
}

SlideState measured_slide(const Values& values, const Table<LinkIndex, Frame>& links,
                          JointIndex slide) {
  const Mechanism& mechanism = values.plan().mechanism;
  const auto placed = [&](FeatureIndex feature) {
    return composed(links[mechanism.features()[feature].link], values.frame(feature));
  };
  const auto [line, other] = features_of_slide(mechanism, slide);
  const Frame along = seen_from(placed(line), placed(other));
  SlideState state;
  state.joint = slide;
  state.displacement = along.pose.x;
  state.velocity = along.velocity(0);
  state.acceleration = along.acceleration(0);
  state.follows.first = along.follows.first.row(0);
  if (along.follows.has_second()) {
    state.follows.second = {along.follows.second[0]};
  }
  return state;
}

}  // namespace assur::mechanism::solve
