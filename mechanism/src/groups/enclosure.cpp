#include "groups/enclosure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace assur::mechanism::groups {

namespace {

/// The equations with displacements in parts of the group's size, and closures, too.
LoopEquations scaled(LoopEquations equations) {
  equations.of_angles /= equations.size();
  return equations;
}

/// The row sums of the moduli of a matrix: its norm as a map of vectors measured by their largest
/// entry.
double norm(const Eigen::MatrixXcd& matrix) { return matrix.cwiseAbs().rowwise().sum().maxCoeff(); }

double norm(const Eigen::VectorXcd& vector) { return vector.cwiseAbs().maxCoeff(); }

/// Bounds of a group's closures near a configuration.
struct Bounds {
  double rounding;  ///< of each closure and of each entry of the Jacobian, as computed
  double bending;   ///< of the second derivatives, along two vectors of length one
};

/// With z = (angles, displacements) the second derivatives of a closure are sums of - a theta_c,
/// along c twice, and i b theta_c, along c and s; in a ball of radius `reach` no theta, nor its
/// reciprocal, grows by more than exp(reach). Products, sums and exponentials of a group of this
/// size are rounded less than `operations` times.
Bounds bounds_of(const LoopEquations& equations, const ComplexConfiguration& at, double reach) {
  Bounds result{0, 0};
  const double grown = std::exp(reach);
  const auto operations =
      static_cast<double>(4 * (equations.of_angles.cols() + 3 * equations.slide_count() + 2));
  for (const bool conjugate : {false, true}) {
    const auto size_of = [&](Eigen::Index angle) {
      const double size = std::abs(at.theta(angle));
      return conjugate ? 1 / size : size;
    };
    for (Eigen::Index loop = 0; loop < equations.loop_count(); ++loop) {
      double terms = std::abs(equations.of_angles(loop, 0));
      double bending = 0;
      for (Eigen::Index angle = 1; angle <= equations.angle_count(); ++angle) {
        const double term = std::abs(equations.of_angles(loop, angle)) * size_of(angle);
        terms += term;
        bending += term;
      }
      for (Eigen::Index slide = 0; slide < equations.slide_count(); ++slide) {
        const int angle = equations.slide_angles[static_cast<std::size_t>(slide)];
        const double along = std::abs(equations.of_slides(loop, slide)) * size_of(angle);
        const double length = std::abs(at.s(slide));
        terms += along * std::max(1.0, length);
        bending += angle > 0 ? along * (length + reach + 2) : 0;
      }
      result.rounding = std::max(result.rounding, operations * epsilon * terms);
      result.bending = std::max(result.bending, grown * bending);
    }
  }
  return result;
}

/// The largest difference of two configurations, angles and displacements alike; turns are
/// measured by the ratio of the directions.
double distance(const ComplexConfiguration& one, const ComplexConfiguration& other) {
  double result = 0;
  for (Eigen::Index angle = 1; angle < one.theta.size(); ++angle) {
    result = std::max(result, std::abs(std::log(Complex(one.theta(angle) / other.theta(angle)))));
  }
  return one.s.size() > 0 ? std::max(result, norm(Eigen::VectorXcd(one.s - other.s))) : result;
}

ComplexConfiguration mirrored(const ComplexConfiguration& of) {
  return {of.theta.conjugate().cwiseInverse(), of.s.conjugate()};
}

ComplexConfiguration with_unit(ComplexConfiguration configuration, double unit) {
  configuration.s *= unit;
  return configuration;
}

/// Newton's steps in the unit of the group; false where they do not settle.
bool polish(const LoopEquations& equations, ComplexConfiguration& at) {
  constexpr int most_steps = 50;
  constexpr double turn = 1;  // radians, or parts of the size: a longer step leads elsewhere
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXcd by =
        -jacobian_at(equations, at).partialPivLu().solve(closures_at(equations, at));
    const double length = norm(by);
    if (!std::isfinite(length)) {
      return false;
    }
    if (length >= last && length < std::sqrt(epsilon)) {
      return true;  // rounding alone is left
    }
    at = stepped(at, length > turn ? Eigen::VectorXcd(by * (turn / length)) : by);
    last = length;
    if (length == 0) {
      return true;
    }
  }
  return false;
}

/// z -> z - Y f(z) maps the ball of radius r about z0 into itself if |Y f(z0)| + q(r) r <= r, where
/// q(r) = |1 - Y J(z0)| + |Y| bending r bounds its derivative in the ball; it has one fixed point
/// in each ball with q < 1.
std::optional<Enclosed> ball_about(const LoopEquations& equations, const ComplexConfiguration& at) {
  const Eigen::MatrixXcd jacobian = jacobian_at(equations, at);
  const Eigen::MatrixXcd inverse = jacobian.inverse();
  if (!inverse.allFinite()) {
    return std::nullopt;
  }
  constexpr double largest_ball = 0.5;  // a turn: exp(reach) stays small
  const Bounds bounds = bounds_of(equations, at, largest_ball);
  const double of_inverse = norm(inverse);
  const auto size = static_cast<double>(jacobian.rows());
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(jacobian.rows(), jacobian.cols());
  const double still = norm(Eigen::MatrixXcd(one - inverse * jacobian)) +
                       of_inverse * size * (bounds.rounding + 4 * size * epsilon * norm(jacobian));
  const double moved = norm(Eigen::VectorXcd(inverse * closures_at(equations, at))) +
                       of_inverse * (bounds.rounding * (1 + 4 * size * epsilon));
  const double bent = of_inverse * bounds.bending;
  if (!(still < 0.5)) {
    return std::nullopt;
  }
  // The ball with q = (1 + still) / 2 is the largest that is counted on.
  const double alone = std::min(largest_ball, (1 - still) / (2 * bent));
  const double holds = 2 * moved / (1 - still);
  return holds <= alone ? std::optional(Enclosed{at, holds, alone, false}) : std::nullopt;
}

bool closes(const LoopEquations& equations, const ComplexConfiguration& at) {
  return norm(closures_at(equations, at)) <= bounds_of(equations, at, 0).rounding;
}

}  // namespace

AllConfigurations all_configurations(const LoopEquations& equations,
                                     const std::vector<Elimination>& eliminations,
                                     int complex_count) {
  const double unit = equations.size();
  const LoopEquations own = scaled(equations);
  AllConfigurations result;
  for (const Elimination& elimination : eliminations) {
    for (ComplexConfiguration& at : candidates(own, elimination)) {
      std::optional<Enclosed> ball = polish(own, at) ? ball_about(own, at) : std::nullopt;
      if (!ball) {
        if (closes(own, at)) {
          result.unproven.push_back(with_unit(at, unit));
        }
        continue;
      }
      // Only disjoint balls are counted: they cannot hold the same solution.
      const bool is_disjoint = std::ranges::none_of(result.enclosed, [&](const Enclosed& other) {
        return distance(at, other.at) <= ball->holds + other.holds;
      });
      if (is_disjoint) {
        ball->is_real = distance(at, mirrored(at)) + ball->holds < ball->alone;
        result.enclosed.push_back(std::move(*ball));
      }
    }
    if (result.count() >= complex_count) {
      break;
    }
  }
  for (Enclosed& ball : result.enclosed) {
    ball.at = with_unit(ball.at, unit);
  }
  return result;
}

}  // namespace assur::mechanism::groups
