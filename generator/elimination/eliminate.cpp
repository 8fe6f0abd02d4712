#include "elimination/eliminate.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "derivatives/mobility.hpp"
#include "elimination/record.hpp"
#include "error.hpp"

namespace assur::generator::elimination {

namespace {

/// a0 + a1 cos x + a2 sin x as a Laurent polynomial in exp(i x), or a0 + a1 x + a2 x^2.
Univariate in_unknown(const GiNaC::ex& expression, const equations::Variable& unknown) {
  Univariate result;
  if (!unknown.is_angle()) {
    const GiNaC::ex expanded = expression.expand();
    for (int power = 0; power <= expanded.degree(unknown.value); ++power) {
      result.add(power, {expanded.coeff(unknown.value, power), 0});
    }
    return result;
  }
  const GiNaC::ex by_cosine = expression.diff(unknown.cosine);
  const GiNaC::ex by_sine = expression.diff(unknown.sine);
  const GiNaC::ex rest = expression.subs(GiNaC::lst{unknown.cosine == 0, unknown.sine == 0});
  const GiNaC::numeric half(1, 2);
  result.add(0, {rest.expand(), 0});
  result.add(1, {(half * by_cosine).expand(), (-half * by_sine).expand()});
  result.add(-1, {(half * by_cosine).expand(), (half * by_sine).expand()});
  return result;
}

class BezoutElimination {
 public:
  BezoutElimination(const equations::ClosureEquations& equations, const Reduction& reduction,
                    const equations::Vocabulary& vocabulary, const equations::Variable& first,
                    const equations::Variable* second)
      : equations_(equations), result_{reduction, &first,     second,           {}, {}, 0,
                                       0,         vocabulary, reduction.record, {}} {}

  Elimination run() {
    const Univariate final_polynomial = result_.second == nullptr ? single() : resultant();
    read_off(final_polynomial);
    return std::move(result_);
  }

 private:
  void finish(RecordedStep step) {
    step.vocabulary_size = result_.vocabulary.quantities().size();
    result_.record.push_back(std::move(step));
  }
  /// The variable of a series in the first unknown x: `w = exp(i x)`, or x itself.
  [[nodiscard]] std::string base() const {
    const std::string& name = result_.first->name;
    return result_.first->is_angle() ? "powers of `w = exp(i " + name + ")`" : "powers of " + name;
  }

  Univariate single() {
    Univariate polynomial = in_unknown(result_.reduction.equations[0], *result_.first)
                                .named("T", "final polynomial", result_.vocabulary);
    finish({"the one equation left, in " + base(),
            "no other unknown is left in it",
            {"T = 0"},
            {},
            {},
            {{"T", "g1", polynomial}}});
    return polynomial;
  }

  Univariate resultant() {
    std::vector<std::array<Univariate, 3>> coefficients;
    for (const GiNaC::ex& equation : result_.reduction.equations) {
      result_.in_second.push_back(coefficients_in_second(equation));
      std::array<Univariate, 3> row;
      for (std::size_t part = 0; part < 3; ++part) {
        row[part] = in_unknown(result_.in_second.back()[part], *result_.first);
      }
      coefficients.push_back(row);
    }
    finish(ordered_by_second(result_.in_second, *result_.second, *result_.first));
    return result_.second->is_angle() ? of_angle(coefficients[0], coefficients[1])
                                      : of_displacement(coefficients[0], coefficients[1]);
  }

  [[nodiscard]] std::array<GiNaC::ex, 3> coefficients_in_second(const GiNaC::ex& equation) const {
    const equations::Variable& z = *result_.second;
    if (z.is_angle()) {
      const GiNaC::ex rest = equation.subs(GiNaC::lst{z.cosine == 0, z.sine == 0}).expand();
      return {equation.diff(z.cosine).expand(), equation.diff(z.sine).expand(), rest};
    }
    const GiNaC::ex expanded = equation.expand();
    return {expanded.coeff(z.value, 2), expanded.coeff(z.value, 1), expanded.coeff(z.value, 0)};
  }

  [[nodiscard]] RecordedStep resultant_step(const std::string& rule,
                                            std::vector<std::string> formulas) const {
    return {"Bezout determinant in " + result_.second->name,
            rule,
            std::move(formulas),
            {result_.second}};
  }

