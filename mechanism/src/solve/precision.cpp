#include "precision.hpp"

#include <algorithm>
#include <assur/support/derivative_digits.hpp>
#include <cmath>
#include <limits>

namespace assur::mechanism::solve {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
using support::six_digits;
constexpr double second_look_constant = 4;

class SecondLook {
 public:
  SecondLook(const GroupModel& model, const models::FlatVariables& d,
             const models::FlatVariables& u, const models::FlatVariables& q,
             const models::GroupMotion& motion)
      : model_(model), d_(d), u_(u), q_(q), inverse_(motion.inverse), size_(motion.size) {}

  /// The relative error of the derivatives where rounding leaves gaps `held` in the closures.
  [[nodiscard]] double error(double held) const {
    const double reach = this->reach();
    const double unclosed = open(held);
    double result = 0;
    for (const bool angles : {false, true}) {
      const models::SmallVector moved = unclosed * loosest(angles);
      // The error of solving the linear equations: the right-hand sides are as large as the group's
      // reach, and the remaining error may be a turn by one, or a length of the group's size.
      result = std::max(result, epsilon * reach * largest(moved, angles) /
                                    (angles ? unclosed : unclosed * size_));
      models::SmallMatrix change(inverse_.rows(), inverse_.cols());
      for (Eigen::Index column = 0; column < inverse_.cols(); ++column) {
        change.col(column) = inverse_ * bent(inverse_.col(column), moved, none(model_.input_count));
      }
      for (const bool of_angles : {false, true}) {
        const double size = largest(inverse_, of_angles);
        result = std::max(result, size > 0 ? largest(change, of_angles) / size : 0);
      }
    }
    return second_look_constant * result;
  }

  /// The relative error of second rates in the same case, where J q'' = -H(q', q') - ...: rounding
  /// moves the configuration by dq and the rates by dq' = J^-1 H(q', dq), plus the rounding of
  /// their own solution, and so the second rates by J^-1 (2 H(q', dq') + H(q'', dq)). The inputs'
  /// rates enter with those of q. Second rates may cancel, so the error is measured against the
  /// squares of rates as well.
  [[nodiscard]] double second_rate_error(double held, const models::SmallVector& rate,
                                         const models::SmallVector& second_rate,
                                         const models::MotionQuery& query) const {
    const double speed = norm(rate) * norm(rate) / size_;
    const double size = std::max(norm(second_rate), speed);
    double result = 0;
    for (const bool angles : {false, true}) {
      const models::SmallVector firmly = loosest(angles);
      const models::SmallVector moved = open(held) * firmly;
      const models::SmallVector change = inverse_ * bent(rate, moved, query.input_rate);
      const models::SmallVector solved = epsilon * norm(rate) * firmly;
      const double most = norm(inverse_ * (2 * bent(rate, change, query.input_rate) +
                                           bent(second_rate, moved, query.input_second_rate))) +
                          norm(inverse_ * (2 * bent(rate, solved, query.input_rate))) +
                          epsilon * norm(firmly) * size;
      result = std::max(result, size > 0 ? most / size : 0);
    }
    return second_look_constant * result;
  }

