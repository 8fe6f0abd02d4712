// Poses of links by Newton's method on rigid bodies, without Assur groups, loops or merged angles:
// the independent truth for the generated models.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

namespace assur::test {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// A point of a body, or a line through it at an angle, in the body's frame.
struct BodyFeature {
  Real x = 0;
  Real y = 0;
  Real angle = 0;
};

struct BodyPose {
  Real x = 0;
  Real y = 0;
  Real theta = 0;

  [[nodiscard]] BodyFeature world(const BodyFeature& local) const {
    return {x + std::cos(theta) * local.x - std::sin(theta) * local.y,
            y + std::sin(theta) * local.x + std::cos(theta) * local.y, theta + local.angle};
  }
  /// The feature that lies at a place of the fixed frame.
  [[nodiscard]] BodyFeature local(const BodyFeature& world) const {
    const Real dx = world.x - x;
    const Real dy = world.y - y;
    return {std::cos(theta) * dx + std::sin(theta) * dy,
            -std::sin(theta) * dx + std::cos(theta) * dy, world.angle - theta};
  }
};

/// A joint between body `first` (or a held feature of the fixed frame) and body `second`.
struct BodyJoint {
  bool prismatic = false;
  int first = -1;
  int second = 0;
  BodyFeature on_first;  ///< in the fixed frame where first is -1
  BodyFeature on_second;
};

struct RigidBodies {
  std::vector<BodyPose> poses;
  std::vector<BodyJoint> joints;

  [[nodiscard]] BodyFeature world_first(const BodyJoint& joint) const {
    return joint.first < 0 ? joint.on_first
                           : poses[static_cast<std::size_t>(joint.first)].world(joint.on_first);
  }
  [[nodiscard]] BodyFeature world_second(const BodyJoint& joint) const {
    return poses[static_cast<std::size_t>(joint.second)].world(joint.on_second);
  }
  /// The distance from the first feature's point to the second's, along the line.
  [[nodiscard]] Real displacement(const BodyJoint& joint) const {
    const BodyFeature a = world_first(joint);
    const BodyFeature b = world_second(joint);
    return (b.x - a.x) * std::cos(a.angle) + (b.y - a.y) * std::sin(a.angle);
  }

  /// Two constraints for each joint: coincidence, or equal direction and no distance across.
  [[nodiscard]] RealVector residual() const {
    RealVector f(2 * static_cast<Eigen::Index>(joints.size()));
    Eigen::Index row = 0;
    for (const BodyJoint& joint : joints) {
      const BodyFeature a = world_first(joint);
      const BodyFeature b = world_second(joint);
      if (joint.prismatic) {
        f(row++) = std::sin(b.angle - a.angle);
        f(row++) = (b.y - a.y) * std::cos(a.angle) - (b.x - a.x) * std::sin(a.angle);
      } else {
        f(row++) = b.x - a.x;
        f(row++) = b.y - a.y;
      }
    }
    return f;
  }

  [[nodiscard]] Real& coordinate(Eigen::Index index) {
    BodyPose& pose = poses[static_cast<std::size_t>(index / 3)];
    return index % 3 == 0 ? pose.x : index % 3 == 1 ? pose.y : pose.theta;
  }

  /// Newton's method with a central-difference Jacobian; true when the residual is at rounding.
  bool assemble() {
    const auto size = 3 * static_cast<Eigen::Index>(poses.size());
    for (int iteration = 0; iteration < 60; ++iteration) {
      const RealVector f = residual();
      RealMatrix jacobian(f.size(), size);
      constexpr Real step = 1e-6L;
      for (Eigen::Index column = 0; column < size; ++column) {
        Real& moved = coordinate(column);
        const Real kept = moved;
        moved = kept + step;
        const RealVector above = residual();
        moved = kept - step;
        const RealVector below = residual();
        moved = kept;
        jacobian.col(column) = (above - below) / (2 * step);
      }
      const RealVector change = jacobian.fullPivLu().solve(-f);
      for (Eigen::Index index = 0; index < size; ++index) {
        coordinate(index) += change(index);
      }
      if (change.cwiseAbs().maxCoeff() < 1e-17L) {
        return true;
      }
    }
    return residual().cwiseAbs().maxCoeff() < 1e-15L;
  }
};

}  // namespace assur::test
