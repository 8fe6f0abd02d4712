// All configurations of a group in 50 digits, counted by Sturm's theorem.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <assur/numeric/second_unknown.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "families.hpp"
#include "positions/position_samples.hpp"
#include "runtime/sturm.hpp"
#include "stability/measure.hpp"

namespace assur::stability {

/// Coefficients by ascending power.
using RealPolynomial = std::vector<Real>;

[[nodiscard]] inline Real in_digits(const test::Rational& value) {
  std::ostringstream stream;
  stream << value;
  const std::string text = stream.str();
  const std::size_t bar = text.find('/');
  const Real numerator(text.substr(0, bar));
  return bar == std::string::npos ? numerator : Real(numerator / Real(text.substr(bar + 1)));
}

[[nodiscard]] inline Real value_at(const RealPolynomial& p, const Real& t) {
  Real value(0);
  for (std::size_t power = p.size(); power > 0; --power) {
    value = value * t + p[power - 1];
  }
  return value;
}

/// Real roots with a change of sign, ascending: between two neighbouring roots of the derivative
/// there is at most one, found by bisection.
[[nodiscard]] inline std::vector<Real> real_roots(RealPolynomial p) {
  while (!p.empty() && p.back() == Real(0)) {
    p.pop_back();
  }
  if (p.size() < 2) {
    return {};
  }
  RealPolynomial derivative;
  Real bound(1);
  for (std::size_t power = 1; power < p.size(); ++power) {
    derivative.push_back(p[power] * Real(static_cast<int>(power)));
    bound += abs(Real(p[power - 1] / p.back()));
  }
  std::vector<Real> ends = real_roots(derivative);
  ends.insert(ends.begin(), Real(-bound));
  ends.push_back(bound);
  std::vector<Real> roots;
  for (std::size_t place = 0; place + 1 < ends.size(); ++place) {
    Real low = ends[place];
    Real high = ends[place + 1];
    const bool rises = value_at(p, low) < Real(0);
    if (rises == (value_at(p, high) < Real(0))) {
      continue;
    }
    for (int step = 0; step < 260; ++step) {
      const Real centre = (low + high) / Real(2);
      ((value_at(p, centre) < Real(0)) == rises ? low : high) = centre;
    }
    roots.push_back((low + high) / Real(2));
  }
  return roots;
}

/// The longest length among variables.
template <typename Variables>
[[nodiscard]] double longest_of(const Variables& variables) {
  double longest = 0;
  for_each_member(variables, [&longest](const auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Real>) {
      longest = std::max(longest, std::abs(static_cast<double>(member)));
    }
  });
  return longest;
}

/// A length this many times the longest given length counts as infinite: a method may list such a
/// configuration or leave it out.
inline constexpr double far_away = 0x1p22;

/// A member of a family: the group as the methods are given it, and all its configurations.
template <typename Model>
struct ConfigurationMember {
  speed::PositionSample<Model> given;
  speed::PositionTruth<Model> truth;  ///< tolerances: 1%, or a third of the way to the next
  std::vector<bool> is_far;           ///< of each configuration, whether it has run to infinity
  /// Whether the list has the length that Sturm's theorem gives and holds the known configurations.
  bool is_vouched = false;
  double largest_condition = 0;  ///< of J, over the configurations that are not at infinity

  [[nodiscard]] int far_count() const {
    return static_cast<int>(std::count(is_far.begin(), is_far.end(), true));
  }
};

/// Newton's iteration on the loop closure from a point that satisfies it to many digits. False if
/// the result does not satisfy it to 40 digits. `assemble` cannot be used: it requires more digits
/// of an unknown than are certain where a configuration lies very far away.
template <typename Model>
[[nodiscard]] bool closes(Geometry<Model, Real>& g) {
  Vector<Real, Model::equation_count> f;
  for (int iteration = 0; iteration < 4; ++iteration) {
    RealJacobian<Model> jacobian;
    Model::jacobian(g.d, g.u, g.q, jacobian);
    Model::residual(g.d, g.u, g.q, f);
    const Vector<Real, Model::unknown_count> step =
        Eigen::FullPivLU<RealJacobian<Model>>(jacobian).solve(-f);
    advance(g.q, step);
  }
  Model::residual(g.d, g.u, g.q, f);
  return f.cwiseAbs().maxCoeff() < g.size * Real("1e-40");
}

