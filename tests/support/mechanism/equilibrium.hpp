// Residual of the equilibrium of every link under given forces: three equations a link, written
// down from joints and loads one by one.
#pragma once

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/mechanism.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace assur::test {

/// The sums of forces and moments on each link, about the ground's origin. With nothing left out,
/// they vanish on links that move, and are the resultant on the ground.
class LinkSums {
 public:
  using Vector = Eigen::Vector2d;
  using LinkIndex = mechanism::LinkIndex;
  using FeatureIndex = mechanism::FeatureIndex;
  using JointIndex = mechanism::JointIndex;

  LinkSums(const mechanism::Mechanism& mechanism, const mechanism::Values& values,
           const mechanism::Configuration& configuration, const mechanism::Forces& forces)
      : mechanism_(mechanism), values_(values), configuration_(configuration) {
    sums_.assign(mechanism.links().size(), Eigen::Vector3d::Zero());
    add_masses();
    add_loads();
    add_springs();
    add_joints(forces);
    add_efforts(forces);
  }

  [[nodiscard]] const Eigen::Vector3d& on(LinkIndex link) const { return sums_[link]; }
  /// The largest force or moment that was added.
  [[nodiscard]] double largest() const { return largest_; }
  /// The largest part of a slide's or slot's force along its line.
  [[nodiscard]] double along_lines() const { return along_lines_; }

 private:
  [[nodiscard]] double number(mechanism::NumberIndex number) const {
    return number.exists()
               ? mechanism_.numbers()[number].formula.evaluate<double>(
                     [&](mechanism::ParameterIndex at) { return values_.parameter(at); },
                     [&](JointIndex joint) { return coordinate(joint); })
               : 0;
  }
  [[nodiscard]] Vector turned(LinkIndex link, const Vector& v) const {
    const auto& [c, s] = configuration_.links[link].pose.direction;
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }
  [[nodiscard]] Vector at(LinkIndex link, const Vector& place) const {
    const auto& pose = configuration_.links[link].pose;
    return Vector(pose.x, pose.y) + turned(link, place);
  }
  [[nodiscard]] LinkIndex link_of(FeatureIndex feature) const {
    return mechanism_.features()[feature].link;
  }
  [[nodiscard]] Vector at(FeatureIndex feature) const {
    const auto& of = mechanism_.features()[feature];
    return at(of.link, {number(of.x), number(of.y)});
  }
  /// A number after some time, in which parameters have moved; zero if it does not exist.
  [[nodiscard]] double moved(mechanism::NumberIndex index, double time) const {
    return index.exists() ? mechanism_.numbers()[index].formula.evaluate<double>(
                                [&](mechanism::ParameterIndex at) {
                                  const mechanism::Dual& rate = values_.in_time(at);
                                  double value = values_.parameter(at);
                                  if (rate.derivatives().size() > 0) {
                                    value += time * rate.derivatives()(0);
                                  }
                                  if (rate.has_hessian()) {
                                    value += time * time / 2 * rate.hessian()(0, 0);
                                  }
                                  return value;
                                })
                          : 0;
  }
  /// The velocity of a point of a link, on which parameters may move it.
  [[nodiscard]] Vector velocity_at(FeatureIndex feature) const {
    const auto& of = mechanism_.features()[feature];
    constexpr double step = 1e-5;  // squared, it is rounding
    const Vector own((moved(of.x, step) - moved(of.x, -step)) / (2 * step),
                     (moved(of.y, step) - moved(of.y, -step)) / (2 * step));
    const Vector arm = turned(of.link, {number(of.x), number(of.y)});
    const Eigen::Vector3d& v = configuration_.links[of.link].velocity;
    return v.head<2>() + v(2) * Vector(-arm.y(), arm.x()) + turned(of.link, own);
  }
  [[nodiscard]] Vector line(FeatureIndex feature) const {
    const auto& of = mechanism_.features()[feature];
    return turned(of.link, Vector(number(of.along_x), number(of.along_y)).normalized());
  }
  /// The line of a slide or slot by which its coordinate is measured.
  [[nodiscard]] FeatureIndex line_of(const mechanism::Joint& joint) const {
    return joint.between[mechanism_.features()[joint.between[0]].is_line ? 0 : 1];
  }
  [[nodiscard]] FeatureIndex other_of(const mechanism::Joint& joint) const {
    return joint.between[mechanism_.features()[joint.between[0]].is_line ? 1 : 0];
  }
  /// The coordinate as measured, or, if a driver turns the joint, as given by its law. The whole
  /// turns of an angle that laws read are part of the configuration.
  [[nodiscard]] double coordinate(JointIndex index) const {
    const mechanism::Joint& joint = mechanism_.joints()[index];
    if (joint.type != mechanism::JointType::revolute) {
      return (at(other_of(joint)) - at(line_of(joint))).dot(line(line_of(joint)));
    }
    if (const auto driver = mechanism_.driver_of(index); driver.exists()) {
      return number(mechanism_.drivers()[driver].position);
    }
    const auto theta = [&](std::size_t end) {
      return angle_of(configuration_.links[link_of(joint.between[end])].pose.direction);
    };
    constexpr double turn = 2 * std::numbers::pi;
    const double measured = std::remainder(theta(1) - theta(0), turn);
    const auto& counted = configuration_.counted;
    const auto known = std::ranges::find(counted, index, &mechanism::CountedAngle::joint);
    return known == counted.end() ? measured
                                  : measured + turn * std::round((known->angle - measured) / turn);
  }

  /// The rate of a coordinate, by the velocities of the links: a slide's line turns, too.
  [[nodiscard]] double rate(const mechanism::Joint& joint) const {
    const auto omega = [&](FeatureIndex feature) {
      return configuration_.links[link_of(feature)].velocity(2);
    };
    if (joint.type == mechanism::JointType::revolute) {
      return omega(joint.between[1]) - omega(joint.between[0]);
    }
    const FeatureIndex from = line_of(joint);
    const Vector along = line(from);
    const Vector apart = at(other_of(joint)) - at(from);
    return (velocity_at(other_of(joint)) - velocity_at(from)).dot(along) +
           omega(from) * apart.dot(Vector(-along.y(), along.x()));
  }

  void add(LinkIndex link, const Vector& place, const Vector& force, double couple) {
    const double moment = couple + place.x() * force.y() - place.y() * force.x();
    sums_[link] += Eigen::Vector3d(force.x(), force.y(), moment);
    largest_ = std::max({largest_, force.norm(), std::abs(moment)});
  }
  /// Adds an effort along the coordinate of a joint, and its opposite on the other link.
  void add_along(const mechanism::Joint& joint, double effort) {
    if (joint.type == mechanism::JointType::revolute) {
      add(link_of(joint.between[1]), Vector::Zero(), Vector::Zero(), effort);
      add(link_of(joint.between[0]), Vector::Zero(), Vector::Zero(), -effort);
      return;
    }
    const Vector force = effort * line(line_of(joint));
    add(link_of(other_of(joint)), at(other_of(joint)), force, 0);
    add(link_of(line_of(joint)), at(other_of(joint)), -force, 0);
  }

  void add_masses() {
    const Vector gravity(number(mechanism_.loading().gravity[0]),
                         number(mechanism_.loading().gravity[1]));
    for (const mechanism::Mass& mass : mechanism_.loading().masses) {
      const LinkIndex link = mass.at.link;
      const Vector own(number(mass.at.x), number(mass.at.y));
      const Vector arm = turned(link, own);
      const Eigen::Vector3d& a = configuration_.links[link].acceleration;
      const double omega = configuration_.links[link].velocity(2);
      // The differentiated formulas are at most quadratic in time.
      constexpr double step = 0.05;
      const auto difference = [&](double back, double here, double on) {
        return turned(
            link, {on * moved(mass.at.x, step) + here * own.x() + back * moved(mass.at.x, -step),
                   on * moved(mass.at.y, step) + here * own.y() + back * moved(mass.at.y, -step)});
      };
      const Vector slide = difference(-1, 0, 1) / (2 * step);
      Vector acceleration = a.head<2>() + a(2) * Vector(-arm.y(), arm.x()) - omega * omega * arm +
                            2 * omega * Vector(-slide.y(), slide.x()) +
                            difference(1, -2, 1) / (step * step);
      double turning = a(2);
      if (link == mechanism_.ground()) {
        acceleration.setZero();
        turning = 0;
      }
      add(link, at(link, own), number(mass.mass) * (gravity - acceleration),
          -number(mass.inertia) * turning);
    }
  }
  void add_loads() {
    for (const mechanism::Load& load : mechanism_.loading().loads) {
      Vector force(number(load.force_x), number(load.force_y));
      force = load.frame.exists() ? turned(load.frame, force) : force;
      add(load.at.link, at(load.at.link, {number(load.at.x), number(load.at.y)}), force,
          number(load.moment));
    }
  }
  void add_springs() {
    for (const mechanism::Spring& spring : mechanism_.loading().springs) {
      const auto [one, other] = spring.between;
      if (spring.at_joint) {
        add_joint_spring(spring);
        continue;
      }
      const Vector apart = at(other) - at(one);
      const Vector along = apart.normalized();
      const double rate = (velocity_at(other) - velocity_at(one)).dot(along);
      const double pull = number(spring.stiffness) * (apart.norm() - number(spring.rest)) +
                          number(spring.damping) * rate;
      add(link_of(one), at(one), pull * along, 0);
      add(link_of(other), at(other), -pull * along, 0);
    }
  }
  void add_joint_spring(const mechanism::Spring& spring) {
    for (const JointIndex index : mechanism_.joints().keys()) {
      const mechanism::Joint& joint = mechanism_.joints()[index];
      if (joint.between.size() != 2 || joint.between[0] != spring.between[0] ||
          joint.between[1] != spring.between[1]) {
        continue;
      }
      double deflection = coordinate(index) - number(spring.rest);
      if (joint.type == mechanism::JointType::revolute && !mechanism_.driver_of(index).exists()) {
        deflection = std::remainder(deflection, 2 * std::numbers::pi);
        deflection += deflection < 1e-9 - std::numbers::pi ? 2 * std::numbers::pi : 0;
      }
      add_along(joint,
                -number(spring.stiffness) * deflection - number(spring.damping) * rate(joint));
    }
  }
  void add_joints(const mechanism::Forces& forces) {
    for (const mechanism::JointForce& told : forces.joints) {
      const mechanism::Joint& joint =
          mechanism_.joints()[index_of(mechanism_.joints(), told.joint)];
      const bool slides = joint.type == mechanism::JointType::prismatic;
      const bool slots = joint.type == mechanism::JointType::pin_in_slot;
      for (std::size_t end = 0; end < joint.between.size(); ++end) {
        const LinkIndex link = link_of(joint.between[end]);
        const auto found =
            std::ranges::find(told.on, link, [](const auto& on) { return on.first; });
        const Vector force = found == told.on.end()
                                 ? Vector::Constant(std::numeric_limits<double>::quiet_NaN())
                                 : found->second;
        const Vector place = slides  ? at(joint.between[1])
                             : slots ? at(other_of(joint))
                                     : at(joint.between[end]);
        add(link, place, force, (end == 0 ? -1 : 1) * told.moment);
        if (slides || slots) {
          along_lines_ = std::max(along_lines_, std::abs(force.dot(line(line_of(joint)))));
        }
      }
    }
  }
  void add_efforts(const mechanism::Forces& forces) {
    for (const mechanism::DriverIndex driver : mechanism_.drivers().keys()) {
      const double effort = forces.efforts[driver];
      const auto& law = mechanism_.numbers()[mechanism_.drivers()[driver].position].formula;
      add_along(mechanism_.joints()[mechanism_.drivers()[driver].joint], effort);
      for (const JointIndex read : law.joints()) {
        const auto moved = [&](double step) {
          return law.evaluate<double>(
              [&](mechanism::ParameterIndex at) { return values_.parameter(at); },
              [&](JointIndex joint) { return coordinate(joint) + (joint == read ? step : 0); });
        };
        constexpr double step = 1e-3;  // laws of the tests are linear or nearly so
        const double derivative =
            (8 * (moved(step) - moved(-step)) - (moved(2 * step) - moved(-2 * step))) / (12 * step);
        add_along(mechanism_.joints()[read], -effort * derivative);
      }
    }
  }

  const mechanism::Mechanism& mechanism_;
  const mechanism::Values& values_;
  const mechanism::Configuration& configuration_;
  mechanism::Table<LinkIndex, Eigen::Vector3d> sums_;
  double largest_ = 0, along_lines_ = 0;
};

}  // namespace assur::test
