// Refinement of a multiple assembly, at which several assemblies meet and which rounding displaces
// by a root of epsilon.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/closure_geometry.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

/// The curve through a singular assembly along which all closures hold but one: with n the one free
/// direction and w the component of the closures that does not change to first order, f(q(t)) =
/// g(t) w, where t is the distance along n. The order of the zero of g is the number of assemblies
/// that meet. Rounding of f displaces a zero of order m by the m-th root of epsilon; derivatives of
/// f are known to rounding, and a derivative of g has a simple zero there.
class FreeCurve {
 public:
  /// Requires one free direction n, and one such component w.
  FreeCurve(const Closures& closures, const FlatVariables<double>& q,
            const FreeDirections& directions, const FreeDirections& parts)
      : closures_(closures),
        origin_(q),
        along_(directions.basis.column(0)),
        part_(parts.basis.column(0)) {}

  /// A point of the curve. Newton's steps normal to the curve restore the other closures.
  [[nodiscard]] FlatVariables<double> at(double t) const {
    constexpr int steps = 4;
    FlatVariables<double> q = origin_;
    closures_.advance(t * along_, q);
    for (int step = 0; step < steps; ++step) {
      const Elimination factors = bordered(q);
      const Vector4 a = factors.solve(closures_.at(q));
      const Vector4 b = factors.solve(part_);
      closures_.advance(dot(along_, a) / dot(along_, b) * b - a, q);
    }
    return q;
  }

  /// dg/dt at a point of the curve, times a smooth positive function.
  [[nodiscard]] double slope(const FlatVariables<double>& q) const {
    return 1 / dot(along_, bordered(q).solve(part_)) - 1;
  }

 private:
  /// J + w n^T, which is regular if n alone spans the null space of J.
  [[nodiscard]] Elimination bordered(const FlatVariables<double>& q) const {
    Matrix4 jacobian = closures_.jacobian(q);
    for (int column = 0; column < 4; ++column) {
      jacobian.column(column) = jacobian.column(column) + along_(column) * part_;
    }
    return {jacobian, pivot_rounding};
  }

  const Closures& closures_;
  const FlatVariables<double>& origin_;
  Vector4 along_, part_;
};

/// The coefficients of the polynomial through given points.
template <std::size_t Count>
[[nodiscard]] std::array<double, Count> interpolated(const std::array<double, Count>& places,
                                                     const std::array<double, Count>& values) {
  std::array<double, Count> differences = values;
  for (std::size_t order = 1; order < Count; ++order) {
    for (std::size_t place = Count - 1; place >= order; --place) {
      differences[place] =
          (differences[place] - differences[place - 1]) / (places[place] - places[place - order]);
    }
  }
  std::array<double, Count> coefficients{};
  for (std::size_t place = Count; place-- > 0;) {
    for (std::size_t power = Count - 1; power > 0; --power) {
      coefficients[power] = coefficients[power - 1] - places[place] * coefficients[power];
    }
    coefficients[0] = differences[place] - places[place] * coefficients[0];
  }
  return coefficients;
}

/// The coefficients of the same polynomial about another point.
template <std::size_t Count>
[[nodiscard]] std::array<double, Count> shifted(std::array<double, Count> coefficients, double by) {
  for (std::size_t least = 0; least + 1 < Count; ++least) {
    for (std::size_t power = Count - 1; power > least; --power) {
      coefficients[power - 1] += by * coefficients[power];
    }
  }
  return coefficients;
}

/// The distance along the curve to the point where most assemblies meet, if rounding may change g
/// by `unsure`: where m meet, g is c t^m over the distance by which rounding separates them.
[[nodiscard]] inline double way_to_meeting(const FreeCurve& curve, double unsure) {
  constexpr std::size_t count = 9;
  constexpr double reach = 0.06;
  std::array<double, count> places{};
  std::array<double, count> slopes{};
  for (std::size_t place = 0; place < count; ++place) {
    const double angle = 3.14159265358979 * (static_cast<double>(place) + 0.5) / count;
    places[place] = reach * std::cos(angle);
    slopes[place] = curve.slope(curve.at(places[place]));
  }
  const std::array<double, count> here = interpolated(places, slopes);
  constexpr std::size_t most_meeting = 6;
  for (std::size_t meeting = most_meeting; meeting > 1; --meeting) {
    const auto all = static_cast<double>(meeting);
    const double leading = here[meeting - 1];
    const double way = -here[meeting - 2] / ((all - 1) * leading);
    const double apart = std::pow(all * unsure / std::abs(leading), 1 / all);
    if (!(std::abs(way) < 4 * apart && apart < reach / 4)) {
      continue;
    }
    const std::array<double, count> there = shifted(here, way);
    bool meet = true;
    for (std::size_t power = 0; power + 2 < meeting; ++power) {
      const double change =
          std::abs(there[power]) * std::pow(apart, static_cast<double>(power + 1));
      meet = meet && change < all * unsure;
    }
    if (meet) {
      return way;
    }
  }
  return 0;
}

/// Moves an isolated multiple assembly to the point where its assemblies meet, if the closures also
/// hold there.
inline void settle(const Closures& closures, FlatVariables<double>& q) {
  constexpr int most_steps = 4;
  FlatVariables<double> settled = q;
  for (int step = 0; step < most_steps; ++step) {
    const Matrix4 jacobian = closures.jacobian(settled);
    const FreeDirections directions = null_space(jacobian, singular_pivot);
    const FreeDirections parts = null_space(transposed(jacobian), singular_pivot);
    if (directions.count != 1 || parts.count != 1) {
      return;
    }
    const FreeCurve curve(closures, settled, directions, parts);
    const double way = way_to_meeting(curve, rounding(closures, settled));
    const FlatVariables<double> next = curve.at(way);
    if (!(norm(closures.at(next)) < rounding(closures, next))) {
      return;
    }
    settled = next;
    if (std::abs(way) < 4 * std::numeric_limits<double>::epsilon()) {
      break;
    }
  }
  q = settled;
}

}  // namespace assur::detail
