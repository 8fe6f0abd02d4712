// Turns the places that links have without a mechanism's redundant constraints into those where all
// constraints together hold them, with their rates.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <assur/numeric/precision.hpp>
#include <assur/status.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace assur::support {

/// Two features, and which coordinates (x, y, theta) of the second one in the frame of the first
/// vanish. `first` and `second` are the places of their links among those that move; a feature with
/// a negative place is on a link that drivers place, and in the ground's frame.
template <typename Frame>
struct HeldPair {
  int first, second;
  Frame one, other;
  std::array<bool, 3> holds;
};

/// The constraints f(q) = 0 of a whole mechanism, body by body. q has three rows for each link that
/// moves: two for the shift of a feature on it, in parts of the mechanism's size, and one for its
/// turn about that feature. f has a row for each coordinate that a pair holds.
template <int Rows, typename Scalar, int Order, int Parameters, std::size_t Links,
          std::size_t Pairs>
class AllConstraints {
  using Frame = support::Frame<Scalar, Order, Parameters>;
  static constexpr int columns = 3 * static_cast<int>(Links);
  using Open = Vector<Scalar, Rows>;
  using Step = Vector<Scalar, columns>;
  using Jacobian = Matrix<Scalar, Rows, columns>;
  /// Its solutions leave out what is below the threshold; those of a plain QR decomposition do not.
  using Factors = Eigen::CompleteOrthogonalDecomposition<Jacobian>;
  using Plane = Vector<Scalar, 2>;

 public:
  AllConstraints(const std::array<Frame*, Links>& links,
                 const std::array<HeldPair<Frame>, Pairs>& pairs)
      : links_(links), pairs_(pairs) {
    measure();
  }

  /// Closes all constraints as far as they can be closed from nearby, by Gauss-Newton steps J^+ f.
  /// Where J has full column rank to rounding, rates and regularity follow from all constraints.
  /// Returns whether the constraints hold, and agree in the rates where these are known.
  [[nodiscard]] bool settle(Status& regularity) {
    close();
    const bool goes_on = find_rates(regularity);
    return goes_on && misses().cwiseAbs().maxCoeff() <= redundancy_slack(reach_, Status::ok);
  }

 private:
  static constexpr bool is_fine = std::numeric_limits<Scalar>::epsilon() < 1e-12;
  /// A singular value below this part of the largest is rounding.
  static constexpr Scalar least_firmness = static_cast<Scalar>(is_fine ? 1e-9 : 1e-4);

  [[nodiscard]] Frame placed(int link, const Frame& feature) const {
    return link < 0 ? feature : frame_in(*links_[static_cast<std::size_t>(link)], feature);
  }
  [[nodiscard]] static Plane place_of(const Frame& frame) { return {frame.pose.x, frame.pose.y}; }
  [[nodiscard]] Scalar rounding() const {
    return 4 * std::numeric_limits<Scalar>::epsilon() * reach_;
  }
  template <typename Visit>
  void for_each_row(const Visit& visit) const {
    int row = 0;
    for (const HeldPair<Frame>& pair : pairs_) {
      for (int coordinate = 0; coordinate < 3; ++coordinate) {
        if (pair.holds[static_cast<std::size_t>(coordinate)]) {
          visit(row++, coordinate, pair);
        }
      }
    }
  }

