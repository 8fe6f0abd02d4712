// Joint constraints of a whole mechanism in coordinates of its bodies: residual, Jacobian and
// steps.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace assur::local {

/// Two features that a joint or a driver connects. `holds` marks the coordinates (x, y, theta) of
/// the second feature, in the frame of the first, that are constrained. `first` and `second` index
/// the moving links; a negative index means the ground, and the feature is then in the ground's
/// frame.
template <typename Scalar>
struct HeldFeatures {
  int first = -1, second = -1;
  Pose<Scalar> one, other;
  std::array<bool, 3> holds{};
  int driven = -1;  ///< the coordinate that a driver holds at `wanted`; the others are held at zero
  Scalar wanted = 0;
};

/// The constraints f(q) = 0. q has three rows for each moving link: the shift of its pivot, divided
/// by the mechanism's size, and its rotation about that pivot. The pivot is the link's first held
/// feature. f has a row for each held coordinate; lengths are divided by the size. `Rows` and
/// `Columns` may be Eigen::Dynamic; `Pairs` is a container of HeldFeatures.
template <int Rows, int Columns, typename HeldPairs>
class BodyConstraints {
 public:
  using Pairs = HeldPairs;
  using Pair = typename Pairs::value_type;
  using Scalar = std::decay_t<decltype(Pair::wanted)>;
  using Open = Vector<Scalar, Rows>;
  using Step = Vector<Scalar, Columns>;
  using Jacobian = Matrix<Scalar, Rows, Columns>;
  /// Poses of the moving links.
  using Poses = std::conditional_t<Columns == Eigen::Dynamic, std::vector<Pose<Scalar>>,
                                   std::array<Pose<Scalar>, detail::size(Columns / 3)>>;

  /// Each of the `links` moving links must occur in some pair.
  BodyConstraints(Pairs pairs, int links)
      : pairs_(std::move(pairs)), columns_(3 * links), pivots_(2, links) {
    pivots_.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    const auto include = [this](int link, const Pose<Scalar>& feature) {
      if (link >= 0 && std::isnan(pivots_(0, link))) {
        pivots_.col(link) = place_of(feature);
      }
    };
    for (const Pair& pair : pairs_) {
      rows_ += static_cast<int>(std::count(pair.holds.begin(), pair.holds.end(), true));
      include(pair.first, pair.one);
      include(pair.second, pair.other);
    }
  }

  /// Replaces the positions or prescribed values of the same features.
  void hold(Pairs pairs) { pairs_ = std::move(pairs); }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  /// The pivot of a moving link, in the link's frame.
  [[nodiscard]] Vector<Scalar, 2> pivot_of(int link) const { return pivots_.col(link); }
  /// The greatest distance of a feature from its link's pivot, or between the two features of a
  /// pair.
  [[nodiscard]] Scalar size() const { return size_; }
  /// One plus the distance of the mechanism from the origin, divided by the size.
  [[nodiscard]] Scalar reach() const { return reach_; }
  /// A bound on the part of f that is due to rounding.
  [[nodiscard]] Scalar rounding() const {
    return 4 * std::numeric_limits<Scalar>::epsilon() * reach_;
  }

  /// Sets size and reach from the poses.
  void measure(const Poses& poses) {
    Scalar longest = 0;
    Scalar farthest = 0;
    for (const Pair& pair : pairs_) {
      const Plane one = place_of(placed(pair.first, pair.one, poses));
      const Plane other = place_of(placed(pair.second, pair.other, poses));
      longest = (std::max)(longest, (other - one).norm());
      farthest = (std::max)({farthest, one.norm(), other.norm()});
      const auto include = [&](int link, const Plane& at, const Pose<Scalar>& feature) {
        if (link >= 0) {
          longest = (std::max)(longest, (at - pivot(link, poses)).norm());
          farthest = (std::max)(farthest, place_of(feature).norm());
        }
      };
      include(pair.first, one, pair.one);
      include(pair.second, other, pair.other);
    }
    size_ = longest > 0 ? longest : (std::max)(farthest, (std::numeric_limits<Scalar>::min)());
    reach_ = 1 + farthest / size_;
  }

  /// f(q).
  [[nodiscard]] Open misses(const Poses& poses) const {
    Open result(rows_);
    for_each_row([&](int row, int coordinate, std::size_t index) {
      const Pair& pair = pairs_[index];
      const Pose<Scalar> one = placed(pair.first, pair.one, poses);
      const Pose<Scalar> other = placed(pair.second, pair.other, poses);
      const Scalar wanted = pair.driven == coordinate ? pair.wanted : Scalar(0);
      if (coordinate == 2) {
        const Direction<Scalar> turn = turned(other.direction, reversed(one.direction));
        constexpr auto whole_turn = static_cast<Scalar>(6.283185307179586);
        result(row) = std::remainder(std::atan2(turn.sin, turn.cos) - wanted, whole_turn);
      } else {
        const Plane apart = place_of(other) - place_of(one);
        result(row) = (axis(one, coordinate).dot(apart) - wanted) / size_;
      }
    });
    return result;
  }

