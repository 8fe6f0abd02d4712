// Closing a group from a nearby point, and the free directions of a configuration.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <assur/numeric/matrix4.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/flat_variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

using numeric::Elimination;
using numeric::Matrix4;
using numeric::Vector4;
using support::FlatVariables;

/// A configuration with a longer displacement, among lengths near one, counts as infinite.
template <typename Scalar>
inline constexpr Scalar farthest_configuration =
    numeric::power_of_two<Scalar>(std::numeric_limits<Scalar>::digits / 2 - 2);

/// The loop closures f(q) of one group in double precision, on flat unknowns: at most four closures
/// in four unknowns. For a group with fewer, J is padded with the identity, which changes nothing.
struct Closures {
  void (*evaluate)(const void* group, const FlatVariables<double>& q, Vector4& f);
  void (*differentiate)(const void* group, const FlatVariables<double>& q, Matrix4& jacobian);
  const void* group;
  const ModelUnknown* unknowns;
  int size;
  double farthest;   ///< the largest coordinate among the inputs
  double displaced;  ///< bound on the displacement of the inputs by rounding
  /// The longest length of the group, the unit of what follows. It may be much less than one in a
  /// specialised group.
  double longest = 1;

  [[nodiscard]] Vector4 at(const FlatVariables<double>& q) const {
    Vector4 f;
    evaluate(group, q, f);
    return 1 / longest * f;
  }
  /// The Jacobian with respect to the steps of `advance`.
  [[nodiscard]] Matrix4 jacobian(const FlatVariables<double>& q) const {
    Matrix4 result = Matrix4::identity();
    differentiate(group, q, result);
    std::size_t place = 0;
    for (int unknown = 0; unknown < size; ++unknown) {
      if (unknowns[unknown].is_angle) {
        result.column(unknown) = 1 / longest * result.column(unknown);
        place += 2;
      } else {
        result.column(unknown) = unit_of(q[place]) / longest * result.column(unknown);
        ++place;
      }
    }
    return result;
  }
  /// The unit in which a displacement is measured: the longest length, or the displacement itself
  /// if it is longer.
  [[nodiscard]] double unit_of(double displacement) const {
    return (std::max)(longest, std::abs(displacement));
  }
  /// The unknowns moved by a step: displacements shift, angles turn, without trigonometric
  /// functions.
  void advance(const Vector4& step, FlatVariables<double>& q) const {
    std::size_t place = 0;
    for (int unknown = 0; unknown < size; ++unknown) {
      const double by = step(unknown);
      if (unknowns[unknown].is_angle) {
        // A turn whose half angle has the tangent by/2 is nearly `by`.
        const double half = by / 2;
        const double norm = 1 + half * half;
        const double c = (1 - half * half) / norm;
        const double s = 2 * half / norm;
        const double cos = c * q[place] - s * q[place + 1];
        const double sin = s * q[place] + c * q[place + 1];
        const double length = std::sqrt(cos * cos + sin * sin);
        q[place] = length > 0 ? cos / length : 1;
        q[place + 1] = length > 0 ? sin / length : 0;
        place += 2;
      } else {
        q[place] += by * unit_of(q[place]);
        ++place;
      }
    }
  }
  /// Scales pairs to directions.
  void straighten(FlatVariables<double>& q) const { advance(Vector4(), q); }
};

/// The longest displacement among flat unknowns, divided by the longest length.
[[nodiscard]] inline double longest_displacement(const Closures& closures,
                                                 const FlatVariables<double>& q) {
  double longest = 0;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    if (closures.unknowns[unknown].is_angle) {
      place += 2;
    } else {
      longest = (std::max)(longest, std::abs(q[place++]));
    }
  }
  return longest / closures.longest;
}

/// The residual that rounding leaves of closures with lengths of at most one: the rounding of the
/// closures themselves, and that of the groups placed before.
[[nodiscard]] inline double rounding(const Closures& closures, const FlatVariables<double>& q) {
  return 32 * std::numeric_limits<double>::epsilon() *
             (1 + closures.farthest / closures.longest + longest_displacement(closures, q)) +
         4 * closures.displaced / closures.longest;
}

