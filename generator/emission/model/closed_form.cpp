#include "emission/model/closed_form.hpp"

#include <algorithm>
#include <assur/numeric/magnitude.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::model {

namespace {

using numeric::Magnitude;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The largest magnitudes of the variables of all groups whose lengths are at most `longest`;
/// `numbers` holds those of variables that are numbers.
Sizes sizes_up_to(double longest, const equations::ClosureEquations& equations,
                  const Sizes& numbers) {
  Sizes sizes = numbers;
  for (const auto* variables : {&equations.dimensions, &equations.inputs, &equations.unknowns}) {
    for (const equations::Variable& variable : *variables) {
      const bool is_given = variables != &equations.unknowns;
      for (const GiNaC::symbol& length : {variable.value, variable.size}) {
        sizes.emplace(length.get_name(), is_given ? longest : unbounded);
      }
      for (const GiNaC::symbol& ratio : {variable.cosine, variable.sine}) {
        sizes.emplace(ratio.get_name(), 1);
      }
    }
  }
  return sizes;
}

/// A program carried out on magnitudes, for any order in which the terms of a sum are added.
class Estimate {
 public:
  Estimate(const program::Program& program, const Sizes& sizes) : program_(program), sizes_(sizes) {
    for (const program::Program::Step& step : program.steps()) {
      const bool is_itself = step.form == equations::NamedQuantity::Form::itself;
      const Magnitude value = is_itself ? scaled(step.value) : Magnitude(unbounded, unbounded);
      steps_.emplace(step.name, value);
    }
    for (const program::Program::Assignment& assignment : program.assignments()) {
      results_.emplace(assignment.target, scaled(assignment.value));
    }
  }

  /// Zero for a result that the program omits.
  [[nodiscard]] Magnitude result(const program::Place& target) const {
    const auto found = results_.find(target);
    return found == results_.end() ? Magnitude() : found->second;
  }

 private:
  [[nodiscard]] static Magnitude number(const GiNaC::numeric& value) {
    return value.is_integer() ? Magnitude(std::abs(value.to_double()), 0)
                              : Magnitude(value.to_double());
  }
  [[nodiscard]] Magnitude scaled(const program::ScaledNode& value) const {
    return value.coefficient.scales() ? number(value.coefficient.value()) * node(value.node)
                                      : node(value.node);
  }
  [[nodiscard]] Magnitude node(program::NodeIndex index) const {
    using Operation = program::ExpressionGraph::Operation;
    const std::string& name = program_.name_of(index);
    if (const auto step = steps_.find(name); step != steps_.end()) {
      return step->second;
    }
    const program::ExpressionGraph::Node& content = program_.graph().nodes()[index];
    switch (content.operation) {
      case Operation::constant:
        return number(1);
      case Operation::symbol:
        return Magnitude::given(sizes_.at(name));
      case Operation::product: {
        Magnitude product = node(content.factors.front());
        std::for_each(std::next(content.factors.begin()), content.factors.end(),
                      [&](program::NodeIndex factor) { product = product * node(factor); });
        return product;
      }
      case Operation::sum:
        break;
    }
    Magnitude sum;
    for (const program::ScaledNode& term : content.terms) {
      const Magnitude value = scaled(term);
      sum = {sum.size + value.size, sum.units + value.units};
    }
    // Whatever the order, no partial sum exceeds the sum of all magnitudes.
    sum.units += static_cast<double>(content.terms.size() - 1) * sum.size;
    return sum;
  }

