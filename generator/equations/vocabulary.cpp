#include "equations/vocabulary.hpp"

#include <algorithm>

#include "equations/symbols.hpp"

namespace assur::generator::equations {

namespace {

using Form = NamedQuantity::Form;

}  // namespace

bool is_plain(const GiNaC::ex& expression) {
  const auto is_atom = [](const GiNaC::ex& part) {
    return GiNaC::is_a<GiNaC::numeric>(part) || GiNaC::is_a<GiNaC::symbol>(part);
  };
  return is_atom(expression) || is_atom(-expression);
}

GiNaC::ex Vocabulary::name(const std::string& name, const GiNaC::ex& definition,
                           const std::string& meaning) {
  GiNaC::ex recognised = recognise(definition);
  if (is_plain(recognised)) {
    return recognised;
  }
  const GiNaC::symbol symbol(name);
  quantities_.push_back({symbol, recognised, expand(recognised), meaning});
  expansions_[symbol] = quantities_.back().expanded;
  return symbol;
}

Vector2 Vocabulary::name(const std::string& name, const Vector2& definition,
                         const std::string& meaning) {
  return {this->name(name + "_x", definition.x, meaning + ", x"),
          this->name(name + "_y", definition.y, meaning + ", y")};
}

void Vocabulary::define(const GiNaC::symbol& symbol, const GiNaC::ex& definition,
                        const std::string& meaning) {
  quantities_.push_back({symbol, definition, symbol, meaning});
}

void Vocabulary::rewrite(const GiNaC::symbol& symbol, const GiNaC::ex& definition) {
  const auto found = std::ranges::find_if(
      quantities_, [&](const NamedQuantity& quantity) { return quantity.symbol.is_equal(symbol); });
  const GiNaC::exset used = symbols_of(definition);
  const bool comes_later =
      std::any_of(found, quantities_.end(),
                  [&](const NamedQuantity& quantity) { return used.contains(quantity.symbol); });
  if (found != quantities_.end() && found->form == Form::itself && !comes_later) {
    found->definition = definition;
  }
}

void Vocabulary::leave_out(const GiNaC::symbol& symbol) {
  std::erase_if(quantities_,
                [&](const NamedQuantity& quantity) { return quantity.symbol.is_equal(symbol); });
}

GiNaC::ex Vocabulary::name_reciprocal(const std::string& name, const GiNaC::ex& denominator,
                                      const std::string& degeneracy) {
  if (GiNaC::is_a<GiNaC::numeric>(denominator)) {
    return 1 / denominator;
  }
  const GiNaC::ex expanded = expand(denominator);
  if (const NamedQuantity* known = find(Form::reciprocal, expanded)) {
    return known->symbol;
  }
  const GiNaC::symbol symbol(name);
  quantities_.push_back({symbol, denominator, expanded, degeneracy, Form::reciprocal});
  return symbol;
}

GiNaC::ex Vocabulary::name_root(const std::string& name, const GiNaC::ex& radicand,
                                const std::string& degeneracy) {
  const GiNaC::ex expanded = expand(radicand);
  if (GiNaC::ex number = GiNaC::sqrt(expanded);
      number.info(GiNaC::info_flags::nonnegative) && number.info(GiNaC::info_flags::rational)) {
    return number;
  }
  if (const NamedQuantity* known = find(Form::square_root, expanded)) {
    NamedQuantity& root = quantities_[static_cast<std::size_t>(known - quantities_.data())];
    if (root.meaning.find(degeneracy) == std::string::npos) {
      root.meaning += (root.meaning.empty() ? "" : ", and ") + degeneracy;
    }
    return known->symbol;
  }
  const GiNaC::symbol symbol(name);
  quantities_.push_back({symbol, radicand, expanded, degeneracy, Form::square_root});
  name_reciprocal("inverse_" + name, symbol, "");
  return symbol;
}

const NamedQuantity* Vocabulary::find(Form form, const GiNaC::ex& expanded) const {
  const auto found =
      std::find_if(quantities_.begin(), quantities_.end(), [&](const NamedQuantity& quantity) {
        return quantity.form == form && (expanded - quantity.expanded).expand().is_zero();
      });
  return found == quantities_.end() ? nullptr : &*found;
}

GiNaC::ex Vocabulary::expand(const GiNaC::ex& expression) const {
  return expression.subs(expansions_, GiNaC::subs_options::no_pattern).expand();
}

GiNaC::ex Vocabulary::derivative(const GiNaC::ex& expression, const Variable& variable) const {
  return gradient(expression, {&variable}).front();
}

std::vector<GiNaC::ex> Vocabulary::gradient(const GiNaC::ex& expression,
                                            const VariableList& variables) const {
  const GiNaC::exset symbols = symbols_of(expression);
  std::vector<std::pair<const NamedQuantity*, GiNaC::ex>> to_names;
  for (const NamedQuantity& quantity : quantities_) {
    if (symbols.contains(quantity.symbol)) {
      to_names.emplace_back(&quantity, expression.diff(quantity.symbol));
    }
  }
  std::vector<GiNaC::ex> result;
  for (const Variable* variable : variables) {
    GiNaC::ex total = partial(expression, *variable);
    for (const auto& [quantity, to_name] : to_names) {
      total += to_name * slope(*quantity, *variable);
    }
    result.push_back(recognise(total.expand()));
  }
  return result;
}

const GiNaC::ex& Vocabulary::slope(const NamedQuantity& quantity, const Variable& variable) const {
  const auto [known, fresh] = slopes_.try_emplace({quantity.symbol.get_name(), variable.name});
  if (fresh) {
    const GiNaC::ex inner = derivative(quantity.definition, variable);
    switch (quantity.form) {
      case Form::reciprocal:
        known->second = -inner * quantity.symbol * quantity.symbol;
        break;
      case Form::square_root:
        known->second = inner * find(Form::reciprocal, quantity.symbol)->symbol / 2;
        break;
      case Form::itself:
        known->second = inner;
        break;
    }
  }
  return known->second;
}

GiNaC::ex Vocabulary::recognise(const GiNaC::ex& expression) const {
  GiNaC::ex expanded = expand(expression);
  if (is_plain(expanded)) {
    return expanded;
  }
  const GiNaC::ex negated = (-expanded).expand();
  for (const NamedQuantity& quantity : quantities_) {
    // Expanded polynomials are in normal form, so that equal ones are identical.
    if (quantity.form == Form::itself && quantity.expanded.is_equal(expanded)) {
      return quantity.symbol;
    }
    if (quantity.form == Form::itself && quantity.expanded.is_equal(negated)) {
      return -quantity.symbol;
    }
  }
  return expression;
}

}  // namespace assur::generator::equations
