// Link positions and rates from all constraints of a mechanism, the redundant ones included.
#pragma once

#include <algorithm>
#include <array>
#include <assur/local/body_constraints.hpp>
#include <assur/local/close.hpp>
#include <assur/status.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::support {

/// Two features; `holds` marks the coordinates (x, y, theta) of the second one in the frame of the
/// first that vanish. `first` and `second` index the moving links; a negative index means a link
/// placed by drivers, and the feature is then in the ground's frame.
template <typename Frame>
struct HeldPair {
  int first, second;
  Frame one, other;
  std::array<bool, 3> holds;
};

/// All constraints f(q) = 0 of a mechanism (see BodyConstraints), and the frames of its links, with
/// their rates and gradients.
template <int Rows, typename Scalar, int Order, int Parameters, std::size_t Links,
          std::size_t Pairs>
class AllConstraints {
  using Frame = support::Frame<Scalar, Order, Parameters>;
  using Features = std::array<local::HeldFeatures<Scalar>, Pairs>;
  using Constraints = local::BodyConstraints<Rows, 3 * static_cast<int>(Links), Features>;
  using Open = typename Constraints::Open;
  using Step = typename Constraints::Step;
  using Jacobian = typename Constraints::Jacobian;
  using Factors = local::Factors<Constraints>;
  using Plane = Vector<Scalar, 2>;
  using Rates = SolvedRates<Scalar>;

 public:
  AllConstraints(const std::array<Frame*, Links>& links,
                 const std::array<HeldPair<Frame>, Pairs>& pairs)
      : links_(links), pairs_(pairs), constraints_(features_of(pairs), static_cast<int>(Links)) {
    for (std::size_t link = 0; link < Links; ++link) {
      poses_[link] = links_[link]->pose;
    }
    constraints_.measure(poses_);
  }

  /// Closes all constraints as far as possible from the present poses. If J has full column rank to
  /// rounding, rates and regularity follow from all constraints. Returns whether the constraints
  /// hold, and agree in the known rates.
  [[nodiscard]] bool settle(Status& regularity) {
    local::close(constraints_, poses_);
    for (std::size_t link = 0; link < Links; ++link) {
      links_[link]->pose = poses_[link];
    }
    const bool goes_on = find_rates(regularity);
    return goes_on && constraints_.misses(poses_).cwiseAbs().maxCoeff() <=
                          redundancy_slack(constraints_.reach(), Status::ok);
  }

 private:
  [[nodiscard]] static Features features_of(const std::array<HeldPair<Frame>, Pairs>& pairs) {
    Features features;
    for (std::size_t pair = 0; pair < Pairs; ++pair) {
      const HeldPair<Frame>& held = pairs[pair];
      features[pair] = {held.first, held.second, held.one.pose, held.other.pose, held.holds};
    }
    return features;
  }
  [[nodiscard]] Frame placed(int link, const Frame& feature) const {
    return link < 0 ? feature : frame_in(*links_[static_cast<std::size_t>(link)], feature);
  }
  [[nodiscard]] static Plane place_of(const Frame& frame) { return {frame.pose.x, frame.pose.y}; }

  /// The derivatives of f for a column of the links' rates or gradients; `twice` adds the terms of
  /// second order in the first rates.
  template <typename Column>
  [[nodiscard]] Open slopes(const Column& column, bool twice) const {
    Open result;
    constraints_.for_each_row([&](int row, int coordinate, std::size_t index) {
      const HeldPair<Frame>& pair = pairs_[index];
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
                        : rotated<Scalar>(reversed(one.pose.direction), slope)(coordinate) /
                              constraints_.size();
    });
    return result;
  }

  /// Solves for a column of all links, which must be zero before the call.
  template <typename Column>
  [[nodiscard]] Rates solve_column(const Factors& factors, const Jacobian& J, const Column& column,
                                   bool twice) {
    const Open open = slopes(column, twice);
    const Step rates = -local::shortest_solution<Constraints>(factors, open);
    for (int link = 0; link < static_cast<int>(Links); ++link) {
      column(*links_[static_cast<std::size_t>(link)]) = constraints_.rates_of(link, rates, poses_);
    }
    return {rates.norm(), open.norm(), (J * rates + open).norm()};
  }

  /// Sets the rates to NaN: several motions are possible, and the groups alone give only one of
  /// them.
  void forget_rates() {
    for (Frame* link : links_) {
      link->rates.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
      link->gradient.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    }
  }

  /// Finds the rates. Returns whether the constraints agree in the known ones.
  [[nodiscard]] bool find_rates(Status& regularity) {
    const Jacobian J = constraints_.jacobian(poses_);
    const Factors factors = local::factors_of<Constraints>(J);
    const RateDigits<Scalar> digits(constraints_.rounding(), local::firmness_of(factors), Order);
    if (!digits.are_known()) {
      forget_rates();
      return true;
    }
    regularity = digits.regularity();
    for (Frame* link : links_) {
      link->rates.setZero();
      link->gradient.setZero();
    }
    bool agree = true;
    if constexpr (Order > 0) {
      const auto velocity = [](auto& frame) { return frame.rates.col(0); };
      const Rates first = solve_column(factors, J, velocity, false);
      agree = !first.contradict();
      if constexpr (Order > 1) {
        const auto acceleration = [](auto& frame) { return frame.rates.col(1); };
        const Rates second = solve_column(factors, J, acceleration, true);
        agree = agree && (regularity != Status::ok || !second.contradict_twice(first));
        for (Frame* link : links_) {
          if (!digits.are_all_known()) {
            link->rates.col(1).setConstant(std::numeric_limits<Scalar>::quiet_NaN());
          }
        }
      }
    }
    if constexpr (Parameters > 0) {
      for (int parameter = 0; parameter < Parameters; ++parameter) {
        const auto gradient = [parameter](auto& frame) { return frame.gradient.col(parameter); };
        // A gradient is unknown if constraints that do not contain the parameter contradict it.
        if (solve_column(factors, J, gradient, false).contradict()) {
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
  Constraints constraints_;
  typename Constraints::Poses poses_;
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