/// The largest difference of two lists of unknowns, relative for long displacements.
[[nodiscard]] inline double distance(const Closures& closures, const FlatVariables<double>& one,
                                     const FlatVariables<double>& other) {
  double largest = 0;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    const bool is_angle = closures.unknowns[unknown].is_angle;
    const double unit = is_angle ? 1 : closures.longest;
    for (int part = is_angle ? 2 : 1; part > 0; --part, ++place) {
      const double size = (std::max)({unit, std::abs(one[place]), std::abs(other[place])});
      largest = (std::max)(largest, std::abs(one[place] - other[place]) / size);
    }
  }
  return largest;
}

/// A pivot below this fraction of the largest one is due to rounding.
inline constexpr double pivot_rounding = 4 * std::numeric_limits<double>::epsilon();

/// Newton's step.
[[nodiscard]] inline Vector4 newton_step(const Matrix4& jacobian, const Vector4& f) {
  return -1 * Elimination(jacobian, pivot_rounding).solve(f);
}

/// Levenberg's step, the least |J s + f|^2 + damping^2 |s|^2, from the normal equations. With the
/// residual as damping it converges from any side to singular assemblies and to curves of
/// assemblies; it has no component along directions below the rounding of J^2, along which it would
/// drift.
[[nodiscard]] inline Vector4 damped_step(const Matrix4& jacobian, const Vector4& f,
                                         double damping) {
  Matrix4 normal;
  for (int unknown = 0; unknown < 4; ++unknown) {
    normal.column(unknown) = transposed_product(jacobian, jacobian.column(unknown));
    normal(unknown, unknown) += (std::max)(damping * damping, 1e-30);
  }
  return -1 * Elimination(normal, pivot_rounding).solve(transposed_product(jacobian, f));
}

/// Moves a point so that the well-conditioned closures are satisfied again. Near an assembly of
/// high multiplicity all closures nearly hold in a narrow curved valley: this leads back into it.
inline void restore(const Closures& closures, FlatVariables<double>& q) {
  constexpr double firm = 0.01;
  constexpr int most_steps = 3;
  for (int step = 0; step < most_steps; ++step) {
    closures.advance(damped_step(closures.jacobian(q), closures.at(q), firm), q);
  }
}

/// The iteration from a point to an assembly.
class Closing {
 public:
  Closing(const Closures& closures, const FlatVariables<double>& q)
      : closures_(closures), q_(q), f_(closures.at(q)), miss_(norm(f_)) {}

  [[nodiscard]] const FlatVariables<double>& point() const { return q_; }
  [[nodiscard]] double miss() const { return miss_; }

  /// False if no step reduces the residual any further.
  bool step() {
    const Matrix4 jacobian = closures_.jacobian(q_);
    // If the Jacobian is nearly singular, Newton's step is arbitrary.
    const Vector4 newton = newton_step(jacobian, f_);
    if (norm(newton) < 100 * miss_ && take(newton, 0.1)) {
      return true;
    }
    const Vector4 damped = damped_step(jacobian, f_, (std::max)(miss_, 1e-15));
    for (const double part : {1.0, 4.0, 16.0, 64.0, 256.0}) {
      if (take(1 / part * damped, 0.99)) {
        return true;
      }
    }
    return !(miss_ < rounding(closures_, q_)) && norm(newton) < 0.1 && take_and_restore(newton);
  }
  /// Newton's step, if it reduces the residual at all.
  bool polish() { return take(newton_step(closures_.jacobian(q_), f_), 1); }

 private:
  bool take(const Vector4& step, double enough) {
    FlatVariables<double> next = q_;
    closures_.advance(step, next);
    return accept(next, enough);
  }

  bool take_and_restore(const Vector4& step) {
    FlatVariables<double> next = q_;
    closures_.advance(step, next);
    restore(closures_, next);
    return accept(next, 0.99);
  }

  bool accept(const FlatVariables<double>& next, double enough) {
    const Vector4 f = closures_.at(next);
    const double miss = norm(f);
    if (!(miss < enough * miss_)) {
      return false;
    }
    q_ = next;
    f_ = f;
    miss_ = miss;
    return true;
  }

  const Closures& closures_;
  FlatVariables<double> q_;
  Vector4 f_;
  double miss_;
};

