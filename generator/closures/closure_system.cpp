#include "closures/closure_system.hpp"

#include <algorithm>
#include <iterator>

#include "equations/symbols.hpp"

namespace assur::generator::closures {

AuditSymbol& ClosureSystem::declare(const std::string& name, bool angle,
                                    const std::string& meaning) {
  ++revision_;
  return symbols_.emplace_back(name, angle, meaning);
}

void ClosureSystem::abbreviate(const std::string& name, const GiNaC::ex& definition) {
  const GiNaC::symbol symbol(name);
  abbreviations_.push_back(symbol);
  abbreviation_names_.emplace(name, symbol);
  definitions_[symbol] = definition;
  const GiNaC::ex whole = expanded(definition);
  whole_[symbol] = whole;
  parts_ += closures::part_count(whole);
  extents_[symbol] = ExtentMeter(&extents_).of(definition);
}

void ClosureSystem::close(const std::string& name, const GiNaC::ex& expression) {
  ++revision_;
  closures_.push_back({name, expression, false});
}

void ClosureSystem::negate_closure(const std::string& name) {
  for (Closure& closure : closures_) {
    if (closure.name == name) {
      closure.expression = -closure.expression;
      closure.turned = !closure.turned;
      ++revision_;
    }
  }
}

AuditSymbol* ClosureSystem::symbol_named(const std::string& name) {
  const auto found = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const AuditSymbol& symbol) { return symbol.name == name; });
  return found == symbols_.end() ? nullptr : &*found;
}

const AuditSymbol* ClosureSystem::symbol_named(const std::string& name) const {
  const auto found = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const AuditSymbol& symbol) { return symbol.name == name; });
  return found == symbols_.end() ? nullptr : &*found;
}

const GiNaC::ex* ClosureSystem::closure_named(const std::string& name) const {
  const auto found = std::find_if(closures_.begin(), closures_.end(),
                                  [&](const Closure& closure) { return closure.name == name; });
  return found == closures_.end() ? nullptr : &found->expression;
}

GiNaC::ex ClosureSystem::closure_as_typed(const std::string& name) const {
  const auto found = std::find_if(closures_.begin(), closures_.end(),
                                  [&](const Closure& closure) { return closure.name == name; });
  return found->turned ? -found->expression : found->expression;
}

std::optional<GiNaC::ex> ClosureSystem::meaning_of(const std::string& name) const {
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.name == name) {
      return symbol.symbol;
    }
  }
  if (const auto found = abbreviation_names_.find(name); found != abbreviation_names_.end()) {
    return found->second;
  }
  if (const GiNaC::ex* closure = closure_named(name)) {
    return *closure;
  }
  return std::nullopt;
}

const GiNaC::ex* ClosureSystem::definition_of(const GiNaC::ex& symbol) const {
  const auto found = definitions_.find(symbol);
  return found == definitions_.end() ? nullptr : &found->second;
}

bool ClosureSystem::is_known(const std::string& name) const { return meaning_of(name).has_value(); }

std::vector<std::string> ClosureSystem::names() const {
  std::vector<std::string> all;
  for (const AuditSymbol& symbol : symbols_) {
    all.push_back(symbol.name);
  }
  for (const GiNaC::symbol& symbol : abbreviations_) {
    all.push_back(symbol.get_name());
  }
  for (const Closure& closure : closures_) {
    all.push_back(closure.name);
  }
  return all;
}

