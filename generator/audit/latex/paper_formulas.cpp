#include "audit/latex/paper_formulas.hpp"

#include <algorithm>

namespace assur::generator::audit::latex {

using generator::latex::LatexFormula;
using generator::latex::printed_name;
using generator::latex::Token;

namespace {

/// Collects the names in a tree that the paper has to define.
void collect_printed(const text::Expression& tree, std::vector<const text::Expression*>& list) {
  if (tree.kind == text::Expression::Kind::name && tree.name.starts_with(printed_name(""))) {
    list.push_back(&tree);
  }
  for (const text::Expression& argument : tree.arguments) {
    collect_printed(argument, list);
  }
}

}  // namespace

GiNaC::ex PaperFormulas::expression(const Tokens& tokens, Place place) {
  const LatexFormula formula = generator::latex::read_latex(tokens, reading_, place);
  const auto place_of = [&](std::size_t column) { return formula.places[column - 1]; };
  std::vector<const text::Expression*> printed;
  collect_printed(formula.tree, printed);
  for (const text::Expression* each : printed) {
    if (!system().is_known(each->name)) {
      throw NotDefined("the paper does not define '" + each->name.substr(printed_name("").size()) +
                           "' in a way that can be read",
                       place_of(each->column), each->name);
    }
  }
  return closures::expression_of(formula.tree, place_of, system());
}

std::string PaperFormulas::source(const Tokens& tokens) const {
  if (tokens.empty()) {
    return "";
  }
  std::size_t from = tokens[0].from;
  std::size_t to = tokens[0].to;
  for (const Token& token : tokens) {
    from = std::min(from, token.from);
    to = std::max(to, token.to);
  }
  std::string text;
  for (const char letter : paper_.substr(from, to - from)) {
    const bool space = letter == '\n' || letter == '\r' || letter == '\t' || letter == ' ';
    if (!space || (!text.empty() && text.back() != ' ')) {
      text += space ? ' ' : letter;
    }
  }
  return text;
}

}  // namespace assur::generator::audit::latex
