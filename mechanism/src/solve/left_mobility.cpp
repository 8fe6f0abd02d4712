#include "left_mobility.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace assur::mechanism::solve {

namespace {

using Body = AllConstraints::Body;
using Poses = Body::Poses;

/// The start of the search for the links that a family does not place: the middle of the others.
Poses start_of(const Family& family, std::size_t loose) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const LinkIndex link : family.is_placed.keys()) {
    if (family.is_placed[link]) {
      centre += Eigen::Vector3d(family.links[link].pose.x, family.links[link].pose.y, 1);
    }
  }
  centre /= std::max(centre(2), 1.0);
  return Poses(loose, {centre.x(), centre.y(), {1, 0}});
}

/// A random step, the same in every process.
Eigen::VectorXd any_step(Eigen::Index size, std::minstd_rand& random) {
  return Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index row) {
    const double part =
        static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max());
    return (2 * part - 1) * (row % 3 == 2 ? std::numbers::pi : 1);
  });
}

/// Closes the constraints from an arbitrary start by Levenberg-Marquardt steps, until several in a
/// row reduce the residual by less than a tenth, as where the constraints cannot hold. Returns
/// whether they then hold to rounding.
bool closes(const Body& body, Poses& poses) {
  constexpr int most_steps = 100;
  constexpr int most_in_vain = 6;  // the last is damped some thousand times more than the first
  constexpr double least_gain = 0.9;
  constexpr double slack = 16;
  const Eigen::Index count = body.columns();
  double damping = 1e-2;
  int in_vain = 0;
  Eigen::VectorXd open = body.misses(poses);
  for (int time = 0; time < most_steps && in_vain < most_in_vain; ++time) {
    if (!(open.norm() > body.rounding() / slack)) {
      break;
    }
    Eigen::MatrixXd damped(open.size() + count, count);
    damped << body.jacobian(poses), Eigen::MatrixXd::Identity(count, count) * damping;
    Eigen::VectorXd wanted(damped.rows());
    wanted << -open, Eigen::VectorXd::Zero(count);
    Poses moved = poses;
    body.move(damped.householderQr().solve(wanted), moved);
    const Eigen::VectorXd left = body.misses(moved);
    in_vain = left.norm() < least_gain * open.norm() ? 0 : in_vain + 1;
    if (left.norm() < open.norm()) {
      poses = std::move(moved);
      open = left;
      damping /= 8;
    } else {
      damping = std::max(4 * damping, std::numeric_limits<double>::epsilon());
    }
  }
  return open.cwiseAbs().maxCoeff() <= slack * body.rounding();
}

Eigen::MatrixXd kernel_at(const Body& body, const Poses& poses) {
  constexpr double negligible = 1e-6;
  const Eigen::JacobiSVD<Eigen::MatrixXd> factors(body.jacobian(poses), Eigen::ComputeFullV);
  const Eigen::VectorXd& values = factors.singularValues();
  const Eigen::Index rank = (values.array() > negligible * std::max(values(0), negligible)).count();
  return factors.matrixV().rightCols(body.columns() - rank);
}

/// A lower bound of the number of freedoms with which closed links move, found by small steps along
/// the kernel of J; zero if they do not move.
int followed_mobility(const Body& body, Poses poses) {
  constexpr int steps = 4;
  constexpr double length = 0.03;
  int mobility = body.columns();
  Eigen::VectorXd last;
  for (int step = 0; step < steps; ++step) {
    const Eigen::MatrixXd kernel = kernel_at(body, poses);
    mobility = std::min(mobility, static_cast<int>(kernel.cols()));
    if (kernel.cols() == 0) {
      return 0;
    }
    const Eigen::VectorXd along =
        (step == 0 ? Eigen::VectorXd(kernel.col(0))
                   : Eigen::VectorXd(kernel * (kernel.transpose() * last)))
            .normalized();
    Poses moved = poses;
    body.move(length * along, moved);
    if (!closes(body, moved) || !(body.step(poses, moved).dot(along) > length / 2)) {
      return 0;
    }
    poses = std::move(moved);
    last = along;
  }
  return mobility;
}

}  // namespace

int left_mobility(const Family& family, const AllConstraints& constraints,
                  const std::vector<LinkIndex>& links) {
  constexpr int most_starts = 40;
  constexpr int enough_closed = 12;
  Body body = constraints.of_loose(constraints.without_joined(family.is_placed, links),
                                   poses_of(family.links));
  const Poses start = start_of(family, static_cast<std::size_t>(body.columns()) / 3);
  body.measure(start);
  std::minstd_rand random(1);
  int closed = 0;
  for (int trial = 0; trial < most_starts && closed < enough_closed; ++trial) {
    Poses poses = start;
    body.move(any_step(body.columns(), random), poses);
    if (closes(body, poses)) {
      ++closed;
      if (const int mobility = followed_mobility(body, poses); mobility > 0) {
        return std::min(mobility, family.mobility);
      }
    }
  }
  return 0;
}

}  // namespace assur::mechanism::solve
