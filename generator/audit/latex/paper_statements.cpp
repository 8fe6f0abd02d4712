#include "audit/latex/paper_statements.hpp"

#include "latex/rows.hpp"

namespace assur::generator::audit::latex {

namespace {

using closures::FormulaError;
using generator::latex::Displayed;
using generator::latex::Meaning;
using generator::latex::Token;

bool is_zero(const Tokens& side) { return side.size() == 1 && side[0].is("0"); }

void expect_sides(const Stated& stated) {
  if (stated.sides.size() < 2) {
    throw FormulaError("an equation with two sides is expected", stated.place);
  }
  for (const Tokens& side : stated.sides) {
    if (side.empty()) {
      throw FormulaError("a side of this equation is missing", stated.place);
    }
  }
}

/// `(k = 1, \dots, 4)`, which only repeats the map, and `\text{and}`.
bool is_remark(const Tokens& tokens, const PaperMap& map) {
  if (tokens[0].is("\\text") || tokens[0].is("\\mbox")) {
    std::size_t at = 1;
    const std::string words =
        generator::latex::letters_of(generator::latex::take_argument(tokens, at));
    return at == tokens.size() && (words == "and" || words == "with" || words == "where");
  }
  if (tokens.size() < 3 || !tokens.front().is("(") || !tokens.back().is(")")) {
    return false;
  }
  for (std::size_t at = 1; at + 1 < tokens.size(); ++at) {
    const Token& token = tokens[at];
    const bool index = token.is_letter() &&
                       (map.indices().contains(token.text) || map.summed().contains(token.text));
    if (!index && !token.is_digit() && !token.is("=") && !token.is(",") && !token.is("\\dots") &&
        !token.is("\\ldots") && !token.is("\\quad")) {
      return false;
    }
  }
  return true;
}

std::string definition_of(const Tokens& side, const PaperMap& map) {
  const std::optional<Meaning> meaning = map.quantity(side);
  return meaning && meaning->formula.empty() ? meaning->name : "";
}

/// `f_1 = ...`, `f_1 = ... = 0`
std::string closure_of(const Stated& stated, const PaperMap& map) {
  const std::optional<Meaning> meaning = map.quantity(stated.sides[0]);
  const bool closure = meaning && !meaning->formula.empty() &&
                       map.system().closure_named(meaning->formula) != nullptr;
  const bool form =
      stated.sides.size() == 2 || (stated.sides.size() == 3 && is_zero(stated.sides[2]));
  return closure && form && !is_zero(stated.sides[1]) ? meaning->formula : "";
}

void separate(const Displayed& displayed, const PaperMap& map, std::vector<Stated>& list) {
  std::vector<Tokens> statements;
  try {
    statements = generator::latex::statements_of(displayed.tokens);
  } catch (const FormulaError& error) {
    list.push_back({displayed.label, displayed.place, displayed.tokens});
    list.back().error = error;
    return;
  }
  for (const Tokens& tokens : statements) {
    if (is_remark(tokens, map)) {
      continue;
    }
    Stated stated{displayed.label, tokens[0].place, tokens};
    try {
      stated.sides = generator::latex::sides_of(tokens);
      expect_sides(stated);
      stated.closure = closure_of(stated, map);
      stated.defines = stated.closure.empty() ? definition_of(stated.sides[0], map) : "";
    } catch (const FormulaError& error) {
      stated.error = error;
    }
    list.push_back(std::move(stated));
  }
}

}  // namespace

std::vector<Stated> paper_statements(const Tokens& tokens, PaperMap& map) {
  const std::vector<Displayed> equations = generator::latex::displayed(tokens, map.commands());
  std::set<std::string> labels;
  for (const Displayed& each : equations) {
    labels.insert(each.label);
  }
  map.find_skipped(labels, generator::latex::section_titles(tokens));
  std::vector<Stated> list;
  for (const Displayed& each : equations) {
    if (!map.skips(each.label, each.section)) {
      separate(each, map, list);
    }
  }
  return list;
}

}  // namespace assur::generator::audit::latex
