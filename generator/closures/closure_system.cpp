#include "closures/closure_system.hpp"

#include <algorithm>

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

GiNaC::ex ClosureSystem::partial(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const {
  GiNaC::ex sum = expression.diff(symbol);
  for (const GiNaC::ex& name : equations::symbols_of(expression)) {
    if (const GiNaC::ex* const definition = definition_of(name)) {
      sum += expression.diff(GiNaC::ex_to<GiNaC::symbol>(name)) * partial(*definition, symbol);
    }
  }
  return sum;
}

GiNaC::ex ClosureSystem::total(const GiNaC::ex& expression, const AuditSymbol& parameter) {
  GiNaC::ex sum = partial(expression, parameter.symbol);
  for (const AuditSymbol* unknown : unknowns()) {
    const GiNaC::ex slope = partial(expression, unknown->symbol);
    if (slope.is_zero()) {
      continue;
    }
    auto known = std::find_if(
        sensitivities_.begin(), sensitivities_.end(), [&](const Sensitivity& sensitivity) {
          return sensitivity.unknown == unknown && sensitivity.parameter == &parameter;
        });
    if (known == sensitivities_.end()) {
      const std::string name = "D(" + unknown->name + ", " + parameter.name + ")";
      sensitivities_.push_back({unknown, &parameter, GiNaC::symbol(name)});
      known = std::prev(sensitivities_.end());
    }
    sum += slope * known->symbol;
  }
  return sum;
}

GiNaC::ex ClosureSystem::rate(const GiNaC::ex& expression) const {
  GiNaC::ex sum;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.unknown || symbol.moving) {
      sum += partial(expression, symbol.symbol) * symbol.rate;
      sum += partial(expression, symbol.rate) * symbol.second_rate;
    }
  }
  return sum;
}

GiNaC::ex ClosureSystem::expanded(const GiNaC::ex& expression) const {
  // GiNaC looks at every entry of the map for each sum and product, so it gets those that occur.
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
  const GiNaC::exset occurring = equations::symbols_of(expanded(expression));
  return std::any_of(sensitivities_.begin(), sensitivities_.end(),
                     [&](const Sensitivity& entry) { return occurring.contains(entry.symbol); }) ||
         std::any_of(symbols_.begin(), symbols_.end(), [&](const AuditSymbol& symbol) {
           return occurring.contains(symbol.rate) || occurring.contains(symbol.second_rate);
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
