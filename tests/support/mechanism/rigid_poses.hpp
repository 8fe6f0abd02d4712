// Poses of rigid bodies in configurations and families, and their comparison.
#pragma once

#include <algorithm>
#include <cmath>

#include "largest.hpp"
#include "mechanism/rigid_scene.hpp"
#include "mechanism/solved.hpp"

namespace assur::test {

inline void set_pose(const RigidScene& rigid, mechanism::LinkIndex link,
                     const ::assur::Pose<double>& pose, RealVector& q) {
  if (const Eigen::Index first = rigid.has(link) ? rigid.coordinate(link) : -1; first >= 0) {
    q.segment<3>(first) << pose.x, pose.y,
        std::atan2(static_cast<Real>(pose.direction.sin), static_cast<Real>(pose.direction.cos));
  }
}

/// The pose of every moving link, as rigid bodies have it.
inline RealVector poses_of(const RigidScene& rigid, const Configuration& configuration) {
  RealVector q(rigid.size());
  for (const mechanism::LinkIndex link : configuration.links.keys()) {
    set_pose(rigid, link, configuration.links[link].pose, q);
  }
  return q;
}

/// Largest difference of poses: lengths as parts of the reach, angles modulo a turn.
inline Real distance(const RigidScene& rigid, const RealVector& one, const RealVector& other) {
  Real worst = 0;
  for (Eigen::Index index = 0; index < one.size(); ++index) {
    const Real difference = one(index) - other(index);
    worst =
        largest(worst, index % 3 == 2 ? std::abs(std::remainder(difference, 2 * std::acos(-1.0L)))
                                      : std::abs(difference) / rigid.reach());
  }
  return worst;
}

/// The largest constraint residual, relative to the mechanism's size: its reach, or its largest
/// coordinate if nearly parallel slides carry it farther. A pose in doubles cannot close to less
/// than the rounding of that.
inline double closure_of(const RigidScene& rigid, const RealVector& q) {
  const Real size = std::max(rigid.reach(), q.cwiseAbs().maxCoeff());
  return static_cast<double>(rigid.values_of(q).cwiseAbs().maxCoeff() / size);
}

inline bool is_listed(const RigidScene& rigid, const RealVector& q, const Solution& solution,
                      Real within) {
  return std::ranges::any_of(solution.configurations, [&](const Configuration& configuration) {
    return distance(rigid, q, poses_of(rigid, configuration)) < within;
  });
}

/// Whether the fixed links of a family have the given poses.
inline bool is_of_a_family(const RigidScene& rigid, const RealVector& q, const Solution& solution,
                           Real within) {
  return std::ranges::any_of(solution.families, [&](const mechanism::Family& family) {
    RealVector placed = q;
    for (const mechanism::LinkIndex link : family.links.keys()) {
      if (family.is_placed[link]) {
        set_pose(rigid, link, family.links[link].pose, placed);
      }
    }
    return distance(rigid, q, placed) < within;
  });
}

}  // namespace assur::test
