// Mobility of a singular assembly; zero if it is isolated.
#pragma once

#include <algorithm>
#include <assur/detail/closure_geometry.hpp>
#include <cmath>
#include <cstddef>

namespace assur::detail {

/// d2f along a direction: the curvature of the closures.
[[nodiscard]] inline Vector4 bend(const Closures& closures, const FlatVariables<double>& q,
                                  const Vector4& along) {
  constexpr double step = 0x1p-10;
  FlatVariables<double> ahead = q;
  FlatVariables<double> behind = q;
  closures.advance(step * along, ahead);
  closures.advance(-step * along, behind);
  return 1 / (step * step) * (closures.at(ahead) + closures.at(behind) - 2 * closures.at(q));
}

/// The step from one list of unknowns to another, if it is small.
[[nodiscard]] inline Vector4 step_between(const Closures& closures,
                                          const FlatVariables<double>& from,
                                          const FlatVariables<double>& to) {
  Vector4 step;
  std::size_t place = 0;
  for (int unknown = 0; unknown < closures.size; ++unknown) {
    if (closures.unknowns[unknown].is_angle) {
      step(unknown) = to[place + 1] * from[place] - to[place] * from[place + 1];
      place += 2;
    } else {
      step(unknown) = (to[place] - from[place]) / closures.unit_of(from[place]);
      ++place;
    }
  }
  return step;
}

/// The neighbourhood of a singular assembly: the directions in which other assemblies lie.
class Neighbourhood {
 public:
  /// Looks for assemblies at the distance `reach`, relative to the longest length or in radians.
  Neighbourhood(const Closures& closures, const FlatVariables<double>& q, double reach)
      : closures_(closures), reach_(reach), free_(free_directions(closures, q, singular_pivot)) {
    for (int one = 0; one < free_.count; ++one) {
      try_both_ways(q, free_.basis.column(one));
      for (int other = 0; other < one; ++other) {
        try_plane(q, free_.basis.column(one), free_.basis.column(other));
      }
    }
  }

  /// The number of independent directions: the dimension of the family, or zero.
  [[nodiscard]] int dimension() const { return dimension_; }
  /// A neighbouring assembly, also singular; requires dimension() > 0.
  [[nodiscard]] const FlatVariables<double>& neighbour() const { return neighbour_; }

 private:
  /// Tries directions in the plane of two free ones: those along which a component of the closures
  /// that does not change to first order does not change to second order either, A c^2 + B c s + C
  /// s^2 = 0, and some between.
  void try_plane(const FlatVariables<double>& q, const Vector4& one, const Vector4& other) {
    const auto at_angle = [&](double angle) {
      try_both_ways(q, std::cos(angle) * one + std::sin(angle) * other);
    };
    const FreeDirections parts = null_space(transposed(closures_.jacobian(q)), singular_pivot);
    const Vector4 a = bend(closures_, q, one);
    const Vector4 c = bend(closures_, q, other);
    const Vector4 b = bend(closures_, q, one + other) - a - c;
    for (int part = 0; part < parts.count; ++part) {
      const double A = dot(parts.basis.column(part), a);
      const double B = dot(parts.basis.column(part), b);
      const double C = dot(parts.basis.column(part), c);
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

  void try_both_ways(const FlatVariables<double>& q, const Vector4& along) {
    for (const double way : {reach_, -reach_}) {
      FlatVariables<double> to = q;
      closures_.advance(way * along, to);
      // If the group is displaced, a family closes to within rounding everywhere and exactly at a
      // few points; reducing the residual below rounding would lead to these.
      restore(closures_, to);
      double miss = norm(closures_.at(to));
      if (!(miss < rounding(closures_, to))) {
        miss = close(closures_, to);
      }
      Vector4 step = step_between(closures_, q, to);
      const double length = norm(step);
      if (!(miss < rounding(closures_, to)) || length < 0.7 * reach_ || length > 1.4 * reach_ ||
          free_directions(closures_, to, singular_pivot).count == 0) {
        continue;
      }
      for (int known = 0; known < dimension_; ++known) {
        const Vector4& tangent = tangents_.column(known);
        step = step - dot(tangent, step) * tangent;
      }
      // A single curve deviates by less than that.
      if (dimension_ < free_.count && norm(step) > 0.35 * length) {
        neighbour_ = to;
        tangents_.column(dimension_) = normalised(step);
        ++dimension_;
      }
    }
  }

  const Closures& closures_;
  double reach_;
  FreeDirections free_;
  Matrix4 tangents_;
  FlatVariables<double> neighbour_{};
  int dimension_ = 0;
};

/// The mobility of a singular assembly; zero if it is isolated. It is counted at a neighbour,
/// because an assembly at which families cross has the free directions of all of them; and at
/// another distance, at which the assembly itself is not found again: two isolated assemblies are
/// no family.
[[nodiscard]] inline int mobility_at(const Closures& closures, const FlatVariables<double>& q) {
  const Neighbourhood here(closures, q, 0.02);
  return here.dimension() == 0 ? 0 : Neighbourhood(closures, here.neighbour(), 0.05).dimension();
}

}  // namespace assur::detail
