// Turns a placed link's state into that of its points and of the links that drivers move.
#pragma once

#include "scene/mechanism.hpp"

namespace assur::generator {

/// Position, velocity and acceleration of a point of the fixed frame.
struct PointState {
  Dual x, y;
  Eigen::Vector2d velocity;
  Eigen::Vector2d acceleration;
};

/// Where a link is and how it moves: the pose of its local frame with gradients to the
/// parameters, and [vx, vy, omega], [ax, ay, alpha] of its local origin.
struct LinkState {
  Dual x, y;
  Direction<Dual> direction;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
};

/// A link that stands in the fixed frame.
[[nodiscard]] LinkState fixed_link(const ParameterValues& values);

/// The point of a link with local coordinates (x, y).
[[nodiscard]] PointState point_of(const LinkState& link, const Dual& x, const Dual& y);

/// The link whose local point (x, y) is at `point`, turned by `direction`, with a given turning.
[[nodiscard]] LinkState link_through(const PointState& point, const Dual& x, const Dual& y,
                                     const Direction<Dual>& direction, double angular_velocity,
                                     double angular_acceleration);

/// A driver's law at one instant: joint angle or displacement, from first link to second.
struct DriverState {
  Dual position;
  double velocity;
  double acceleration;
};

/// The link on the other side of a driven joint from `placed`, whose state is known.
[[nodiscard]] LinkState driven_link(const MechanismJoint& joint, int placed, const LinkState& state,
                                    const DriverState& driver);

}  // namespace assur::generator
