#include "latex/rows.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace assur::generator::latex {

namespace {

constexpr std::array<std::string_view, 6> systems = {"aligned", "gathered",  "split",
                                                     "cases",   "alignedat", "array"};
constexpr std::array<std::string_view, 12> other_relations = {
    "<",     ">",        "\\le",    "\\leq", "\\ge", "\\geq",
    "\\neq", "\\approx", "\\equiv", "\\sim", "\\to", "\\propto"};

/// Tracks which tokens lie outside groups, brackets and environments.
class Depth {
 public:
  explicit Depth(bool brackets) : brackets_(brackets) {}

  /// Whether the token lies outside. Must be called for each token in turn.
  bool outside(const Token& token) {
    const bool opens = token.is("{") || token.is("\\begin") ||
                       (brackets_ && (token.is("(") || token.is("[") || token.is("\\{")));
    const bool closes = token.is("}") || token.is("\\end") ||
                        (brackets_ && (token.is(")") || token.is("]") || token.is("\\}")));
    depth_ -= closes ? 1 : 0;
    const bool result = depth_ <= 0 && !opens && !closes;
    depth_ += opens ? 1 : 0;
    return result;
  }

 private:
  bool brackets_;
  int depth_ = 0;
};

/// The parts between separators that lie outside.
template <typename Separates>
std::vector<Tokens> parts(const Tokens& tokens, bool brackets, const Separates& separates) {
  std::vector<Tokens> list(1);
  Depth depth(brackets);
  for (const Token& token : tokens) {
    if (depth.outside(token) && separates(token)) {
      list.emplace_back();
    } else {
      list.back().push_back(token);
    }
  }
  return list;
}

bool is_punctuation(const Token& token) {
  return token.is(",") || token.is(".") || token.is(";") || is_thin_space(token);
}

Tokens trimmed(Tokens tokens) {
  while (!tokens.empty() && is_punctuation(tokens.back())) {
    tokens.pop_back();
  }
  while (!tokens.empty() && (is_thin_space(tokens.front()) || tokens.front().is("&"))) {
    tokens.erase(tokens.begin());
  }
  return tokens;
}

bool has_relation(const Tokens& tokens) {
  Depth depth(true);
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const Token& token) { return depth.outside(token) && token.is("="); });
}

/// Equations side by side: an `&` ends an equation that has its `=` if another `=` follows.
std::vector<Tokens> side_by_side(const Tokens& row) {
  const std::vector<Tokens> cells = cells_of(row);
  std::vector<Tokens> list(1);
  for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
    if (has_relation(list.back()) && !continues(*cell) &&
        std::any_of(cell, cells.end(), has_relation)) {
      list.emplace_back();
    }
    list.back().insert(list.back().end(), cell->begin(), cell->end());
  }
  return list;
}

/// Returns the statements of the system of equations that begins at `at`, and moves `at` past it.
std::vector<Tokens> system_rows(const Tokens& tokens, std::size_t& at) {
  const Token& opened = tokens[at++];
  const std::string name = letters_of(take_argument(tokens, at));
  const Tokens inside = take_environment(tokens, at, name, opened);
  std::size_t first = 0;
  if (name == "array" || name == "alignedat") {
    static_cast<void>(take_argument(inside, first));  // the description of its columns
  }
  std::vector<Tokens> list;
  for (const Tokens& row : rows_of(slice(inside, first, inside.size()))) {
    if (!list.empty() && continues(row)) {
      list.back().insert(list.back().end(), row.begin(), row.end());
    } else if (!row.empty()) {
      list.push_back(row);
    }
  }
  return list;
}

/// The start of a system of equations, at 0 or after a brace; else the number of tokens.
std::size_t begin_of_system(const Tokens& tokens) {
  std::size_t at = 0;
  while (at < tokens.size() && (is_layout(tokens[at]) || tokens[at].is("\\{") ||
                                tokens[at].is("\\lbrace") || tokens[at].is("&"))) {
    ++at;
  }
  if (at >= tokens.size() || !tokens[at].is("\\begin")) {
    return tokens.size();
  }
  std::size_t behind = at + 1;
  const std::string name = letters_of(take_argument(tokens, behind));
  const bool braced = at > 0 && (tokens[at - 1].is("\\{") || tokens[at - 1].is("\\lbrace"));
  return contains(systems, name) && (name != "array" || braced) ? at : tokens.size();
}

}  // namespace