  /// df/dq. The second feature is measured in the frame of the first. A motion of the first link
  /// therefore acts like the opposite motion of the second feature as a point of that link.
  [[nodiscard]] Jacobian jacobian(const Poses& poses) const {
    Jacobian result = Jacobian::Zero(rows_, columns_);
    for_each_row([&](int row, int coordinate, std::size_t index) {
      const Pair& pair = pairs_[index];
      const Plane at = place_of(placed(pair.second, pair.other, poses));
      const Plane seen = axis(placed(pair.first, pair.one, poses), coordinate);
      const auto add = [&](int link, Scalar sense) {
        if (link < 0) {
          return;
        }
        if (coordinate < 2) {
          result(row, 3 * link) += sense * seen(0);
          result(row, 3 * link + 1) += sense * seen(1);
        }
        const Plane arm = at - pivot(link, poses);
        result(row, 3 * link + 2) +=
            sense * (coordinate == 2 ? Scalar(1) : seen.dot(support::across<Scalar>(arm)) / size_);
      };
      add(pair.first, -1);
      add(pair.second, 1);
    });
    return result;
  }

  /// Moves the links by a step of q.
  void move(const Step& step, Poses& poses) const {
    for (int link = 0; 3 * link < columns_; ++link) {
      Pose<Scalar>& pose = poses[static_cast<std::size_t>(link)];
      const Plane about = pivot(link, poses);
      const Direction<Scalar> turn{std::cos(step(3 * link + 2)), std::sin(step(3 * link + 2))};
      const Plane origin = about + size_ * Plane(step(3 * link), step(3 * link + 1)) +
                           support::rotated<Scalar>(turn, place_of(pose) - about);
      const Direction<Scalar> direction = turned(pose.direction, turn);
      const Scalar length = std::hypot(direction.cos, direction.sin);
      pose = {origin(0), origin(1), {direction.cos / length, direction.sin / length}};
    }
  }

  /// The step of q between two nearby sets of poses.
  [[nodiscard]] Step step(const Poses& from, const Poses& to) const {
    Step result(columns_);
    for (int link = 0; 3 * link < columns_; ++link) {
      const auto place = static_cast<std::size_t>(link);
      const Plane shift = (pivot(link, to) - pivot(link, from)) / size_;
      const Direction<Scalar> turn = turned(to[place].direction, reversed(from[place].direction));
      result.template segment<3>(3 * link) << shift(0), shift(1), std::atan2(turn.sin, turn.cos);
    }
    return result;
  }

  /// The rates (x, y, theta) of a link's frame from rates of q.
  [[nodiscard]] Vector<Scalar, 3> rates_of(int link, const Step& rates, const Poses& poses) const {
    const Scalar turning = rates(3 * link + 2);
    const Plane arm = place_of(poses[static_cast<std::size_t>(link)]) - pivot(link, poses);
    const Plane origin = size_ * Plane(rates(3 * link), rates(3 * link + 1)) +
                         turning * support::across<Scalar>(arm);
    return {origin(0), origin(1), turning};
  }

  /// The rates of a link's part of q from the rates (x, y, theta) of its frame.
  [[nodiscard]] Vector<Scalar, 3> unknown_rates_of(int link, const Vector<Scalar, 3>& rates,
                                                   const Poses& poses) const {
    const Plane arm = pivot(link, poses) - place_of(poses[static_cast<std::size_t>(link)]);
    const Plane shift =
        (Plane(rates(0), rates(1)) + rates(2) * support::across<Scalar>(arm)) / size_;
    return {shift(0), shift(1), rates(2)};
  }

  /// Calls `visit(row, coordinate, pair)` for each row of f, with the number of the pair.
  template <typename Visit>
  void for_each_row(const Visit& visit) const {
    int row = 0;
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      for (int coordinate = 0; coordinate < 3; ++coordinate) {
        if (pairs_[pair].holds[static_cast<std::size_t>(coordinate)]) {
          visit(row++, coordinate, pair);
        }
      }
    }
  }

 private:
  using Plane = Vector<Scalar, 2>;

  [[nodiscard]] static Plane place_of(const Pose<Scalar>& pose) { return {pose.x, pose.y}; }
  /// The x- or y-axis of a frame.
  [[nodiscard]] static Plane axis(const Pose<Scalar>& pose, int coordinate) {
    const auto& [c, s] = pose.direction;
    return coordinate == 0 ? Plane(c, s) : Plane(-s, c);
  }
  [[nodiscard]] static Pose<Scalar> placed(int link, const Pose<Scalar>& feature,
                                           const Poses& poses) {
    return link < 0 ? feature : support::pose_in(poses[static_cast<std::size_t>(link)], feature);
  }
  [[nodiscard]] Plane pivot(int link, const Poses& poses) const {
    const Pose<Scalar>& pose = poses[static_cast<std::size_t>(link)];
    return place_of(pose) + support::rotated<Scalar>(pose.direction, Plane(pivots_.col(link)));
  }

  Pairs pairs_;
  int rows_ = 0;
  int columns_;
  Matrix<Scalar, 2, Columns == Eigen::Dynamic ? Eigen::Dynamic : Columns / 3> pivots_;
  Scalar size_ = 1;
  Scalar reach_ = 1;
};

}  // namespace assur::local
