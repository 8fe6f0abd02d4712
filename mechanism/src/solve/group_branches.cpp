#include "group_branches.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace assur::mechanism::solve {

namespace {

constexpr double undecided = std::numeric_limits<double>::quiet_NaN();
constexpr auto highest_order = static_cast<Eigen::Index>(models::Series::order);
/// A component that is a smaller part of its vector than this is zero up to rounding.
constexpr double negligible_part = 1e-6;
/// Configurations that meet are listed as one where rounding does not separate them; then s^2 is at
/// most this part of the noise.
constexpr double met = 0.1;

/// The real roots of a c^2 + b c + constant. Two roots that differ by less than `rounding` are
/// listed as one.
std::vector<double> roots_of(double a, double b, double constant, double rounding) {
  const double discriminant = b * b - 4 * a * constant;
  const double least = std::abs(a) * rounding;
  if (std::abs(discriminant) <= least * least) {
    return {0.0 - b / (2 * a)};
  }
  if (discriminant < 0) {
    return {};
  }
  // The first root adds magnitudes and so loses no digits; the other one follows from the product
  // of both.
  const double far = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  return {far / a, constant / far};
}

class BranchExpansion {
 public:
  explicit BranchExpansion(const GroupOnTheMove& group)
      : group_(group),
        count_(static_cast<Eigen::Index>(group.model.unknowns.size())),
        parts_(Eigen::MatrixXd::Zero(count_, highest_order + 1)) {
    factorise();
  }

  std::vector<GroupBranch> run() {
    const Eigen::VectorXd& values = factors_.singularValues();
    const double noise = group_.displaced + 16 * std::numeric_limits<double>::epsilon();
    const auto firmness = [&](Eigen::Index place) { return values(place) / values(0); };
    const double last = firmness(count_ - 1);
    const double least = std::sqrt(noise / two_digits_lost);
    if (last > least) {
      rank_ = count_;
      for (Eigen::Index order = 1; order <= highest_order; ++order) {
        solve(order);
      }
      if (!(noise / (last * last * last) < two_digits_lost)) {
        parts_.rightCols(highest_order - 1).setConstant(undecided);
      }
      list();
    } else if (last * last < met * noise && (count_ == 1 || firmness(count_ - 2) > least)) {
      rank_ = count_ - 1;
      expand_singular();
    }
    return std::move(found_);
  }

 private:
  /// Computes J, one coefficient of the closures for each unknown, scales its columns to one size,
  /// and factorises it.
  void factorise() {
    const Moving still = at_rest();
    Eigen::MatrixXd jacobian(count_, count_);
    for (Eigen::Index column = 0; column < count_; ++column) {
      parts_(column, 1) = 1;
      jacobian.col(column) = closures(1, still);
      parts_(column, 1) = 0;
    }
    scale_ = jacobian.cwiseAbs().colwise().maxCoeff().transpose();
    for (Eigen::Index column = 0; column < count_; ++column) {
      scale_(column) = scale_(column) > 0 ? 1 / scale_(column) : 1;
    }
    factors_.compute(jacobian * scale_.asDiagonal(), Eigen::ComputeFullU | Eigen::ComputeFullV);
    blocked_ = factors_.matrixU().col(count_ - 1);
    free_ = scale_.cwiseProduct(factors_.matrixV().col(count_ - 1));
  }

  /// The motion of a group's dimensions and inputs.
  struct Moving {
    models::FlatSeries d, u;
    std::vector<AcrossOnTheMove> across;
  };
  [[nodiscard]] Moving at_rest() const {
    Moving still;
    for (std::size_t place = 0; place < still.u.size(); ++place) {
      still.d[place] = group_.d[place].value();
      still.u[place] = group_.u[place].value();
    }
    return still;
  }

  [[nodiscard]] models::FlatSeries unknowns() const {
    models::FlatSeries moving;
    std::size_t place = 0;
    for (Eigen::Index row = 0; row < count_; ++row) {
      models::Series part = part_of(row);
      if (group_.model.unknowns[static_cast<std::size_t>(row)].is_angle) {
        const Direction<models::Series> direction =
            turning({group_.q[place], group_.q[place + 1]}, part);
        moving[place++] = direction.cos;
        moving[place++] = direction.sin;
      } else {
        part.c[0] = group_.q[place];
        moving[place++] = part;
      }
    }
    return moving;
  }

