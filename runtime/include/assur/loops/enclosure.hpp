// Enclosures of a group's complex configurations in balls that hold exactly one each.
#pragma once

#include <algorithm>
#include <array>
#include <assur/loops/hidden_angle.hpp>
#include <assur/loops/loop_equations.hpp>
#include <assur/loops/parameter_path.hpp>
#include <assur/loops/settling.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace assur::loops {

/// A list of fixed capacity that allocates no memory.
template <typename Item, int Capacity>
class BoundedList {
 public:
  void push_back(const Item& item) { items_[static_cast<std::size_t>(count_++)] = item; }
  [[nodiscard]] int size() const { return count_; }
  [[nodiscard]] bool is_full() const { return count_ == Capacity; }
  [[nodiscard]] Item* begin() { return items_.data(); }
  [[nodiscard]] Item* end() { return items_.data() + count_; }
  [[nodiscard]] const Item* begin() const { return items_.data(); }
  [[nodiscard]] const Item* end() const { return items_.data() + count_; }

 private:
  std::array<Item, static_cast<std::size_t>(Capacity)> items_;
  int count_ = 0;
};
/// A list whose capacity is not known at compile time.
template <typename Item>
class BoundedList<Item, Eigen::Dynamic> : public std::vector<Item> {
 public:
  [[nodiscard]] static constexpr bool is_full() { return false; }
};

/// A configuration to which Newton's method has converged, and a ball about it in which Krawczyk's
/// operator is a contraction, with bounds for all roundings. The norm is the largest modulus of the
/// angles' errors and of the displacements' errors, divided by the group's size or by a longer
/// displacement. Within `holds` of the configuration lies one exact solution of the equations with
/// their rounded coefficients, and within `alone` no other.
template <typename Of>
struct Enclosed {
  ComplexConfiguration<Of> at;
  double holds;
  double alone;
  bool is_real;  ///< the solution is its own mirror image theta -> 1 / conj(theta), s -> conj(s)
};

/// The complex configurations found, in disjoint balls.
template <typename Of>
struct AllConfigurations {
  BoundedList<Enclosed<Of>, Of::configurations> enclosed;
  /// Approximate configurations whose closures vanish to rounding, but for which no ball was found.
  /// Families have infinitely many points: at most two are kept for each configuration sought.
  BoundedList<ComplexConfiguration<Of>,
              Of::configurations == Eigen::Dynamic ? Eigen::Dynamic : 2 * Of::configurations>
      unproven;

  [[nodiscard]] int count() const { return static_cast<int>(enclosed.size()); }
};

/// The row sums of the moduli of a matrix: its norm as a map of vectors measured by their largest
/// entry. For a vector this is the largest modulus; zero if it is empty.
template <typename Matrix>
[[nodiscard]] double norm_of(const Eigen::MatrixBase<Matrix>& matrix) {
  double largest = 0;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    const double sum = matrix.row(row).cwiseAbs().sum();
    largest = sum <= largest ? largest : sum;  // NaN counts as the largest
  }
  return largest;
}

/// Bounds of a group's closures near a configuration, one for each: if a direction has a large
/// modulus, so has its loop, but not the conjugate of the loop.
template <typename Of>
struct ClosureBounds {
  typename Of::Closures
      rounding;  ///< rounding error of the closure and of each of its derivatives, as computed
  typename Of::Closures
      bending;  ///< bound on its second derivatives, along two vectors of length one
};

