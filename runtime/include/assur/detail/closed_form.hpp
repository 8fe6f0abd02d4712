// Turns a model whose configurations follow by formula into what is certain of all its groups.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
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

/// The length up to which what is certain of a model is found: one, in the longest length; a
/// specialised group holds its dimensions as numbers and has a unit of its own.
template <typename Model>
inline constexpr double most_length = Model::dimension_count == 0 ? 8 : 1;

/// Variables of a model, with `length()` as each length and `direction()` as each direction.
template <typename Variables, typename Length, typename GetDirection>
[[nodiscard]] Variables filled(Length length, GetDirection direction) {
  Variables result;
  for_each_member(result, [&](auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, decltype(length())>) {
      member = length();
    } else {
      member = direction();
    }
  });
  return result;
}

/// A model's variables whose lengths are at most so long, each known to a few roundings.
template <typename Variables>
[[nodiscard]] Variables all_up_to(double longest) {
  using numeric::Magnitude;
  return filled<Variables>([longest] { return Magnitude::given(longest); },
                           [] {
                             return Direction<Magnitude>{Magnitude::given(1), Magnitude::given(1)};
                           });
}

/// The discriminants of a model whose lengths are at most `longest`, whatever its variables are.
template <typename Model>
[[nodiscard]] Discriminants<numeric::Magnitude> discriminant_magnitudes(double longest) {
  using numeric::Magnitude;
  const auto d = all_up_to<typename Model::template Dimensions<Magnitude>>(longest);
  const auto u = all_up_to<typename Model::template Inputs<Magnitude>>(longest);
  FinalPolynomial<Model, Magnitude> T;
  Model::position_polynomial(d, u, T);
  widen(T, Magnitude::error(support::rounding_of_numbers<Model>()));
  return discriminants_of(T);
}

/// Tells whether a discriminant of a model has a certain sign. It is homogeneous in the lengths; of
/// a specialised group, which holds its dimensions as numbers, it counts as of degree zero.
struct Certainty {
  double firmness = 0;  ///< one over the largest error where the longest length is `most_length`
  int degree = 0;       ///< of the discriminant in the lengths, at most seven

  template <typename Model>
  [[nodiscard]] static Certainty of(numeric::Magnitude Discriminants<numeric::Magnitude>::*which) {
    const numeric::Magnitude found = discriminant_magnitudes<Model>(most_length<Model>).*which;
    const numeric::Magnitude twice = discriminant_magnitudes<Model>(2 * most_length<Model>).*which;
    const bool is_scaled = Model::dimension_count > 0;
    const int degree = is_scaled ? std::ilogb(twice.size / found.size) : 0;
    return {degree < 8 ? 1 / found.rounding() : 0, degree};
  }

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

  /// By the square of the longest length and by `power` of it. Where rounding has displaced the
  /// inputs, errors grow as this has grown beyond the rounding that is taken for granted.
  [[nodiscard]] bool has_sign(double discriminant, double square, double power,
                              const support::Displacement& displaced) const {
    double error = power;
    if (displaced.moved > 0 || displaced.turned > 0) {
      const double part = std::max(displaced.moved / std::sqrt(square), displaced.turned);
      error *= 1 + part / numeric::Magnitude::given_rounding();
    }
    return std::abs(discriminant) * firmness > error;
  }
};

/// What det J is at most where `is_regular` may say no, squared, whatever the variables are up to
/// the given length: rounding times all that the pivots could be. Infinite or no number where a
/// displacement has no bound.
template <typename Model>
[[nodiscard]] double irregular_square(double longest) {
  using numeric::Magnitude;
  const auto d = all_up_to<typename Model::template Dimensions<Magnitude>>(longest);
  const auto u = all_up_to<typename Model::template Inputs<Magnitude>>(longest);
  constexpr double none = std::numeric_limits<double>::infinity();
  auto q = filled<typename Model::template Configuration<Magnitude>>(
      [] { return Magnitude(none, none); },
      [] {
        return Direction<Magnitude>{Magnitude::given(1), Magnitude::given(1)};
      });
  Model::complete(d, u, q);
  const Pivots<Model, Magnitude> pivots = pivots_at<Model, Magnitude>(d, u, q);
  double square = derivative_rounding<double>() / six_digits * pivots.terms.size;
  for (int index = 0; index < Model::pivot_count; ++index) {
    const double size = pivots.sizes(index).size;
    square *= index < Model::core_pivot_count ? size : size * size;
  }
  return square;
}

