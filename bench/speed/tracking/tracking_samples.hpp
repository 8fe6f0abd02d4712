// Single steps of cranks that drive RRR-RRR tetrads, with the end of the branch by fine
// continuation.
#pragma once

#include <assur/assembly.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tracking.hpp>
#include <optional>
#include <vector>

namespace assur::speed {

using tetrad::Model01;

/// A step of the crank that moves joint B.
struct TrackingSample {
  Model01::Dimensions<double> d;
  Model01::Inputs<double> u;  ///< x_B, y_B: the crank's pivot
  double radius = 0;
  double from = 0;
  double to = 0;
  BranchPoint<Model01> start;
  Eigen::Vector4d theta;  ///< of the start: BCG, EDF, CD, GF

  [[nodiscard]] InputMotion<Model01> at(double angle) const {
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    return {{u.x_B + x, u.y_B + y, u.x_E, u.y_E}, {-y, x, 0, 0}, {-x, -y, 0, 0}};
  }
};

struct TrackingSamples {
  std::vector<TrackingSample> list;
  /// The configuration of the branch at `to`; empty where the branch ends earlier.
  std::vector<std::optional<Model01::Configuration<long double>>> ends;
};

[[nodiscard]] TrackingSamples random_steps(std::size_t count, double step);

}  // namespace assur::speed
