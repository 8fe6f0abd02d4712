// Configurations of a group on a lattice by Newton's method from random starts.
#pragma once

#include <Eigen/QR>

#include "mechanism/lattice_comparison.hpp"

namespace assur::test {

/// Regular configurations, each once. It is for comparison: it may miss some, and it takes long.
inline std::vector<ListedConfiguration> searched_configurations(const LatticeScene& scene,
                                                                int starts, unsigned seed) {
  std::mt19937 engine(seed);
  const auto within = [&engine](double bound) {
    return bound * (static_cast<double>(engine()) / 2147483648.0 - 1);
  };
  std::vector<ListedConfiguration> result;
  for (int start = 0; start < starts; ++start) {
    ListedConfiguration at;
    for (std::size_t link = 0; link < scene.links().size(); ++link) {
      at.poses.push_back(Eigen::Translation2d(within(8), within(8)) *
                         Eigen::Rotation2Dd(within(3.2)));
    }
    double miss = 1;
    for (int step = 0; step < 60 && miss > 1e-14; ++step) {
      const ClosureEquations equations = closure_equations(scene, at.poses);
      miss = equations.miss.cwiseAbs().maxCoeff();
      const Eigen::VectorXd by = equations.jacobian.colPivHouseholderQr().solve(equations.miss);
      // A turn of more than a third of a radian is cut short.
      double turn = 0;
      for (Eigen::Index row = 2; row < by.size(); row += 3) {
        turn = std::max(turn, std::abs(by(row)));
      }
      const double part = std::min(1.0, 0.3 / std::max(turn, 1e-9));
      for (std::size_t link = 0; link < at.poses.size(); ++link) {
        const Eigen::Vector3d twist = -part * by.segment<3>(static_cast<Eigen::Index>(3 * link));
        // The motion of a link whose point at the origin has this velocity, to second order.
        const Eigen::Rotation2Dd turned(twist.z());
        at.poses[link] = Eigen::Translation2d(twist.x(), twist.y()) * turned * at.poses[link];
      }
    }
    examine(scene, at);
    const bool known = std::any_of(result.begin(), result.end(), [&](const auto& before) {
      return difference(before, at) < same_configuration;
    });
    if (at.residual < 1e-10 && at.smallest > 1e-4 && !known) {
      result.push_back(at);
    }
  }
  return result;
}

}  // namespace assur::test
