// Turns a group whose final polynomial has one or two roots into its configurations by formula, or
// tells that a closer look is needed.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/polish.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
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

/// Lengths of at most so much: one, after scaling; a specialised group holds its dimensions as
/// numbers and is not scaled.
template <typename Model>
inline constexpr double most_length = Model::dimension_count == 0 ? 8 : 1;

/// The error that rounding may leave in the discriminants of a model, whatever its variables are,
/// if no length is longer than `most_length` and each is known to a few roundings.
template <typename Model>
[[nodiscard]] Discriminants<double> discriminant_rounding() {
  using numeric::Magnitude;
  const auto fill = [](auto& member, std::size_t) {
    const Magnitude length = Magnitude::given(most_length<Model>);
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Magnitude>) {
      member = length;
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
  const Discriminants<Magnitude> found = discriminants_of(T);
  return {found.discriminant.rounding(), found.leading.rounding()};
}

/// Until the program's variables are initialised it is zero, and nothing is vouched for by it.
template <typename Model>
inline const Discriminants<double> discriminant_error = discriminant_rounding<Model>();

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

 public:
  ClosedSearch(const Dimensions& d, const Inputs& u, Assemblies<Model>& result)
      : d_(d), u_(u), result_(result) {}

  /// False if it cannot vouch for its list. Lengths are at most `most_length`, and rounding has
  /// displaced the inputs by at most `displaced`.
  [[nodiscard]] bool run(double displaced) {
    FinalPolynomial<Model, double> T;
    Model::position_polynomial(d_, u_, T);
    const Discriminants<double> found = discriminants_of(T);
    // Errors grow with what the inputs are off.
    const double growth = 1 + displaced / numeric::Magnitude::given_rounding();
    const Discriminants<double>& rounding = discriminant_error<Model>;
    const bool is_certain = std::abs(found.discriminant) > rounding.discriminant * growth &&
                            std::abs(found.leading) > rounding.leading * growth &&
                            rounding.discriminant > 0;
    if (!is_certain && !is_certain_here(displaced)) {
      return false;
    }
    return found.discriminant < 0 ||
           (list_roots(T, found) && !(was_polished_ && has_twins<Model>(result_)));
  }

 private:
  /// The same with the bounds of these very dimensions and inputs, which are much closer where many
  /// lengths are multiplied.
  [[nodiscard, gnu::noinline]] bool is_certain_here(double displaced) const {
    using Certified = numeric::Bounded<double>;
    FinalPolynomial<Model, Certified> T;
    Model::position_polynomial(support::rounded<typename Model::template Dimensions<Certified>>(
                                   d_, support::rounding_of_one),
                               support::rounded<typename Model::template Inputs<Certified>>(
                                   u_, support::rounding_of_inputs(u_, displaced)),
                               T);
    widen(T, Certified(0, support::rounding_of_numbers<Model>()));
    const Discriminants<Certified> found = discriminants_of(T);
    return found.discriminant.sign_is_certain() && found.leading.sign_is_certain();
  }

  /// With r = sqrt(discriminant): c1 cos x + s1 sin x = -c0 and s1 cos x - c1 sin x = -+r.
  [[nodiscard]] bool list_roots(const TrigonometricPolynomial<double, 1>& T,
                                const Discriminants<double>& found) {
    const double root = std::sqrt(found.discriminant);
    const double scale = 1 / found.leading;
    const double cosine = T.cosine[1] * scale;
    const double sine = T.sine[1] * scale;
    const Direction<double> middle = {-T.cosine[0] * cosine, -T.cosine[0] * sine};
    return accept(Direction<double>{middle.cos - root * sine, middle.sin + root * cosine}) &&
           accept(Direction<double>{middle.cos + root * sine, middle.sin - root * cosine});
  }
  [[nodiscard]] bool list_roots(const Vector<double, 2>& T,
                                const Discriminants<double>& /*found*/) {
    return accept(-T(0) / T(1));
  }
  [[nodiscard]] bool list_roots(const Vector<double, 3>& T, const Discriminants<double>& found) {
    const double larger = -(T(1) + std::copysign(std::sqrt(found.discriminant), T(1))) / 2;
    // Both roots are zero only where the discriminant is.
    return accept(larger / T(2)) && accept(T(0) / larger);
  }

  /// Completes and lists a configuration; false if it does not close.
  template <typename Value>
  [[nodiscard]] bool accept(const Value& value) {
    Configuration q;
    std::get<size(Model::first_unknown)>(q.members()) = value;
    if (!complete<Model>(d_, u_, q)) {
      return false;
    }
    Status& regularity = entry(result_.regularity, result_.count);
    regularity = closes(q) ? regularity_of_closed(q) : polish<Model>(d_, u_, q);
    if (regularity == Status::no_convergence) {
      return false;
    }
    entry(result_.configurations, result_.count) = q;
    ++result_.count;
    return true;
  }

  /// Whether the closures hold as they are to a few roundings.
  [[nodiscard]] bool closes(const Configuration& q) {
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, q, f);
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double longest = std::max({1.0, longest_length(u_), longest_length(q)});
    const bool hold =
        f.cwiseAbs().maxCoeff() <= rounding * longest && longest < farthest_configuration;
    was_polished_ = was_polished_ || !hold;
    return hold;
  }

  [[nodiscard]] Status regularity_of_closed(const Configuration& q) const {
    const Pivots<Model, double> pivots = pivots_at<Model, double>(d_, u_, q);
    return is_regular<Model>(pivots, derivative_rounding<double>()) ? Status::ok
                                                                    : Status::near_singular;
  }

  const Dimensions& d_;
  const Inputs& u_;
  Assemblies<Model>& result_;
  bool was_polished_ = false;
};

/// Every configuration by formula, in any unit of length. False, and nothing is listed, if a closer
/// look is needed.
template <typename Model>
[[nodiscard]] bool search_by_formula(const typename Model::template Dimensions<double>& d,
                                     const typename Model::template Inputs<double>& u,
                                     double displaced, Assemblies<Model>& result) {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  const double longest = std::max(longest_length(d), longest_length(u));
  double scale = 1;  // a specialised group is in a unit of its own
  if constexpr (Model::dimension_count == 0) {
    if (!(longest <= most_length<Model>)) {
      return false;
    }
  } else {
    // Products of several lengths may neither overflow nor underflow.
    if (!(longest > 0x1p-64 && longest < 0x1p64)) {
      return false;
    }
    scale = support::inverse_power_of_two(longest) / 2;
  }
  const Dimensions scaled_d = support::scaled_to<Dimensions>(d, scale);
  const Inputs scaled_u = support::scaled_to<Inputs>(u, scale);
  if (!ClosedSearch<Model>(scaled_d, scaled_u, result).run(displaced * scale)) {
    result.count = 0;
    return false;
  }
  list_in<Model>(scaled_d, scaled_u, 1 / scale, result);
  return true;
}

}  // namespace assur::detail
