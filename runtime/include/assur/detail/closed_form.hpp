// Turns a model whose configurations follow by formula into what is certain of all its groups.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace assur::detail {

/// Whether a model's final polynomial has at most two roots, in closed form.
template <typename Model>
inline constexpr bool has_closed_form = Model::polynomial_degree == 1 ||
                                        (!is_angle<Model>(Model::first_unknown) &&
                                         Model::polynomial_degree == 2);

using support::Discriminants;
using support::discriminants_of;

/// With r = sqrt(discriminant): c1 cos x + s1 sin x = -c0 and s1 cos x - c1 sin x = -+r.
[[nodiscard]] inline Direction<numeric::Pair> roots_of(const TrigonometricPolynomial<double, 1>& T,
                                                       const Discriminants<double>& found) {
  using numeric::Pair;
  const double root = std::sqrt(found.discriminant);
  const double scale = 1 / found.leading;
  const double cosine = T.cosine[1] * scale;
  const double sine = T.sine[1] * scale;
  const Pair roots(root, -root);
  return {-T.cosine[0] * cosine - roots * sine, roots * cosine - T.cosine[0] * sine};
}
[[nodiscard]] inline double roots_of(const Vector<double, 2>& T,
                                     const Discriminants<double>& /*found*/) {
  return -T(0) / T(1);
}
[[nodiscard]] inline numeric::Pair roots_of(const Vector<double, 3>& T,
                                            const Discriminants<double>& found) {
  using numeric::Pair;
  const double larger = -(T(1) + std::copysign(std::sqrt(found.discriminant), T(1))) / 2;
  // Both roots are zero only where the discriminant is.
  return Pair(larger, T(0)) / Pair(T(2), larger);
}

/// The final polynomial of a model as its functions take it.
template <typename Model, typename Scalar>
using FinalPolynomial =
    std::conditional_t<is_angle<Model>(Model::first_unknown),
                       TrigonometricPolynomial<Scalar, Model::polynomial_degree>,
                       Vector<Scalar, static_cast<int>(Model::polynomial_degree) + 1>>;

/// What holds an unknown of all configurations, which are computed at once.
template <typename Model>
using AllRoots = std::conditional_t<Model::max_configurations == 2, numeric::Pair, double>;

/// Coefficients that may be off by more: `error` is a number without a value.
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

/// The length up to which what is said of a model, or of a specialised group, holds.
template <typename Model>
inline constexpr double most_length =
    Model::dimension_count == 0 ? support::most_length_of_numbers : 1;

/// Tells whether a discriminant of a model has a certain sign. It is homogeneous in the lengths; of
/// a specialised group it counts as of degree zero.
struct Certainty {
  double firmness = 0;  ///< one over the largest error where the longest length is `most_length`
  int degree = 0;       ///< of the discriminant in the lengths

  /// A length to the discriminant's degree, by the length's square.
  [[nodiscard]] double power(double square) const {
    double result = (degree & 1) != 0 ? std::sqrt(square) : 1;
    if ((degree & 2) != 0) {
      result *= square;
    }
    if ((degree & 4) != 0) {
      result *= square * square;
    }
    return result;
  }

  /// The largest error, times `firmness`, by the square of the longest length. Where rounding has
  /// displaced the inputs, errors grow as this has grown beyond the rounding that is taken for
  /// granted; where that is not a number, neither is what is certain.
  [[nodiscard]] double error(double square, const support::Displacement& displaced) const {
    const double error = power(square);
    if (!(displaced.moved <= 0) || !(displaced.turned <= 0)) {
      const double part = displaced.moved / std::sqrt(square) + displaced.turned;
      return error * (1 + part / numeric::Magnitude::given_rounding());
    }
    return error;
  }
};

/// What is certain of all groups of a model, as the generator has derived it.
template <typename Model>
struct ClosedForm {
  static constexpr Certainty discriminant = {1 / Model::discriminant_error,
                                             Model::discriminant_degree};
  /// Whether a large discriminant vouches for configurations that are regular, that differ by
  /// Model::first_key, and that close.
  static constexpr bool vouches = Model::regular_discriminant > 0;
  /// One over a discriminant that has a certain sign and, if any does, vouches.
  static constexpr double firmness =
      1 / (std::max)(Model::discriminant_error, Model::regular_discriminant);
};

/// Whether there is a formula for a model's configurations of which that is said.
template <typename Model>
inline constexpr bool vouches_for_roots = [] {
  if constexpr (has_closed_form<Model>) {
    return ClosedForm<Model>::vouches;
  } else {
    return false;
  }
}();

}  // namespace assur::detail
