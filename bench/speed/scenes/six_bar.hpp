// The third-class six-bar of Zhauyt et al. (2017) over a turn: the input of its methods.
#pragma once

#include <assur/tracking.hpp>
#include <assur/triad/model_01.hpp>
#include <vector>

namespace assur::speed {

using TriadModel = triad::Model01;

/// The dimensions of examples/zhauyt_2017_six_bar.json, in the order of its parameters.
struct SixBar {
  static constexpr int parameters = 13;
  enum Parameter { x_O, y_O, OA, AB, BE, BD, EF, DG, x_F, y_F, x_G, y_G, ED };
  static constexpr std::array<double, parameters> value = {0,   0, 40,  190,  120,  190, 220,
                                                           105, 0, 205, -170, -155, 200};
  static constexpr std::array<double, parameters> tolerance = {
      0.1, 0.1, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.1, 0.1, 0.1, 0.1, 0.05};
  static constexpr int positions = 360;
};

/// The plate's points D and M in its frame; M's derivatives with respect to BE only.
template <typename Scalar>
struct Plate {
  Scalar x_D, y_D, x_M, y_M;
};

/// `degree_60` is the direction of the angle from BE to EM.
template <typename Scalar>
[[nodiscard]] Plate<Scalar> plate(const Scalar& BE, const Scalar& BD, const Scalar& ED,
                                  const Direction<Scalar>& degree_60) {
  using std::sqrt;
  const Scalar x = (BE * BE + BD * BD - ED * ED) / (Scalar(2) * BE);
  const auto EM = Scalar(80);
  return {x, -sqrt(BD * BD - x * x), BE + EM * degree_60.cos, EM * degree_60.sin};
}

/// One position of the crank, and the configuration that dwells.
struct SixBarSample {
  double crank = 0;  ///< radians
  TriadModel::Configuration<double> q;
  Eigen::Vector4d theta;  ///< of plate, bar, upper, output
  double previous_crank = 0;
  BranchPoint<TriadModel> previous;
  Eigen::Vector4d previous_theta;
};

/// Half the width of the range of M, in x and in y.
struct SixBarAnswer {
  bool failed = false;
  Eigen::Vector2d worst_case;
};

#ifdef ASSUR_CERES
/// Sensitivities by Jets and LU at known angles.
[[nodiscard]] SixBarAnswer six_bar_by_jets(double crank, const Eigen::Vector4d& theta);
/// Newton's method with Jets and LU from other angles, then the sensitivities.
[[nodiscard]] SixBarAnswer six_bar_tracked_by_jets(double crank, Eigen::Vector4d theta);
#endif

}  // namespace assur::speed
