// Loop closures of a group with given numbers, as linear forms in the unit complex numbers of its
// angles and in its displacements.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace assur::loops {

using Complex = std::complex<double>;
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The numbers of loops, angles and displacements of a group, the largest size of its
/// eigenproblems, and the number of its complex configurations; all may be Eigen::Dynamic. There
/// are as many angles and displacements together as there are closures: two for each loop.
template <int Loops, int Angles, int Slides, int Eigenvalues, int Configurations>
struct Sizes {
  static constexpr int loops = Loops, angles = Angles, slides = Slides, eigenvalues = Eigenvalues;
  static constexpr int configurations = Configurations;
  static constexpr int closures = Loops == Eigen::Dynamic ? Eigen::Dynamic : 2 * Loops;
  static constexpr int directions = Angles == Eigen::Dynamic ? Eigen::Dynamic : Angles + 1;
  // The sizes are upper bounds: loops unrolled over fixed sizes would take minutes to compile.
  template <typename Scalar, int Rows, int Columns = 1>
  using AtMost = Eigen::Matrix<Scalar, Eigen::Dynamic, Columns == 1 ? 1 : Eigen::Dynamic,
                               Eigen::ColMajor, Rows == 0 ? 1 : Rows, Columns == 0 ? 2 : Columns>;
  using OfLoops = AtMost<Complex, loops>;
  using Directions = AtMost<Complex, directions>;
  using Displacements = AtMost<Complex, slides>;
  using ComplexClosures = AtMost<Complex, closures>;
  using ComplexSquare = AtMost<Complex, closures, closures>;
  using Closures = AtMost<double, closures>;
  using Square = AtMost<double, closures, closures>;
};
using AnySizes =
    Sizes<Eigen::Dynamic, Eigen::Dynamic, Eigen::Dynamic, Eigen::Dynamic, Eigen::Dynamic>;

/// The closures f_k = sum_c of_angles(k, c) theta_c + sum_j of_slides(k, j) s_j theta_{angle of j}
/// of a group, with theta_c = exp(i angle c), theta_0 = 1. Their conjugates also hold, with 1 /
/// theta_c in place of theta_c; for complex angles these are independent conditions.
template <typename Of>
struct LoopEquations {
  /// One row per loop, one column per angle, the base's first.
  typename Of::template AtMost<Complex, Of::loops, Of::directions> of_angles;
  /// One row per loop, one column per displacement.
  typename Of::template AtMost<Complex, Of::loops, Of::slides> of_slides;
  /// The angle of each displacement's direction.
  typename Of::template AtMost<int, Of::slides> slide_angles;

  [[nodiscard]] Eigen::Index loop_count() const { return of_angles.rows(); }
  [[nodiscard]] Eigen::Index angle_count() const { return of_angles.cols() - 1; }
  [[nodiscard]] Eigen::Index slide_count() const { return of_slides.cols(); }
  /// The longest coefficient of an angle: the unit in which displacements are measured.
  [[nodiscard]] double size() const { return of_angles.cwiseAbs().maxCoeff(); }
  [[nodiscard]] bool is_finite() const { return of_angles.allFinite() && of_slides.allFinite(); }
};

/// The equations of a group from its closures at unit vectors. `closures_at(angle, slide)` returns
/// a complex number for each loop, with the direction of one angle set to 1 and those of all others
/// to 0 (allowed, as the closures are linear), and likewise for one displacement. `angle` is 0 and
/// `slide` -1 if all are 0; otherwise angles count from 1.
template <typename Of, typename ClosuresAt>
[[nodiscard]] LoopEquations<Of> loop_equations(
    Eigen::Index loops, Eigen::Index angles,
    const typename Of::template AtMost<int, Of::slides>& slide_angles,
    const ClosuresAt& closures_at) {
  LoopEquations<Of> result;
  result.of_angles.resize(loops, angles + 1);
  result.of_slides.resize(loops, slide_angles.size());
  result.slide_angles = slide_angles;
  for (Eigen::Index angle = 0; angle <= angles; ++angle) {
    result.of_angles.col(angle) = closures_at(angle, Eigen::Index(-1));
    if (angle > 0) {
      result.of_angles.col(angle) -= result.of_angles.col(0);
    }
  }
  for (Eigen::Index slide = 0; slide < slide_angles.size(); ++slide) {
    const Eigen::Index angle = slide_angles(slide);
    result.of_slides.col(slide) = closures_at(angle, slide) - closures_at(angle, Eigen::Index(-1));
  }
  return result;
}

