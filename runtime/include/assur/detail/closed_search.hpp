// Turns a group whose final polynomial has one or two roots into its configurations by formula, or
// tells that a closer look is needed.
#pragma once

#include <algorithm>
#include <array>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/detail/polish.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail {

/// What decides how many real roots a final polynomial of first or second degree has, and what
/// its formula divides by: the discriminant, and the leading coefficient of a polynomial in a
/// displacement (that of a trigonometric one is no less than its discriminant).
template <typename Scalar>
struct Discriminants {
  Scalar discriminant{};
  Scalar leading{};
};

/// Of T = c0 + c1 cos x + s1 sin x: c1^2 + s1^2 - c0^2.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const TrigonometricPolynomial<Scalar, 1>& T) {
  const Scalar leading = T.cosine[1] * T.cosine[1] + T.sine[1] * T.sine[1];
  return {leading - T.cosine[0] * T.cosine[0], leading};
}
/// Of T = a + b x, which has one root wherever it has a leading coefficient.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const Vector<Scalar, 2>& T) {
  return {T(1) * T(1), T(1)};
}
/// Of T = a + b x + c x^2: b^2 - 4 a c.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const Vector<Scalar, 3>& T) {
  return {T(1) * T(1) - Scalar(4) * T(2) * T(0), T(2)};
}

/// The final polynomial of a model as its functions take it.
template <typename Model, typename Scalar>
using FinalPolynomial =
    std::conditional_t<is_angle<Model>(Model::first_unknown),
                       TrigonometricPolynomial<Scalar, Model::polynomial_degree>,
                       Vector<Scalar, static_cast<int>(Model::polynomial_degree) + 1>>;

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

/// The length up to which the errors of a model's discriminants are estimated: one, in the longest
/// length; a specialised group holds its dimensions as numbers and has a unit of its own.
template <typename Model>
inline constexpr double most_length = Model::dimension_count == 0 ? 8 : 1;

/// The discriminants of a model whose lengths are at most `longest`, each known to a few roundings,
/// whatever its variables are.
template <typename Model>
[[nodiscard]] Discriminants<numeric::Magnitude> discriminant_magnitudes(double longest) {
  using numeric::Magnitude;
  const auto fill = [longest](auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Magnitude>) {
      member = Magnitude::given(longest);
    } else {
      member = {Magnitude::given(1), Magnitude::given(1)};
    }
  };
  typename Model::template Dimensions<Magnitude> d;
  typename Model::template Inputs<Magnitude> u;
  for_each_member(d, fill);
  for_each_member(u, fill);
  FinalPolynomial<Model, Magnitude> T;
  Model::position_polynomial(d, u, T);
  widen(T, Magnitude::error(support::rounding_of_numbers<Model>()));
  return discriminants_of(T);
}

/// Tells whether a discriminant of a model has a certain sign. It is homogeneous in the lengths; of
/// a specialised group, which holds its dimensions as numbers, it counts as of degree zero.
struct Certainty {
  double firmness = 0;  ///< one over the largest error where the longest length is `most_length`
  int degree = 0;       ///< of the discriminant in the lengths

  template <typename Model>
  [[nodiscard]] static Certainty of(numeric::Magnitude Discriminants<numeric::Magnitude>::*which) {
    const numeric::Magnitude found = discriminant_magnitudes<Model>(most_length<Model>).*which;
    const numeric::Magnitude twice = discriminant_magnitudes<Model>(2 * most_length<Model>).*which;
    const bool is_scaled = Model::dimension_count > 0;
    return {1 / found.rounding(), is_scaled ? std::ilogb(twice.size / found.size) : 0};
  }

  /// In the unit given: the longest length, or one. Where rounding has displaced the inputs, errors
  /// grow as this has grown beyond the rounding that is taken for granted.
  [[nodiscard]] bool has_sign(double discriminant, double unit, double displaced) const {
    double size = unit + displaced / numeric::Magnitude::given_rounding();
    for (int power = 0; power < degree; ++power) {
      size *= unit;
    }
    return std::abs(discriminant) * firmness * unit > size;
  }
};

/// Until the program's variables are initialised it is zero, and nothing is vouched for by it.
template <typename Model>
inline const Discriminants<Certainty> certainty = {
    Certainty::of<Model>(&Discriminants<numeric::Magnitude>::discriminant),
    Certainty::of<Model>(&Discriminants<numeric::Magnitude>::leading)};

/// Whether a model's final polynomial has at most two roots, in closed form.
template <typename Model>
inline constexpr bool has_closed_form = Model::polynomial_degree == 1 ||
                                        (!is_angle<Model>(Model::first_unknown) &&
                                         Model::polynomial_degree == 2);

/// The search by formula. It vouches for its list where the discriminant has a certain sign,
/// however dimensions and inputs were rounded, and what it lists closes.
template <typename Model>
class ClosedSearch {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  using Pair = numeric::Pair;
  static constexpr auto root_count = static_cast<std::size_t>(Model::max_configurations);
  /// What holds an unknown of all configurations, which are computed at once.
  using Scalar = std::conditional_t<root_count == 2, Pair, double>;

