#include "pivoting/trigonometric_factors.hpp"

#include <algorithm>
#include <utility>

namespace assur::generator::pivoting {

namespace {

using Angles = std::vector<const equations::Variable*>;

Angles angles_in(const GiNaC::ex& expression, const equations::ClosureEquations& equations) {
  Angles angles;
  for (const auto* variables : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *variables) {
      if (variable.is_angle() &&
          (expression.has(variable.cosine) || expression.has(variable.sine))) {
        angles.push_back(&variable);
      }
    }
  }
  return angles;
}

bool holds_a_length(const GiNaC::ex& expression, const equations::ClosureEquations& equations) {
  for (const auto* variables : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *variables) {
      if (!variable.is_angle() && expression.has(variable.value)) {
        return true;
      }
    }
  }
  return false;
}

/// The terms of an expanded sum.
std::vector<GiNaC::ex> terms_of(const GiNaC::ex& expanded) {
  if (!GiNaC::is_a<GiNaC::add>(expanded)) {
    return {expanded};
  }
  return {expanded.begin(), expanded.end()};
}

/// One angle's exponential exp(i angle) as a symbol, and its square.
struct Exponential {
  const equations::Variable* angle;
  GiNaC::symbol single{"e"};
  GiNaC::symbol square{"w"};
};

/// The expression in squares of exponentials, times a monomial and a power of i; empty if powers of
/// i or odd powers of the exponentials remain.
std::optional<GiNaC::ex> in_squares(const GiNaC::ex& expression,
                                    const std::vector<Exponential>& exponentials) {
  GiNaC::ex sum;
  int parity = -1;
  for (const GiNaC::ex& term : terms_of(expression.expand())) {
    GiNaC::ex image = term;
    int sines = 0;
    for (const Exponential& each : exponentials) {
      sines += term.degree(each.angle->sine);
      image = image.subs(GiNaC::lst{each.angle->cosine == (each.single + 1 / each.single) / 2,
                                    each.angle->sine == (each.single - 1 / each.single) / 2});
    }
    if (parity < 0) {
      parity = sines % 2;
    }
    if (sines % 2 != parity) {
      return std::nullopt;
    }
    sum += sines % 4 < 2 ? image : -image;  // sin = (e - 1/e)/(2i): i^2 = -1 for each two of them
  }
  sum = sum.expand();
  for (const Exponential& each : exponentials) {
    sum = (sum * GiNaC::pow(each.single, -sum.ldegree(each.single))).expand();
    GiNaC::ex squares;
    for (int power = 0; power <= sum.degree(each.single); ++power) {
      const GiNaC::ex coefficient = sum.coeff(each.single, power);
      if (power % 2 == 1 && !coefficient.is_zero()) {
        return std::nullopt;
      }
      squares += coefficient * GiNaC::pow(each.square, power / 2);
    }
    sum = squares.expand();
  }
  return sum;
}

/// Up to a monomial, a w^m - a w^n is a sine of m - n times the angle, and a w^m + a w^n a cosine.
std::optional<TrigonometricFactor> binomial(const GiNaC::ex& factor,
                                            const std::vector<Exponential>& exponentials) {
  const std::vector<GiNaC::ex> terms = terms_of(factor.expand());
  if (terms.size() != 2) {
    return std::nullopt;
  }
  TrigonometricFactor result{false, {}};
  GiNaC::ex first = terms[0];
  GiNaC::ex second = terms[1];
  for (const Exponential& each : exponentials) {
    result.angle.add(*each.angle, first.degree(each.square) - second.degree(each.square));
    first = first.subs(each.square == 1);
    second = second.subs(each.square == 1);
  }
  if (!first.is_equal(second) && !first.is_equal(-second)) {
    return std::nullopt;
  }
  result.sine = first.is_equal(-second);
  // The sign of the angle is chosen so that it is the same in every process.
  if (result.angle.terms().front().second < 0) {
    result.angle = equations::AngleSum() - result.angle;
  }
  return result;
}

GiNaC::ex expanded(const std::vector<TrigonometricFactor>& factors) {
  GiNaC::ex product = 1;
  for (const TrigonometricFactor& factor : factors) {
    const equations::Vector2 direction = factor.angle.direction();
    product *= factor.sine ? direction.y : direction.x;
  }
  return product.expand();
}

/// The value at rational points of the circle, one for each angle.
GiNaC::ex at_a_point(const GiNaC::ex& expression, const Angles& angles) {
  GiNaC::exmap values;
  GiNaC::numeric tangent(1, 2);
  for (const equations::Variable* angle : angles) {
    const GiNaC::numeric scale = 1 / (1 + tangent * tangent);
    values[angle->cosine] = (1 - tangent * tangent) * scale;
    values[angle->sine] = 2 * tangent * scale;
    tangent = tangent / 3 + 1;
  }
  return expression.subs(values).expand();
}

}  // namespace

std::optional<TrigonometricProduct> trigonometric_product(
    const GiNaC::ex& expression, const equations::ClosureEquations& equations) {
  if (holds_a_length(expression, equations)) {
    return std::nullopt;
  }
  const Angles angles = angles_in(expression, equations);
  std::vector<Exponential> exponentials;
  for (const equations::Variable* angle : angles) {
    exponentials.push_back({angle});
  }
  const std::optional<GiNaC::ex> polynomial = in_squares(expression, exponentials);
  if (!polynomial) {
    return std::nullopt;
  }
  const GiNaC::ex factored = GiNaC::factor(*polynomial);
  std::vector<GiNaC::ex> parts = {factored};
  if (GiNaC::is_a<GiNaC::mul>(factored)) {
    parts = {factored.begin(), factored.end()};
  }
  TrigonometricProduct product{1, {}};
  for (const GiNaC::ex& part : parts) {
    if (GiNaC::is_a<GiNaC::numeric>(part) || GiNaC::is_a<GiNaC::symbol>(part)) {
      continue;  // scales are settled below; a monomial has size one
    }
    const std::optional<TrigonometricFactor> factor = binomial(part, exponentials);
    if (!factor) {
      return std::nullopt;
    }
    product.factors.push_back(*factor);
  }
  std::sort(product.factors.begin(), product.factors.end(),
            [](const TrigonometricFactor& left, const TrigonometricFactor& right) {
              return std::pair(left.angle.text(), left.sine) <
                     std::pair(right.angle.text(), right.sine);
            });
  const GiNaC::ex value = at_a_point(expression, angles);
  const GiNaC::ex other = at_a_point(expanded(product.factors), angles);
  if (value.is_equal(-other)) {
    product.sign = -1;
  } else if (!value.is_equal(other)) {
    return std::nullopt;
  }
  return product;
}

}  // namespace assur::generator::pivoting
