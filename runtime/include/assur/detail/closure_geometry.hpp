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
template <typename Real>
using FlatVector = Eigen::Matrix<Real, 4, 1>;
template <typename Real>
using FlatMatrix = Eigen::Matrix<Real, 4, 4>;

/// The loop closures f(q) of one group in double precision, on flat unknowns.
template <typename Real>
struct Closures {
  void (*evaluate)(const void* group, const FlatVariables<Real>& q, FlatVector<Real>& f);
  void (*differentiate)(const void* group, const FlatVariables<Real>& q,
                        FlatMatrix<Real>& jacobian);
  const void* group;
  const ModelUnknown* unknowns;
  int size;
  Real farthest;   ///< coordinate among the inputs
  Real displaced;  ///< by rounding, the inputs, at most

  [[nodiscard]] FlatVector<Real> at(const FlatVariables<Real>& q) const {
    FlatVector<Real> f = FlatVector<Real>::Zero();
    evaluate(group, q, f);
    return f;
  }
  /// Against steps as `advance` takes them.
  [[nodiscard]] FlatMatrix<Real> jacobian(const FlatVariables<Real>& q) const {
    FlatMatrix<Real> result = FlatMatrix<Real>::Identity();
    differentiate(group, q, result);
    std::size_t place = 0;
    for (int unknown = 0; unknown < size; ++unknown) {
      if (unknowns[unknown].is_angle) {
        place += 2;
      } else {
        result.col(unknown) *= unit_of(q[place++]);
      }
    }
    return result;
  }
  /// A displacement far beyond the longest length is measured in itself.
  [[nodiscard]] static Real unit_of(Real displacement) {
    return std::max<Real>(1, std::abs(displacement));
  }
  /// The unknowns moved by a step: displacements shift, angles turn, without trigonometric
  /// functions.
  void advance(const FlatVector<Real>& step, FlatVariables<Real>& q) const {
    std::size_t place = 0;
    for (int unknown = 0; unknown < size; ++unknown) {
      const Real by = step(unknown);
      if (unknowns[unknown].is_angle) {
        // The half angle's tangent by/2 turns by nearly `by`.
        const Real half = by / 2;
        const Real norm = 1 + half * half;
        const Real c = (1 - half * half) / norm;
        const Real s = 2 * half / norm;
        const Real cos = c * q[place] - s * q[place + 1];
        const Real sin = s * q[place] + c * q[place + 1];
        const Real length = std::sqrt(cos * cos + sin * sin);
        q[place] = length > 0 ? cos / length : 1;
        q[place + 1] = length > 0 ? sin / length : 0;
        place += 2;
      } else {
        q[place] += by * unit_of(q[place]);
        ++place;
      }
    }
  }
  /// Pairs that are no directions yet become some.
  void straighten(FlatVariables<Real>& q) const { advance(FlatVector<Real>::Zero(), q); }
};

/// The longest displacement among flat unknowns.
template <typename Real>
[[nodiscard]] Real longest_displacement(const Closures<Real>& closures,
                                        const FlatVariables<Real>& q) {
  Real longest = 0;
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

/// What rounding leaves of closures among lengths of at most one: the rounding of the closures
/// themselves, and that of the groups that were placed before.
template <typename Real>
[[nodiscard]] Real rounding(const Closures<Real>& closures, const FlatVariables<Real>& q) {
  return 32 * std::numeric_limits<Real>::epsilon() *
             (1 + closures.farthest + longest_displacement(closures, q)) +
         4 * closures.displaced;
}

/// The largest difference of two lists of unknowns; of long displacements in parts of them.
template <typename Real>
[[nodiscard]] Real distance(const Closures<Real>& closures, const FlatVariables<Real>& one,
                            const FlatVariables<Real>& other) {
  Real largest = 0;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    for (int part = closures.unknowns[unknown].is_angle ? 2 : 1; part > 0; --part, ++place) {
      const Real size = std::max<Real>({1, std::abs(one[place]), std::abs(other[place])});
      largest = std::max(largest, std::abs(one[place] - other[place]) / size);
    }
  }
  return largest;
}

/// Newton's step.
template <typename Real>
[[nodiscard]] FlatVector<Real> newton_step(const FlatMatrix<Real>& jacobian,
                                           const FlatVector<Real>& f) {
  return Eigen::FullPivLU<FlatMatrix<Real>>(jacobian).solve(-f);
}

