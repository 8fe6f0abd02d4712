// Turns a point near an assembly into the assembly, and tells one that stands from one that moves.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <assur/model.hpp>
#include <assur/support/flat_variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

using support::FlatVariables;

/// A configuration with a longer displacement, among lengths near one, has run to infinity as far
/// as rounding lets tell.
inline constexpr double farthest_configuration = 0x1p24;

/// Four closures in four unknowns at most. Where a group has fewer, the rest are those of the
/// identity, which change nothing.
using FlatVector = Eigen::Matrix<double, 4, 1>;
using FlatMatrix = Eigen::Matrix<double, 4, 4>;

/// The loop closures f(q) of one group in double precision, on flat unknowns.
struct Closures {
  void (*evaluate)(const void* group, const FlatVariables<double>& q, FlatVector& f);
  void (*differentiate)(const void* group, const FlatVariables<double>& q, FlatMatrix& jacobian);
  const void* group;
  const ModelUnknown* unknowns;
  int size;
  double farthest;  ///< coordinate among the inputs

  [[nodiscard]] FlatVector at(const FlatVariables<double>& q) const {
    FlatVector f = FlatVector::Zero();
    evaluate(group, q, f);
    return f;
  }
  [[nodiscard]] FlatMatrix jacobian(const FlatVariables<double>& q) const {
    FlatMatrix result = FlatMatrix::Identity();
    differentiate(group, q, result);
    return result;
  }
};

/// The longest displacement among flat unknowns.
[[nodiscard]] inline double longest_displacement(const Closures& closures,
                                                 const FlatVariables<double>& q) {
  double longest = 0;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    if (closures.unknowns[unknown].is_angle) {
      place += 2;
    } else {
      longest = std::max(longest, std::abs(q[place++]));
    }
  }
  return longest;
}

/// What rounding leaves of closures among lengths of at most one.
[[nodiscard]] inline double rounding(const Closures& closures, const FlatVariables<double>& q) {
  return 32 * std::numeric_limits<double>::epsilon() *
         (1 + closures.farthest + longest_displacement(closures, q));
}

/// The unknowns moved by a step: displacements shift, angles turn, without trigonometric functions.
inline void advance(const Closures& closures, const FlatVector& step, FlatVariables<double>& q) {
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    const double by = step(unknown);
    if (closures.unknowns[unknown].is_angle) {
      // The half angle's tangent by/2 turns by nearly `by`.
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
      q[place++] += by;
    }
  }
}

/// The largest difference of two lists of unknowns.
[[nodiscard]] inline double distance(const Closures& closures, const FlatVariables<double>& one,
                                     const FlatVariables<double>& other) {
  double largest = 0;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    for (int part = closures.unknowns[unknown].is_angle ? 2 : 1; part > 0; --part, ++place) {
      largest = std::max(largest, std::abs(one[place] - other[place]));
    }
  }
  return largest;
}

/// A step of Newton, or of Levenberg with the residual as damping: that one leads from any side
/// onto singular assemblies and onto curves of assemblies.
[[nodiscard]] inline FlatVector closing_step(const FlatMatrix& jacobian, const FlatVector& f,
                                             bool damped) {
  if (!damped) {
    return Eigen::FullPivLU<FlatMatrix>(jacobian).solve(-f);
  }
  FlatMatrix normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += std::max(f.squaredNorm(), 1e-30);
  const FlatVector downhill = -(jacobian.transpose() * f);
  return Eigen::FullPivLU<FlatMatrix>(normal).solve(downhill);
}

/// Moves a point to an assembly near it, and returns the norm of the closures that is left.
inline double close(const Closures& closures, FlatVariables<double>& q) {
  constexpr int most_steps = 200;
  FlatVector f = closures.at(q);
  double miss = f.norm();
  if (miss < rounding(closures, q) / 8) {
    return miss;  // where it comes from more digits, steps in fewer would only move it
  }
  const auto lessened = [&](const FlatVector& step, double enough) {
    FlatVariables<double> next = q;
    advance(closures, step, next);
    const FlatVector next_f = closures.at(next);
    const double next_miss = next_f.norm();
    if (!(next_miss < enough * miss)) {
      return false;
    }
    q = next;
    f = next_f;
    miss = next_miss;
    return true;
  };
  for (int step = 0; step < most_steps && miss > 0; ++step) {
    const FlatMatrix jacobian = closures.jacobian(q);
    // Where the Jacobian is nearly singular Newton's step leads anywhere.
    const FlatVector newton = closing_step(jacobian, f, false);
    if (newton.norm() < 100 * miss && lessened(newton, 0.1)) {
      continue;
    }
    FlatVector move = closing_step(jacobian, f, true);
    bool better = lessened(move, 0.99);
    for (int cut = 0; cut < 4 && !better; ++cut) {
      move /= 4;
      better = lessened(move, 0.99);
    }
    if (!better) {
      break;
    }
  }
  // Rounding is left: as little as two more steps can make it.
  for (int step = 0; step < 2 && lessened(closing_step(closures.jacobian(q), f, false), 1);
       ++step) {
  }
  return miss;
}