  [[nodiscard]] models::Series part_of(Eigen::Index row) const {
    models::Series part;
    for (std::size_t order = 1; order <= highest_order; ++order) {
      part.c[order] = parts_(row, static_cast<Eigen::Index>(order));
    }
    return part;
  }

  /// The coefficient of the closures at an order.
  [[nodiscard]] Eigen::VectorXd closures(Eigen::Index order, const Moving& from) const {
    models::MovingGroup moving;
    expand(group_.model, from.d, from.u, unknowns(), from.across, moving);
    Eigen::VectorXd coefficients(count_);
    for (Eigen::Index row = 0; row < count_; ++row) {
      coefficients(row) =
          moving.closures[static_cast<std::size_t>(row)].c[static_cast<std::size_t>(order)];
    }
    return coefficients;
  }
  [[nodiscard]] Eigen::VectorXd closures(Eigen::Index order) const {
    return closures(order, {group_.d, group_.u, group_.across});
  }

  /// Sets the unknowns' coefficient of an order, the shortest one where J has no inverse.
  void solve(Eigen::Index order) {
    parts_.col(order).setZero();
    const Eigen::VectorXd rhs = factors_.matrixU().leftCols(rank_).transpose() * closures(order);
    parts_.col(order) =
        -scale_.cwiseProduct(factors_.matrixV().leftCols(rank_) *
                             rhs.cwiseQuotient(factors_.singularValues().head(rank_)));
  }

  /// Whether w f of an order is zero up to rounding.
  [[nodiscard]] bool can_close(Eigen::Index order) const {
    const Eigen::VectorXd f = closures(order);
    return std::abs(blocked_.dot(f)) <= negligible_part * size_of(order, f);
  }
  /// The size of the terms in a coefficient of the closures: those of each dimension and each input
  /// when it moves alone, and those of the unknowns. What moves counts with the terms of its motion
  /// (`MotionTerms`), since their sum may be nothing but rounding.
  [[nodiscard]] double size_of(Eigen::Index order, const Eigen::VectorXd& f) const {
    double size = std::max(f.norm(), size_of_order(order));
    const Moving still = at_rest();
    const Eigen::VectorXd of_unknowns = closures(order, still);
    const auto include = [&](const models::FlatSeries& series, models::FlatSeries Moving::*of) {
      for (std::size_t place = 0; place < series.size(); ++place) {
        if (series[place].c[static_cast<std::size_t>(order)] != 0) {
          Moving one_moves = still;
          (one_moves.*of)[place] = series[place];
          size = std::max(size, (closures(order, one_moves) - of_unknowns).norm());
        }
      }
    };
    include(group_.terms.d, &Moving::d);
    include(group_.terms.u, &Moving::u);
    for (const AcrossOnTheMove& one : group_.across) {
      Moving one_moves = still;
      one_moves.across = {one};
      size = std::max(size, (closures(order, one_moves) - of_unknowns).norm());
    }
    return size;
  }
  /// The larger of two sizes, in units of v: that of the unknowns' coefficient at an order, and
  /// that of what the first-order turn contributes there.
  [[nodiscard]] double size_of_order(Eigen::Index order) const {
    double turning = 0;
    for (Eigen::Index row = 0; row < count_; ++row) {
      if (group_.model.unknowns[static_cast<std::size_t>(row)].is_angle) {
        turning = std::max(turning, std::abs(parts_(row, 1)));
      }
    }
    const auto moved = [this](Eigen::Index of) {
      return parts_.col(of).cwiseQuotient(scale_).norm();
    };
    return std::max(moved(order), moved(1) * std::pow(turning, static_cast<double>(order - 1)));
  }

  /// The coefficient of the closures at an order as a quadratic polynomial in the component along v
  /// of an earlier order; the orders between the two follow from that component.
  struct Quadratic {
    Eigen::VectorXd square, linear, constant;
  };
  [[nodiscard]] Quadratic quadratic(Eigen::Index order, Eigen::Index at, double reach) {
    const Eigen::VectorXd least = parts_.col(order);
    const auto left = [&](double part) {
      parts_.col(order) = least + part * free_;
      for (Eigen::Index between = order + 1; between < at; ++between) {
        solve(between);
      }
      return closures(at);
    };
    const Eigen::VectorXd before = left(-reach);
    const Eigen::VectorXd after = left(reach);
    const Eigen::VectorXd here = left(0);
    return {((before + after) / 2 - here) / (reach * reach), (after - before) / (2 * reach), here};
  }