/// Levenberg's step, the least |J s + f|^2 + damping^2 |s|^2, from the normal equations. With the
/// residual as damping it leads from any side onto singular assemblies and onto curves of
/// assemblies; what is below rounding of J^2 stays where it is, so that it does not move along.
template <typename Real>
[[nodiscard]] FlatVector<Real> damped_step(const FlatMatrix<Real>& jacobian,
                                           const FlatVector<Real>& f, Real damping) {
  FlatMatrix<Real> normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += std::max<Real>(damping * damping, 1e-30);
  const FlatVector<Real> downhill = -(jacobian.transpose() * f);
  return Eigen::FullPivLU<FlatMatrix<Real>>(normal).solve(downhill);
}

/// Moves a point so that those closures hold again that hold firmly. Near an assembly of high
/// multiplicity all of them nearly hold in a narrow bent valley: this leads back into it.
template <typename Real>
void restore(const Closures<Real>& closures, FlatVariables<Real>& q) {
  constexpr Real firm = 0.01;
  constexpr int most_steps = 3;
  for (int step = 0; step < most_steps; ++step) {
    closures.advance(damped_step(closures.jacobian(q), closures.at(q), firm), q);
  }
}

/// A point on its way to an assembly.
template <typename Real>
class Closing {
 public:
  Closing(const Closures<Real>& closures, const FlatVariables<Real>& q)
      : closures_(closures), q_(q), f_(closures.at(q)), miss_(f_.norm()) {}

  [[nodiscard]] const FlatVariables<Real>& point() const { return q_; }
  [[nodiscard]] Real miss() const { return miss_; }

  /// False where no step lessens the miss any more.
  bool step() {
    const FlatMatrix<Real> jacobian = closures_.jacobian(q_);
    // Where the Jacobian is nearly singular Newton's step leads anywhere.
    const FlatVector<Real> newton = newton_step(jacobian, f_);
    if (newton.norm() < 100 * miss_ && take(newton, 0.1)) {
      return true;
    }
    const FlatVector<Real> damped = damped_step(jacobian, f_, std::max<Real>(miss_, 1e-15));
    for (const Real part : {1, 4, 16, 64, 256}) {
      if (take(damped / part, 0.99)) {
        return true;
      }
    }
    return !(miss_ < rounding(closures_, q_)) && newton.norm() < 0.1 && take_and_restore(newton);
  }
  /// Newton's step if it lessens the miss at all.
  bool polish() { return take(newton_step(closures_.jacobian(q_), f_), 1); }

 private:
  bool take(const FlatVector<Real>& step, Real enough) {
    FlatVariables<Real> next = q_;
    closures_.advance(step, next);
    return accept(next, enough);
  }

  bool take_and_restore(const FlatVector<Real>& step) {
    FlatVariables<Real> next = q_;
    closures_.advance(step, next);
    restore(closures_, next);
    return accept(next, 0.99);
  }

  bool accept(const FlatVariables<Real>& next, Real enough) {
    const FlatVector<Real> f = closures_.at(next);
    const Real miss = f.norm();
    if (!(miss < enough * miss_)) {
      return false;
    }
    q_ = next;
    f_ = f;
    miss_ = miss;
    return true;
  }

  const Closures<Real>& closures_;
  FlatVariables<Real> q_;
  FlatVector<Real> f_;
  Real miss_;
};

/// Moves a point to an assembly near it, and returns the norm of the closures that is left.
template <typename Real>
Real close(const Closures<Real>& closures, FlatVariables<Real>& q) {
  constexpr int most_steps = 200;
  Closing<Real> closing(closures, q);
  if (closing.miss() < rounding(closures, q) / 8) {
    return closing.miss();  // where it comes from more digits, steps in fewer would only move it
  }
  for (int step = 0; step < most_steps && closing.miss() > 0 && closing.step(); ++step) {
  }
  // Rounding is left: as little as two more steps can make it.
  for (int step = 0; step < 2 && closing.polish(); ++step) {
  }
  q = closing.point();
  return closing.miss();
}

