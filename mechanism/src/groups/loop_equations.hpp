// The loop closures of a group at given numbers, as linear forms in the unit complex numbers of its
// angles and in its displacements.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <limits>
#include <vector>

#include "groups/loops.hpp"
#include "groups/placed_links.hpp"

namespace assur::mechanism::groups {

using Complex = std::complex<double>;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The closures f_k = sum_c of_angles(k, c) theta_c + sum_j of_slides(k, j) s_j theta_{angle of j}
/// of a group, with theta_c = exp(i angle c), theta_0 = 1. Conjugated they hold, too, with 1 /
/// theta_c in place of theta_c: that is a condition of its own where the angles are complex.
struct LoopEquations {
  Eigen::MatrixXcd of_angles;     ///< a row per loop, a column per angle, the base's first
  Eigen::MatrixXcd of_slides;     ///< a row per loop, a column per displacement
  std::vector<int> slide_angles;  ///< the angle along which each displacement runs

  [[nodiscard]] Eigen::Index loop_count() const { return of_angles.rows(); }
  [[nodiscard]] Eigen::Index angle_count() const { return of_angles.cols() - 1; }
  [[nodiscard]] Eigen::Index slide_count() const { return of_slides.cols(); }
  /// The longest coefficient of an angle: the unit in which displacements are measured.
  [[nodiscard]] double size() const { return of_angles.cwiseAbs().maxCoeff(); }
};

[[nodiscard]] LoopEquations loop_equations(const Loops& loops,
                                           const std::vector<JointFeatures<double>>& features);

/// A configuration of a group in complex numbers. Where it is real, |theta_c| = 1 and the
/// displacements are real.
struct ComplexConfiguration {
  Eigen::VectorXcd theta;  ///< of each angle, the base's first
  Eigen::VectorXcd s;      ///< of each displacement
};

/// The closures of the loops, and then their conjugates, in a complex configuration.
[[nodiscard]] Eigen::VectorXcd closures_at(const LoopEquations& equations,
                                           const ComplexConfiguration& at);
/// Their derivatives to the angles but the base's, and then to the displacements.
[[nodiscard]] Eigen::MatrixXcd jacobian_at(const LoopEquations& equations,
                                           const ComplexConfiguration& at);
/// The configuration with steps of its angles and displacements added.
[[nodiscard]] ComplexConfiguration stepped(const ComplexConfiguration& from,
                                           const Eigen::VectorXcd& step);

}  // namespace assur::mechanism::groups