/// With z = (angles, displacements in their units) the second derivatives of a closure are sums of
/// - a theta_c, along c twice, and i b theta_c, along c and s; in a ball of radius `reach` no
/// theta, nor its reciprocal, grows by more than exp(reach). In a group of this size a result has
/// fewer than `operations` roundings.
template <typename Of>
[[nodiscard]] ClosureBounds<Of> bounds_of(const LoopEquations<Of>& equations,
                                          const ComplexConfiguration<Of>& at, double reach) {
  const Eigen::Index loops = equations.loop_count();
  ClosureBounds<Of> result{typename Of::Closures(2 * loops), typename Of::Closures(2 * loops)};
  const double grown = std::exp(reach);
  const auto operations =
      static_cast<double>(4 * (equations.of_angles.cols() + 3 * equations.slide_count() + 2));
  for (const bool conjugate : {false, true}) {
    const auto size_of = [&](Eigen::Index angle) {
      const double size = std::abs(at.theta(angle));
      return conjugate ? 1 / size : size;
    };
    for (Eigen::Index loop = 0; loop < loops; ++loop) {
      double terms = std::abs(equations.of_angles(loop, 0));
      double bending = 0;
      for (Eigen::Index angle = 1; angle <= equations.angle_count(); ++angle) {
        const double term = std::abs(equations.of_angles(loop, angle)) * size_of(angle);
        terms += term;
        bending += term;
      }
      for (Eigen::Index slide = 0; slide < equations.slide_count(); ++slide) {
        const int angle = equations.slide_angles(slide);
        const double along = std::abs(equations.of_slides(loop, slide)) * size_of(angle);
        const double length = std::abs(at.s(slide));
        const double unit = unit_of(at.s(slide));
        terms += along * unit;
        bending += angle > 0 ? along * (length + unit * (reach + 2)) : 0;
      }
      const Eigen::Index closure = conjugate ? loops + loop : loop;
      result.rounding(closure) = operations * epsilon * terms;
      result.bending(closure) = grown * bending;
    }
  }
  return result;
}

/// Whether the closures vanish to their roundings.
template <typename Of>
[[nodiscard]] bool closes(const LoopEquations<Of>& equations, const ComplexConfiguration<Of>& at) {
  const typename Of::Closures open = closures_at(equations, at).cwiseAbs();
  return (open.array() <= bounds_of(equations, at, 0).rounding.array()).all();
}

/// The largest difference of two configurations over angles and displacements, in the larger of
/// their units; angles are compared by the ratio of their directions.
template <typename Of>
[[nodiscard]] double distance_between(const ComplexConfiguration<Of>& one,
                                      const ComplexConfiguration<Of>& other) {
  double result = 0;
  for (Eigen::Index slide = 0; slide < one.s.size(); ++slide) {
    const double unit = (std::max)(unit_of(one.s(slide)), unit_of(other.s(slide)));
    result = (std::max)(result, std::abs(one.s(slide) - other.s(slide)) / unit);
  }
  for (Eigen::Index angle = 1; angle < one.theta.size(); ++angle) {
    const Complex ratio = one.theta(angle) / other.theta(angle);
    result = (std::max)(result, std::abs(std::log(ratio)));
  }
  return result;
}

template <typename Of>
[[nodiscard]] ComplexConfiguration<Of> mirrored(const ComplexConfiguration<Of>& of) {
  return {of.theta.conjugate().cwiseInverse(), of.s.conjugate()};
}

/// Whether the configuration is at infinity: a direction, or the reciprocal of one or of a
/// displacement divided by the size, is zero to rounding, or to the square root of epsilon where
/// two eigenvalues meet.
template <typename Of>
[[nodiscard]] bool is_at_infinity(const ComplexConfiguration<Of>& at) {
  const auto sizes = at.theta.cwiseAbs();
  const double zero = std::sqrt(epsilon);
  return !(sizes.minCoeff() > zero * sizes.maxCoeff() && norm_of(at.s) * zero < 1);
}

/// Newton's method in the unit of the group; false if it does not converge.
template <typename Of>
[[nodiscard]] bool polish(const LoopEquations<Of>& equations, ComplexConfiguration<Of>& at) {
  constexpr int most_steps = 50;
  constexpr double turn = 1;  // radians, or relative to the size: a longer step leads elsewhere
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    typename Of::ComplexClosures by =
        -solved<Of>(jacobian_at(equations, at), closures_at(equations, at));
    const double length = norm_of(by);
    if (!std::isfinite(length)) {
      return false;
    }
    if (length >= last && closes(equations, at)) {
      return true;  // only rounding is left, which moves a multiple configuration far
    }
    if (length > turn) {
      by *= turn / length;
    }
    at = stepped<Of>(at, by);
    last = length;
    if (length == 0) {
      return true;
    }
  }
  return false;
}