 public:
  /// Most groups, as they are. False if a closer look is needed; the list is undefined then.
  [[nodiscard, gnu::flatten]] static bool list(const Dimensions& dimensions, const Inputs& inputs,
                                               double displaced, Assemblies<Model>& result) {
    const double longest = std::max(longest_length(inputs), longest_length(dimensions));
    if (!is_in_range(longest, 0x1p32)) {
      return false;
    }
    FinalPolynomial<Model, double> T;
    Model::position_polynomial(dimensions, inputs, T);
    const Discriminants<double> found = discriminants_of(T);
    const double unit = is_scaled ? longest : 1;
    if (!certainty<Model>.discriminant.has_sign(found.discriminant, unit, displaced)) {
      return false;
    }
    if (found.discriminant < 0) {
      return is_finite(dimensions) && is_finite(inputs);
    }
    if constexpr (has_leading_coefficient) {
      if (!certainty<Model>.leading.has_sign(found.leading, unit, displaced)) {
        return false;
      }
    }
    const auto d = support::scaled_to<typename Model::template Dimensions<Scalar>>(dimensions, 1.0);
    const auto u = support::scaled_to<typename Model::template Inputs<Scalar>>(inputs, 1.0);
    typename Model::template Configuration<Scalar> q;
    first_of(q) = roots_of(T, found);
    if (!complete_simple<Model, Scalar>(d, u, q) || !is_settled<Model, Scalar>(d, u, q, longest)) {
      return false;
    }
    std::size_t first = 0;
    if constexpr (root_count == 2 && !comes_in_any_order<Model>) {
      first = comes_before<Model>(d, u, q, unit) ? 0 : 1;
    }
    for (std::size_t index = 0; index < root_count; ++index) {
      result.configurations[index ^ first] = lane_of<Model, Scalar>(q, index);
      result.regularity[index] = Status::ok;
    }
    result.count = static_cast<int>(root_count);
    return true;
  }

  /// A closer look: with the bounds of these very dimensions and inputs, which are much closer
  /// where many lengths are multiplied, and polished. False if it cannot vouch for its list.
  [[nodiscard, gnu::noinline, gnu::cold]] static bool list_polished(const Dimensions& dimensions,
                                                                    const Inputs& inputs,
                                                                    double displaced,
                                                                    Assemblies<Model>& result) {
    const double longest = std::max(longest_length(inputs), longest_length(dimensions));
    if (!is_in_range(longest, 0x1p64) || !is_finite(dimensions) || !is_finite(inputs)) {
      return false;
    }
    const double scale = is_scaled ? support::inverse_power_of_two(longest) / 2 : 1.0;
    const auto d = support::scaled_to<Dimensions>(dimensions, scale);
    const auto u = support::scaled_to<Inputs>(inputs, scale);
    FinalPolynomial<Model, double> T;
    Model::position_polynomial(d, u, T);
    const Discriminants<double> found = discriminants_of(T);
    if (!is_certain(d, u, displaced * scale)) {
      return false;
    }
    if (found.discriminant < 0) {
      return true;
    }
    const auto roots = roots_of(T, found);
    for (std::size_t index = 0; index < root_count; ++index) {
      Configuration& q = result.configurations[index];
      first_of(q) = numeric::lane(roots, index);
      if (!complete<Model>(d, u, q)) {
        return false;
      }
      result.regularity[index] = polish<Model>(d, u, q);
      if (result.regularity[index] == Status::no_convergence) {
        return false;
      }
    }
    result.count = static_cast<int>(root_count);
    if (has_twins<Model>(result)) {
      result.count = 0;
      return false;
    }
    list_in<Model>(d, u, 1 / scale, result);
    return true;
  }

 private:
  static constexpr bool is_scaled = Model::dimension_count > 0;

  /// Products of several lengths may neither overflow nor underflow.
  [[nodiscard]] static bool is_in_range(double longest, double most) {
    return is_scaled ? longest * most > 1 && longest < most : longest <= most_length<Model>;
  }

  /// The leading coefficient of a trigonometric polynomial is no less than its discriminant, and
  /// that of a linear one is the root of it.
  static constexpr bool has_leading_coefficient =
      !is_angle<Model>(Model::first_unknown) && Model::polynomial_degree == 2;

  [[nodiscard]] static bool is_certain(const Dimensions& d, const Inputs& u, double displaced) {
    using Certified = numeric::Bounded<double>;
    FinalPolynomial<Model, Certified> T;
    Model::position_polynomial(support::rounded<typename Model::template Dimensions<Certified>>(
                                   d, support::rounding_of_one),
                               support::rounded<typename Model::template Inputs<Certified>>(
                                   u, support::rounding_of_inputs(u, displaced)),
                               T);
    widen(T, Certified(0, support::rounding_of_numbers<Model>()));
    const Discriminants<Certified> found = discriminants_of(T);
    return found.discriminant.sign_is_certain() && found.leading.sign_is_certain();
  }

  /// With r = sqrt(discriminant): c1 cos x + s1 sin x = -c0 and s1 cos x - c1 sin x = -+r.
  [[nodiscard]] static Direction<Pair> roots_of(const TrigonometricPolynomial<double, 1>& T,
                                                const Discriminants<double>& found) {
    const double root = std::sqrt(found.discriminant);
    const double scale = 1 / found.leading;
    const double cosine = T.cosine[1] * scale;
    const double sine = T.sine[1] * scale;
    const Pair roots(root, -root);
    return {-T.cosine[0] * cosine - roots * sine, roots * cosine - T.cosine[0] * sine};
  }
  [[nodiscard]] static double roots_of(const Vector<double, 2>& T,
                                       const Discriminants<double>& /*found*/) {
    return -T(0) / T(1);
  }
  [[nodiscard]] static Pair roots_of(const Vector<double, 3>& T,
                                     const Discriminants<double>& found) {
    const double larger = -(T(1) + std::copysign(std::sqrt(found.discriminant), T(1))) / 2;
    // Both roots are zero only where the discriminant is.
    return Pair(larger, T(0)) / Pair(T(2), larger);
  }

  template <typename Unknowns>
  [[nodiscard]] static auto& first_of(Unknowns& q) {
    return std::get<size(Model::first_unknown)>(q.members());
  }
};

}  // namespace assur::detail
