// The loop Jacobian of a geared five-bar with a slotted arm, by hand. One sign is wrong.
#include <Eigen/Core>
#include <cmath>

struct Links {
  double l1, l2, l3, l4;
  double e;
};

/// J = df/dq with q = (phi2, phi3, phi5, s).
void loop_jacobian(const Links& p, const double* q, Eigen::Matrix4d& J) {
  const double s2 = std::sin(q[0]), c2 = std::cos(q[0]);
  const double s3 = std::sin(q[1]), c3 = std::cos(q[1]);
  const double s5 = std::sin(q[2]), c5 = std::cos(q[2]);
  J.setZero();
  // O - A - B - C - D
  J(0, 0) = -p.l2 * s2;
  J(0, 1) = p.l3 * s3;
  J(1, 0) = p.l2 * c2;
  J(1, 1) = p.l3 * c3;
  // O - A - B - E
  J(2, 0) = J(0, 0);
  J(2, 2) = q[3] * s5 + p.e * c5;
  J(2, 3) = -c5;
  J(3, 0) = p.l2 * c2;
  J(3, 2) = -q[3] * c5 + p.e * s5;
  J(3, 3) = -s5;
}