/// What is certain of all groups of a model. Until the program's variables are initialised it is
/// zero, and nothing is vouched for by it.
template <typename Model>
struct ClosedForm {
  Certainty discriminant;
  Certainty leading;
  /// One over a discriminant from which on groups are regular where the longest length is
  /// `most_length`; zero where none vouches for it.
  double regularity = 0;
  /// Of the entries by which configurations are put in order, the first that may differ.
  int first_key = 0;

  [[nodiscard]] static ClosedForm found() {
    using numeric::Magnitude;
    ClosedForm result;
    result.discriminant = Certainty::of<Model>(&Discriminants<Magnitude>::discriminant);
    result.leading = Certainty::of<Model>(&Discriminants<Magnitude>::leading);
    // Of larger groups det J has more factors, and no sample would vouch for them.
    if constexpr (Model::max_configurations == 2 && Model::unknown_count == 2) {
      result.look_at_samples();
    }
    return result;
  }

 private:
  using Scalar = AllRoots<Model>;
  using Dimensions = typename Model::template Dimensions<Scalar>;
  using Inputs = typename Model::template Inputs<Scalar>;

  /// The discriminant is a multiple of the square of det J, or it is not, and an entry of the order
  /// is the same of both configurations, or it is not: what holds at some places that have nothing
  /// to do with one another holds everywhere.
  void look_at_samples() {
    constexpr int samples = 64;
    constexpr int enough = 8;
    constexpr double same = 1e-6;
    constexpr double clear = 1e-2;
    constexpr double golden = 0.6180339887498949;
    double place = 0;
    const auto length = [&place] {
      place += golden;
      return Scalar(2 * (place - std::floor(place)) - 1);
    };
    const auto direction = [&length] {
      const Scalar half = length();
      const Scalar scale = Scalar(1) / (Scalar(1) + half * half);
      return Direction<Scalar>{(Scalar(1) - half * half) * scale, Scalar(2) * half * scale};
    };
    int assembled = 0;
    double ratio = 0;
    bool is_multiple = true;
    first_key = std::numeric_limits<int>::max();
    for (int sample = 0; sample < samples; ++sample) {
      const auto d = filled<Dimensions>(length, direction);
      const auto u = filled<Inputs>(length, direction);
      FinalPolynomial<Model, double> T;
      Model::position_polynomial(lane_of<typename Model::template Dimensions<double>>(d, 0),
                                 lane_of<typename Model::template Inputs<double>>(u, 0), T);
      const Discriminants<double> found = discriminants_of(T);
      if (!(found.discriminant > clear)) {
        continue;
      }
      typename Model::template Configuration<Scalar> q;
      first_of<Model>(q) = roots_of(T, found);
      if (!static_cast<bool>(complete_simple<Model, Scalar>(d, u, q))) {
        continue;
      }
      Scalar square(1);
      for (const Scalar& pivot : pivots_at<Model, Scalar>(d, u, q).values) {
        square = square * pivot * pivot;
      }
      for (std::size_t index = 0; index < 2; ++index) {
        const double here = found.discriminant / square[index];
        ratio = assembled++ == 0 ? here : ratio;
        is_multiple = is_multiple && std::abs(here - ratio) < same * ratio;
      }
      if constexpr (!comes_in_any_order<Model>) {
        for_each_key<Model>(d, u, q, [this](const Scalar& entry, int key, bool) {
          if (key < first_key && std::abs(entry[0] - entry[1]) > same) {
            first_key = key;
          }
        });
      }
    }
    const double most = ratio * irregular_square<Model>(most_length<Model>);
    regularity = is_multiple && assembled > enough && most > 0 ? 1 / most : 0;
    first_key = assembled > enough ? first_key : 0;
  }
};

template <typename Model>
inline const ClosedForm<Model> closed_form = ClosedForm<Model>::found();

}  // namespace assur::detail