  const program::Program& program_;
  const Sizes& sizes_;
  std::map<std::string, Magnitude> steps_;
  std::map<program::Place, Magnitude> results_;
};

/// The discriminants of the final polynomial, as the runtime computes them.
support::Discriminants<Magnitude> discriminants(const elimination::Elimination& elimination,
                                                const Estimate& polynomial, double off) {
  const auto coefficient = [&](const program::Place& target) {
    return polynomial.result(target) + Magnitude::error(off);
  };
  if (elimination.first->is_angle()) {
    TrigonometricPolynomial<Magnitude, 1> T;
    for (const std::size_t power : {0U, 1U}) {
      const std::string place = "[" + std::to_string(power) + "]";
      T.cosine[power] = coefficient({"T", ".cosine" + place});
      T.sine[power] = coefficient({"T", ".sine" + place});
    }
    return support::discriminants_of(T);
  }
  if (elimination.degree == 1) {
    Vector<Magnitude, 2> T;
    T << coefficient(program::entry("T", 0)), coefficient(program::entry("T", 1));
    return support::discriminants_of(T);
  }
  Vector<Magnitude, 3> T;
  T << coefficient(program::entry("T", 0)), coefficient(program::entry("T", 1)),
      coefficient(program::entry("T", 2));
  return support::discriminants_of(T);
}

/// An upper bound of the magnitude of a polynomial.
double most(const GiNaC::ex& polynomial, const Sizes& sizes) {
  const GiNaC::ex expanded = polynomial.expand();
  if (GiNaC::is_a<GiNaC::numeric>(expanded)) {
    return std::abs(GiNaC::ex_to<GiNaC::numeric>(expanded).to_double());
  }
  if (GiNaC::is_a<GiNaC::symbol>(expanded)) {
    return sizes.at(GiNaC::ex_to<GiNaC::symbol>(expanded).get_name());
  }
  if (GiNaC::is_a<GiNaC::power>(expanded)) {
    return std::pow(most(expanded.op(0), sizes),
                    GiNaC::ex_to<GiNaC::numeric>(expanded.op(1)).to_double());
  }
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
  double result = is_sum ? 0 : 1;
  for (const GiNaC::ex& part : expanded) {
    result = is_sum ? result + most(part, sizes) : result * most(part, sizes);
  }
  return result;
}

/// A final polynomial T = c0 + c1 cos x + s1 sin x of a group with two unknowns. Its two roots
/// belong to r = sqrt(discriminant) and to -r, and the derivative of T is r there, up to its sign.
class Circle {
 public:
  Circle(const equations::ClosureEquations& equations, const elimination::Elimination& elimination,
         const pivoting::StructuredJacobian& structured)
      : equations_(equations),
        elimination_(elimination),
        structured_(structured),
        x_(elimination.first->direction()),
        constant_(elimination.vocabulary.expand(elimination.polynomial[0].x)),
        cosine_(elimination.vocabulary.expand(elimination.polynomial[1].x)),
        sine_(elimination.vocabulary.expand(elimination.polynomial[1].y)) {
    for (const elimination::BackSubstitution& step : elimination.reduction.steps) {
      const auto value = [&](std::size_t part) {
        return elimination.vocabulary.expand(step.numerators[part]) /
               elimination.vocabulary.expand(step.denominator);
      };
      if (step.unknown->is_angle()) {
        completed_[step.unknown->cosine] = value(0);
        completed_[step.unknown->sine] = value(1);
      } else {
        completed_[step.unknown->value] = value(0);
      }
    }
  }

  /// The discriminant above which a group is certainly regular. Zero if det J is not a constant
  /// multiple of the square root of the discriminant, which then does not decide.
  [[nodiscard]] double regular_discriminant(Sizes sizes) const {
    GiNaC::ex determinant = 1;
    for (const pivoting::Pivot& pivot : structured_.pivots()) {
      determinant *= structured_.vocabulary().expand(pivot.value);
    }
    const GiNaC::ex multiple = ratio(determinant, sine_ * x_.x - cosine_ * x_.y);
    if (!GiNaC::is_a<GiNaC::numeric>(multiple) || multiple.is_zero()) {
      return 0;
    }
    for (const elimination::BackSubstitution& step : elimination_.reduction.steps) {
      if (!step.unknown->is_angle() && step.denominator.is_equal(1)) {
        sizes[step.unknown->size.get_name()] =
            most(elimination_.vocabulary.expand(step.numerators[0]), sizes);
      }
    }
    // `is_regular` with every magnitude at its bound.
    const auto size_of = [&](const GiNaC::ex& size) {
      return most(structured_.vocabulary().expand(size), sizes);
    };
    double square = support::derivative_rounding<double>() / support::six_digits *
                    size_of(structured_.core_terms());
    for (std::size_t index = 0; index < structured_.pivots().size(); ++index) {
      const double size = size_of(structured_.pivots()[index].bound);
      square *= index < structured_.core_pivot_count() ? size : size * size;
    }
    const double factor = GiNaC::ex_to<GiNaC::numeric>(multiple).to_double();
    return std::isfinite(square) ? square / (factor * factor) : 0;
  }

