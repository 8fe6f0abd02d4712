#include "precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::solve {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double six_digits = 5e-7;
constexpr double second_look_constant = 4;

class SecondLook {
 public:
  SecondLook(const GroupModel& model, const models::FlatVariables& d,
             const models::FlatVariables& u, const models::FlatVariables& q,
             const models::GroupMotion& motion)
      : model_(model), d_(d), u_(u), q_(q), inverse_(motion.inverse), size_(motion.size) {}

  /// The relative error of the derivatives where rounding leaves closures open by `held`.
  [[nodiscard]] double error(double held) const {
    const double reach = std::max(size_, longest_of_q());
    const double unclosed = 2 * held + epsilon * reach;
    double result = 0;
    for (const bool angles : {false, true}) {
      const models::SmallVector moved = unclosed * loosest(angles);
      // The error of solving the linear equations: the right-hand sides are as long as the group
      // reaches, and what is left of them may be a turn by one, or a length of the group's size.
      result = std::max(result, epsilon * reach * largest(moved, angles) /
                                    (angles ? unclosed : unclosed * size_));
      models::SmallMatrix change(inverse_.rows(), inverse_.cols());
      for (Eigen::Index column = 0; column < inverse_.cols(); ++column) {
        change.col(column) = inverse_ * bent(inverse_.col(column), moved);
      }
      for (const bool of_angles : {false, true}) {
        const double size = largest(inverse_, of_angles);
        result = std::max(result, size > 0 ? largest(change, of_angles) / size : 0);
      }
    }
    return second_look_constant * result;
  }

  /// The factor by which the error of second rates exceeds that of rates. In J q'' = -H(q', q') -
  /// ... an error of q' counts 1 / s times, where s is how firmly J holds. Near a fold q'' is as
  /// large; at a crossing it is not.
  [[nodiscard]] double second_rate_error(const models::SmallVector& rate,
                                         const models::SmallVector& second_rate) const {
    const double speed = norm(rate) * norm(rate) / size_;
    const double firm = std::max(norm(loosest(false)), norm(loosest(true)));
    const double size = std::max(norm(second_rate), speed);
    return size > 0 ? std::max(1.0, firm * speed / size) : 1.0;
  }

 private:
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
  /// The largest entry in the rows of angles, or of lengths.
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
  /// With turns as lengths.
  [[nodiscard]] double norm(const models::SmallVector& of) const {
    return std::max(largest(of, false), size_ * largest(of, true));
  }
  /// J^-1 f for closures f that fail by one each, with the signs that move angles, or lengths,
  /// most.
  [[nodiscard]] models::SmallVector loosest(bool angles) const {
    Eigen::Index row_of_all = 0;
    double most = -1;
    for (Eigen::Index row = 0; row < inverse_.rows(); ++row) {
      const double moves = inverse_.row(row).cwiseAbs().sum();
      if (is_angle(row) == angles && moves > most) {
        most = moves;
        row_of_all = row;
      }
    }
    models::SmallVector sum = models::SmallVector::Zero(inverse_.rows());
    for (Eigen::Index column = 0; column < inverse_.cols(); ++column) {
      sum += inverse_.col(column) * (inverse_(row_of_all, column) < 0 ? -1 : 1);
    }
    return sum;
  }
  /// H(x, y), up to its sign, from the quadratic form: both are brought to one length.
  [[nodiscard]] models::SmallVector bent(const models::SmallVector& x,
                                         const models::SmallVector& y) const {
    const double length_x = norm(x);
    const double length_y = norm(y);
    if (!(length_x > 0 && length_y > 0)) {
      return models::SmallVector::Zero(inverse_.rows());
    }
    return (curvature(x / length_x + y / length_y) - curvature(x / length_x - y / length_y)) *
           (length_x * length_y / 4);
  }
  [[nodiscard]] models::SmallVector curvature(const models::SmallVector& along) const {
    const auto none = [](std::size_t count) {
      return models::SmallVector(models::SmallVector::Zero(static_cast<Eigen::Index>(count)));
    };
    models::Curvature result;
    model_.kernel->bend(d_, u_, q_, along, none(model_.dimension_count), none(model_.input_count),
                        result);
    return result.closures;
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
                       const models::GroupMotion& motion) {
  Precision result;
  const bool moves = motion.rate.allFinite();
  if (motion.standing.status == Status::ok) {
    result.regularity = moves ? Status::ok : Status::near_singular;
    result.derivatives_known = result.second_rates_known = true;
    return result;
  }
  if (motion.standing.status != Status::near_singular) {
    return result;
  }
  const SecondLook look(model, d, u, q, motion);
  const double error =
      motion.inverse.allFinite() ? look.error(motion.held) : motion.standing.error();
  const bool is_regular = error < six_digits;
  result.regularity = moves && is_regular ? Status::ok : Status::near_singular;
  result.derivatives_known = error < two_digits;
  result.second_rates_known =
      result.derivatives_known &&
      (is_regular || look.second_rate_error(motion.rate, motion.second_rate) * error < two_digits);
  return result;
}

Precision precision_of_shape(double firmness) {
  const double error = std::numeric_limits<double>::epsilon() / firmness;
  return {error / firmness < six_digits ? Status::ok : Status::near_singular, error < two_digits,
          error / firmness < two_digits};
}

}  // namespace assur::mechanism::solve