/// A configuration of a group in complex numbers. If it is real, |theta_c| = 1 and the
/// displacements are real.
template <typename Of>
struct ComplexConfiguration {
  typename Of::Directions theta;  ///< of each angle, the base's first
  typename Of::Displacements s;   ///< of each displacement
};

/// The unit for errors of a displacement given relative to the size: almost parallel slides make it
/// long, and so its error.
[[nodiscard]] inline double unit_of(const Complex& s) { return (std::max)(1.0, std::abs(s)); }

/// The closures of the loops, followed by their conjugates, in a complex configuration.
template <typename Of>
[[nodiscard]] typename Of::ComplexClosures closures_at(const LoopEquations<Of>& equations,
                                                       const ComplexConfiguration<Of>& at) {
  const Eigen::Index loops = equations.loop_count();
  typename Of::ComplexClosures result(2 * loops);
  const typename Of::Directions inverse = at.theta.cwiseInverse();
  result.head(loops) = equations.of_angles.lazyProduct(at.theta);
  result.tail(loops) = equations.of_angles.conjugate().lazyProduct(inverse);
  for (Eigen::Index slide = 0; slide < at.s.size(); ++slide) {
    const Complex theta = at.theta(equations.slide_angles(slide));
    result.head(loops) += at.s(slide) * theta * equations.of_slides.col(slide);
    result.tail(loops) += at.s(slide) / theta * equations.of_slides.col(slide).conjugate();
  }
  return result;
}

/// Their derivatives with respect to the angles, the base's excluded, and then to the
/// displacements.
template <typename Of>
[[nodiscard]] typename Of::ComplexSquare jacobian_at(const LoopEquations<Of>& equations,
                                                     const ComplexConfiguration<Of>& at) {
  const Complex i(0, 1);
  const Eigen::Index loops = equations.loop_count();
  const Eigen::Index angles = equations.angle_count();
  typename Of::ComplexSquare result(2 * loops, angles + equations.slide_count());
  for (Eigen::Index angle = 1; angle <= angles; ++angle) {
    const Complex theta = at.theta(angle);
    result.col(angle - 1).head(loops) = i * theta * equations.of_angles.col(angle);
    result.col(angle - 1).tail(loops) = -i / theta * equations.of_angles.col(angle).conjugate();
  }
  for (Eigen::Index slide = 0; slide < equations.slide_count(); ++slide) {
    const int angle = equations.slide_angles(slide);
    const Complex theta = at.theta(angle);
    const typename Of::OfLoops along = theta * equations.of_slides.col(slide);
    const typename Of::OfLoops against = equations.of_slides.col(slide).conjugate() / theta;
    result.col(angles + slide).head(loops) = along;
    result.col(angles + slide).tail(loops) = against;
    if (angle > 0) {
      result.col(angle - 1).head(loops) += i * at.s(slide) * along;
      result.col(angle - 1).tail(loops) -= i * at.s(slide) * against;
    }
  }
  return result;
}

/// The configuration with steps of its angles and displacements added.
template <typename Of>
[[nodiscard]] ComplexConfiguration<Of> stepped(const ComplexConfiguration<Of>& from,
                                               const typename Of::ComplexClosures& step) {
  const Complex i(0, 1);
  const Eigen::Index angles = from.theta.size() - 1;
  ComplexConfiguration<Of> result = from;
  for (Eigen::Index angle = 1; angle <= angles; ++angle) {
    result.theta(angle) *= std::exp(i * step(angle - 1));
  }
  for (Eigen::Index slide = 0; slide < from.s.size(); ++slide) {
    result.s(slide) += step(angles + slide);
  }
  return result;
}

/// The residual that rounding may leave: each closure is a sum of some ten products of rounded
/// numbers.
template <typename Of>
[[nodiscard]] double rounding_of(const LoopEquations<Of>& equations,
                                 const ComplexConfiguration<Of>& at) {
  double reach = equations.of_angles.cwiseAbs().rowwise().sum().maxCoeff();
  for (Eigen::Index slide = 0; slide < at.s.size(); ++slide) {
    reach += std::abs(at.s(slide));
  }
  return 64 * epsilon * reach;
}

}  // namespace assur::loops
