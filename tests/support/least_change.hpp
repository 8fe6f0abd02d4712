// Shortest solution of equations A x = b of full row rank.
#pragma once

#include <Eigen/LU>

namespace assur::test {

/// x = A^T (A A^T)^-1 b. The matrices are of no fixed size, so that this is compiled once. The
/// normal equations double the digits that are lost: callers repeat the step, or need few.
inline Eigen::VectorXd least_change(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::MatrixXd normal = A * A.transpose();
  return A.transpose() * Eigen::VectorXd(normal.fullPivLu().solve(b));
}

}  // namespace assur::test
