#include "emission/scene/specialise.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

namespace {

using Form = equations::NamedQuantity::Form;

bool is_symbol(const GiNaC::ex& expression) {
  return GiNaC::is_a<GiNaC::symbol>(expression) || GiNaC::is_a<GiNaC::symbol>(-expression);
}

/// Whether a number is a quotient by named constants that no double equals; it keeps its name.
bool is_quotient(const GiNaC::ex& definition, const GiNaC::numeric& number) {
  return !GiNaC::is_a<GiNaC::numeric>(definition.denom()) && !cpp::is_double(number);
}

class Specialiser {
 public:
  Specialiser(program::SymbolOrder& order, GiNaC::exmap values)
      : order_(order), values_(std::move(values)) {}

  NamedResults run(const std::vector<equations::NamedQuantity>& quantities,
                   const std::vector<program::Result>& results) {
    special_ = {quantities, results};
    for (equations::NamedQuantity& quantity : special_.quantities) {
      quantity.definition = folded(quantity.definition);
      if (quantity.form == Form::reciprocal) {
        invert(quantity);
      }
      const std::optional<GiNaC::numeric> number = order_.number(quantity.definition);
      if (number && quantity.form == Form::reciprocal) {
        // A quotient by zero is undetermined. Any number will do, as configurations computed from
        // it are checked for closure.
        values_[quantity.symbol] =
            quantity.definition.is_zero() ? GiNaC::ex(0) : 1 / quantity.definition;
      } else if (number && quantity.form == Form::itself &&
                 is_quotient(quantity.definition, *number)) {
        order_.set_constant(quantity.symbol, *number);
      } else if (quantity.form == Form::itself && (number || is_symbol(quantity.definition))) {
        values_[quantity.symbol] = quantity.definition;
      }
    }
    std::erase_if(special_.quantities, [&](const equations::NamedQuantity& quantity) {
      const auto value = values_.find(quantity.symbol);
      return (value != values_.end() && !value->second.has(quantity.symbol)) ||
             order_.constant(quantity.symbol.get_name());
    });
    for (program::Result& result : special_.results) {
      result.value = folded(result.value);
    }
    merge_multiples();
    return std::move(special_);
  }

 private:
  /// The expression with `values_` substituted, without factors of a term that cancel.
  [[nodiscard]] GiNaC::ex folded(const GiNaC::ex& expression) const {
    const GiNaC::ex numbers = expression.subs(values_, GiNaC::subs_options::no_pattern);
    program::Polynomial sum;
    for (const auto& [monomial, coefficient] : program::polynomial(numbers, order_)) {
      program::Monomial rest = monomial;
      for (const program::Monomial& one : ones_) {
        if (std::includes(rest.begin(), rest.end(), one.begin(), one.end())) {
          program::Monomial left;
          std::set_difference(rest.begin(), rest.end(), one.begin(), one.end(),
                              std::back_inserter(left));
          rest = std::move(left);
        }
      }
      sum[rest] += coefficient;
    }
    std::erase_if(sum, [](const auto& term) { return term.second.is_zero(); });
    return program::expression(sum, order_);
  }

  /// The definitions and values that contain a symbol.
  [[nodiscard]] std::vector<GiNaC::ex*> users_of(const GiNaC::symbol& symbol) {
    std::vector<GiNaC::ex*> users;
    for (equations::NamedQuantity& quantity : special_.quantities) {
      if (quantity.definition.has(symbol)) {
        users.push_back(&quantity.definition);
      }
    }
    for (program::Result& result : special_.results) {
      if (result.value.has(symbol)) {
        users.push_back(&result.value);
      }
    }
    return users;
  }

  /// The reciprocal of a number times symbols becomes that of the symbols, divided by the number,
  /// which often cancels.
  void invert(equations::NamedQuantity& reciprocal) {
    if (reciprocal.definition.is_zero()) {
      return;
    }
    for (const equations::NamedQuantity& quantity : special_.quantities) {
      if (quantity.form == Form::itself && reciprocal.definition.is_equal(quantity.symbol) &&
          users_of(quantity.symbol).size() == 1) {
        reciprocal.definition = quantity.definition;
      }
    }
    const program::Polynomial divisor = program::polynomial(reciprocal.definition, order_);
    const auto& [monomial, coefficient] = *divisor.begin();
    if (divisor.size() > 1 || monomial.empty()) {
      return;
    }
    program::Monomial one = monomial;
    one.push_back(order_.rank(reciprocal.symbol));
    std::sort(one.begin(), one.end());
    ones_.push_back(std::move(one));
    reciprocal.definition = program::expression({{monomial, 1}}, order_);
    values_[reciprocal.symbol] = reciprocal.symbol / coefficient.origin();
  }

  /// A number times symbols needs no name if it is used once, multiplied by a number.
  void merge_multiples() {
    for (const equations::NamedQuantity& quantity : special_.quantities) {
      const program::Polynomial definition = program::polynomial(quantity.definition, order_);
      const std::vector<GiNaC::ex*> users = users_of(quantity.symbol);
      if (quantity.form != Form::itself || definition.size() != 1 ||
          !definition.begin()->second.scales() || users.size() != 1) {
        continue;
      }
      const program::SymbolRank symbol = order_.rank(quantity.symbol);
      std::ptrdiff_t uses = 0;
      bool scaled = false;
      for (const auto& [monomial, coefficient] : program::polynomial(*users.front(), order_)) {
        const std::ptrdiff_t here = std::count(monomial.begin(), monomial.end(), symbol);
        uses += here;
        scaled = scaled || (here > 0 && coefficient.scales());
      }
      if (uses == 1 && scaled) {
        *users.front() = users.front()->subs(quantity.symbol == quantity.definition).expand();
      }
    }
  }

  program::SymbolOrder& order_;
  GiNaC::exmap values_;
  std::vector<program::Monomial> ones_;  ///< products of symbols and their reciprocals
  NamedResults special_;
};

}  // namespace

NamedResults specialised(const std::vector<equations::NamedQuantity>& quantities,
                         const std::vector<program::Result>& results, program::SymbolOrder& order,
                         GiNaC::exmap values) {
  return Specialiser(order, std::move(values)).run(quantities, results);
}

}  // namespace assur::generator::emission::scene