/// Whether two assemblies are one that rounding keeps apart, as it does a multiple one: then the
/// closures hold between them, too, or on a bend very near there.
[[nodiscard]] inline bool are_one(const Closures& closures, const FlatVariables<double>& one,
                                  const FlatVariables<double>& other) {
  constexpr double near = 1e-2;   // a quadruple assembly is known to 1e-3
  constexpr double equal = 1e-7;  // a double one is known to 1e-8
  const double apart = distance(closures, one, other);
  if (!(apart < near) || apart < equal) {
    return apart < equal;
  }
  const auto between = [&](double part) {
    FlatVariables<double> point = one;
    for (std::size_t place = 0; place < point.size(); ++place) {
      point[place] = (1 - part) * one[place] + part * other[place];
    }
    advance(closures, FlatVector::Zero(), point);
    return point;
  };
  const FlatVariables<double> middle = between(0.5);
  if (closures.at(middle).norm() < rounding(closures, middle)) {
    return true;
  }
  // Not in the middle: there may stand a third.
  for (const double part : {0.3, 0.6}) {
    const FlatVariables<double> from = between(part);
    FlatVariables<double> to = from;
    if (!(close(closures, to) < rounding(closures, to) &&
          distance(closures, from, to) < 0.1 * apart)) {
      return false;
    }
  }
  return true;
}

/// Directions in which the closures do not change to first order.
struct FreeDirections {
  int count = 0;
  FlatMatrix basis = FlatMatrix::Zero();  ///< a column each; orthonormal
};

/// The null space of a matrix by Gauss's elimination with full pivoting: what is below `threshold`
/// of the largest pivot counts as zero.
[[nodiscard]] inline FreeDirections null_space(const FlatMatrix& matrix, double threshold) {
  Eigen::FullPivLU<FlatMatrix> factors(matrix);
  factors.setThreshold(threshold);
  FreeDirections result;
  result.count = static_cast<int>(factors.dimensionOfKernel());
  if (result.count > 0) {
    result.basis.leftCols(result.count) = factors.kernel();
    for (int column = 0; column < result.count; ++column) {
      for (int other = 0; other < column; ++other) {
        const double along = result.basis.col(other).dot(result.basis.col(column));
        result.basis.col(column) -= along * result.basis.col(other);
      }
      result.basis.col(column).normalize();
    }
  }
  return result;
}

/// The directions in which unknowns may leave an assembly to first order.
[[nodiscard]] inline FreeDirections free_directions(const Closures& closures,
                                                    const FlatVariables<double>& q,
                                                    double threshold) {
  return null_space(closures.jacobian(q), threshold);
}

/// d2f along a direction: how the closures bend.
[[nodiscard]] inline FlatVector bend(const Closures& closures, const FlatVariables<double>& q,
                                     const FlatVector& along) {
  constexpr double step = 0x1p-10;
  FlatVariables<double> ahead = q;
  FlatVariables<double> behind = q;
  advance(closures, step * along, ahead);
  advance(closures, -step * along, behind);
  return (closures.at(ahead) + closures.at(behind) - 2 * closures.at(q)) / (step * step);
}

/// Below this a pivot belongs to an assembly at which the closures are singular: rounding of the
/// closures moves a double one by 1e-8, a triple one by 1e-5.
inline constexpr double singular_pivot = 1e-4;
/// Below this a derivative has lost more than six digits, whatever the model's own pivots say.
inline constexpr double lost_pivot = 1e-7;

/// The step that leads from one list of unknowns to another, for small ones.
[[nodiscard]] inline FlatVector step_between(const Closures& closures,
                                             const FlatVariables<double>& from,
                                             const FlatVariables<double>& to) {
  FlatVector step = FlatVector::Zero();
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    if (closures.unknowns[unknown].is_angle) {
      step(unknown) = to[place + 1] * from[place] - to[place] * from[place + 1];
      place += 2;
    } else {
      step(unknown) = to[place] - from[place];
      ++place;
    }
  }
  return step;
}