 private:
  /// The residual of the closures that rounding may cause.
  [[nodiscard]] double open(double held) const { return 2 * held + epsilon * reach(); }
  [[nodiscard]] double reach() const { return std::max(size_, longest_of_q()); }
  [[nodiscard]] bool is_angle(Eigen::Index row) const {
    return model_.unknowns[static_cast<std::size_t>(row)].is_angle;
  }
  [[nodiscard]] double longest_of_q() const {
    double result = 0;
    std::size_t place = 0;
    for (const ModelUnknown& unknown : model_.unknowns) {
      result = unknown.is_angle ? result : std::max(result, std::abs(q_[place]));
      place += unknown.is_angle ? 2 : 1;
    }
    return result;
  }
  /// The largest entry in the rows of angles or of lengths.
  template <typename Rows>
  [[nodiscard]] double largest(const Rows& rows, bool angles) const {
    double result = 0;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      if (is_angle(row) == angles) {
        result = std::max(result, rows.row(row).cwiseAbs().maxCoeff());
      }
    }
    return result;
  }
  /// The norm, with angles multiplied by the size to give lengths.
  [[nodiscard]] double norm(const models::SmallVector& of) const {
    return std::max(largest(of, false), size_ * largest(of, true));
  }
  /// J^-1 f for closures f with a gap of one in every loop, in the directions that move angles, or
  /// lengths, most. A loop has two closures, one along each axis.
  [[nodiscard]] models::SmallVector loosest(bool angles) const {
    models::SmallVector result = models::SmallVector::Zero(inverse_.rows());
    double most = -1;
    for (Eigen::Index row = 0; row < inverse_.rows(); ++row) {
      if (is_angle(row) != angles) {
        continue;
      }
      models::SmallVector open = models::SmallVector::Zero(inverse_.cols());
      double moves = 0;
      for (Eigen::Index loop = 0; loop + 1 < inverse_.cols(); loop += 2) {
        const auto of_loop = inverse_.row(row).segment<2>(loop).transpose();
        moves += of_loop.norm();
        open.segment<2>(loop) = of_loop.stableNormalized();
      }
      if (moves > most) {
        most = moves;
        result = inverse_ * open;
      }
    }
    return result;
  }
  /// H((x, u), (y, 0)), up to its sign, from the quadratic form: x and y are brought to one length.
  [[nodiscard]] models::SmallVector bent(const models::SmallVector& x, const models::SmallVector& y,
                                         const models::SmallVector& u) const {
    const double length_x = std::max(norm(x), u.cwiseAbs().maxCoeff());
    const double length_y = norm(y);
    if (!(length_x > 0 && length_y > 0)) {
      return none(model_.unknowns.size());
    }
    const models::SmallVector along_u = u / length_x;
    return (curvature(x / length_x + y / length_y, along_u) -
            curvature(x / length_x - y / length_y, along_u)) *
           (length_x * length_y / 4);
  }
  [[nodiscard]] models::SmallVector curvature(const models::SmallVector& along_q,
                                              const models::SmallVector& along_u) const {
    models::Curvature result;
    model_.kernel->bend(d_, u_, q_, along_q, none(model_.dimension_count), along_u, result);
    return result.closures;
  }
  [[nodiscard]] static models::SmallVector none(std::size_t count) {
    return models::SmallVector::Zero(static_cast<Eigen::Index>(count));
  }

  const GroupModel& model_;
  const models::FlatVariables& d_;
  const models::FlatVariables& u_;
  const models::FlatVariables& q_;
  const models::SmallMatrix& inverse_;
  double size_;
};

}  // namespace

Precision precision_of(const GroupModel& model, const models::FlatVariables& d,
                       const models::FlatVariables& u, const models::FlatVariables& q,
                       const models::MotionQuery& query, const models::GroupMotion& motion) {
  Precision result;
  const Regularity<double>& standing = motion.standing;
  if (!is_solvable(standing.status)) {
    return result;
  }
  const bool moves = motion.rate.allFinite();
  const bool is_firm = standing.error() < six_digits * standing.firmness;
  if (is_firm || !motion.inverse.allFinite()) {
    result.regularity = moves && is_firm ? Status::ok : Status::near_singular;
    result.derivatives_known = standing.error() < two_digits;
    result.path_known = standing.error() < one_digit;
    result.second_rates_known = is_firm;
    return result;
  }
  const SecondLook look(model, d, u, q, motion);
  const double error = std::min(standing.error(), look.error(motion.held));
  const double of_second_rates =
      moves ? std::max(error,
                       look.second_rate_error(motion.held, motion.rate, motion.second_rate, query))
            : error;
  result.regularity = moves && of_second_rates < six_digits ? Status::ok : Status::near_singular;
  result.derivatives_known = error < two_digits;
  result.path_known = error < one_digit;
  result.second_rates_known = of_second_rates < two_digits;
  return result;
}

Precision precision_of_shape(double firmness) {
  const double error = std::numeric_limits<double>::epsilon() / firmness;
  return {error / firmness < six_digits ? Status::ok : Status::near_singular, error < two_digits,
          error < one_digit, error / firmness < two_digits};
}

}  // namespace assur::mechanism::solve
