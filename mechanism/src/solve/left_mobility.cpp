#include "left_mobility.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>

namespace assur::mechanism::solve {

namespace {

using Poses = AllConstraints::Poses;

/// What became of a motion that was followed along the kernel of J in small steps.
struct FollowedMotion {
  bool goes_on = false;
  int mobility = 0;  ///< the least dimension of the kernel on the way
};

class FamilyTrial {
 public:
  FamilyTrial(const Family& family, AllConstraints& constraints)
      : family_(family), constraints_(constraints), start_(poses_of(family.links)) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const LinkIndex link : constraints.moving()) {
      if (family.is_placed[link]) {
        centre += Eigen::Vector3d(start_[link].x, start_[link].y, 1);
      } else {
        loose_.push_back(link);
      }
    }
    centre /= std::max(centre(2), 1.0);
    for (const LinkIndex link : loose_) {
      start_[link] = {centre.x(), centre.y(), {1, 0}};
    }
    constraints_.measure(start_);
  }

  [[nodiscard]] int mobility() {
    constexpr int most_starts = 40;
    constexpr int enough_closed = 12;
    int closed = 0;
    for (int start = 0; start < most_starts && closed < enough_closed; ++start) {
      Poses poses = start_;
      constraints_.move(in_all(any_step()), poses);
      if (!close(poses)) {
        continue;
      }
      ++closed;
      if (const FollowedMotion motion = followed(poses); motion.goes_on) {
        return std::min(motion.mobility, family_.mobility);
      }
    }
    return 0;
  }

 private:
  /// Turns a step of the loose links into a step of all links, in which the others rest.
  [[nodiscard]] Eigen::VectorXd in_all(const Eigen::VectorXd& step) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(constraints_.unknowns());
    for (std::size_t place = 0; place < loose_.size(); ++place) {
      all.segment<3>(constraints_.column_of(loose_[place])) =
          step.segment<3>(3 * static_cast<Eigen::Index>(place));
    }
    return all;
  }
  [[nodiscard]] Eigen::MatrixXd jacobian(const Poses& poses) const {
    const Eigen::MatrixXd all = constraints_.jacobian(poses);
    Eigen::MatrixXd result(all.rows(), 3 * std::ssize(loose_));
    for (std::size_t place = 0; place < loose_.size(); ++place) {
      result.middleCols<3>(3 * static_cast<Eigen::Index>(place)) =
          all.middleCols<3>(constraints_.column_of(loose_[place]));
    }
    return result;
  }

  /// Draws a random step of the loose links. Every process draws the same ones.
  [[nodiscard]] Eigen::VectorXd any_step() {
    Eigen::VectorXd step(3 * std::ssize(loose_));
    for (Eigen::Index row = 0; row < step.size(); ++row) {
      const double part =
          static_cast<double>(random_()) / static_cast<double>(decltype(random_)::max());
      step(row) = (2 * part - 1) * (row % 3 == 2 ? std::numbers::pi : 1);
    }
    return step;
  }

  /// Moves the loose links by steps of Levenberg and Marquardt until the constraints hold, or some
  /// steps in a row gain less than a tenth, as where they cannot hold. Returns whether they then
  /// hold within rounding.
  [[nodiscard]] bool close(Poses& poses) const {
    constexpr int most_steps = 100;
    constexpr int most_in_vain = 6;  // the last is some thousand times as stiff as the first
    constexpr double least_gain = 0.9;
    constexpr double slack = 16;
    double damping = 1e-2;
    int in_vain = 0;
    Eigen::VectorXd open = constraints_.misses(poses);
    for (int time = 0; time < most_steps && in_vain < most_in_vain; ++time) {
      if (!(open.norm() > constraints_.rounding() / slack)) {
        break;
      }
      const Eigen::MatrixXd own = jacobian(poses);
      const Eigen::Index count = own.cols();
      Eigen::MatrixXd damped(own.rows() + count, count);
      damped << own, Eigen::MatrixXd::Identity(count, count) * damping;
      Eigen::VectorXd wanted(damped.rows());
      wanted << -open, Eigen::VectorXd::Zero(count);
      Poses moved = poses;
      constraints_.move(in_all(damped.householderQr().solve(wanted)), moved);
      const Eigen::VectorXd left = constraints_.misses(moved);
      in_vain = left.norm() < least_gain * open.norm() ? 0 : in_vain + 1;
      if (left.norm() < open.norm()) {
        poses = std::move(moved);
        open = left;
        damping /= 8;
      } else {
        damping = std::max(4 * damping, std::numeric_limits<double>::epsilon());
      }
    }
    return open.cwiseAbs().maxCoeff() <= slack * constraints_.rounding();
  }

  /// Whether the links move from where they are closed, and by how many freedoms at least.
  [[nodiscard]] FollowedMotion followed(Poses poses) const {
    constexpr int steps = 4;
    constexpr double length = 0.03;
    FollowedMotion motion{true, static_cast<int>(3 * loose_.size())};
    Eigen::VectorXd last;
    for (int step = 0; step < steps && motion.goes_on; ++step) {
      const Eigen::MatrixXd kernel = kernel_at(poses);
      motion.mobility = std::min(motion.mobility, static_cast<int>(kernel.cols()));
      if (kernel.cols() == 0) {
        return {};
      }
      Eigen::VectorXd along = step == 0 ? Eigen::VectorXd(kernel.col(0))
                                        : Eigen::VectorXd(kernel * (kernel.transpose() * last));
      along.normalize();
      Poses moved = poses;
      constraints_.move(in_all(length * along), moved);
      motion.goes_on =
          close(moved) && constraints_.step(poses, moved).dot(in_all(along)) > length / 2;
      poses = std::move(moved);
      last = along;
    }
    return motion;
  }

  [[nodiscard]] Eigen::MatrixXd kernel_at(const Poses& poses) const {
    constexpr double negligible = 1e-6;
    const Eigen::JacobiSVD<Eigen::MatrixXd> factors(jacobian(poses), Eigen::ComputeFullV);
    const Eigen::VectorXd& values = factors.singularValues();
    const Eigen::Index rank =
        (values.array() > negligible * std::max(values(0), negligible)).count();
    return factors.matrixV().rightCols(3 * std::ssize(loose_) - rank);
  }

  const Family& family_;
  AllConstraints& constraints_;
  Poses start_;
  std::vector<LinkIndex> loose_;
  std::minstd_rand random_{1};
};

}  // namespace

int left_mobility(const Family& family, AllConstraints& constraints) {
  return FamilyTrial(family, constraints).mobility();
}

}  // namespace assur::mechanism::solve
