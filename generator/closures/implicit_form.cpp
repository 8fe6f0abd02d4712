#include "closures/implicit_form.hpp"

#include <algorithm>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <set>

#include "closures/angle_terms.hpp"
#include "closures/circle_algebra.hpp"
#include "closures/extent.hpp"
#include "closures/formula_text.hpp"

namespace assur::generator::closures {

namespace {

/// The largest power, since powers of sums are multiplied out.
constexpr int max_power = 64;

/// The consequence when the radicand of a function vanishes or is negative.
const std::string no_derivatives = " has no value or no derivatives";

bool is_function(const GiNaC::ex& expression) { return GiNaC::is_a<GiNaC::function>(expression); }

std::string function_name(const GiNaC::ex& function) {
  return GiNaC::ex_to<GiNaC::function>(function).get_name();
}

/// Throws NotAlgebraic if there are too many terms.
GiNaC::ex multiplied_out(const GiNaC::ex& expression) {
  if (!can_be_multiplied_out(expression, max_terms_emitted)) {
    throw NotAlgebraic("it has too many terms when its powers and products are multiplied out");
  }
  return expression.expand();
}

class Translation {
 public:
  Translation(const ClosureSystem& system, const std::vector<std::string>& types,
              const std::vector<std::string>& locals)
      : system_(system), used_(types.begin(), types.end()) {
    used_.insert(locals.begin(), locals.end());
    declare_variables(types);
  }

  equations::ImplicitEquations run() {
    ExtentMeter meter(&system_.extents());
    for (const ClosureSystem::Closure& closure : system_.closures()) {
      try {
        if (meter.of(closure.expression).nesting > max_nesting_emitted) {
          throw NotAlgebraic("more than " + std::to_string(max_nesting_emitted) +
                             " roots and inverse functions stand within one another");
        }
        result_.residuals.push_back(multiplied_out(scalar(closure.expression)));
      } catch (const NotAlgebraic& error) {
        throw NotAlgebraic("closure " + closure.name + ": " + error.what());
      }
    }
    result_.residuals_meaning =
        text::joined(system_.closures(), ", ",
                     [](const ClosureSystem::Closure& closure) { return closure.name; });
    return std::move(result_);
  }

 private:
  using Quantity = equations::Variable::Quantity;

  void declare_variables(const std::vector<std::string>& taken) {
    std::vector<std::string> names;
    for (const AuditSymbol& symbol : system_.symbols()) {
      names.push_back(symbol.name);
    }
    const std::vector<std::string> members = text::member_names(names, taken);
    for (std::size_t place = 0; place < members.size(); ++place) {
      const AuditSymbol& symbol = system_.symbols()[place];
      const std::string& name = members[place];
      std::deque<equations::Variable>& list = symbol.unknown  ? result_.unknowns
                                              : symbol.moving ? result_.inputs
                                                              : result_.dimensions;
      const std::string kind = symbol.angle ? "angle" : "length";
      equations::Variable& variable =
          list.emplace_back(name, symbol.angle ? Quantity::angle : Quantity::length,
                            symbol.meaning.empty() ? kind : kind + ", " + symbol.meaning);
      // By default phi_1 and psi_1 would both have the rate omega_1, and a length may be cos_phi.
      variable.cosine = GiNaC::symbol("cos(" + name + ")");
      variable.sine = GiNaC::symbol("sin(" + name + ")");
      variable.size = GiNaC::symbol("abs(" + name + ")");
      if (symbol.angle) {
        variable.rate = GiNaC::symbol("omega_" + name);
        variable.second_rate = GiNaC::symbol("alpha_" + name);
        variable.third_rate = GiNaC::symbol("jerk_" + name);
      }
      variables_.emplace(symbol.symbol, &variable);
      used_.insert(name);
      for (const GiNaC::symbol& rate : {variable.rate, variable.second_rate, variable.third_rate}) {
        used_.insert(rate.get_name());
      }
    }
  }

  /// A new identifier for a quantity; the one prefixed by `inverse_` stays free for its reciprocal.
  std::string fresh(const std::string& wanted) {
    // Programs name their temporaries t1, t2, ...
    const bool temporary = wanted.size() > 1 && wanted[0] == 't' &&
                           wanted.find_first_not_of("0123456789", 1) == std::string::npos;
    const std::string base = temporary ? wanted + "_" : wanted;
    while (true) {
      std::string name =
          text::member_names({base}, std::vector<std::string>(used_.begin(), used_.end()))[0];
      used_.insert(name);
      if (used_.insert("inverse_" + name).second) {
        return name;
      }
    }
  }