  /// Each link turns about its first feature; the longest arm is the size.
  void measure() {
    std::array<bool, Links> has_pivot{};
    Scalar longest = 0;
    Scalar farthest = 0;
    const auto include = [&](int link, const Frame& feature) {
      const Plane at = place_of(placed(link, feature));
      farthest = (std::max)(farthest, at.norm());
      if (link >= 0) {
        const auto place = static_cast<std::size_t>(link);
        if (!has_pivot[place]) {
          has_pivot[place] = true;
          pivots_[place] = {feature.pose.x, feature.pose.y};
        }
        longest = (std::max)(longest, (at - pivot(link)).norm());
      }
    };
    for (const HeldPair<Frame>& pair : pairs_) {
      include(pair.first, pair.one);
      include(pair.second, pair.other);
      longest = (std::max)(longest, (place_of(placed(pair.first, pair.one)) -
                                     place_of(placed(pair.second, pair.other)))
                                        .norm());
    }
    size_ = longest > 0 ? longest : (std::max)(farthest, (std::numeric_limits<Scalar>::min)());
    reach_ = 1 + farthest / size_;
  }
  [[nodiscard]] Plane pivot(int link) const {
    const auto place = static_cast<std::size_t>(link);
    const Pose<Scalar>& pose = links_[place]->pose;
    return Plane(pose.x, pose.y) + rotated<Scalar>(pose.direction, pivots_[place]);
  }

  [[nodiscard]] Open misses() const {
    Open open;
    for_each_row([&](int row, int coordinate, const HeldPair<Frame>& pair) {
      const Frame one = placed(pair.first, pair.one);
      const Frame other = placed(pair.second, pair.other);
      const Direction<Scalar> back = reversed(one.pose.direction);
      open(row) = coordinate == 2
                      ? turned(other.pose.direction, back).sin
                      : rotated<Scalar>(back, place_of(other) - place_of(one))(coordinate) / size_;
    });
    return open;
  }

  [[nodiscard]] Jacobian jacobian() const {
    Jacobian result = Jacobian::Zero();
    for_each_row([&](int row, int coordinate, const HeldPair<Frame>& pair) {
      const Direction<Scalar>& along = placed(pair.first, pair.one).pose.direction;
      const Plane at = place_of(placed(pair.second, pair.other));
      const Plane seen =
          coordinate == 0 ? Plane(along.cos, along.sin) : Plane(-along.sin, along.cos);
      const auto add = [&](int link, Scalar sense) {
        if (link < 0) {
          return;
        }
        if (coordinate < 2) {
          result(row, 3 * link) += sense * seen(0);
          result(row, 3 * link + 1) += sense * seen(1);
        }
        const Plane arm = at - pivot(link);
        result(row, 3 * link + 2) +=
            sense * (coordinate == 2 ? Scalar(1) : seen.dot(across<Scalar>(arm)) / size_);
      };
      add(pair.first, -1);
      add(pair.second, 1);
    });
    return result;
  }

  void move(const Step& step) {
    for (int link = 0; link < static_cast<int>(Links); ++link) {
      Pose<Scalar>& pose = links_[static_cast<std::size_t>(link)]->pose;
      const Plane about = pivot(link);
      const Direction<Scalar> turn{std::cos(step(3 * link + 2)), std::sin(step(3 * link + 2))};
      const Plane origin = about + size_ * Plane(step(3 * link), step(3 * link + 1)) +
                           rotated<Scalar>(turn, Plane(pose.x, pose.y) - about);
      const Direction<Scalar> direction = turned(pose.direction, turn);
      const Scalar length = std::hypot(direction.cos, direction.sin);
      pose = {origin(0), origin(1), {direction.cos / length, direction.sin / length}};
    }
  }

  /// J^+ b. Eigen's own solution allocates memory where J has not full rank.
  [[nodiscard]] static Step shortest_solution(const Factors& factors, Open b) {
    const Eigen::Index rank = factors.rank();
    b.applyOnTheLeft(factors.householderQ().setLength(rank).adjoint());
    Step x = Step::Zero();
    x.head(rank) = factors.matrixT()
                       .topLeftCorner(rank, rank)
                       .template triangularView<Eigen::Upper>()
                       .solve(b.head(rank));
    for (Eigen::Index row = 0; row < rank && rank < columns; ++row) {
      std::swap(x(row), x(rank - 1));
      Scalar workspace = 0;
      x.tail(columns - rank + 1)
          .applyHouseholderOnTheLeft(factors.matrixQTZ().row(row).tail(columns - rank).adjoint(),
                                     factors.zCoeffs()(row), &workspace);
      std::swap(x(row), x(rank - 1));
    }
    return factors.colsPermutation() * x;
  }

