// Type of a singular configuration along a given motion: fold or crossing.
#pragma once

#include <Eigen/SVD>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>

namespace assur {

enum class SingularityType : unsigned char {
  fold,      ///< two configurations meet and end: the motion cannot go on
  crossing,  ///< configurations pass through one another: the motion can go on
};

/// A singularity along a motion dd/dt, du/dt.
template <typename Scalar>
struct Singularity {
  /// ok: the other members are set. singular: J vanishes, and no direction is nearer to its range
  /// than another. not_finite.
  Status status = Status::singular;
  SingularityType type = SingularityType::fold;
  /// |w F_t| / |F_t| for the unit left null vector w of J and F_t = F_d dd/dt + F_u du/dt: the
  /// distance of the motion from the range of J. Zero at a crossing.
  Scalar transversality = Scalar(0);
  /// Ratio of the smallest to the largest singular value of J with scaled columns: the distance
  /// from the singularity.
  Scalar distance = Scalar(0);
};

/// The type of the singularity at or near an assembled configuration. J dq/dt = -F_t has a solution
/// where J is singular only if F_t has no part along w; near a crossing that part falls with the
/// distance.
template <typename Model, typename Scalar>
[[nodiscard]] Singularity<Scalar> singularity_along(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u,
    const typename Model::template Configuration<Scalar>& q,
    const Vector<Scalar, Model::dimension_count>& d_rate,
    const Vector<Scalar, Model::input_count>& u_rate) {
  using Square = Matrix<Scalar, Model::equation_count, Model::unknown_count>;
  using std::sqrt;
  Singularity<Scalar> result;
  if (!is_finite(d) || !is_finite(u) || !is_finite(q) || !is_finite(d_rate) || !is_finite(u_rate)) {
    result.status = Status::not_finite;
    return result;
  }
  Square jacobian;
  Matrix<Scalar, Model::equation_count, Model::dimension_count> f_d;
  Matrix<Scalar, Model::equation_count, Model::input_count> f_u;
  Model::jacobian(d, u, q, jacobian);
  Model::dimension_jacobian(d, u, q, f_d);
  Model::input_jacobian(d, u, q, f_u);
  const Vector<Scalar, Model::equation_count> f_t = f_d * d_rate + f_u * u_rate;
  for (int column = 0; column < Model::unknown_count; ++column) {
    const Scalar size = jacobian.col(column).cwiseAbs().maxCoeff();
    if (size > Scalar(0)) {
      jacobian.col(column) /= size;
    }
  }
  const Eigen::JacobiSVD<Square> factors(jacobian, Eigen::ComputeFullU);
  const int last = Model::unknown_count - 1;
  if (!(factors.singularValues()(0) > Scalar(0))) {
    return result;
  }
  result.distance = factors.singularValues()(last) / factors.singularValues()(0);
  const Scalar size = f_t.norm();
  if (size > Scalar(0)) {
    using std::abs;
    result.transversality = abs(factors.matrixU().col(last).dot(f_t)) / size;
  }
  // At a fold the transversality keeps its size while the distance vanishes; at a crossing it falls
  // with the distance. The square root of the distance separates the two cases.
  const Scalar rounding = std::numeric_limits<Scalar>::epsilon();
  const bool falls = result.transversality <= sqrt(result.distance + rounding);
  result.type = falls ? SingularityType::crossing : SingularityType::fold;
  result.status = Status::ok;
  return result;
}

}  // namespace assur