Tokens slice(const Tokens& tokens, std::size_t from, std::size_t to) {
  to = std::min(to, tokens.size());
  from = std::min(from, to);
  return {tokens.begin() + static_cast<std::ptrdiff_t>(from),
          tokens.begin() + static_cast<std::ptrdiff_t>(to)};
}

Tokens take_environment(const Tokens& tokens, std::size_t& at, const std::string& name,
                        const Token& opened) {
  const std::size_t from = at;
  int depth = 1;
  while (at < tokens.size()) {
    const std::size_t end = at;
    const Token& token = tokens[at++];
    if (!token.is("\\begin") && !token.is("\\end")) {
      continue;
    }
    if (letters_of(take_argument(tokens, at)) == name) {
      depth += token.is("\\begin") ? 1 : -1;
      if (depth == 0) {
        return slice(tokens, from, end);
      }
    }
  }
  throw FormulaError("\\begin{" + name + "} is not closed", opened.place);
}

std::vector<Tokens> rows_of(const Tokens& tokens) {
  std::vector<Tokens> rows = parts(tokens, false, [](const Token& token) {
    return token.is("\\\\") || token.is("\\cr") || token.is("\\tabularnewline");
  });
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Tokens& list = rows[row];
    if (row > 0 && !list.empty() && list[0].is("[") && !list[0].spaced) {  // \\[2mm]
      std::size_t close = 0;
      while (close < list.size() && !list[close].is("]")) {
        ++close;
      }
      list = slice(list, close + 1, list.size());
    }
    std::erase_if(list, [](const Token& token) { return token.is("\\hline"); });
  }
  if (rows.back().empty()) {
    rows.pop_back();
  }
  return rows;
}

std::vector<Tokens> cells_of(const Tokens& row) {
  return parts(row, false, [](const Token& token) { return token.is("&"); });
}

bool continues(const Tokens& row) {
  for (const Token& token : row) {
    if (token.is("&") || is_thin_space(token) || is_layout(token) || token.is("\\quad") ||
        token.is("\\qquad") || (token.is("{"))) {
      continue;
    }
    return token.is("=") || token.is("+") || token.is("-") || token.is("\\cdot") ||
           token.is("\\times");
  }
  return false;
}

std::vector<Tokens> statements_of(const Tokens& equation) {
  std::vector<Tokens> list;
  Tokens rest = equation;
  std::size_t at = begin_of_system(rest);
  if (at < rest.size()) {
    list = system_rows(rest, at);
    rest = slice(rest, at, rest.size());
    while (!rest.empty() && (is_layout(rest[0]) || is_punctuation(rest[0]))) {
      rest.erase(rest.begin());  // \right. and the following delimiter
    }
  }
  list.push_back(rest);
  std::vector<Tokens> equations;
  for (const Tokens& row : list) {
    const std::vector<Tokens> some = side_by_side(row);
    equations.insert(equations.end(), some.begin(), some.end());
  }
  std::vector<Tokens> statements;
  for (const Tokens& each : equations) {
    bool first = true;
    for (const Tokens& part : parts(each, true, [](const Token& token) {
           return token.is("\\quad") || token.is("\\qquad") || token.is("\\\\");
         })) {
      Tokens statement = trimmed(part);
      if (statement.empty()) {
        continue;
      }
      if (!first && continues(statement)) {  // the space indents a continued line
        statements.back().insert(statements.back().end(), statement.begin(), statement.end());
      } else {
        statements.push_back(std::move(statement));
      }
      first = false;
    }
  }
  return statements;
}

std::vector<Tokens> sides_of(const Tokens& statement) {
  Tokens open;
  Depth depth(true);
  for (const Token& token : statement) {
    if (token.is("(") || token.is("[") || token.is("\\{")) {
      open.push_back(token);
    } else if (!open.empty() && (token.is(")") || token.is("]") || token.is("\\}"))) {
      open.pop_back();
    }
    if (depth.outside(token) && contains(other_relations, token.text)) {
      throw FormulaError("only equations can be compared, and this is '" + token.text + "'",
                         token.place);
    }
  }
  if (!open.empty()) {
    throw FormulaError("'" + open.back().text + "' is not closed", open.back().place);
  }
  return parts(statement, true, [](const Token& token) { return token.is("="); });
}

}  // namespace assur::generator::latex
