// Turns a point near an assembly into the assembly, and tells one that stands from one that moves.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <assur/detail/flat_variables.hpp>
#include <assur/model.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

/// Four unknowns at most: the sizes of a model's equations at run time.
using FlatVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4, 1>;
using FlatMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 4>;

/// The loop closures f(q) of one group in double precision, on flat unknowns.
struct Closures {
  void (*evaluate)(const void* group, const FlatVariables<double>& q, FlatVector& f);
  void (*differentiate)(const void* group, const FlatVariables<double>& q, FlatMatrix& jacobian);
  const void* group;
  const ModelUnknown* unknowns;
  int size;
  double farthest;  ///< coordinate among the inputs

  [[nodiscard]] FlatVector at(const FlatVariables<double>& q) const {
    FlatVector f(size);
    evaluate(group, q, f);
    return f;
  }
  [[nodiscard]] FlatMatrix jacobian(const FlatVariables<double>& q) const {
    FlatMatrix result(size, size);
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
      q[place] = cos / length;
      q[place + 1] = sin / length;
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

/// Moves a point to an assembly near it, and returns the residual that is left.
inline double close(const Closures& closures, FlatVariables<double>& q) {
  constexpr int most_steps = 60;
  FlatVector f = closures.at(q);
  double miss = f.norm();
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
    if (miss < 1e-3 && lessened(closing_step(jacobian, f, false), 0.1)) {
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
  return f.size() > 0 ? f.cwiseAbs().maxCoeff() : 0.0;
}

/// Directions in which the closures do not change to first order.
struct FreeDirections {
  int count = 0;
  FlatMatrix basis;  ///< a column each; orthonormal
};

/// The null space of the Jacobian by Gauss's elimination with full pivoting: what is below
/// `threshold` of the largest pivot counts as zero.
[[nodiscard]] inline FreeDirections free_directions(const Closures& closures,
                                                    const FlatVariables<double>& q,
                                                    double threshold) {
  Eigen::FullPivLU<FlatMatrix> factors(closures.jacobian(q));
  factors.setThreshold(threshold);
  FreeDirections result;
  result.count = static_cast<int>(factors.dimensionOfKernel());
  if (result.count > 0) {
    result.basis = factors.kernel();
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

/// Below this a pivot belongs to an assembly at which the closures are singular: rounding of the
/// closures moves a double one by 1e-8, a triple one by 1e-5.
inline constexpr double singular_pivot = 1e-4;

/// How many freedoms a singular assembly has: it is left along its free directions, and where the
/// closures hold again at a distance, twice in a row and singular there too, it moves. Zero for an
/// assembly that stands alone.
[[nodiscard]] inline int mobility_at(const Closures& closures, const FlatVariables<double>& q) {
  constexpr double reach = 0.04;  // of the longest length, or in radians
  constexpr int turns = 8;        // directions tried in a plane of free ones
  const FreeDirections free = free_directions(closures, q, singular_pivot);
  const int tries = free.count == 0 ? 0 : free.count == 1 ? 2 : 2 * turns;
  for (int attempt = 0; attempt < tries; ++attempt) {
    const double angle = 3.14159265358979 * attempt / (free.count == 1 ? 1 : turns) + 0.1;
    FlatVector along = std::cos(angle) * free.basis.col(0);
    if (free.count > 1) {
      along += std::sin(angle) * free.basis.col(1);
    }
    FlatVariables<double> from = q;
    bool moves = true;
    int mobility = 0;
    for (int leg = 0; leg < 2 && moves; ++leg) {
      FlatVariables<double> to = from;
      advance(closures, reach * along, to);
      const double miss = close(closures, to);
      const FreeDirections there = free_directions(closures, to, singular_pivot);
      moves = miss < rounding(closures, to) && distance(closures, from, to) > reach / 8 &&
              there.count > 0;
      if (moves) {
        // On along the curve, in the direction in which it was left.
        FlatVector next = there.basis.col(0);
        double best = std::abs(next.dot(along));
        for (int column = 1; column < there.count; ++column) {
          const double turn = std::abs(there.basis.col(column).dot(along));
          if (turn > best) {
            best = turn;
            next = there.basis.col(column);
          }
        }
        along = next.dot(along) < 0 ? FlatVector(-next) : next;
        mobility = mobility == 0 ? there.count : std::min(mobility, there.count);
        from = to;
      }
    }
    if (moves) {
      return mobility;
    }
  }
  return 0;
}

}  // namespace assur::detail
