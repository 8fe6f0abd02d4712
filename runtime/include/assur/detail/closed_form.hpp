// Certified discriminants of models whose configurations follow in closed form.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::detail {

/// Whether a model's final polynomial has at most two roots, in closed form.
template <typename Model>
inline constexpr bool has_closed_form = Model::polynomial_degree == 1 ||
                                        (!is_angle<Model>(Model::first_unknown) &&
                                         Model::polynomial_degree == 2);

using support::Discriminants;
using support::discriminants_of;

/// The roots, with r = sqrt(discriminant): c1 cos x + s1 sin x = -c0, s1 cos x - c1 sin x = -+r.
template <typename Scalar>
[[nodiscard]] Direction<numeric::PairOf<Scalar>> roots_of(
    const TrigonometricPolynomial<Scalar, 1>& T, const Discriminants<Scalar>& found) {
  const Scalar root = std::sqrt(found.discriminant);
  const Scalar scale = 1 / found.leading;
  const Scalar cosine = T.cosine[1] * scale;
  const Scalar sine = T.sine[1] * scale;
  const numeric::PairOf<Scalar> roots(root, -root);
  return {-T.cosine[0] * cosine - roots * sine, roots * cosine - T.cosine[0] * sine};
}
template <typename Scalar>
[[nodiscard]] Scalar roots_of(const Vector<Scalar, 2>& T, const Discriminants<Scalar>& /*found*/) {
  return -T(0) / T(1);
}
template <typename Scalar>
[[nodiscard]] numeric::PairOf<Scalar> roots_of(const Vector<Scalar, 3>& T,
                                               const Discriminants<Scalar>& found) {
  using Pair = numeric::PairOf<Scalar>;
  const Scalar larger = -(T(1) + std::copysign(std::sqrt(found.discriminant), T(1))) / 2;
  // Both roots are zero only if the discriminant is zero.
  return Pair(larger, T(0)) / Pair(T(2), larger);
}

/// The type of a model's final polynomial.
template <typename Model, typename Scalar>
using FinalPolynomial =
    std::conditional_t<is_angle<Model>(Model::first_unknown),
                       TrigonometricPolynomial<Scalar, Model::polynomial_degree>,
                       Vector<Scalar, static_cast<int>(Model::polynomial_degree) + 1>>;

/// The type of one unknown of all configurations, which are computed at once.
template <typename Model, typename Scalar>
using AllRoots =
    std::conditional_t<Model::max_configurations == 2, numeric::PairOf<Scalar>, Scalar>;

/// Adds an error, a number of value zero with a bound, to every coefficient.
template <typename Scalar, std::size_t Degree>
void widen(TrigonometricPolynomial<Scalar, Degree>& T, const Scalar& error) {
  for (std::size_t k = 0; k <= Degree; ++k) {
    T.cosine[k] = T.cosine[k] + error;
    T.sine[k] = T.sine[k] + error;
  }
}
template <typename Scalar, int Count>
void widen(Vector<Scalar, Count>& T, const Scalar& error) {
  for (Scalar& coefficient : T) {
    coefficient = coefficient + error;
  }
}

/// The longest length for which the error bounds of a model, or of a specialised group, hold.
template <typename Model, typename Scalar>
inline constexpr Scalar most_length = Model::dimension_count == 0
                                          ? static_cast<Scalar>(support::most_length_of_numbers)
                                          : Scalar(1);

/// A test whether a discriminant of a model has a certain sign. The discriminant is homogeneous in
/// the lengths; that of a specialised group counts as of degree zero.
template <typename Scalar>
struct Certainty {
  Scalar firmness = 0;  ///< one over the largest error if the longest length is `most_length`
  int degree = 0;       ///< of the discriminant in the lengths