  /// The components of q_order along v with which the closures can hold at a later order.
  [[nodiscard]] std::vector<double> free_parts(Eigen::Index order, Eigen::Index decided_by) {
    solve(order);
    const double start = size_of_order(order);
    const auto component = [this](const Eigen::VectorXd& f) {
      const double along = blocked_.dot(f);
      return std::abs(along) > negligible_part * f.norm() ? along : 0.0;
    };
    // If `start` is only the rounding of what moves the group, it does not tell how far this goes.
    const double moved = size_of(order, closures(order));
    double reach = start > negligible_part * moved ? start : moved > 0 ? moved : 1;
    double reached = 0;
    double rounding = 0;
    double a = 0;
    double b = 0;
    double constant = 0;
    // The first round finds how large the components are; the second one evaluates the polynomial
    // with components of that size.
    for (int time = 0; time < 2; ++time) {
      const Quadratic f = quadratic(order, decided_by, reach);
      a = component(f.square);
      b = blocked_.dot(f.linear);
      constant = blocked_.dot(f.constant);
      const double terms = size_of(decided_by, f.constant);
      constant = std::abs(constant) > 1e-12 * terms ? constant : 0.0;
      rounding = 1e-2 * start + 2e-6 * std::sqrt(terms / std::abs(a));
      const double size = std::max({start, std::sqrt(std::abs(constant / a)), std::abs(b / a)});
      reached = reach;
      reach = std::isfinite(size) && size > 0 ? size : reach;
    }
    // At the larger root the square term is as large as the others. If it is far smaller for
    // components of that size, it is rounding.
    const bool decides =
        std::abs(a) * reached > 1e-3 * std::abs(b) && std::isfinite(a + b + constant);
    return decides ? roots_of(a, b, constant, rounding) : std::vector<double>{};
  }

  void expand_singular() {
    if (!can_close(1)) {
      return;  // a fold
    }
    const std::vector<double> parts = free_parts(1, 2);
    const Eigen::VectorXd least = parts_.col(1);
    for (const double part : parts) {
      parts_.setZero();
      parts_.col(1) = least + part * free_;
      parts.size() == 2 ? expand_crossing() : expand_double();
    }
  }

  /// Decides each order by the next one, which is linear in its component along v.
  void expand_crossing() {
    for (Eigen::Index order = 2; order < highest_order; ++order) {
      solve(order);
      const Eigen::VectorXd least = parts_.col(order);
      const double size = size_of_order(order);
      const double step = size > 0 ? size : 1;
      const double here = blocked_.dot(closures(order + 1));
      parts_.col(order) = least + step * free_;
      const double there = blocked_.dot(closures(order + 1));
      parts_.col(order) = least - here / (there - here) * step * free_;
    }
    parts_.col(highest_order).setConstant(undecided);
    list();
  }

  /// Handles branches that touch, and groups that are singular throughout. At a cusp, where w f_3
  /// is not zero, the second rates grow beyond all bounds; they are not known either where the
  /// inputs' series are known to too few orders.
  void expand_double() {
    solve(2);
    const bool goes_on = can_close(3) && closures(4).allFinite();
    const std::vector<double> parts = goes_on ? free_parts(2, 4) : std::vector<double>{undecided};
    const Eigen::VectorXd least = parts_.col(2);
    for (const double part : parts) {
      parts_.rightCols(highest_order - 1).setConstant(undecided);
      parts_.col(2) = least + part * free_;
      list();
    }
  }

  void list() {
    models::MovingGroup moving;
    expand(group_.model, group_.d, group_.u, unknowns(), group_.across, moving);
    found_.push_back({moving.poses});
  }

  const GroupOnTheMove& group_;
  Eigen::Index count_;
  Eigen::Index rank_ = 0;
  Eigen::MatrixXd parts_;  ///< a row per unknown, a column per order
  Eigen::VectorXd scale_;  ///< per unknown, so that a scaled one moves the closures by about one
  Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> factors_;
  Eigen::VectorXd blocked_;  ///< w
  Eigen::VectorXd free_;     ///< v
  std::vector<GroupBranch> found_;
};

}  // namespace

std::vector<GroupBranch> branches_through(const GroupOnTheMove& group) {
  return BranchExpansion(group).run();
}

}  // namespace assur::mechanism::solve