/// What surrounds a singular assembly: the directions in which others lie close by.
class Neighbourhood {
 public:
  /// Looks `reach` away, of the longest length or in radians.
  Neighbourhood(const Closures& closures, const FlatVariables<double>& q, double reach)
      : closures_(closures), reach_(reach), free_(free_directions(closures, q, singular_pivot)) {
    for (int one = 0; one < free_.count; ++one) {
      try_both_ways(q, free_.basis.col(one));
      for (int other = 0; other < one; ++other) {
        try_plane(q, free_.basis.col(one), free_.basis.col(other));
      }
    }
  }

  /// How many of the directions are independent: the dimension of the family, or zero.
  [[nodiscard]] int dimension() const { return dimension_; }
  /// An assembly close by, singular as well; requires dimension() > 0.
  [[nodiscard]] const FlatVariables<double>& neighbour() const { return neighbour_; }

 private:
  /// Directions in the plane of two free ones: those in which a part of the closures that is free
  /// of first order does not bend either, A c^2 + B c s + C s^2 = 0, and some between.
  void try_plane(const FlatVariables<double>& q, const FlatVector& one, const FlatVector& other) {
    const auto at_angle = [&](double angle) {
      try_both_ways(q, std::cos(angle) * one + std::sin(angle) * other);
    };
    const FreeDirections parts = null_space(closures_.jacobian(q).transpose(), singular_pivot);
    const FlatVector a = bend(closures_, q, one);
    const FlatVector c = bend(closures_, q, other);
    const FlatVector b = bend(closures_, q, one + other) - a - c;
    for (int part = 0; part < parts.count; ++part) {
      const double A = parts.basis.col(part).dot(a);
      const double B = parts.basis.col(part).dot(b);
      const double C = parts.basis.col(part).dot(c);
      // (A + C)/2 + (A - C)/2 cos 2x + B/2 sin 2x = 0.
      const double size = std::hypot(A - C, B);
      const double inside = -(A + C) / size;
      if (size > 0 && std::abs(inside) <= 1 + 1e-6) {
        const double reach_of_angle = std::acos(std::clamp(inside, -1.0, 1.0)) / 2;
        const double middle = std::atan2(B, A - C) / 2;
        at_angle(middle + reach_of_angle);
        at_angle(middle - reach_of_angle);
      }
    }
    constexpr int turns = 6;
    for (int turn = 1; turn < turns; ++turn) {
      at_angle(3.14159265358979 * turn / turns + 0.1);
    }
  }

  void try_both_ways(const FlatVariables<double>& q, const FlatVector& along) {
    for (const double way : {reach_, -reach_}) {
      FlatVariables<double> to = q;
      advance(closures_, way * along, to);
      const double miss = close(closures_, to);
      FlatVector step = step_between(closures_, q, to);
      const double length = step.norm();
      if (!(miss < rounding(closures_, to)) || length < 0.7 * reach_ || length > 1.4 * reach_ ||
          free_directions(closures_, to, singular_pivot).count == 0) {
        continue;
      }
      for (int known = 0; known < dimension_; ++known) {
        step -= tangents_.col(known).dot(step) * tangents_.col(known);
      }
      // A curve bends by less.
      if (dimension_ < free_.count && step.norm() > 0.35 * length) {
        neighbour_ = to;
        tangents_.col(dimension_) = step.normalized();
        ++dimension_;
      }
    }
  }

  const Closures& closures_;
  double reach_;
  FreeDirections free_;
  FlatMatrix tangents_ = FlatMatrix::Zero();
  FlatVariables<double> neighbour_{};
  int dimension_ = 0;
};

/// How many freedoms a singular assembly has; zero for one that stands alone. Where families cross,
/// the freedoms of the one that is left first; so a neighbour is asked, not the assembly itself. It
/// is asked at another distance, at which it does not see where it was reached from: two assemblies
/// that stand alone are no family.
[[nodiscard]] inline int mobility_at(const Closures& closures, const FlatVariables<double>& q) {
  const Neighbourhood here(closures, q, 0.02);
  return here.dimension() == 0 ? 0 : Neighbourhood(closures, here.neighbour(), 0.05).dimension();
}

}  // namespace assur::detail
