#include "emission/scene/scene_number.hpp"

#include <assur/mechanism/error.hpp>
#include <assur/text/names.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "emission/cpp/cpp_text.hpp"
#include "emission/scene/formula_expression.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::emission::scene {

namespace {

template <typename Of>
SceneNumber unary(mechanism::Dual number, const SceneNumber& a, const Of& of) {
  return a.has_formula() ? SceneNumber(std::move(number), of(a.formula()), *a.symbols())
                         : SceneNumber(std::move(number));
}

template <typename Of>
SceneNumber binary(mechanism::Dual number, const SceneNumber& a, const SceneNumber& b,
                   const Of& of) {
  SceneSymbols* symbols = a.has_formula() ? a.symbols() : b.symbols();
  return symbols != nullptr ? SceneNumber(std::move(number), of(a.formula(), b.formula()), *symbols)
                            : SceneNumber(std::move(number));
}

/// The names of the symbols that a number depends on.
std::string symbols_in(const SceneNumber& number) {
  std::set<std::string> names;
  const GiNaC::ex formula = number.symbols()->written_out(number.formula());
  for (const GiNaC::ex& symbol : equations::symbols_of(formula)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
    const bool is_parameter = name.starts_with("p.");
    names.insert(is_parameter ? "parameters." + name.substr(2) : name);
  }
  return text::listed({names.begin(), names.end()});
}

/// The base, of either sign, of a formula that is a square; empty for any other formula.
std::optional<GiNaC::ex> squared(const GiNaC::ex& formula) {
  const GiNaC::ex factored =
      formula.info(GiNaC::info_flags::polynomial) ? GiNaC::factor(formula) : formula;
  std::vector<GiNaC::ex> factors = {factored};
  if (GiNaC::is_a<GiNaC::mul>(factored)) {
    factors.assign(factored.begin(), factored.end());
  }
  GiNaC::ex root = 1;
  for (const GiNaC::ex& factor : factors) {
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
    if (is_power && factor.op(1).info(GiNaC::info_flags::even)) {
      root *= GiNaC::pow(factor.op(0), factor.op(1) / 2);
    } else if (factor.info(GiNaC::info_flags::rational) &&
               GiNaC::sqrt(factor).info(GiNaC::info_flags::rational)) {
      root *= GiNaC::sqrt(factor);
    } else {
      return std::nullopt;
    }
  }
  return root.expand();
}

GiNaC::ex evaluated_power(const GiNaC::ex& a, const GiNaC::ex& b, const GiNaC::ex& by_base,
                          const GiNaC::ex& by_exponent) {
  if (!GiNaC::is_a<GiNaC::numeric>(b) || !by_exponent.is_zero()) {
    return power_derivative(a, b, by_base, by_exponent).hold();
  }
  GiNaC::ex factor = 1;
  const int times = GiNaC::ex_to<GiNaC::numeric>(by_base).to_int();
  for (int taken = 0; taken < times; ++taken) {
    factor *= b - taken;
  }
  return factor.is_zero() ? factor : factor * GiNaC::pow(a, b - by_base);
}

GiNaC::ex differentiated_power(const GiNaC::ex& a, const GiNaC::ex& b, const GiNaC::ex& by_base,
                               const GiNaC::ex& by_exponent, unsigned argument) {
  return argument == 0 ? power_derivative(a, b, by_base + 1, by_exponent)
                       : power_derivative(a, b, by_base, by_exponent + 1);
}

bool is_number(const GiNaC::ex& a) { return GiNaC::is_a<GiNaC::numeric>(a); }

GiNaC::ex evaluated_sense(const GiNaC::ex& a) {
  return is_number(a) ? GiNaC::ex(a.info(GiNaC::info_flags::negative) ? -1 : 1)
                      : sense_of(a).hold();
}

GiNaC::ex flat(const GiNaC::ex&, unsigned) { return 0; }

GiNaC::ex evaluated_absolute(const GiNaC::ex& a) {
  return is_number(a) ? evaluated_sense(a) * a : absolute(a).hold();
}

GiNaC::ex differentiated_absolute(const GiNaC::ex& a, unsigned) { return sense_of(a); }

GiNaC::ex evaluated_smaller(const GiNaC::ex& a, const GiNaC::ex& b) {
  return !is_number(a) || !is_number(b) ? smaller_of(a, b).hold() : bool(b < a) ? b : a;
}

GiNaC::ex evaluated_larger(const GiNaC::ex& a, const GiNaC::ex& b) {
  return !is_number(a) || !is_number(b) ? larger_of(a, b).hold() : bool(a < b) ? b : a;
}

/// The derivative of a choice with respect to an argument: 1 for the chosen one, by the sign of a
/// difference, and 0 for the other.
GiNaC::ex chosen(const GiNaC::ex& for_first, unsigned argument) {
  return (1 + (argument == 0 ? 1 : -1) * sense_of(for_first)) / 2;
}

GiNaC::ex differentiated_smaller(const GiNaC::ex& a, const GiNaC::ex& b, unsigned argument) {
  return chosen(b - a, argument);
}

GiNaC::ex differentiated_larger(const GiNaC::ex& a, const GiNaC::ex& b, unsigned argument) {
  return chosen(a - b, argument);
}

}  // namespace

