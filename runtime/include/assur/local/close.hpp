// Gauss-Newton closure of constraints from a nearby point, for Jacobians of any rank.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <assur/model.hpp>
#include <limits>
#include <utility>

namespace assur::local {

/// The decomposition J = Q [T 0; 0 0] Z P of the constraints' Jacobian.
template <typename System>
using Factors = Eigen::CompleteOrthogonalDecomposition<typename System::Jacobian>;

/// Singular values below this fraction of the largest may be due to rounding.
template <typename Scalar>
inline constexpr Scalar least_firmness =
    static_cast<Scalar>(std::numeric_limits<Scalar>::epsilon() < 1e-12 ? 1e-9 : 1e-4);

/// Singular values below `least_firmness` count as zero.
template <typename System>
[[nodiscard]] Factors<System> factors_of(const typename System::Jacobian& J) {
  Factors<System> factors(J.rows(), J.cols());
  factors.setThreshold(least_firmness<typename System::Scalar>);
  factors.compute(J);
  return factors;
}

/// The ratio of the least singular value to the largest, by inverse iteration with T; zero if J
/// lacks full column rank.
template <typename Decomposition>
[[nodiscard]] auto firmness_of(const Decomposition& factors) {
  using Matrix = typename Decomposition::MatrixType;
  using Scalar = typename Matrix::Scalar;
  constexpr int Columns = Matrix::ColsAtCompileTime;
  const Eigen::Index count = factors.cols();
  if (factors.rank() < count) {
    return Scalar(0);
  }
  const assur::Matrix<Scalar, Columns, Columns> T = factors.matrixT().topRows(count);
  const auto triangle = T.template triangularView<Eigen::Upper>();
  Vector<Scalar, Columns> direction = Vector<Scalar, Columns>::Ones(count).normalized();
  Scalar least = 0;
  for (int time = 0; time < 8; ++time) {
    const Vector<Scalar, Columns> once = triangle.transpose().solve(direction);
    least = 1 / once.norm();
    direction = triangle.solve(once);
    direction.normalize();
  }
  return least / factors.maxPivot();
}

/// J^+ b, the shortest x that minimises |J x - b|. Eigen's own solution allocates memory if J lacks
/// full rank.
template <typename System>
[[nodiscard]] typename System::Step shortest_solution(const Factors<System>& factors,
                                                      typename System::Open b) {
  using Step = typename System::Step;
  const Eigen::Index rank = factors.rank();
  const Eigen::Index left = factors.cols() - rank;
  b.applyOnTheLeft(factors.householderQ().setLength(rank).adjoint());
  Step x = Step::Zero(factors.cols());
  x.head(rank) = factors.matrixT()
                     .topLeftCorner(rank, rank)
                     .template triangularView<Eigen::Upper>()
                     .solve(b.head(rank));
  for (Eigen::Index row = 0; row < rank && left > 0; ++row) {
    typename System::Scalar workspace = 0;
    std::swap(x(row), x(rank - 1));
    x.tail(left + 1).applyHouseholderOnTheLeft(factors.matrixQTZ().row(row).tail(left).adjoint(),
                                               factors.zCoeffs()(row), &workspace);
    std::swap(x(row), x(rank - 1));
  }
  return factors.colsPermutation() * x;
}

/// Closes the constraints as far as possible from a nearby point, by Gauss-Newton steps -J^+ f.
/// `system.measure` must have been called.
template <typename System>
void close(const System& system, typename System::Poses& poses) {
  using Scalar = typename System::Scalar;
  constexpr int most_tries = 40;  // bounds the effort; far fewer steps are needed in practice
  constexpr Scalar longest_step = static_cast<Scalar>(0.1);
  constexpr Scalar least_gain = static_cast<Scalar>(0.9);
  typename System::Open open = system.misses(poses);
  for (int time = 0; time < most_tries && open.norm() > system.rounding() / 16; ++time) {
    typename System::Step step =
        -shortest_solution<System>(factors_of<System>(system.jacobian(poses)), open);
    step *= (std::min)(Scalar(1), longest_step / step.cwiseAbs().maxCoeff());
    bool is_better = false;
    for (int halving = 0; halving < 4 && !is_better; ++halving, step /= 2) {
      typename System::Poses there = poses;
      system.move(step, there);
      const typename System::Open left = system.misses(there);
      is_better = left.norm() < least_gain * open.norm();
      if (is_better) {
        poses = std::move(there);
        open = left;
      }
    }
    if (!is_better) {
      return;
    }
  }
}

}  // namespace assur::local