  GiNaC::ex scalar(const GiNaC::ex& expression) {
    if (GiNaC::is_a<GiNaC::numeric>(expression)) {
      if (!expression.info(GiNaC::info_flags::rational)) {
        throw NotAlgebraic("'" + text(expression) + "' is not a real number");
      }
      return expression;
    }
    if (GiNaC::is_a<GiNaC::symbol>(expression)) {
      return named(expression);
    }
    if (GiNaC::is_a<GiNaC::power>(expression)) {
      return power(expression, "");
    }
    if (GiNaC::is_a<GiNaC::add>(expression) || GiNaC::is_a<GiNaC::mul>(expression)) {
      const bool sum = GiNaC::is_a<GiNaC::add>(expression);
      GiNaC::ex result = sum ? 0 : 1;
      for (const GiNaC::ex& operand : ordered_operands(expression)) {
        const GiNaC::ex value = scalar(operand);
        result = sum ? result + value : result * value;
      }
      return result;
    }
    if (is_function(expression)) {
      const std::string name = function_name(expression);
      if (name == "cos" || name == "sin" || name == "tan") {
        const equations::Vector2 direction = direction_of(expression.op(0));
        if (name == "tan") {
          return direction.y * reciprocal(direction.x, "cos(" + text(expression.op(0)) + ") = 0");
        }
        return name == "cos" ? direction.x : direction.y;
      }
    }
    throw NotAlgebraic("'" + text(expression) + "' stands outside a sine or cosine");
  }

  static std::string text(const GiNaC::ex& expression) { return formula_text(expression); }

  /// A length, or an abbreviation of a number, by its name.
  GiNaC::ex named(const GiNaC::ex& symbol) {
    if (const auto variable = variables_.find(symbol); variable != variables_.end()) {
      if (variable->second->is_angle()) {
        throw NotAlgebraic("the angle '" + text(symbol) + "' stands outside a sine or cosine");
      }
      return variable->second->value;
    }
    const GiNaC::ex* definition = system_.definition_of(symbol);
    if (definition == nullptr) {
      throw NotAlgebraic("'" + text(symbol) + "' is a derivative along the solutions of the " +
                         "closures, and these cannot contain one");
    }
    auto [known, is_new] = numbers_.try_emplace(symbol);
    if (is_new) {
      const std::string name = text(symbol);
      if (GiNaC::is_a<GiNaC::power>(*definition)) {
        known->second = power(*definition, name);
      } else {
        const GiNaC::ex value = multiplied_out(scalar(*definition));
        known->second = result_.vocabulary.name(fresh(name), value, text(*definition));
      }
    }
    return known->second;
  }

  /// Sorts first the one of two opposite sums that begins with a plus.
  static std::pair<bool, std::string> rank(const GiNaC::ex& sum) {
    const std::string shown = text(sum);
    return {shown.starts_with('-'), shown};
  }

  GiNaC::ex power(const GiNaC::ex& expression, const std::string& name) {
    GiNaC::ex base = expression.op(0);
    const GiNaC::ex twice = 2 * expression.op(1);
    if (!twice.info(GiNaC::info_flags::integer)) {
      throw NotAlgebraic("the power " + text(expression.op(1)) + " is not a whole or half number");
    }
    if (abs(GiNaC::ex_to<GiNaC::numeric>(twice)) > 2 * max_power) {
      throw NotAlgebraic("the power " + text(expression.op(1)) + " is higher than " +
                         std::to_string(max_power));
    }
    const int halves = GiNaC::ex_to<GiNaC::numeric>(twice).to_int();
    const int whole = std::abs(halves) / 2;
    GiNaC::ex sign = 1;
    // GiNaC writes 1/(a - b) as -1/(b - a) in some runs.
    if (halves % 2 == 0 && halves < 0 && GiNaC::is_a<GiNaC::add>(base) &&
        rank(-base) < rank(base)) {
      base = -base;
      sign = whole % 2 == 0 ? 1 : -1;
    }
    const GiNaC::ex value = scalar(base);
    const bool rooted = halves % 2 != 0;
    GiNaC::ex root = 1;
    if (rooted) {
      const std::string degeneracy =
          GiNaC::is_a<GiNaC::numeric>(base) ? "" : "sqrt(" + text(base) + ")" + no_derivatives;
      root = result_.vocabulary.name_root(fresh(name.empty() ? "root" : name),
                                          multiplied_out(value), degeneracy);
    }
    if (halves > 0) {
      return GiNaC::pow(value, whole) * root;
    }
    const std::string degeneracy = text(base) + " = 0";
    GiNaC::ex inverse = rooted ? reciprocal(root, degeneracy) : GiNaC::ex(1);
    if (whole > 0) {
      inverse *= GiNaC::pow(reciprocal(value, degeneracy), whole);
    }
    return sign * inverse;
  }

  /// The reciprocal of a value, named `inverse_a5` for a symbol a5, else `inverse_divisor`.
  GiNaC::ex reciprocal(const GiNaC::ex& value, const std::string& degeneracy) {
    const GiNaC::ex denominator = multiplied_out(value);
    if (denominator.is_zero()) {
      throw NotAlgebraic("division by zero: " + degeneracy);
    }
    std::string name = "divisor";
    if (GiNaC::is_a<GiNaC::symbol>(denominator)) {
      name = text::c_identifier(GiNaC::ex_to<GiNaC::symbol>(denominator).get_name());
      name.erase(name.find_last_not_of('_') + 1);
    }
    return result_.vocabulary.name_reciprocal(fresh("inverse_" + name), denominator, degeneracy);
  }

