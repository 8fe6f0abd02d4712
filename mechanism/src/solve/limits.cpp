#include "limits.hpp"

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/support/limits.hpp>
#include <assur/text/names.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "plan/plan_data.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

/// The angle in (-pi, pi]. An angle that is -pi up to rounding becomes pi, so that a law that reads
/// it has the same value however the links are listed.
double whole_angle(const Direction<double>& direction) {
  constexpr double negligible = 1e-9;
  const double angle = angle_of(direction);
  return angle < negligible - std::numbers::pi ? angle + 2 * std::numbers::pi : angle;
}

/// The excess of a joint beyond its limits, such as `B by 3.5 deg`.
std::string excess_text(const Joint& joint, double excess) {
  const bool turns = joint.type == JointType::revolute;
  std::array<char, 40> by{};
  (void)std::snprintf(by.data(), by.size(), turns ? "%.3g deg" : "%.3g",
                      turns ? excess * 180 / std::numbers::pi : excess);
  return joint.name + " by " + by.data();
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
  const auto listed = std::ranges::find(slides, index, &SlideState::joint);
  std::optional<SlideState> measured;
  if (listed == slides.end()) {  // a second pin in a slot, which no group measures
    measured = measured_slide(values, links, index);
  }
  const SlideState& slide = measured ? *measured : *listed;
  Eigen::MatrixXd second;
  if (values.second_order()) {
    second = slide.follows.second[0];
  }
  return {{slide.displacement, slide.follows.first.row(0).transpose(), second},
          slide.velocity,
          slide.acceleration};
}

double beyond_limits(const Values& values, const Table<LinkIndex, Frame>& links,
                     const std::vector<SlideState>& slides, JointIndex index) {
  const Mechanism& mechanism = values.plan().mechanism;
  const Joint& joint = mechanism.joints()[index];
  const DriverIndex driver = mechanism.driver_of(index);
  const JointMotion motion =
      driver.exists() ? values.motion(driver) : coordinate_of(values, links, slides, index);
  const double at = motion.position.value();
  const double lowest = values.number(joint.lowest).value();
  const double highest = values.number(joint.highest).value();
  if (joint.type != JointType::revolute) {
    return support::is_between(lowest, at, highest) ? 0 : std::max(lowest - at, at - highest);
  }
  if (support::is_turned_between(lowest, at, highest)) {
    return 0;
  }
  constexpr double turn = 2 * std::numbers::pi;
  const double above = at + turn * std::ceil((lowest - at) / turn);
  return std::min(above - highest, lowest - (above - turn));
}

}  // namespace assur::mechanism::solve

namespace assur::mechanism {

void add_breach(const LimitBreach& breach, std::vector<LimitBreach>& breaches) {
  const auto same = std::ranges::find(breaches, breach.joint, &LimitBreach::joint);
  if (same == breaches.end()) {
    breaches.push_back(breach);
    return;
  }
  same->configurations += breach.configurations;
  same->least = std::min(same->least, breach.least);
}

std::string excesses_text(const Mechanism& mechanism,
                          const std::vector<NearestToLimits::Excess>& excesses) {
  return text::joined(excesses, ", ", [&](const NearestToLimits::Excess& excess) {
    return solve::excess_text(mechanism.joints()[excess.joint], excess.by);
  });
}

std::string breaches_text(const Mechanism& mechanism, const std::vector<LimitBreach>& breaches) {
  return text::joined(breaches, ", ", [&](const LimitBreach& breach) {
    return solve::excess_text(mechanism.joints()[breach.joint], breach.least) + " at least";
  });
}

}  // namespace assur::mechanism