  void close() {
    constexpr int most_tries = 40;
    constexpr Scalar longest_step = static_cast<Scalar>(0.1);
    constexpr Scalar least_gain = static_cast<Scalar>(0.9);
    Open open = misses();
    for (int time = 0; time < most_tries && open.norm() > rounding() / 16; ++time) {
      Factors factors;
      factors.setThreshold(least_firmness);
      factors.compute(jacobian());
      Step step = -shortest_solution(factors, open);
      step *= (std::min)(Scalar(1), longest_step / step.cwiseAbs().maxCoeff());
      bool is_better = false;
      for (int halving = 0; halving < 4 && !is_better; ++halving, step /= 2) {
        std::array<Pose<Scalar>, Links> before;
        for (std::size_t link = 0; link < Links; ++link) {
          before[link] = links_[link]->pose;
        }
        move(step);
        const Open left = misses();
        is_better = left.norm() < least_gain * open.norm();
        if (is_better) {
          open = left;
        }
        for (std::size_t link = 0; link < Links && !is_better; ++link) {
          links_[link]->pose = before[link];
        }
      }
      if (!is_better) {
        return;
      }
    }
  }

  /// The ratio of the least singular value to the largest, from the triangle of the factors by
  /// inverse iteration.
  [[nodiscard]] static Scalar firmness_of(const Factors& factors) {
    if (factors.rank() < columns) {
      return 0;
    }
    const Matrix<Scalar, columns, columns> R =
        factors.matrixT().template topLeftCorner<columns, columns>();
    const auto triangle = R.template triangularView<Eigen::Upper>();
    Step direction = Step::Ones().normalized();
    Scalar least = 0;
    for (int time = 0; time < 8; ++time) {
      const Step once = triangle.transpose().solve(direction);
      least = 1 / once.norm();
      direction = triangle.solve(once);
      direction.normalize();
    }
    return least / factors.maxPivot();
  }

  /// The derivatives of f in a column of the links' rates or gradients; `twice` adds what the rates
  /// of first order contribute to derivatives of second order.
  template <typename Column>
  [[nodiscard]] Open slopes(const Column& column, bool twice) const {
    Open result;
    for_each_row([&](int row, int coordinate, const HeldPair<Frame>& pair) {
      const Frame one = placed(pair.first, pair.one);
      const Frame other = placed(pair.second, pair.other);
      const Vector<Scalar, 3> of_one = column(one);
      const Vector<Scalar, 3> apart = column(other) - of_one;
      const Plane d = place_of(other) - place_of(one);
      Plane slope = Plane(apart(0), apart(1)) - of_one(2) * across<Scalar>(d);
      if constexpr (Order > 0) {
        if (twice) {
          const Scalar omega = one.rates(2, 0);
          const Plane rate(other.rates(0, 0) - one.rates(0, 0),
                           other.rates(1, 0) - one.rates(1, 0));
          slope -= 2 * omega * across<Scalar>(rate) + omega * omega * d;
        }
      }
      result(row) = coordinate == 2
                        ? apart(2)
                        : rotated<Scalar>(reversed(one.pose.direction), slope)(coordinate) / size_;
    });
    return result;
  }

  /// The rates of a link's (x, y, theta) from those of its rows of q.
  [[nodiscard]] Vector<Scalar, 3> moved(int link, const Step& rates) const {
    const Pose<Scalar>& pose = links_[static_cast<std::size_t>(link)]->pose;
    const Scalar turning = rates(3 * link + 2);
    const Plane origin = size_ * Plane(rates(3 * link), rates(3 * link + 1)) +
                         turning * across<Scalar>(Plane(pose.x, pose.y) - pivot(link));
    return {origin(0), origin(1), turning};
  }

  /// How a column of rates or gradients was solved: the norms of the rates of q, of the derivatives
  /// of f from which they follow, and of what is left of these.
  struct Solved {
    Scalar rates, open, left;

