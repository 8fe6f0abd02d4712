// Random scenes with drivers anywhere, and their solutions in terms of rigid bodies.
#pragma once

#include <gtest/gtest.h>

#include <iostream>

#include "mechanism/random_driven_scene.hpp"
#include "mechanism/rigid_poses.hpp"
#include "mechanism/scene_solutions.hpp"
#include "whole_campaign.hpp"

namespace assur::test {

constexpr unsigned first_driven_seed = 27182;

/// Groups that tie links make scenes larger.
inline RandomDrivenScene driven_scene(unsigned seed, Places places, Ties ties = Ties::drivers) {
  const unsigned most_groups = ties == Ties::drivers ? 3 : 2;
  return {seed, places, 1 + static_cast<int>((seed - first_driven_seed) % most_groups), ties};
}

/// Several links that form one link of a group are tied by drivers, or by groups solved before.
class DrivenScenes : public testing::TestWithParam<Ties> {
 protected:
  /// Runs a check of many scenes: a refusal is a failure of one of them.
  template <typename Check>
  static void for_each_scene(unsigned few, unsigned many, Places places, const Check& check_one) {
    const unsigned share = GetParam() == Ties::drivers ? few : few / 3 + 1;
    const unsigned scenes = is_whole_campaign() ? many : share;
    for (unsigned seed = first_driven_seed; seed < first_driven_seed + scenes; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      try {
        check_one(driven_scene(seed, places, GetParam()), seed);
      } catch (const mechanism::InputError& error) {
        ADD_FAILURE() << error.what();
      }
    }
    std::cout << scenes << " scenes, seeds from " << first_driven_seed << ": ";
  }
};

inline std::string name_of_ties(const testing::TestParamInfo<Ties>& ties) {
  return ties.param == Ties::drivers  ? "ByDrivers"
         : ties.param == Ties::groups ? "ByGroups"
                                      : "InLargerGroups";
}

/// The condition of the constraints' Jacobian: the ratio of the least to the largest pivot of
/// orthogonal elimination. Singular values are more accurate by a factor, but take a hundred times
/// as long.
inline Real condition_of(const RigidScene& rigid, const RealVector& q) {
  const RealMatrix jacobian = rigid.jacobian(q);
  const RealVector pivots =
      Eigen::ColPivHouseholderQR<RealMatrix>(jacobian).matrixQR().diagonal().cwiseAbs();
  return pivots.minCoeff() / pivots.maxCoeff();
}

/// The random poses in which the bodies of a scene were placed.
inline RealVector thrown_poses(const RigidScene& rigid, const mechanism::Mechanism& mechanism,
                               const RandomDrivenScene& made) {
  RealVector q(rigid.size());
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    if (const Eigen::Index first = rigid.coordinate(link); first >= 0) {
      const RandomDrivenScene::BodyPose& pose = made.poses().at(mechanism.links()[link].name);
      q.segment<3>(first) << pose.x, pose.y, pose.theta;
    }
  }
  return q;
}

/// Velocities, or accelerations, of all moving links.
inline RealVector rates_of(const RigidScene& rigid, const Configuration& configuration,
                           Eigen::Vector3d mechanism::Frame::*rate) {
  RealVector result(rigid.size());
  for (const mechanism::LinkIndex link : configuration.links.keys()) {
    if (const Eigen::Index first = rigid.coordinate(link); first >= 0) {
      result.segment<3>(first) = (configuration.links[link].*rate).cast<Real>();
    }
  }
  return result;
}

/// Difference of two vectors relative to the larger of them, or to `least` if both are smaller.
inline double relative(const RealVector& one, const RealVector& other, Real least = 1e-9L) {
  const Real size = std::max({one.cwiseAbs().maxCoeff(), other.cwiseAbs().maxCoeff(), least});
  return static_cast<double>((one - other).cwiseAbs().maxCoeff() / size);
}

/// The difference of two poses of a link: a length, or the sine of an angle.
inline double pose_difference(const ::assur::Pose<double>& one, const ::assur::Pose<double>& two) {
  return std::max({std::abs(one.x - two.x), std::abs(one.y - two.y),
                   std::abs(turned(one.direction, reversed(two.direction)).sin)});
}

/// Expects the same configurations, in order, whatever the order of links, joints and drivers.
/// Those that meet others are known to `within_singular` alone.
inline void expect_same_configurations(const Solved& one, const Solved& other,
                                       double within_singular = 1e-7) {
  ASSERT_EQ(one.configurations().size(), other.configurations().size());
  const RigidScene rigid(one.plan.mechanism(), one.values);
  for (std::size_t place = 0; place < one.configurations().size(); ++place) {
    const Configuration& configuration = one.configurations()[place];
    const bool is_regular = configuration.regularity == Status::ok;
    Real worst = 0;
    for (const mechanism::Link& link : one.plan.mechanism().links()) {
      worst =
          largest<Real>(worst, pose_difference(configuration.link(link.name).pose,
                                               other.configurations()[place].link(link.name).pose));
    }
    EXPECT_LT(worst / (1 + rigid.reach()), is_regular ? 1e-7 : within_singular)
        << "configuration " << place + 1;
    // The bounds that decide for a chain depend on the frames of its links, and so on the listing.
    const Configuration& there = other.configurations()[place];
    EXPECT_TRUE(is_regular == (there.regularity == Status::ok) ||
                (configuration.rates_known && there.rates_known))
        << "configuration " << place + 1;
  }
}

}  // namespace assur::test