/// Completes a root of the final polynomial and closes the loops in 50 digits. False if the
/// configuration lies at infinity.
template <typename Model>
[[nodiscard]] bool complete_root(const Real& t, Geometry<Model, Real>& g) {
  const Real norm = Real(1) + t * t;
  const Direction<Real> angle = {(Real(1) - t * t) / norm, Real(2) * t / norm};
  std::get<static_cast<std::size_t>(Model::first_unknown)>(g.q.members()) = angle;
  if constexpr (Model::second_unknown >= 0) {
    Matrix<Real, 2, 3> e;
    Model::second_equations(g.d, g.u, g.q, e);
    auto& second = std::get<static_cast<std::size_t>(Model::second_unknown)>(g.q.members());
    const auto candidates = numeric::second_candidates<std::decay_t<decltype(second)>>(e);
    if (candidates.count == 0) {
      return false;
    }
    second = candidates.list[0].value;
  }
  Model::complete(g.d, g.u, g.q);
  const double longest = longest_of(g.q);
  g.size = Real(std::max(1.0, longest));
  return longest < 1e25 && closes(g);
}

template <typename Family>
[[nodiscard]] ConfigurationMember<typename Family::Model> with_truth(
    const KnownGroup<typename Family::Model>& drawn, double distance) {
  using Model = typename Family::Model;
  using Dimensions = typename Model::template Dimensions<Real>;
  using Inputs = typename Model::template Inputs<Real>;
  using Long = typename Model::template Configuration<long double>;
  using Asked = typename Family::Asked;
  ConfigurationMember<Model> member;
  member.given = {converted<typename Model::template Dimensions<double>>(drawn.d),
                  converted<typename Model::template Inputs<double>>(drawn.u)};
  const auto& given = member.given;

  const auto polynomial =
      test::exact_final_polynomial<Model>(Asked::dimensions(given.d), Asked::inputs(given.u));
  const int expected =
      test::real_root_count(polynomial) - (distance > 0 ? 0 : Asked::roots_at_infinity);
  RealPolynomial in_reals;
  for (const test::Rational& coefficient : polynomial) {
    in_reals.push_back(in_digits(coefficient));
  }
  Geometry<Model, Real> g;
  g.d = converted<Dimensions>(given.d);
  g.u = converted<Inputs>(given.u);
  const double far = far_away * std::max(longest_of(g.d), longest_of(g.u));
  std::vector<typename Model::template Configuration<Real>> exact;
  Geometry<Model, Real> asked = g;
  asked.d = Asked::dimensions(g.d);
  asked.u = Asked::inputs(g.u);
  for (const Real& root : real_roots(in_reals)) {
    if (complete_root(root, asked)) {
      exact.push_back(Asked::answer(asked.q));
    }
  }
  for (const auto& q : exact) {
    member.truth.list.push_back(converted<Long>(q));
    member.is_far.push_back(longest_of(q) > far);
    g.q = q;
    if (!member.is_far.back() && longest_of(q) < 10) {
      member.largest_condition = std::max(member.largest_condition, derivatives(g).condition);
    }
  }
  member.truth.count = member.truth.list.size();
  for (const Long& q : member.truth.list) {
    double tolerance = wrong_error;
    for (const Long& other : member.truth.list) {
      const double gap = speed::apart(q, other);
      tolerance = gap > 0 ? std::min(tolerance, gap / 3) : tolerance;
    }
    member.truth.tolerances.push_back(tolerance);
  }
  member.is_vouched = static_cast<int>(exact.size()) == expected;
  for (const auto& q : drawn.known) {
    member.is_vouched =
        member.is_vouched && std::any_of(exact.begin(), exact.end(), [&](const auto& other) {
          return speed::apart(converted<Long>(q), converted<Long>(other)) < 1e-10;
        });
  }
  return member;
}

/// Members with the same number use the same random numbers at all distances. Configurations that
/// stay finite are regular, so a lost one is lost by the method.
template <typename Family>
[[nodiscard]] ConfigurationMember<typename Family::Model> make_configuration_member(
    int number, double distance) {
  RandomNumbers random(seed + static_cast<unsigned>(number));
  for (;;) {
    auto member = with_truth<Family>(Family::draw(random, Real(distance)), distance);
    if (member.largest_condition < regular_condition) {
      return member;
    }
  }
}

}  // namespace assur::stability