  /// With P = A - i B and e = exp(i z), A cos z + B sin z + C = 0 is P e + 2 C + conj(P) / e = 0.
  /// Two such equations have a common root where |P1 C2 - P2 C1|^2 = (Im P1 conj(P2))^2.
  Univariate of_angle(const std::array<Univariate, 3>& one, const std::array<Univariate, 3>& two) {
    const ComplexExpression minus_i{0, -1};
    const auto leading = [&](const std::array<Univariate, 3>& row, const std::string& number) {
      return (row[0] + minus_i * row[1])
          .named("P" + number, "coefficient P of equation " + number, result_.vocabulary);
    };
    const auto constant = [&](const std::array<Univariate, 3>& row, const std::string& number) {
      return row[2].named("C" + number, "coefficient C of equation " + number, result_.vocabulary);
    };
    const Univariate p1 = leading(one, "1");
    const Univariate p2 = leading(two, "2");
    const Univariate c1 = constant(one, "1");
    const Univariate c2 = constant(two, "2");
    const Univariate u = (p1 * c2 - p2 * c1).named("U", "P1 C2 - P2 C1", result_.vocabulary);
    const Univariate product = p1 * p2.circle_conjugate();
    // Im f = (f - conj f) / (2 i) as a function on the circle.
    const Univariate v =
        (ComplexExpression{0, GiNaC::numeric(-1, 2)} * (product - product.circle_conjugate()))
            .named("V", "Im P1 conj(P2)", result_.vocabulary);
    const std::string& z = result_.second->name;
    RecordedStep step = resultant_step(
        "with `e = exp(i " + z +
            ")` and `P = A - i*B` an equation is `P*e + 2*C + conj(P)/e = 0`; two of "
            "them have a common root on the circle where their resultant vanishes. Given here in " +
            base() + "; at its root Cramer's rule gives " + z + " back",
        {"T = U*conj(U) - V^2 = 0", "cos(" + z + ") = (B1*C2 - B2*C1)/(A1*B2 - A2*B1)",
         "sin(" + z + ") = (A2*C1 - A1*C2)/(A1*B2 - A2*B1)"});
    step.series = {{"P1", "A1 - i*B1", p1}, {"P2", "A2 - i*B2", p2},   {"C1", "C1", c1},
                   {"C2", "C2", c2},        {"U", "P1*C2 - P2*C1", u}, {"V", "Im(P1*conj(P2))", v}};
    finish(std::move(step));
    return u * u.circle_conjugate() - v * v;
  }

  /// The resultant of a z^2 + b z + c and d z^2 + e z + f, by their degrees in z.
  Univariate of_displacement(std::array<Univariate, 3> one, std::array<Univariate, 3> two) {
    const bool swapped = one[0].is_zero() && !two[0].is_zero();
    if (swapped) {
      std::swap(one, two);
    }
    const auto name = [&](std::array<Univariate, 3>& row, const std::string& letters) {
      for (std::size_t part = 0; part < 3; ++part) {
        row[part] =
            row[part].named(std::string(1, letters[part]),
                            "coefficient of z^" + std::to_string(2 - part), result_.vocabulary);
      }
    };
    name(one, "abc");
    name(two, "def");
    const auto& [a, b, c] = one;
    const auto& [d, e, f] = two;
    const std::string& z = result_.second->name;
    const auto series_of = [&](const std::string& letters, const std::string& number) {
      const std::array<Univariate, 3>& row = letters == "abc" ? one : two;
      std::vector<RecordedSeries> series;
      for (std::size_t part = 0; part < 3; ++part) {
        series.push_back({std::string(1, letters[part]), "ABC"[part] + number, row[part]});
      }
      return series;
    };
    const auto record = [&](const std::string& resultant, const std::string& root,
                            std::vector<RecordedSeries> minors) {
      RecordedStep step = resultant_step(
          "two polynomials in " + z + ", `a*z^2 + b*z + c` and `d*z^2 + e*z + f` with `z = " + z +
              "`, have a common root where their resultant vanishes. Given here in " + base(),
          {"T = " + resultant + " = 0", z + " = " + root});
      step.series = series_of("abc", swapped ? "2" : "1");
      for (const auto& list : {series_of("def", swapped ? "1" : "2"), std::move(minors)}) {
        step.series.insert(step.series.end(), list.begin(), list.end());
      }
      finish(std::move(step));
    };
    if (a.is_zero()) {
      record("b*f - e*c", "-c/b", {});
      return b * f - e * c;
    }
    if (d.is_zero()) {
      record("a*f^2 - b*f*e + c*e^2", "-f/e", {});
      return a * f * f - b * f * e + c * e * e;
    }
    // Both quadratic: the Bezout determinant.
    const auto named = [&](const Univariate& value, const std::string& letter) {
      return value.named(letter, "minor of the Bezout matrix", result_.vocabulary);
    };
    const Univariate ac = named(a * f - d * c, "M");
    const Univariate ab = named(a * e - d * b, "N");
    const Univariate bc = named(b * f - e * c, "O");
    record("M^2 - N*O", "-M/N",
           {{"M", "a*f - d*c", ac}, {"N", "a*e - d*b", ab}, {"O", "b*f - e*c", bc}});
    return ac * ac - ab * bc;
  }

