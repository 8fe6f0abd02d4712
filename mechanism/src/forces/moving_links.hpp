// Links of a configuration as functions of time and, optionally, of one parameter.
#pragma once

#include <assur/mechanism/loads.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>

#include "joint_coordinates.hpp"
#include "moving_number.hpp"

namespace assur::mechanism::forces {

using MovingPose = Pose<MovingNumber>;

/// A place, or a vector, in the axes of the ground.
struct MovingPlace {
  MovingNumber x, y;

  [[nodiscard]] Eigen::Vector2d value() const { return {x.value(), y.value()}; }
  [[nodiscard]] Eigen::Vector2d derivative() const { return {x.derivative(), y.derivative()}; }
  [[nodiscard]] Eigen::Vector2d second_rate() const { return {x.second_rate(), y.second_rate()}; }
};
[[nodiscard]] inline MovingPlace operator+(const MovingPlace& a, const MovingPlace& b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline MovingPlace operator-(const MovingPlace& a, const MovingPlace& b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline MovingPlace operator*(const MovingNumber& factor, const MovingPlace& a) {
  return {factor * a.x, factor * a.y};
}

/// A force and a couple on a link, at a place, and their opposites on another link there.
struct Reaction {
  LinkIndex on, from;
  MovingPlace at, force;
  MovingNumber couple;
};

class MovingLinks {
 public:
  /// The links with the rates of the configuration. Both must outlive it.
  MovingLinks(const Values& values, const Configuration& configuration);

  [[nodiscard]] const MovingPose& pose(LinkIndex link) const { return poses_[link]; }
  [[nodiscard]] const JointCoordinates& coordinates() const { return coordinates_; }
  /// A link rotated and displaced from its pose in the configuration.
  void displace(LinkIndex link, const MovingPlace& by, const MovingNumber& turn);
  /// Makes the parameters' formulas depend on one of them.
  void vary(ParameterIndex parameter);

  /// A number without joints in its formula; zero if it does not exist.
  [[nodiscard]] MovingNumber number(NumberIndex number) const;
  /// A mass, an inertia, a stiffness, the length of a spring, or a damping, at rest.
  [[nodiscard]] MovingNumber size(NumberIndex number) const;
  /// A number whose formula may read joints.
  [[nodiscard]] MovingNumber reading(NumberIndex number) const;
  /// The derivative of a driver's law by the coordinate of a joint, at rest.
  [[nodiscard]] MovingNumber law_slope(DriverIndex driver, JointIndex by) const;
  /// The law of a driver, with its given rates.
  [[nodiscard]] MovingNumber law(DriverIndex driver) const;

  /// A vector in the frame of a link, rotated into the axes of the ground.
  [[nodiscard]] MovingPlace turned_with(LinkIndex link, const MovingPlace& vector) const;
  /// A place on a link, from the origin of the link's frame, and from that of the ground.
  [[nodiscard]] MovingPlace arm(const PlaceOnLink& on) const;
  [[nodiscard]] MovingPlace place(const PlaceOnLink& on) const;
  [[nodiscard]] MovingPlace place(FeatureIndex point) const;
  /// The frame of a feature.
  [[nodiscard]] MovingPose placed(FeatureIndex feature) const;
  /// A coordinate of the second feature in the frame of the first: 0, 1 along its axes, 2 its
  /// angle, within half a turn.
  [[nodiscard]] MovingNumber relative(FeatureIndex first, FeatureIndex second,
                                      int coordinate) const;
  /// A unit along such a coordinate, on the link of the second feature: an angle in radians, or a
  /// length.
  [[nodiscard]] Reaction along(FeatureIndex first, FeatureIndex second, int coordinate) const;
  /// The coordinate of a joint, including whole turns given by a law or a branch.
  [[nodiscard]] MovingNumber coordinate(JointIndex joint) const;

 private:
  using CoordinateOf = std::function<MovingNumber(JointIndex)>;
  [[nodiscard]] MovingNumber evaluated(NumberIndex number, const CoordinateOf& coordinate_of) const;

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
  JointCoordinates coordinates_;
  Table<ParameterIndex, MovingNumber> parameters_;
  Table<LinkIndex, MovingPose> poses_;
};

}  // namespace assur::mechanism::forces
