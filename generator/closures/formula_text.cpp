#include "closures/formula_text.hpp"

#include <algorithm>
#include <utility>

#include "closures/canonical_sum.hpp"

namespace assur::generator::closures {

std::string formula_text(const GiNaC::ex& expression) { return CanonicalSum(expression).text(); }

std::vector<GiNaC::ex> ordered_operands(const GiNaC::ex& expression) {
  // GiNaC chooses the sign of a factor that is a sum, but not that of a term.
  const bool signs_count = !GiNaC::is_a<GiNaC::mul>(expression);
  std::vector<std::pair<std::string, GiNaC::ex>> texts;
  for (const GiNaC::ex& operand : expression) {
    const CanonicalSum sum(operand);
    texts.emplace_back((!signs_count && sum.is_reversed() ? sum.scaled(-1) : sum).text(), operand);
  }
  std::sort(texts.begin(), texts.end(),
            [](const auto& left, const auto& right) { return left.first < right.first; });
  std::vector<GiNaC::ex> operands;
  operands.reserve(texts.size());
  for (const auto& [text, operand] : texts) {
    operands.push_back(operand);
  }
  return operands;
}

}  // namespace assur::generator::closures