  /// Extracts the real coefficients and finds the generic degree by exact evaluation.
  void read_off(const Univariate& polynomial) {
    const bool trigonometric = result_.first->is_angle();
    for (int power = 0; power <= polynomial.degree(); ++power) {
      const ComplexExpression coefficient = polynomial.at(power);
      // f_k w^k + conj(f_k) w^-k = 2 Re f_k cos kx - 2 Im f_k sin kx.
      result_.polynomial.push_back(trigonometric && power > 0
                                       ? equations::Vector2{2 * coefficient.re, -2 * coefficient.im}
                                       : equations::Vector2{coefficient.re, 0});
    }
    const std::size_t formal_size = result_.polynomial.size();
    std::vector<GiNaC::exmap> assemblies;
    for (unsigned seed = 1; seed <= 3; ++seed) {
      assemblies.push_back(derivatives::random_assembly(equations_, seed));
    }
    const auto vanishes = [&](const GiNaC::ex& part) {
      const GiNaC::ex in_variables = result_.vocabulary.expand(part);
      return std::all_of(assemblies.begin(), assemblies.end(), [&](const GiNaC::exmap& values) {
        return in_variables.subs(values).expand().is_zero();
      });
    };
    while (!result_.polynomial.empty() && vanishes(result_.polynomial.back().x) &&
           vanishes(result_.polynomial.back().y)) {
      result_.polynomial.pop_back();
    }
    if (result_.polynomial.size() < 2) {
      throw GeneratorError("elimination", equations_.model->title(),
                           "the final polynomial has no unknown in it");
    }
    result_.degree = result_.polynomial.size() - 1;
    result_.max_configurations = trigonometric ? 2 * result_.degree : result_.degree;
    RecordedStep step = final_coefficients(result_.polynomial, *result_.first, formal_size - 1);
    result_.polynomial_text = step.formulas.front();
    const std::vector<RecordedQuantity> coefficients = step.quantities;
    step.formulas.front() = "T = " + step.formulas.front() + " = 0";
    finish(std::move(step));
    if (trigonometric) {
      finish(half_angle_form(coefficients, *result_.first));
    }
  }

  const equations::ClosureEquations& equations_;
  Elimination result_;
};

}  // namespace

Elimination eliminate(const equations::ClosureEquations& equations) {
  equations::Vocabulary vocabulary;
  const Reduction reduction = reduce(equations, vocabulary);
  const std::vector<const equations::Variable*>& remaining = reduction.remaining;
  std::vector<std::pair<const equations::Variable*, const equations::Variable*>> choices;
  if (remaining.size() == 1) {
    choices = {{remaining[0], nullptr}};
  } else {
    choices = {{remaining[0], remaining[1]}};
    // Of an angle and a displacement the angle remains: the displacement is simpler to eliminate.
    if (remaining[0]->is_angle() == remaining[1]->is_angle()) {
      choices.emplace_back(remaining[1], remaining[0]);
    }
  }
  std::optional<Elimination> best;
  for (const auto& [first, second] : choices) {
    Elimination candidate =
        BezoutElimination(equations, reduction, vocabulary, *first, second).run();
    if (!best || candidate.degree < best->degree) {
      best = std::move(candidate);
    }
  }
  return std::move(*best);
}

}  // namespace assur::generator::elimination
