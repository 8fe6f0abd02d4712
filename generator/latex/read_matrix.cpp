#include "latex/read_matrix.hpp"

#include <algorithm>

#include "latex/rows.hpp"

namespace assur::generator::latex {

namespace {

bool is_matrix_name(const std::string& name) {
  return name == "pmatrix" || name == "bmatrix" || name == "matrix" || name == "Bmatrix" ||
         name == "smallmatrix" || name == "array";
}

/// (a, b, c)^T
std::optional<LatexMatrix> read_column(const Tokens& tokens) {
  const auto is_transposed = [](const std::string& text) {
    return text == "T" || text == "\\top" || text == "\\mathrm{T}" || text == "\\mathsf{T}" ||
           text == "\\intercal" || text == "\\mathrm T";
  };
  std::size_t close = tokens.size();
  while (close > 0 && !closes(tokens[close - 1])) {
    --close;
  }
  if (close == 0 || close + 1 >= tokens.size() || !tokens[close].is("^") || !opens(tokens[0])) {
    return std::nullopt;
  }
  std::size_t behind = close + 1;
  if (!is_transposed(letters_of(take_argument(tokens, behind))) || behind != tokens.size()) {
    return std::nullopt;
  }
  LatexMatrix matrix;
  matrix.place = tokens[0].place;
  matrix.cells.emplace_back(1);
  int depth = 0;
  for (std::size_t at = 1; at + 1 < close; ++at) {
    depth += tokens[at].is("{") || opens(tokens[at]) ? 1 : 0;
    depth -= tokens[at].is("}") || closes(tokens[at]) ? 1 : 0;
    if (depth == 0 && tokens[at].is(",")) {
      matrix.cells.emplace_back(1);
    } else {
      matrix.cells.back()[0].push_back(tokens[at]);
    }
  }
  return matrix;
}

}  // namespace

std::optional<LatexMatrix> read_matrix(const Tokens& given) {
  Tokens tokens = given;
  std::erase_if(tokens, [](const Token& token) { return is_layout(token); });
  const auto begin = std::find_if(tokens.begin(), tokens.end(),
                                  [](const Token& token) { return token.is("\\begin"); });
  if (begin == tokens.end()) {
    return read_column(tokens);
  }
  const auto place = static_cast<std::size_t>(begin - tokens.begin());
  std::size_t at = place + 1;
  const std::string name = letters_of(take_argument(tokens, at));
  if (name == "vmatrix" || name == "Vmatrix") {
    throw FormulaError("a determinant is not read; write it out", begin->place);
  }
  if (!is_matrix_name(name)) {
    throw FormulaError("\\begin{" + name + "} is not read here", begin->place);
  }
  std::size_t end = at;
  const Tokens inside = take_environment(tokens, end, name, *begin);
  const std::string before = letters_of(slice(tokens, 0, place));
  const std::string after = letters_of(slice(tokens, end, tokens.size()));
  const bool bracketed = (before == "(" && after == ")") || (before == "[" && after == "]");
  const bool bare = before.empty() && after.empty();
  if (before == "|" || before == "\\lvert") {
    throw FormulaError("a determinant is not read; write it out", begin->place);
  }
  if (!bracketed && !bare) {
    throw FormulaError(
        "only a matrix by itself can be compared, without factors, terms and superscripts",
        begin->place);
  }
  LatexMatrix matrix;
  matrix.place = begin->place;
  std::size_t first = 0;
  const std::string columns = name == "array" ? letters_of(take_argument(inside, first)) : "";
  const bool titled = columns.size() > 2 && columns[1] == '|';
  for (const Tokens& row : rows_of(slice(inside, first, inside.size()))) {
    matrix.cells.push_back(cells_of(row));
    if (matrix.cells.back().size() != matrix.cells[0].size()) {
      throw FormulaError(
          "the number of entries in this row is " + std::to_string(matrix.cells.back().size()) +
              ", and in the first row it is " + std::to_string(matrix.cells[0].size()),
          row.empty() ? begin->place : row[0].place);
    }
  }
  const auto expect_entries = [&] {
    if (matrix.cells.empty() || matrix.cells[0].empty()) {
      throw FormulaError("this matrix has no entries", begin->place);
    }
  };
  expect_entries();
  if (titled) {
    matrix.column_titles.assign(matrix.cells[0].begin() + 1, matrix.cells[0].end());
    matrix.cells.erase(matrix.cells.begin());
    for (std::vector<Tokens>& row : matrix.cells) {
      matrix.row_titles.push_back(row[0]);
      row.erase(row.begin());
    }
    expect_entries();
  }
  return matrix;
}

}  // namespace assur::generator::latex