GiNaC::ex ClosureSystem::slope(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const {
  GiNaC::ex sum = expression.diff(symbol);
  for (const GiNaC::ex& name : equations::symbols_of(expression)) {
    if (const GiNaC::ex* const definition = definition_of(name)) {
      sum += expression.diff(GiNaC::ex_to<GiNaC::symbol>(name)) * slope(*definition, symbol);
    }
  }
  return sum;
}

const ClosureDerivative& ClosureSystem::derivative(const ClosureDerivative& wanted) {
  const auto is_it = [&](const ClosureDerivative& one) {
    return one.of == wanted.of && one.partly_by == wanted.partly_by && one.by == wanted.by &&
           one.times == wanted.times;
  };
  const auto known = std::ranges::find_if(derivatives_, is_it);
  return known == derivatives_.end() ? derivatives_.emplace_back(wanted) : *known;
}

const GiNaC::symbol& ClosureSystem::component(const ClosureDerivative& derivative,
                                              const AuditSymbol& unknown) {
  const auto key = std::make_pair(&derivative, &unknown);
  if (const auto known = component_symbols_.find(key); known != component_symbols_.end()) {
    return known->second;
  }
  const bool is_rate = derivative.of == nullptr && derivative.by.empty();
  GiNaC::symbol symbol = is_rate && derivative.times == 1   ? unknown.rate
                         : is_rate && derivative.times == 2 ? unknown.second_rate
                                                            : GiNaC::symbol();
  if (!is_rate || derivative.times > 2) {
    std::string name = derivative.of == nullptr
                           ? unknown.name
                           : "d(" + component(*derivative.of, unknown).get_name() + ", " +
                                 derivative.partly_by->name + ")";
    for (const AuditSymbol* parameter : derivative.by) {
      name = "D(" + name + ", " + parameter->name + ")";
    }
    for (int left = derivative.times; left > 0; left -= 2) {
      name = (left == 1 ? "rate(" : "rate2(") + name + ")";
    }
    symbol = GiNaC::symbol(name);
  }
  components_.emplace(symbol, Component{&derivative, &unknown, symbol});
  return component_symbols_.emplace(key, symbol).first->second;
}

const ClosureSystem::Component* ClosureSystem::component_of(const GiNaC::ex& symbol) const {
  const auto found = components_.find(symbol);
  return found == components_.end() ? nullptr : &found->second;
}

const ClosureDerivative* ClosureSystem::derivative_of(const GiNaC::ex& symbol) const {
  const Component* const found = component_of(symbol);
  return found == nullptr ? nullptr : found->derivative;
}

std::vector<GiNaC::symbol> ClosureSystem::symbols_of(const ClosureDerivative& derivative) {
  std::vector<GiNaC::symbol> symbols;
  for (const AuditSymbol* unknown : unknowns()) {
    symbols.push_back(component(derivative, *unknown));
  }
  return symbols;
}

std::vector<GiNaC::ex> ClosureSystem::equations_of(const ClosureDerivative& derivative) {
  std::vector<GiNaC::ex> equations;
  const auto each = [&](const std::vector<GiNaC::ex>& before, const auto& further) {
    std::ranges::transform(before, std::back_inserter(equations), further);
  };
  ClosureDerivative before = derivative;
  if (derivative.times > 0) {
    --before.times;
    each(equations_of(before), [&](const GiNaC::ex& equation) { return rate(equation); });
  } else if (!derivative.by.empty()) {
    before.by.pop_back();
    each(equations_of(before),
         [&](const GiNaC::ex& equation) { return total(equation, *derivative.by.back()); });
  } else if (derivative.of != nullptr) {
    each(equations_of(*derivative.of),
         [&](const GiNaC::ex& equation) { return partial(equation, *derivative.partly_by); });
  } else {
    for (const Closure& closure : closures_) {
      equations.push_back(closure.expression);
    }
  }
  return equations;
}

template <typename Further>
GiNaC::ex ClosureSystem::through_derivatives(const GiNaC::ex& expression, const Further& further) {
  GiNaC::ex sum;
  for (const GiNaC::ex& name : equations::symbols_of(expanded(expression))) {
    if (const Component* const found = component_of(name)) {
      const GiNaC::ex part = slope(expression, found->symbol);
      if (!part.is_zero()) {
        const AuditSymbol& unknown = *found->unknown;
        ClosureDerivative wanted = *found->derivative;
        wanted = further(*found->derivative, wanted);
        sum += part * component(derivative(wanted), unknown);
      }
    }
  }
  return sum;
}

GiNaC::ex ClosureSystem::partial(const GiNaC::ex& expression, const AuditSymbol& by) {
  return slope(expression, by.symbol) +
         through_derivatives(expression, [&](const ClosureDerivative& of, const auto&) {
           return ClosureDerivative{&of, &by, {}, 0};
         });
}

GiNaC::ex ClosureSystem::total(const GiNaC::ex& expression, const AuditSymbol& parameter) {
  const auto further = [&](ClosureDerivative wanted) {
    const auto place = [this](const AuditSymbol* symbol) {
      return std::ranges::find_if(symbols_,
                                  [&](const AuditSymbol& one) { return &one == symbol; }) -
             symbols_.begin();
    };
    wanted.by.insert(std::ranges::upper_bound(wanted.by, place(&parameter), {}, place), &parameter);
    return wanted;
  };
  GiNaC::ex sum = slope(expression, parameter.symbol);
  for (const AuditSymbol* unknown : unknowns()) {
    if (const GiNaC::ex part = slope(expression, unknown->symbol); !part.is_zero()) {
      sum += part * component(derivative(further({})), *unknown);
    }
  }
  return sum + through_derivatives(
                   expression, [&](const auto&, const auto& wanted) { return further(wanted); });
}

std::optional<GiNaC::ex> ClosureSystem::by_rate(const GiNaC::ex& expression,
                                                const AuditSymbol& parameter, int order) {
  GiNaC::ex sum = slope(expression, rate_symbol(parameter, order));
  for (const GiNaC::ex& name : equations::symbols_of(expanded(expression))) {
    const Component* const found = component_of(name);
    if (found == nullptr || slope(expression, found->symbol).is_zero()) {
      continue;
    }
    const ClosureDerivative of = *found->derivative;
    if (of.of != nullptr) {
      return std::nullopt;
    }
    if (of.times < order) {
      continue;  // it has no rates of that order
    }
    // The k-th derivative by t has n of k dots removed: C(k, n) d^(k-n)/dt^(k-n) of dq/da.
    const AuditSymbol& unknown = *found->unknown;
    const GiNaC::ex part = slope(expression, found->symbol);
    GiNaC::ex followed = unknown.symbol;
    for (const AuditSymbol* by : of.by) {
      followed = total(followed, *by);
    }
    followed = total(followed, parameter);
    for (int time = order; time < of.times; ++time) {
      followed = rate(followed);
    }
    sum += part * GiNaC::binomial(GiNaC::numeric(of.times), GiNaC::numeric(order)) * followed;
  }
  return sum;
}

GiNaC::symbol ClosureSystem::rate_symbol(const AuditSymbol& symbol, int order) {
  if (order <= 2) {
    return order == 1 ? symbol.rate : symbol.second_rate;
  }
  const auto key = std::make_pair(&symbol, order);
  const auto known = higher_rates_.find(key);
  if (known != higher_rates_.end()) {
    return known->second;
  }
  std::string name = symbol.name;
  for (int left = order; left > 0; left -= 2) {
    name = (left == 1 ? "rate(" : "rate2(") + name + ")";
  }
  return higher_rates_.emplace(key, GiNaC::symbol(name)).first->second;
}

const AuditSymbol* ClosureSystem::moved_by(const GiNaC::ex& symbol) const {
  for (const AuditSymbol& one : symbols_) {
    if (one.moving && (symbol.is_equal(one.rate) || symbol.is_equal(one.second_rate))) {
      return &one;
    }
  }
  for (const auto& [key, rate] : higher_rates_) {
    if (symbol.is_equal(rate)) {
      return key.first;
    }
  }
  return nullptr;
}

GiNaC::ex ClosureSystem::rate(const GiNaC::ex& expression) {
  GiNaC::ex sum;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.unknown) {
      if (const GiNaC::ex part = slope(expression, symbol.symbol); !part.is_zero()) {
        sum += part * component(derivative({nullptr, nullptr, {}, 1}), symbol);
      }
    } else if (symbol.moving) {
      sum += slope(expression, symbol.symbol) * symbol.rate;
      for (int order = 1;
           !symbol.steady && (order <= 2 || higher_rates_.contains({&symbol, order})); ++order) {
        if (const GiNaC::ex part = slope(expression, rate_symbol(symbol, order)); !part.is_zero()) {
          sum += part * rate_symbol(symbol, order + 1);
        }
      }
    }
  }
  return sum + through_derivatives(expression, [](const auto&, ClosureDerivative wanted) {
           ++wanted.times;
           return wanted;
         });
}

GiNaC::ex ClosureSystem::expanded(const GiNaC::ex& expression) const {
  // GiNaC checks every entry of the map at each sum and product, so only those needed are passed.
  GiNaC::exmap occurring;
  for (const GiNaC::ex& symbol : equations::symbols_of(expression)) {
    if (const auto found = whole_.find(symbol); found != whole_.end()) {
      occurring.insert(*found);
    }
  }
  return occurring.empty() ? expression
                           : expression.subs(occurring, GiNaC::subs_options::no_pattern);
}

bool ClosureSystem::follows_closures(const GiNaC::ex& expression) const {
  return std::ranges::any_of(
      equations::symbols_of(expanded(expression)), [&](const GiNaC::ex& symbol) {
        return derivative_of(symbol) != nullptr || moved_by(symbol) != nullptr;
      });
}

std::vector<const AuditSymbol*> ClosureSystem::unknowns() const {
  std::vector<const AuditSymbol*> list;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.unknown) {
      list.push_back(&symbol);
    }
  }
  return list;
}

}  // namespace assur::generator::closures