/// Moves a point to an assembly near it, and returns the norm of the remaining residual.
inline double close(const Closures& closures, FlatVariables<double>& q) {
  constexpr int most_steps = 200;
  Closing closing(closures, q);
  if (closing.miss() < rounding(closures, q) / 8) {
    return closing.miss();  // steps with fewer digits than the point has would only move it
  }
  for (int step = 0; step < most_steps && closing.miss() > 0 && closing.step(); ++step) {
  }
  // The residual is at rounding level; two more steps reduce it as far as possible.
  for (int step = 0; step < 2 && closing.polish(); ++step) {
  }
  q = closing.point();
  return closing.miss();
}

/// The least norm of the closures near a point from which no assembly is reached. Far from an
/// assembly, Gauss-Newton steps are too long unless they are damped, each by about as much as the
/// last.
[[nodiscard]] inline double least_miss_near(const Closures& closures, FlatVariables<double> q) {
  constexpr int most_steps = 1000;
  constexpr double stiffest = 1e8;
  double damping = 1;
  Vector4 f = closures.at(q);
  bool gains = true;
  for (int step = 0; step < most_steps && gains && damping < stiffest; ++step) {
    FlatVariables<double> next = q;
    closures.advance(damped_step(closures.jacobian(q), f, damping), next);
    const Vector4 left = closures.at(next);
    const double gain = norm(f) - norm(left);
    if (gain > 0) {
      gains = gain > std::numeric_limits<double>::epsilon() * norm(f);
      q = next;
      f = left;
      damping /= 2;
    } else {
      damping *= 4;
    }
  }
  return norm(f);
}

/// Whether two assemblies are one multiple assembly that rounding splits: then the closures also
/// hold between the two.
[[nodiscard]] inline bool are_one(const Closures& closures, const FlatVariables<double>& one,
                                  const FlatVariables<double>& other) {
  constexpr double close_by = 1e-2;  // a quadruple assembly is known to 1e-3
  constexpr double equal = 1e-7;     // a double one is known to 1e-8
  const double apart = distance(closures, one, other);
  if (!(apart < close_by) || apart < equal) {
    return apart < equal;
  }
  const auto between = [&](double part) {
    FlatVariables<double> point = one;
    for (std::size_t place = 0; place < point.size(); ++place) {
      point[place] = (1 - part) * one[place] + part * other[place];
    }
    closures.straighten(point);
    return point;
  };
  // The midpoint alone is not enough: a third assembly may lie there.
  for (const double part : {0.3, 0.5, 0.6}) {
    FlatVariables<double> point = between(part);
    restore(closures, point);
    if (!(norm(closures.at(point)) < rounding(closures, point))) {
      return false;
    }
  }
  return true;
}

/// Directions along which the closures do not change to first order.
struct FreeDirections {
  int count = 0;
  Matrix4 basis;  ///< one per column; orthonormal
};

/// The null space of a matrix by Gauss's elimination with full pivoting: pivots below `threshold`
/// times the largest count as zero.
[[nodiscard]] inline FreeDirections null_space(const Matrix4& matrix, double threshold) {
  const Elimination factors(matrix, threshold);
  FreeDirections result;
  result.count = 4 - factors.rank();
  for (int column = 0; column < result.count; ++column) {
    Vector4 direction = factors.null_vector(column);
    for (int other = 0; other < column; ++other) {
      const Vector4& known = result.basis.column(other);
      direction = direction - dot(known, direction) * known;
    }
    result.basis.column(column) = normalised(direction);
  }
  return result;
}

/// The directions along which unknowns may leave an assembly to first order.
[[nodiscard]] inline FreeDirections free_directions(const Closures& closures,
                                                    const FlatVariables<double>& q,
                                                    double threshold) {
  return null_space(closures.jacobian(q), threshold);
}

/// A pivot below this means that the closures are singular at the assembly: rounding moves a double
/// assembly by 1e-8, a triple one by 1e-5.
inline constexpr double singular_pivot = 1e-4;
/// With a pivot below this a derivative has lost more than six digits, whatever the model's own
/// pivots are.
inline constexpr double lost_pivot = 1e-7;

}  // namespace assur::detail