/// Whether two assemblies are one that rounding keeps apart, as it does a multiple one: then the
/// closures hold between them, too.
template <typename Real>
[[nodiscard]] bool are_one(const Closures<Real>& closures, const FlatVariables<Real>& one,
                           const FlatVariables<Real>& other) {
  constexpr Real near = 1e-2;   // a quadruple assembly is known to 1e-3
  constexpr Real equal = 1e-7;  // a double one is known to 1e-8
  const Real apart = distance(closures, one, other);
  if (!(apart < near) || apart < equal) {
    return apart < equal;
  }
  const auto between = [&](Real part) {
    FlatVariables<Real> point = one;
    for (std::size_t place = 0; place < point.size(); ++place) {
      point[place] = (1 - part) * one[place] + part * other[place];
    }
    closures.straighten(point);
    return point;
  };
  // Not in the middle alone: there may stand a third.
  for (const Real part : {Real(0.3), Real(0.5), Real(0.6)}) {
    FlatVariables<Real> point = between(part);
    restore(closures, point);
    if (!(closures.at(point).norm() < rounding(closures, point))) {
      return false;
    }
  }
  return true;
}

/// Directions in which the closures do not change to first order.
template <typename Real>
struct FreeDirections {
  int count = 0;
  FlatMatrix<Real> basis = FlatMatrix<Real>::Zero();  ///< a column each; orthonormal
};

/// The null space of a matrix by Gauss's elimination with full pivoting: what is below `threshold`
/// of the largest pivot counts as zero.
template <typename Real>
[[nodiscard]] FreeDirections<Real> null_space(const FlatMatrix<Real>& matrix, double threshold) {
  Eigen::FullPivLU<FlatMatrix<Real>> factors(matrix);
  factors.setThreshold(threshold);
  FreeDirections<Real> result;
  result.count = static_cast<int>(factors.dimensionOfKernel());
  if (result.count > 0) {
    result.basis.leftCols(result.count) = factors.kernel();
    for (int column = 0; column < result.count; ++column) {
      for (int other = 0; other < column; ++other) {
        const Real along = result.basis.col(other).dot(result.basis.col(column));
        result.basis.col(column) -= along * result.basis.col(other);
      }
      result.basis.col(column).normalize();
    }
  }
  return result;
}

/// The directions in which unknowns may leave an assembly to first order.
template <typename Real>
[[nodiscard]] FreeDirections<Real> free_directions(const Closures<Real>& closures,
                                                   const FlatVariables<Real>& q, double threshold) {
  return null_space(closures.jacobian(q), threshold);
}

/// d2f along a direction: how the closures bend.
template <typename Real>
[[nodiscard]] FlatVector<Real> bend(const Closures<Real>& closures, const FlatVariables<Real>& q,
                                    const FlatVector<Real>& along) {
  constexpr Real step = 0x1p-10;
  FlatVariables<Real> ahead = q;
  FlatVariables<Real> behind = q;
  closures.advance(step * along, ahead);
  closures.advance(-step * along, behind);
  return (closures.at(ahead) + closures.at(behind) - 2 * closures.at(q)) / (step * step);
}

/// Below this a pivot belongs to an assembly at which the closures are singular: rounding of the
/// closures moves a double one by 1e-8, a triple one by 1e-5.
inline constexpr double singular_pivot = 1e-4;
/// Below this a derivative has lost more than six digits, whatever the model's own pivots say.
inline constexpr double lost_pivot = 1e-7;

/// The step that leads from one list of unknowns to another, for small ones.
template <typename Real>
[[nodiscard]] FlatVector<Real> step_between(const Closures<Real>& closures,
                                            const FlatVariables<Real>& from,
                                            const FlatVariables<Real>& to) {
  FlatVector<Real> step = FlatVector<Real>::Zero();
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    if (closures.unknowns[unknown].is_angle) {
      step(unknown) = to[place + 1] * from[place] - to[place] * from[place + 1];
      place += 2;
    } else {
      step(unknown) = (to[place] - from[place]) / Closures<Real>::unit_of(from[place]);
      ++place;
    }
  }
  return step;
}

