// Turns a point near an assembly into the assembly, and an assembly into its free directions.
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

/// A configuration with a longer displacement, among lengths near one, counts as having run to
/// infinity.
template <typename Scalar>
inline constexpr Scalar farthest_configuration =
    numeric::power_of_two<Scalar>(std::numeric_limits<Scalar>::digits / 2 - 2);

/// The loop closures f(q) of one group in double precision, on flat unknowns: at most four closures
/// in four unknowns. Where a group has fewer, J is filled up with the identity, which changes
/// nothing.
struct Closures {
  void (*evaluate)(const void* group, const FlatVariables<double>& q, Vector4& f);
  void (*differentiate)(const void* group, const FlatVariables<double>& q, Matrix4& jacobian);
  const void* group;
  const ModelUnknown* unknowns;
  int size;
  double farthest;   ///< the largest coordinate among the inputs
  double displaced;  ///< how far rounding may have displaced the inputs
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
  /// A displacement beyond the longest length is measured in parts of itself.
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

/// The longest displacement among flat unknowns, in parts of the longest length.
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

/// What rounding leaves of closures among lengths of at most one: the rounding of the closures
/// themselves, and that of the groups that were placed before.
[[nodiscard]] inline double rounding(const Closures& closures, const FlatVariables<double>& q) {
  return 32 * std::numeric_limits<double>::epsilon() *
             (1 + closures.farthest / closures.longest + longest_displacement(closures, q)) +
         4 * closures.displaced / closures.longest;
}

/// The largest difference of two lists of unknowns; long displacements count in parts of
/// themselves.
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

/// A pivot below this part of the largest one is rounding.
inline constexpr double pivot_rounding = 4 * std::numeric_limits<double>::epsilon();

/// Newton's step.
[[nodiscard]] inline Vector4 newton_step(const Matrix4& jacobian, const Vector4& f) {
  return -1 * Elimination(jacobian, pivot_rounding).solve(f);
}

/// Levenberg's step, the least |J s + f|^2 + damping^2 |s|^2, from the normal equations. With the
/// residual as damping it leads from any side onto singular assemblies and onto curves of
/// assemblies; it has no part along directions that are below the rounding of J^2, along which it
/// would drift.
[[nodiscard]] inline Vector4 damped_step(const Matrix4& jacobian, const Vector4& f,
                                         double damping) {
  Matrix4 normal;
  for (int unknown = 0; unknown < 4; ++unknown) {
    normal.column(unknown) = transposed_product(jacobian, jacobian.column(unknown));
    normal(unknown, unknown) += (std::max)(damping * damping, 1e-30);
  }
  return -1 * Elimination(normal, pivot_rounding).solve(transposed_product(jacobian, f));
}

/// Moves a point so that the closures that hold it firmly are satisfied again. Near an assembly of
/// high multiplicity all closures nearly hold in a narrow bent valley: this leads back into it.
inline void restore(const Closures& closures, FlatVariables<double>& q) {
  constexpr double firm = 0.01;
  constexpr int most_steps = 3;
  for (int step = 0; step < most_steps; ++step) {
    closures.advance(damped_step(closures.jacobian(q), closures.at(q), firm), q);
  }
}

/// A point on its way to an assembly.
class Closing {
 public:
  Closing(const Closures& closures, const FlatVariables<double>& q)
      : closures_(closures), q_(q), f_(closures.at(q)), miss_(norm(f_)) {}

  [[nodiscard]] const FlatVariables<double>& point() const { return q_; }
  [[nodiscard]] double miss() const { return miss_; }

  /// False where no step lessens the miss any more.
  bool step() {
    const Matrix4 jacobian = closures_.jacobian(q_);
    // Where the Jacobian is nearly singular Newton's step leads anywhere.
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
  /// Newton's step if it lessens the miss at all.
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

/// Moves a point to an assembly near it, and returns the norm of the closures that is left.
inline double close(const Closures& closures, FlatVariables<double>& q) {
  constexpr int most_steps = 200;
  Closing closing(closures, q);
  if (closing.miss() < rounding(closures, q) / 8) {
    return closing.miss();  // steps in fewer digits than the point has would only move it
  }
  for (int step = 0; step < most_steps && closing.miss() > 0 && closing.step(); ++step) {
  }
  // What is left is rounding; two more steps make it as small as they can.
  for (int step = 0; step < 2 && closing.polish(); ++step) {
  }
  q = closing.point();
  return closing.miss();
}

/// The least norm of the closures near a point from which no assembly is reached: far from one,
/// Gauss-Newton steps are too long unless they are damped, by about as much as the last one needed.
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

/// Whether two assemblies are one that rounding keeps apart, as it does a multiple assembly: then
/// the closures hold between the two as well.
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
  // The middle alone does not tell: a third assembly may stand there.
  for (const double part : {0.3, 0.5, 0.6}) {
    FlatVariables<double> point = between(part);
    restore(closures, point);
    if (!(norm(closures.at(point)) < rounding(closures, point))) {
      return false;
    }
  }
  return true;
}

/// Directions in which the closures do not change to first order.
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

/// The directions in which unknowns may leave an assembly to first order.
[[nodiscard]] inline FreeDirections free_directions(const Closures& closures,
                                                    const FlatVariables<double>& q,
                                                    double threshold) {
  return null_space(closures.jacobian(q), threshold);
}

/// Below this a pivot belongs to an assembly at which the closures are singular: rounding of the
/// closures moves a double one by 1e-8, a triple one by 1e-5.
inline constexpr double singular_pivot = 1e-4;
/// Below this a derivative has lost more than six digits, whatever the model's own pivots say.
inline constexpr double lost_pivot = 1e-7;

}  // namespace assur::detail