  /// A length to the power of the discriminant's degree; `square` is the length's square.
  template <typename Number>
  [[nodiscard]] Number power(const Number& square) const {
    using std::sqrt;
    Number result = (degree & 1) != 0 ? sqrt(square) : Number(1);
    if ((degree & 2) != 0) {
      result = result * square;
    }
    if ((degree & 4) != 0) {
      result = result * (square * square);
    }
    return result;
  }

  /// The largest error, times `firmness`; `square` is the square of the longest length. If rounding
  /// has displaced the inputs, the error grows by the ratio of the displacement to the assumed
  /// rounding. A displacement that is NaN makes it NaN.
  [[nodiscard]] Scalar error(Scalar square,
                             const support::DisplacementOf<Scalar>& displaced) const {
    const Scalar error = power(square);
    if (!(displaced.moved <= 0) || !(displaced.turned <= 0)) {
      const Scalar part = displaced.moved / std::sqrt(square) + displaced.turned;
      constexpr Scalar given = static_cast<Scalar>(numeric::Magnitude::given_rounding()) *
                               numeric::roundings_of_double<Scalar>;
      return error * (1 + part / given);
    }
    return error;
  }
};

/// The certainty of a quantity, from its largest error in double, which the generator has derived.
template <typename Scalar>
[[nodiscard]] constexpr Certainty<Scalar> certainty(double error, int degree) {
  return {static_cast<Scalar>(1 / error) / numeric::roundings_of_double<Scalar>, degree};
}

/// Bounds that hold for all groups of a model, derived by the generator.
template <typename Model, typename Scalar>
struct ClosedForm {
  static constexpr Certainty<Scalar> discriminant =
      certainty<Scalar>(Model::discriminant_error, Model::discriminant_degree);
  /// Whether a discriminant other than zero determines all unknowns: det J is a multiple of it.
  static constexpr bool determines = Model::regular_discriminant > 0;
  /// Whether a large discriminant certifies that configurations are regular, differ in
  /// Model::first_key, and close. In float the bound that holds for all groups exceeds the
  /// discriminants of most, so each group is checked separately.
  static constexpr bool vouches = determines && std::is_same_v<Scalar, double>;
  /// One over the least discriminant that has a certain sign and, if `vouches`, certifies the
  /// configurations.
  static constexpr Scalar firmness =
      vouches ? 1 / (std::max)(static_cast<Scalar>(Model::discriminant_error),
                               static_cast<Scalar>(Model::regular_discriminant))
              : discriminant.firmness;
  /// The leading coefficient of a trigonometric polynomial is no less than the discriminant, and
  /// that of a linear one is the discriminant's root.
  static constexpr bool has_leading_coefficient =
      !is_angle<Model>(Model::first_unknown) && Model::polynomial_degree == 2;
  static constexpr bool is_scaled = Model::dimension_count > 0;
  /// The discriminant neither overflows nor underflows if the lengths are between two to this power
  /// and its inverse.
  static constexpr int most_power =
      (std::min)(32, std::numeric_limits<Scalar>::max_exponent * 7 / 16 /
                         (std::max)(1, Model::discriminant_degree));

  /// Whether products of several lengths neither overflow nor underflow; `square` is the sum of the
  /// squares of all lengths.
  template <typename Number>
  [[nodiscard]] static auto is_in_range(const Number& square) {
    constexpr auto longest = numeric::power_of_two<Scalar>(most_power);
    constexpr Scalar most = longest * longest;
    constexpr Scalar most_of_numbers = most_length<Model, Scalar> * most_length<Model, Scalar>;
    if constexpr (is_scaled) {
      return (square * Number(most) > Number(1)) & (square < Number(most));
    } else {
      return square <= Number(most_of_numbers);
    }
  }
};

/// Whether there is a formula for a model's configurations, and a large discriminant certifies
/// them.
template <typename Model, typename Scalar>
inline constexpr bool vouches_for_roots = [] {
  if constexpr (has_closed_form<Model>) {
    return ClosedForm<Model, Scalar>::vouches;
  } else {
    return false;
  }
}();

}  // namespace assur::detail