  /// The first of the keys that order configurations in which the two roots differ.
  struct Difference {
    int key;
    /// The square of the difference is at least this times the discriminant; zero if no such bound
    /// is known.
    double least;
  };
  [[nodiscard]] Difference first_difference(const Sizes& sizes) const {
    std::vector<equations::Vector2> links;
    for (const equations::LinkPose& pose : equations_.poses) {
      links.push_back({expanded(pose.direction.x), expanded(pose.direction.y)});
    }
    std::vector<GiNaC::ex> keys;
    const auto add_pairs = [&](const auto& key_of) {
      for (std::size_t one = 0; one < links.size(); ++one) {
        for (std::size_t other = one + 1; other < links.size(); ++other) {
          keys.push_back(key_of(links[one], links[other]));
        }
      }
    };
    add_pairs([](const auto& a, const auto& b) { return a.x * b.x + a.y * b.y; });
    add_pairs([](const auto& a, const auto& b) { return a.x * b.y - a.y * b.x; });
    for (const equations::Variable& unknown : equations_.unknowns) {
      if (!unknown.is_angle()) {
        keys.emplace_back(unknown.value);
      }
    }
    for (std::size_t place = 0; place < keys.size(); ++place) {
      const GiNaC::ex square = square_of_difference(keys[place]);
      if (!square.is_zero()) {
        const GiNaC::ex fraction = square.numer_denom();
        const bool is_bounded = GiNaC::is_a<GiNaC::numeric>(fraction.op(0));
        return {static_cast<int>(place),
                is_bounded ? most(fraction.op(0), sizes) / most(fraction.op(1), sizes) : 0};
      }
    }
    return {0, 0};
  }

  /// Whether a root of T, with the other unknowns completed, always satisfies the closures: the sum
  /// of their squares is a constant multiple of T^2. T must also contain every dimension and input,
  /// so that it is NaN if one of these is.
  [[nodiscard]] bool completion_closes() const {
    GiNaC::ex square;
    for (const GiNaC::ex& residual : equations_.residuals) {
      square += GiNaC::pow(expanded(residual), 2);
    }
    const GiNaC::ex T = constant_ + cosine_ * x_.x + sine_ * x_.y;
    const auto shows = [&](const equations::Variable& variable) {
      return variable.is_angle() ? T.has(variable.cosine) && T.has(variable.sine)
                                 : T.has(variable.value);
    };
    return GiNaC::is_a<GiNaC::numeric>(ratio(square, T * T)) &&
           std::all_of(equations_.dimensions.begin(), equations_.dimensions.end(), shows) &&
           std::all_of(equations_.inputs.begin(), equations_.inputs.end(), shows);
  }