// The macro is GiNaC's.
REGISTER_FUNCTION(sense_of,  // NOLINT
                  eval_func(evaluated_sense).evalf_func(evaluated_sense).derivative_func(flat))
REGISTER_FUNCTION(absolute,  // NOLINT
                  eval_func(evaluated_absolute)
                      .evalf_func(evaluated_absolute)
                      .derivative_func(differentiated_absolute))
REGISTER_FUNCTION(smaller_of,  // NOLINT
                  eval_func(evaluated_smaller)
                      .evalf_func(evaluated_smaller)
                      .derivative_func(differentiated_smaller))
REGISTER_FUNCTION(
    larger_of,  // NOLINT
    eval_func(evaluated_larger).evalf_func(evaluated_larger).derivative_func(differentiated_larger))

REGISTER_FUNCTION(power_derivative,  // NOLINT
                  eval_func(evaluated_power).derivative_func(differentiated_power))

GiNaC::ex SceneSymbols::root_of(const GiNaC::ex& radicand) {
  for (const Root& root : roots_) {
    if ((root.radicand - radicand).expand().is_zero()) {
      return root.symbol;
    }
  }
  const std::string name = "root_" + std::to_string(roots_.size() + 1);
  const GiNaC::symbol symbol(name);
  values_[symbol] = GiNaC::sqrt(value_of(radicand)).evalf();
  roots_.push_back(
      {symbol, radicand, GiNaC::symbol(name + "_rate"), GiNaC::symbol(name + "_second_rate")});
  return symbol;
}

GiNaC::ex SceneSymbols::value_of(const GiNaC::ex& formula) const {
  return formula.subs(values_).evalf();
}

GiNaC::ex SceneSymbols::written_out(const GiNaC::ex& formula) const {
  GiNaC::ex result = formula;
  for (auto root = roots_.rbegin(); root != roots_.rend(); ++root) {
    result = result.subs(root->symbol == GiNaC::sqrt(root->radicand));
  }
  return result;
}

GiNaC::ex SceneSymbols::derivative(const GiNaC::ex& formula, const GiNaC::symbol& symbol) const {
  GiNaC::ex result = formula.diff(symbol);
  for (const Root& root : roots_) {
    if (formula.has(root.symbol)) {
      result += formula.diff(root.symbol) * derivative(root.radicand, symbol) / (2 * root.symbol);
    }
  }
  return result;
}

SceneNumber::SceneNumber(mechanism::Dual number, GiNaC::ex formula, SceneSymbols& symbols)
    : number_(std::move(number)) {
  if (is_constant(formula)) {  // so it depends on none of the symbols
    number_ = mechanism::Dual(GiNaC::ex_to<GiNaC::numeric>(formula.evalf()).to_double());
  } else {
    formula_ = std::move(formula);
    symbols_ = &symbols;
  }
}

GiNaC::ex SceneNumber::formula() const {
  return has_formula() ? formula_ : GiNaC::ex(cpp::exact(value()));
}

bool operator>(const SceneNumber& a, const SceneNumber& b) {
  if (a.value() == b.value() && (a.has_formula() || b.has_formula())) {
    throw mechanism::MechanismError(
        "", "a length that depends on " + symbols_in(a.has_formula() ? a : b) +
                " is zero at the scene's own numbers, so that a link has no direction there; "
                "give the scene other numbers");
  }
  return a.value() > b.value();
}