/// Sets the ball about `ball.at`; false if there is none. z -> z - Y f(z) maps the ball of radius r
/// about z0 into itself if |Y f(z0)| + q(r) r <= r, where q(r) = |1 - Y J(z0)| + |Y| bending r
/// bounds its derivative in the ball; it has one fixed point in each ball with q < 1.
template <typename Of>
[[nodiscard]] bool enclose(const LoopEquations<Of>& equations, Enclosed<Of>& ball) {
  using Square = typename Of::ComplexSquare;
  Square jacobian = jacobian_at(equations, ball.at);
  for (Eigen::Index slide = 0; slide < ball.at.s.size(); ++slide) {
    jacobian.col(equations.angle_count() + slide) *= unit_of(ball.at.s(slide));
  }
  const Square one = Square::Identity(jacobian.rows(), jacobian.cols());
  const Square inverse = solved<Of>(jacobian, one);
  if (!inverse.allFinite()) {
    return false;
  }
  constexpr double largest_ball = 0.5;  // radians: exp(reach) stays small
  const ClosureBounds<Of> bounds = bounds_of(equations, ball.at, largest_ball);
  const typename Of::Square of_inverse = inverse.cwiseAbs();
  const auto size = static_cast<double>(jacobian.rows());
  const double product_rounding = 4 * size * epsilon;
  const Square left = one - inverse.lazyProduct(jacobian);
  const typename Of::Closures of_rows = jacobian.cwiseAbs().rowwise().sum();
  const typename Of::Closures of_entries = size * bounds.rounding + product_rounding * of_rows;
  const double still = norm_of(left) + norm_of(of_inverse.lazyProduct(of_entries));
  const typename Of::ComplexClosures correction =
      inverse.lazyProduct(closures_at(equations, ball.at));
  const double moved = norm_of(correction) +
                       norm_of(of_inverse.lazyProduct(bounds.rounding)) * (1 + product_rounding);
  const double bent = norm_of(of_inverse.lazyProduct(bounds.bending));
  if (!(still < 0.5)) {
    return false;
  }
  // The largest ball used is that with q = (1 + still) / 2.
  ball.alone = (std::min)(largest_ball, (1 - still) / (2 * bent));
  ball.holds = 2 * moved / (1 - still);
  ball.is_real = distance_between(ball.at, mirrored(ball.at)) + ball.holds < ball.alone;
  return ball.holds <= ball.alone;
}

/// Applies one method after another, each an `Elimination` or a `Start`, until `complex_count`
/// balls are found or no method is left.
template <typename Of, typename Ways>
[[nodiscard]] AllConfigurations<Of> all_configurations(const LoopEquations<Of>& equations,
                                                       const Ways& ways, int complex_count) {
  const double unit = equations.size();
  LoopEquations<Of> own = equations;  // displacements and closures divided by the size
  own.of_angles /= unit;
  AllConfigurations<Of> result;
  const auto found = [&](const ComplexConfiguration<Of>& near) {
    if (result.count() >= complex_count || is_at_infinity(near)) {
      return;
    }
    Enclosed<Of> ball{near, 0, 0, false};
    const bool is_settled = polish(own, ball.at);
    if (is_at_infinity(ball.at)) {
      return;
    }
    if (!is_settled || !enclose(own, ball)) {
      if (!closes(own, ball.at)) {  // if J is singular, Newton's method may not converge
        ball.at = settled(own, made_real(near));
      }
      if (closes(own, ball.at) && !result.unproven.is_full()) {
        ball.at.s *= unit;
        result.unproven.push_back(ball.at);
      }
      return;
    }
    // Only disjoint balls are counted: they cannot hold the same solution.
    for (const Enclosed<Of>& other : result.enclosed) {
      if (distance_between(ball.at, other.at) <= ball.holds + other.holds) {
        return;
      }
    }
    result.enclosed.push_back(ball);
  };
  for (const auto& way : ways) {
    each_candidate<Of>(own, way, found);
    if (result.count() >= complex_count) {
      break;
    }
  }
  for (Enclosed<Of>& ball : result.enclosed) {
    ball.at.s *= unit;
  }
  return result;
}

}  // namespace assur::loops
