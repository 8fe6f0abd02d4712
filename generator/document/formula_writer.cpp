#include "document/formula_writer.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace assur::generator::document {

FormulaWriter::FormulaWriter(const equations::ClosureEquations& equations)
    : order_(program::symbol_order(equations, equations.vocabulary)) {
  for (const auto* variables : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *variables) {
      spellings_[variable.cosine.get_name()] = {"cos(" + variable.name + ")", 1};
      spellings_[variable.sine.get_name()] = {"sin(" + variable.name + ")", 1};
      for (const GiNaC::symbol& rate : {variable.rate, variable.second_rate}) {
        spellings_[rate.get_name()] = {rate.get_name(), 2};
      }
    }
  }
}

FormulaWriter::Spelled FormulaWriter::spelled(program::SymbolRank rank) const {
  const std::string& name = order_.name(rank);
  const auto found = spellings_.find(name);
  return found == spellings_.end() ? Spelled{name, 0} : found->second;
}

std::string FormulaWriter::term(const program::Monomial& monomial,
                                const GiNaC::numeric& size) const {
  std::vector<std::pair<Spelled, std::ptrdiff_t>> powers;
  for (auto at = monomial.begin(); at != monomial.end();) {
    const auto next =
        std::find_if(at, monomial.end(), [&](program::SymbolRank rank) { return rank != *at; });
    powers.emplace_back(spelled(*at), next - at);
    at = next;
  }
  std::stable_sort(powers.begin(), powers.end(), [](const auto& left, const auto& right) {
    return left.first.place < right.first.place;
  });
  std::string text;
  if (size != 1 || powers.empty()) {
    std::ostringstream number;
    number << size;
    text = number.str();
  }
  for (const auto& [factor, power] : powers) {
    text += (text.empty() ? "" : "*") + factor.text;
    text += power == 1 ? "" : "^" + std::to_string(power);
  }
  return text;
}

std::string FormulaWriter::operator()(const GiNaC::ex& expression) const {
  struct Term {
    bool negative;
    std::string text;
  };
  std::vector<Term> terms;
  for (const auto& [monomial, coefficient] : program::polynomial(expression, order_)) {
    if (!coefficient.is_zero()) {
      terms.push_back({coefficient.is_negative(), term(monomial, coefficient.size().value())});
    }
  }
  if (terms.empty()) {
    return "0";
  }
  // A positive term comes first, so that no sign is in front.
  const auto positive =
      std::find_if(terms.begin(), terms.end(), [](const Term& each) { return !each.negative; });
  if (positive != terms.end()) {
    std::rotate(terms.begin(), positive, std::next(positive));
  }
  std::string text;
  for (const Term& each : terms) {
    text += text.empty() ? (each.negative ? "-" : "") : (each.negative ? " - " : " + ");
    text += each.text;
  }
  return text;
}

}  // namespace assur::generator::document