  equations::Vector2 direction_of(const GiNaC::ex& angle) {
    const AngleTerms sum = angle_terms(angle, system_);
    equations::Vector2 direction{1, 0};
    if (!sum.terms.empty()) {
      const int sense = sum.terms.begin()->second.factor < 0 ? -1 : 1;
      direction = direction_of_terms(sum, sense,
                                     GiNaC::is_a<GiNaC::symbol>(angle) ? "_" + text(angle) : "");
      direction.y = sense * direction.y;
    }
    const int turns = (sum.quarter_turns % 4 + 4) % 4;
    for (int turn = 0; turn < turns; ++turn) {
      direction = {-direction.y, direction.x};
    }
    return direction;
  }

  /// The direction of the sum of the terms times `sense`, which makes the first one positive.
  equations::Vector2 direction_of_terms(const AngleTerms& sum, int sense, std::string name) {
    equations::Vector2 direction{1, 0};
    std::string spelled;
    for (const auto& [text, term] : sum.terms) {
      const int factor = sense * term.factor;
      direction = turned_by_multiple(direction, direction_of_term(term.angle), factor);
      spelled += spelled.empty() ? "_" : factor < 0 ? "_minus_" : "_plus_";
      spelled += std::abs(factor) == 1 ? "" : std::to_string(std::abs(factor)) + "_";
      spelled += text;
    }
    const bool single = sum.terms.size() == 1 && std::abs(sum.terms.begin()->second.factor) == 1;
    if (single) {
      return direction;
    }
    const auto [known, is_new] = sums_.try_emplace(spelled);
    if (is_new) {
      name = text::c_identifier(name.empty() || sense < 0 ? spelled : name);
      known->second = {result_.vocabulary.name(fresh("cos" + name), direction.x, "cosine"),
                       result_.vocabulary.name(fresh("sin" + name), direction.y, "sine")};
    }
    return known->second;
  }

  equations::Vector2 direction_of_term(const GiNaC::ex& angle) {
    if (const auto variable = variables_.find(angle); variable != variables_.end()) {
      if (!variable->second->is_angle()) {
        throw NotAlgebraic("'" + text(angle) + "' is used as an angle and is not declared as one");
      }
      return variable->second->direction();
    }
    const auto known = inverses_.find(angle);
    if (known != inverses_.end()) {
      return known->second;
    }
    const GiNaC::ex* definition = system_.definition_of(angle);
    const GiNaC::ex function = definition == nullptr ? angle : *definition;
    if (!is_function(function)) {
      throw NotAlgebraic("'" + text(angle) + "' is used as an angle and is not declared as one");
    }
    const std::string name = definition == nullptr ? function_name(function) : text(angle);
    return inverses_[angle] = direction_of_inverse(function, text::c_identifier(name));
  }

  /// The direction of an angle that is an inverse function of numbers.
  equations::Vector2 direction_of_inverse(const GiNaC::ex& function, const std::string& name) {
    const std::string called = function_name(function);
    if (called != "acos" && called != "asin" && called != "atan" && called != "atan2") {
      throw NotAlgebraic("'" + text(function) + "' is used as an angle and is a number");
    }
    equations::Vocabulary& vocabulary = result_.vocabulary;
    const GiNaC::ex first = multiplied_out(scalar(function.op(0)));
    if (called == "acos" || called == "asin") {
      const bool is_cosine = called == "acos";
      const GiNaC::ex given =
          vocabulary.name(fresh((is_cosine ? "cos_" : "sin_") + name), first, text(function));
      const GiNaC::ex other =
          vocabulary.name_root(fresh((is_cosine ? "sin_" : "cos_") + name), 1 - given * given,
                               text(function) + no_derivatives);
      return is_cosine ? equations::Vector2{given, other} : equations::Vector2{other, given};
    }
    const GiNaC::ex second =
        called == "atan2" ? multiplied_out(scalar(function.op(1))) : GiNaC::ex(1);
    // One and a square never vanish together.
    const std::string degeneracy =
        called == "atan2" ? text(function) + " has no direction" : std::string();
    const GiNaC::ex size = vocabulary.name_root(
        fresh("size_" + name), multiplied_out(first * first + second * second), degeneracy);
    const GiNaC::ex inverse = reciprocal(size, degeneracy);
    return {vocabulary.name(fresh("cos_" + name), second * inverse, "cosine of " + name),
            vocabulary.name(fresh("sin_" + name), first * inverse, "sine of " + name)};
  }

  template <typename Value>
  using ByExpression = std::map<GiNaC::ex, Value, GiNaC::ex_is_less>;

  const ClosureSystem& system_;
  equations::ImplicitEquations result_;
  std::set<std::string> used_;
  ByExpression<const equations::Variable*> variables_;
  ByExpression<GiNaC::ex> numbers_;                 ///< of abbreviations
  ByExpression<equations::Vector2> inverses_;       ///< of angles that are not variables
  std::map<std::string, equations::Vector2> sums_;  ///< of sums of angles, by their names
};

}  // namespace

equations::ImplicitEquations implicit_form(const ClosureSystem& system,
                                           const std::vector<std::string>& types,
                                           const std::vector<std::string>& locals) {
  return Translation(system, types, locals).run();
}

}  // namespace assur::generator::closures