 private:
  [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& expression) const {
    return equations_.vocabulary.expand(expression);
  }
  /// A value, with the completed unknowns substituted, divided by a polynomial.
  [[nodiscard]] GiNaC::ex ratio(const GiNaC::ex& value, const GiNaC::ex& polynomial) const {
    const GiNaC::ex fraction = value.subs(completed_).normal().numer_denom();
    return (elimination::on_circle(fraction.op(0), equations_) /
            elimination::on_circle(fraction.op(1) * polynomial, equations_))
        .normal();
  }
  /// The square of a key's difference between the two roots, over the discriminant. For a key of
  /// higher degree in the unknown the difference counts as unknown.
  [[nodiscard]] GiNaC::ex square_of_difference(const GiNaC::ex& key) const {
    const GiNaC::ex fraction = key.subs(completed_).normal().numer_denom();
    const GiNaC::ex numerator = elimination::on_circle(fraction.op(0), equations_);
    if (!is_linear(numerator)) {
      return x_.x;
    }
    const GiNaC::ex part = numerator.coeff(x_.y) * cosine_ - numerator.coeff(x_.x) * sine_;
    const GiNaC::ex leading = (cosine_ * cosine_ + sine_ * sine_) * fraction.op(1);
    return (elimination::on_circle(4 * part * part, equations_) /
            elimination::on_circle(leading * leading, equations_))
        .normal();
  }
  [[nodiscard]] bool is_linear(const GiNaC::ex& polynomial) const {
    return polynomial.degree(x_.x) <= 1 && polynomial.degree(x_.y) <= 1 &&
           !polynomial.coeff(x_.x).has(x_.y);
  }

  const equations::ClosureEquations& equations_;
  const elimination::Elimination& elimination_;
  const pivoting::StructuredJacobian& structured_;
  equations::Vector2 x_;
  GiNaC::ex constant_, cosine_, sine_;
  GiNaC::exmap completed_;
};

/// A bound in three digits, rounded up.
std::string bound_text(double bound) {
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 2);
  std::ostringstream text;
  text << std::setprecision(3) << std::ceil(bound / unit) * unit;
  return bound > 0 ? text.str() : "0";
}

}  // namespace

int show_closed_form(const equations::ClosureEquations& equations,
                     const elimination::Elimination& elimination,
                     const pivoting::StructuredJacobian& structured,
                     const program::Program& polynomial, const GroupRange& range, cpp::View& view) {
  view.set("is_closed", elimination.is_closed());
  if (!elimination.is_closed()) {
    return 0;
  }
  const auto up_to = [&](double longest) {
    const Sizes sizes = sizes_up_to(longest, equations, range.numbers);
    return discriminants(elimination, Estimate(polynomial, sizes), range.rounding_of_numbers);
  };
  const support::Discriminants<Magnitude> found = up_to(range.longest);
  const support::Discriminants<Magnitude> twice = up_to(2 * range.longest);
  const auto show = [&](const std::string& name, const Magnitude& one, const Magnitude& two) {
    const int degree = range.is_scaled ? std::ilogb(two.size / one.size) : 0;
    // Products of errors are not estimated. Where the magnitude is zero, there are no other errors.
    const bool is_known = one.rounding() > 0 && degree <= support::highest_discriminant_degree;
    constexpr double nothing_is_certain = 1e300;
    view.set(name + "_degree", std::to_string(degree));
    view.set(name + "_error", bound_text(is_known ? std::min(one.rounding(), nothing_is_certain)
                                                  : nothing_is_certain));
  };
  show("discriminant", found.discriminant, twice.discriminant);
  const bool has_leading = !elimination.first->is_angle() && elimination.degree == 2;
  view.set("has_leading", has_leading);
  if (has_leading) {
    show("leading", found.leading, twice.leading);
  }
  // In larger groups det J has more factors.
  double regular = 0;
  int first_key = 0;
  if (elimination.first->is_angle() && equations.unknowns.size() == 2) {
    const Circle circle(equations, elimination, structured);
    const Sizes sizes = sizes_up_to(range.longest, equations, range.numbers);
    const Circle::Difference difference = circle.first_difference(sizes);
    // Ten times the largest difference that rounding causes in a key.
    constexpr double clear = 1e-5;
    const double from = circle.regular_discriminant(sizes);
    if (from > 0 && difference.least > 0 && circle.completion_closes()) {
      regular = std::max(from, clear * clear / difference.least);
      first_key = difference.key;
    }
  }
  view.set("regular_discriminant", bound_text(regular));
  view.set("first_key", std::to_string(first_key));
  return first_key;
}

}  // namespace assur::generator::emission::model
