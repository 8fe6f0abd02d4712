// Roots of a final polynomial in double-double: the values of its unknown.
#pragma once

#include <algorithm>
#include <array>
#include <assur/model.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <cmath>
#include <cstddef>

namespace assur::detail {

/// One real root of a final polynomial: an angle as (cos, sin), or a displacement in `cos`.
struct FirstValue {
  numeric::DoubleDouble cos, sin;
  bool simple = true;  ///< otherwise several roots that could not be separated
};

struct FirstValues {
  std::array<FirstValue, 6> list;
  std::size_t count = 0;
  /// No coefficient exceeds its error: the first unknown is free or undetermined.
  bool vanishing = false;
  /// No root is infinite.
  bool finite = true;

  /// Whether every root is certainly a simple one.
  [[nodiscard]] bool certain() const {
    return finite && !vanishing &&
           std::all_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
                       [](const FirstValue& value) { return value.simple; });
  }

  void add(const FirstValue& value) {
    if (count < list.size()) {
      list[count++] = value;
    }
  }
};

/// The values x at which T = c0 + c1 cos x + s1 sin x vanishes, by formula. If it is uncertain
/// whether T reaches zero, the value at which |T| is least.
[[nodiscard]] inline FirstValues first_values_of_first_degree(
    const TrigonometricPolynomial<numeric::Bounded<numeric::DoubleDouble>, 1>& T) {
  using numeric::DoubleDouble;
  FirstValues result;
  const auto leading = T.cosine[1] * T.cosine[1] + T.sine[1] * T.sine[1];
  const auto inside = leading - T.cosine[0] * T.cosine[0];
  if (inside.sign_is_certain() && inside.value < DoubleDouble(0)) {
    return result;
  }
  if (!T.cosine[1].sign_is_certain() && !T.sine[1].sign_is_certain()) {
    result.vanishing = true;
    return result;
  }
  const bool simple = inside.sign_is_certain();
  const DoubleDouble reach = simple ? sqrt(inside.value) : DoubleDouble(0);
  const DoubleDouble foot =
      simple ? -T.cosine[0].value
             : DoubleDouble(T.cosine[0].value < DoubleDouble(0) ? 1 : -1) * sqrt(leading.value);
  const auto add = [&](DoubleDouble across) {
    result.add({(foot * T.cosine[1].value - across * T.sine[1].value) / leading.value,
                (foot * T.sine[1].value + across * T.cosine[1].value) / leading.value, simple});
  };
  add(reach);
  if (simple) {
    add(-reach);
  }
  return result;
}

template <std::size_t Degree>
[[nodiscard]] FirstValues first_values(
    const TrigonometricPolynomial<numeric::Bounded<numeric::DoubleDouble>, Degree>& bounded) {
  using numeric::DoubleDouble;
  if constexpr (Degree == 1) {
    return first_values_of_first_degree(bounded);
  } else {
    TrigonometricPolynomial<DoubleDouble, Degree> polynomial;
    double error = 0;
    for (std::size_t k = 0; k <= Degree; ++k) {
      polynomial.cosine[k] = bounded.cosine[k].value;
      polynomial.sine[k] = bounded.sine[k].value;
      error =
          (std::max)({error, bounded.cosine[k].certain_bound(), bounded.sine[k].certain_bound()});
    }
    const auto roots =
        numeric::trigonometric_roots<DoubleDouble, Degree>(polynomial, DoubleDouble(error));
    FirstValues result;
    result.vanishing = roots.status == numeric::RootStatus::vanishing;
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      result.add({roots.roots[root].cosine, roots.roots[root].sine, true});
    }
    for (std::size_t cluster = 0; cluster < roots.cluster_count; ++cluster) {
      const double angle = roots.clusters[cluster].angle;
      result.add({DoubleDouble(std::cos(angle)), DoubleDouble(std::sin(angle)), false});
    }
    return result;
  }
}

/// The roots of a polynomial of degree one or two in a displacement. If the leading coefficient may
/// be zero, one root counts as infinite and is left out.
template <int Size>
[[nodiscard]] FirstValues first_values(
    const Vector<numeric::Bounded<numeric::DoubleDouble>, Size>& bounded) {
  static_assert(Size == 2 || Size == 3, "displacements come from polynomials of degree one or two");
  using numeric::DoubleDouble;
  FirstValues result;
  if constexpr (Size == 3) {
    using Certified = numeric::Bounded<DoubleDouble>;
    if (bounded(2).sign_is_certain()) {
      const Certified inside = bounded(1) * bounded(1) - Certified(4) * bounded(2) * bounded(0);
      const DoubleDouble middle = -bounded(1).value / (DoubleDouble(2) * bounded(2).value);
      if (!inside.sign_is_certain()) {
        result.add({middle, DoubleDouble(0), false});
      } else if (inside.value > DoubleDouble(0)) {
        const DoubleDouble reach = sqrt(inside.value) / (DoubleDouble(2) * bounded(2).value);
        result.add({middle - reach, DoubleDouble(0), true});
        result.add({middle + reach, DoubleDouble(0), true});
      }
      return result;
    }
    result.finite = false;
  }
  if (bounded(1).sign_is_certain()) {
    result.add({-bounded(0).value / bounded(1).value, DoubleDouble(0), Size == 2});
  } else {
    result.vanishing = true;
  }
  return result;
}

}  // namespace assur::detail
