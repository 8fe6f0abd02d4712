#include "limits.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <cmath>
#include <numbers>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// A limit counts as kept where rounding may have moved the coordinate beyond it.
constexpr double rounding = 1e-12;

bool is_between(double lowest, double coordinate, double highest) {
  const double slack = rounding * std::max({1.0, std::abs(lowest), std::abs(highest)});
  return lowest - slack <= coordinate && coordinate <= highest + slack;
}

/// Whether an angle, turned by whole turns, lies between two others.
bool is_turned_between(double lowest, double angle, double highest) {
  constexpr double turn = 2 * std::numbers::pi;
  const double slack = rounding * std::max({1.0, std::abs(lowest), std::abs(highest)});
  const double first = angle + turn * std::ceil((lowest - slack - angle) / turn);
  return first <= highest + slack;
}

/// Above -pi, and not at it by what rounding leaves of half a turn: a law that reads the angle says
/// the same however the links are listed.
double whole_angle(const Direction<double>& direction) {
  constexpr double negligible = 1e-9;
  const double angle = angle_of(direction);
  return angle < negligible - std::numbers::pi ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

JointMotion coordinate_of(const Values& values, const Table<LinkIndex, Frame>& links,
                          const std::vector<SlideState>& slides, JointIndex index) {
  const Mechanism& mechanism = values.plan().mechanism;
  const Joint& joint = mechanism.joints()[index];
  if (joint.type == JointType::revolute) {
    const Frame& one = links[mechanism.features()[joint.between[0]].link];
    const Frame& other = links[mechanism.features()[joint.between[1]].link];
    const Eigen::VectorXd first =
        (other.follows.first.row(2) - one.follows.first.row(2)).transpose();
    Eigen::MatrixXd second;
    if (values.second_order()) {
      second = other.follows.second[2] - one.follows.second[2];
    }
    return {
        {whole_angle(turned(other.pose.direction, reversed(one.pose.direction))), first, second},
        other.velocity(2) - one.velocity(2),
        other.acceleration(2) - one.acceleration(2)};
  }
  const SlideState& slide = *std::ranges::find(slides, index, &SlideState::joint);
  Eigen::MatrixXd second;
  if (values.second_order()) {
    second = slide.follows.second[0];
  }
  return {{slide.displacement, slide.follows.first.row(0).transpose(), second},
          slide.velocity,
          slide.acceleration};
}

bool keeps_limits(const Values& values, const Table<LinkIndex, Frame>& links,
                  const std::vector<SlideState>& slides, JointIndex index) {
  const Mechanism& mechanism = values.plan().mechanism;
  const Joint& joint = mechanism.joints()[index];
  if (!joint.lowest.exists()) {
    return true;
  }
  const DriverIndex driver = mechanism.driver_of(index);
  const JointMotion motion =
      driver.exists() ? values.motion(driver) : coordinate_of(values, links, slides, index);
  const auto keeps = joint.type == JointType::revolute ? is_turned_between : is_between;
  return keeps(values.number(joint.lowest).value(), motion.position.value(),
               values.number(joint.highest).value());
}

}  // namespace assur::mechanism::solve