GiNaC::ex shortened(const GiNaC::ex& formula) {
  const GiNaC::ex expanded = formula.expand();
  const GiNaC::ex any = GiNaC::wild();
  const GiNaC::ex in_cosines =
      expanded.subs(GiNaC::pow(GiNaC::sin(any), 2) == 1 - GiNaC::pow(GiNaC::cos(any), 2)).expand();
  return is_constant(in_cosines) || in_cosines.nops() < expanded.nops() ? in_cosines : formula;
}

SceneNumber operator-(const SceneNumber& a) {
  return unary(-a.number(), a, [](const GiNaC::ex& f) { return -f; });
}
SceneNumber operator+(const SceneNumber& a, const SceneNumber& b) {
  return binary(a.number() + b.number(), a, b,
                [](const GiNaC::ex& f, const GiNaC::ex& g) { return f + g; });
}
SceneNumber operator-(const SceneNumber& a, const SceneNumber& b) {
  return binary(a.number() - b.number(), a, b,
                [](const GiNaC::ex& f, const GiNaC::ex& g) { return f - g; });
}
SceneNumber operator*(const SceneNumber& a, const SceneNumber& b) {
  return binary(a.number() * b.number(), a, b,
                [](const GiNaC::ex& f, const GiNaC::ex& g) { return f * g; });
}
SceneNumber operator/(const SceneNumber& a, const SceneNumber& b) {
  return binary(a.number() / b.number(), a, b,
                [](const GiNaC::ex& f, const GiNaC::ex& g) -> GiNaC::ex {
                  const GiNaC::ex quotient = f / g;
                  const GiNaC::ex cancelled = quotient.normal();
                  return is_constant(cancelled) ? cancelled : quotient;
                });
}
SceneNumber operator/(const SceneNumber& a, double b) { return a / SceneNumber(b); }

SceneNumber sqrt(const SceneNumber& a) {
  return unary(sqrt(a.number()), a, [&a](const GiNaC::ex& f) -> GiNaC::ex {
    const GiNaC::ex radicand = shortened(f);
    const std::optional<GiNaC::ex> root = squared(radicand);
    if (!root) {
      return a.symbols()->root_of(radicand);
    }
    return bool(a.symbols()->value_of(*root) < 0) ? GiNaC::ex(-*root) : *root;
  });
}
SceneNumber sin(const SceneNumber& a) {
  return unary(sin(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::sin(f); });
}
SceneNumber cos(const SceneNumber& a) {
  return unary(cos(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::cos(f); });
}
SceneNumber tan(const SceneNumber& a) {
  return unary(tan(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::tan(f); });
}
SceneNumber asin(const SceneNumber& a) {
  return unary(asin(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::asin(f); });
}
SceneNumber acos(const SceneNumber& a) {
  return unary(acos(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::acos(f); });
}
SceneNumber atan(const SceneNumber& a) {
  return unary(atan(a.number()), a, [](const GiNaC::ex& f) { return GiNaC::atan(f); });
}
SceneNumber atan2(const SceneNumber& y, const SceneNumber& x) {
  return binary(atan2(y.number(), x.number()), y, x,
                [](const GiNaC::ex& f, const GiNaC::ex& g) { return GiNaC::atan2(f, g); });
}
SceneNumber abs(const SceneNumber& a) {
  return unary(abs(a.number()), a, [](const GiNaC::ex& f) -> GiNaC::ex { return absolute(f); });
}
SceneNumber min(const SceneNumber& a, const SceneNumber& b) {
  return binary(
      min(a.number(), b.number()), a, b,
      [](const GiNaC::ex& f, const GiNaC::ex& g) -> GiNaC::ex { return smaller_of(f, g); });
}
SceneNumber max(const SceneNumber& a, const SceneNumber& b) {
  return binary(
      max(a.number(), b.number()), a, b,
      [](const GiNaC::ex& f, const GiNaC::ex& g) -> GiNaC::ex { return larger_of(f, g); });
}
SceneNumber pow(const SceneNumber& a, double exponent) {
  return unary(pow(a.number(), exponent), a,
               [exponent](const GiNaC::ex& f) { return GiNaC::pow(f, cpp::exact(exponent)); });
}
SceneNumber pow(const SceneNumber& a, const SceneNumber& b) {
  return binary(pow(a.number(), b.number()), a, b,
                [](const GiNaC::ex& f, const GiNaC::ex& g) -> GiNaC::ex {
                  return power_derivative(f, g, 0, 0);
                });
}

}  // namespace assur::generator::emission::scene