    /// Whether more is left than a part of what there was: then the constraints do not agree.
    [[nodiscard]] bool contradicts(Scalar part, Scalar more = 0) const {
      return left > part * (open + more);
    }
  };
  /// Solves for a column of all links, which has to be zero before.
  template <typename Column>
  [[nodiscard]] Solved solve_column(const Factors& factors, const Jacobian& J, const Column& column,
                                    bool twice) {
    const Open open = slopes(column, twice);
    const Step rates = -shortest_solution(factors, open);
    for (int link = 0; link < static_cast<int>(Links); ++link) {
      column(*links_[static_cast<std::size_t>(link)]) = moved(link, rates);
    }
    return {rates.norm(), open.norm(), (J * rates + open).norm()};
  }

  /// Sets the rates to NaN: the groups alone give those of only one of several motions.
  void forget_rates() {
    for (Frame* link : links_) {
      link->rates.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
      link->gradient.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    }
  }

  /// Finds the rates. Returns whether the constraints agree in them, where they are known.
  [[nodiscard]] bool find_rates(Status& regularity) {
    const Jacobian J = jacobian();
    Factors factors;
    factors.setThreshold(least_firmness);
    factors.compute(J);
    const Scalar firmness = firmness_of(factors);
    const Scalar error = rounding() / (firmness * firmness);
    if (!(error < Scalar(two_digits))) {
      forget_rates();
      return true;
    }
    const Scalar last_error = Order < 2 ? error : error / firmness;  // of the last rates modelled
    const bool is_known_twice = last_error < Scalar(two_digits);
    regularity = last_error < Scalar(regular_error<Scalar>) ? Status::ok : Status::near_singular;
    for (Frame* link : links_) {
      link->rates.setZero();
      link->gradient.setZero();
    }
    constexpr Scalar rounding_of_rates = Scalar(is_fine ? 1e-8 : 1e-3);
    bool agree = true;
    if constexpr (Order > 0) {
      const auto velocity = [](auto& frame) { return frame.rates.col(0); };
      const Solved first = solve_column(factors, J, velocity, false);
      agree = !first.contradicts(rounding_of_rates);
      if constexpr (Order > 1) {
        constexpr Scalar rounding_of_second_rates = Scalar(is_fine ? 1e-4 : 1e-2);
        const auto acceleration = [](auto& frame) { return frame.rates.col(1); };
        const Solved second = solve_column(factors, J, acceleration, true);
        agree = agree && (regularity != Status::ok ||
                          !second.contradicts(rounding_of_second_rates, first.rates * first.rates));
        for (Frame* link : links_) {
          if (!is_known_twice) {
            link->rates.col(1).setConstant(std::numeric_limits<Scalar>::quiet_NaN());
          }
        }
      }
    }
    if constexpr (Parameters > 0) {
      for (int parameter = 0; parameter < Parameters; ++parameter) {
        const auto gradient = [parameter](auto& frame) { return frame.gradient.col(parameter); };
        // A gradient is not known where constraints without the parameter contradict it.
        if (solve_column(factors, J, gradient, false).contradicts(rounding_of_rates)) {
          for (Frame* link : links_) {
            gradient(*link).setConstant(std::numeric_limits<Scalar>::quiet_NaN());
          }
        }
      }
    }
    return agree;
  }

  const std::array<Frame*, Links>& links_;
  const std::array<HeldPair<Frame>, Pairs>& pairs_;
  std::array<Plane, Links> pivots_{};
  Scalar size_ = 1;
  Scalar reach_ = 1;
};

/// See `AllConstraints::settle`.
template <int Rows, typename Scalar, int Order, int Parameters, std::size_t Links,
          std::size_t Pairs>
[[nodiscard]] bool settle_links(
    const std::array<Frame<Scalar, Order, Parameters>*, Links>& links,
    const std::array<HeldPair<Frame<Scalar, Order, Parameters>>, Pairs>& pairs,
    Status& regularity) {
  return AllConstraints<Rows, Scalar, Order, Parameters, Links, Pairs>(links, pairs)
      .settle(regularity);
}

}  // namespace assur::support