/// Moves a double assembly that stands alone to where the closures are exactly singular: rounding
/// of the closures leaves it known to the root of epsilon, their derivatives know it to epsilon.
template <typename Real>
void settle(const Closures<Real>& closures, FlatVariables<Real>& q) {
  constexpr int most_steps = 4;
  FlatVariables<Real> settled = q;
  for (int step = 0; step < most_steps; ++step) {
    const FlatMatrix<Real> jacobian = closures.jacobian(settled);
    const FreeDirections<Real> free = null_space(jacobian, singular_pivot);
    const FreeDirections<Real> parts = null_space<Real>(jacobian.transpose(), singular_pivot);
    if (free.count != 1 || parts.count != 1) {
      return;
    }
    const FlatVector<Real> along = free.basis.col(0);
    const FlatVector<Real> part = parts.basis.col(0);
    const Real slope = part.dot(jacobian * along);
    const Real change = part.dot(bend(closures, settled, along));
    if (!(std::abs(slope) < 1e-3 * std::abs(change))) {
      return;  // not a double one
    }
    closures.advance(-slope / change * along, settled);
    restore(closures, settled);
  }
  if (closures.at(settled).norm() < rounding(closures, settled)) {
    q = settled;
  }
}

/// What surrounds a singular assembly: the directions in which others lie close by.
template <typename Real>
class Neighbourhood {
 public:
  /// Looks `reach` away, of the longest length or in radians.
  Neighbourhood(const Closures<Real>& closures, const FlatVariables<Real>& q, Real reach)
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
  [[nodiscard]] const FlatVariables<Real>& neighbour() const { return neighbour_; }

 private:
  /// Directions in the plane of two free ones: those in which a part of the closures that is free
  /// of first order does not bend either, A c^2 + B c s + C s^2 = 0, and some between.
  void try_plane(const FlatVariables<Real>& q, const FlatVector<Real>& one,
                 const FlatVector<Real>& other) {
    const auto at_angle = [&](Real angle) {
      try_both_ways(q, std::cos(angle) * one + std::sin(angle) * other);
    };
    const FreeDirections<Real> parts =
        null_space<Real>(closures_.jacobian(q).transpose(), singular_pivot);
    const FlatVector<Real> a = bend(closures_, q, one);
    const FlatVector<Real> c = bend(closures_, q, other);
    const FlatVector<Real> b = bend<Real>(closures_, q, one + other) - a - c;
    for (int part = 0; part < parts.count; ++part) {
      const Real A = parts.basis.col(part).dot(a);
      const Real B = parts.basis.col(part).dot(b);
      const Real C = parts.basis.col(part).dot(c);
      // (A + C)/2 + (A - C)/2 cos 2x + B/2 sin 2x = 0.
      const Real size = std::hypot(A - C, B);
      const Real inside = -(A + C) / size;
      if (size > 0 && std::abs(inside) <= 1 + 1e-6) {
        const Real reach_of_angle = std::acos(std::clamp<Real>(inside, -1, 1)) / 2;
        const Real middle = std::atan2(B, A - C) / 2;
        at_angle(middle + reach_of_angle);
        at_angle(middle - reach_of_angle);
      }
    }
    constexpr int turns = 6;
    for (int turn = 1; turn < turns; ++turn) {
      at_angle(3.14159265358979 * turn / turns + 0.1);
    }
  }

  void try_both_ways(const FlatVariables<Real>& q, const FlatVector<Real>& along) {
    for (const Real way : {reach_, -reach_}) {
      FlatVariables<Real> to = q;
      closures_.advance(way * along, to);
      // Where neighbours are displaced, a family closes to within rounding everywhere and exactly
      // in a few places; steps that lessen what is below rounding would lead there.
      restore(closures_, to);
      Real miss = closures_.at(to).norm();
      if (!(miss < rounding(closures_, to))) {
        miss = close(closures_, to);
      }
      FlatVector<Real> step = step_between(closures_, q, to);
      const Real length = step.norm();
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

  const Closures<Real>& closures_;
  Real reach_;
  FreeDirections<Real> free_;
  FlatMatrix<Real> tangents_ = FlatMatrix<Real>::Zero();
  FlatVariables<Real> neighbour_{};
  int dimension_ = 0;
};

/// How many freedoms a singular assembly has; zero for one that stands alone. Where families cross,
/// the freedoms of the one that is left first; so a neighbour is asked, not the assembly itself. It
/// is asked at another distance, at which it does not see where it was reached from: two assemblies
/// that stand alone are no family.
template <typename Real>
[[nodiscard]] int mobility_at(const Closures<Real>& closures, const FlatVariables<Real>& q) {
  const Neighbourhood<Real> here(closures, q, 0.02);
  return here.dimension() == 0 ? 0
                               : Neighbourhood<Real>(closures, here.neighbour(), 0.05).dimension();
}

}  // namespace assur::detail
