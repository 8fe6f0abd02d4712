// Audits statements whose left side is a matrix of the map.
#include "audit/latex/paper_statements.hpp"
#include "latex/read_matrix.hpp"
#include "latex/rows.hpp"

namespace assur::generator::audit::latex {

namespace {

using generator::latex::LatexMatrix;
using generator::latex::Token;

/// Comparing an inverse with this many products takes ten seconds.
constexpr std::size_t most_products = 100'000;

void expect_few_entries(std::size_t rows, std::size_t columns, Place place) {
  if (rows * columns > most_entries) {
    throw FormulaError(
        "the matrix has more than " + std::to_string(most_entries) + " entries; divide it", place);
  }
}

PrintedMatrix frame_of_titles(const PaperFormulas& formulas, const LatexMatrix& matrix) {
  if (matrix.row_titles.empty()) {
    throw FormulaError("the matrix has no titles that rules separate from its entries",
                       matrix.place);
  }
  PrintedMatrix frame;
  const auto name_of = [&](const Tokens& title) {
    const std::optional<Meaning> meaning = formulas.map().quantity(title);
    if (!meaning || !formulas.map().system().is_known(meaning->formula)) {
      throw FormulaError("no quantity is known as '" + formulas.source(title) + "'",
                         title.empty() ? matrix.place : title[0].place);
    }
    return meaning->formula;
  };
  for (const Tokens& title : matrix.row_titles) {
    frame.rows.push_back(name_of(title));
  }
  for (const Tokens& title : matrix.column_titles) {
    frame.columns.push_back(name_of(title));
    if (formulas.map().system().symbol_named(frame.columns.back()) == nullptr) {
      throw FormulaError("'" + frame.columns.back() + "' is not a symbol to differentiate by",
                         title[0].place);
    }
  }
  expect_parameters(frame, formulas.map().system(), matrix.place);
  return frame;
}

MatrixAnswer audit_entries(PaperFormulas& formulas, PrintedMatrix frame,
                           const LatexMatrix& matrix) {
  if (frame.columns.empty()) {
    frame = frame_of_titles(formulas, matrix);
  } else if (!matrix.row_titles.empty()) {
    throw FormulaError("the matrix has titles; say 'matrix by its titles' in the map",
                       matrix.place);
  }
  if (matrix.cells.size() != frame.rows.size() || matrix.cells[0].size() != frame.columns.size()) {
    throw FormulaError("the map says " + std::to_string(frame.rows.size()) + " by " +
                           std::to_string(frame.columns.size()) + " entries, and these are " +
                           std::to_string(matrix.cells.size()) + " by " +
                           std::to_string(matrix.cells[0].size()),
                       matrix.place);
  }
  expect_few_entries(frame.rows.size(), frame.columns.size(), matrix.place);
  std::vector<Finding> findings;
  for (std::size_t row = 0; row < frame.rows.size(); ++row) {
    Place last = matrix.place;
    for (std::size_t column = 0; column < frame.columns.size(); ++column) {
      const Tokens& cell = matrix.cells[row][column];
      last = cell.empty() ? last : cell[0].place;
      const bool blank = cell.empty() && formulas.blanks_are_zero();
      findings.push_back(audit_entry(
          formulas.points(), frame, row, column, {blank ? "0" : formulas.source(cell), last},
          [&]() -> GiNaC::ex { return blank ? GiNaC::ex(0) : formulas.expression(cell, last); }));
    }
  }
  return {frame.columns.size(), std::move(findings)};
}

/// `dq/da = -[df/dq]^{-1} df/da`, audited as `df/dq dq/da = -df/da`: entry by entry.
std::optional<MatrixAnswer> audit_inverse(PaperFormulas& formulas, const Stated& stated,
                                          const PrintedMatrix& left) {
  Tokens side = stated.sides[1];
  std::erase_if(side, [](const Token& token) { return generator::latex::is_layout(token); });
  const bool minus = !side.empty() && side[0].is("-");
  std::size_t mark = 0;
  while (mark + 4 < side.size() &&
         !(side[mark].is("^") && side[mark + 1].is("{") && side[mark + 2].is("-") &&
           side[mark + 3].is("1") && side[mark + 4].is("}"))) {
    ++mark;
  }
  if (mark + 5 >= side.size() || stated.sides.size() != 2 || left.rows.empty()) {
    return std::nullopt;
  }
  std::size_t behind = mark + 5;
  behind += side[behind].is("\\cdot") ? 1 : 0;
  const Tokens one = generator::latex::slice(side, minus ? 1 : 0, mark);
  const Tokens other = generator::latex::slice(side, behind, side.size());
  const std::optional<PrintedMatrix> inverted =
      one.empty() ? std::nullopt : formulas.map().matrix_frame(one);
  const std::optional<PrintedMatrix> right =
      other.empty() ? std::nullopt : formulas.map().matrix_frame(other);
  if (!inverted || !right || inverted->columns != left.rows || inverted->rows != right->rows ||
      right->columns != left.columns) {
    throw FormulaError("the map's matrices do not fit together here", stated.sides[1][0].place);
  }
  if (right->rows.size() * right->columns.size() * left.rows.size() > most_products) {
    throw FormulaError("these matrices are too large: their entries are compared by more than " +
                           std::to_string(most_products) + " products; let the map skip this",
                       stated.sides[1][0].place);
  }
  std::vector<Finding> findings;
  for (const std::string& row : right->rows) {
    for (const std::string& column : right->columns) {
      const closures::AuditSymbol& by = *formulas.system().symbol_named(column);
      const GiNaC::ex* const named = formulas.system().closure_named(row);
      if (named == nullptr) {
        throw FormulaError(
            "'" + row + "' is not a closure, and such a product has derivatives of closures",
            stated.sides[1][0].place);
      }
      const GiNaC::ex& closure = *named;
      GiNaC::ex sum;
      for (const std::string& unknown : left.rows) {
        const closures::AuditSymbol& each = *formulas.system().symbol_named(unknown);
        sum += formulas.system().slope(closure, each.symbol) *
               formulas.system().total(each.symbol, by);
      }
      const GiNaC::ex direct = formulas.system().slope(closure, by.symbol);
      findings.push_back(audit_equation(formulas.points(), row + " by " + column, sum,
                                        minus ? -direct : direct,
                                        {formulas.source(stated.tokens), stated.place}));
    }
  }
  return MatrixAnswer{0, std::move(findings)};
}

}  // namespace

std::optional<MatrixAnswer> audit_matrix_statement(PaperFormulas& formulas, const Stated& stated) {
  if (stated.sides.size() < 2) {
    return std::nullopt;
  }
  const std::optional<PrintedMatrix> left = formulas.map().matrix_frame(stated.sides[0]);
  if (!left) {
    return std::nullopt;
  }
  if (auto answer = audit_inverse(formulas, stated, *left)) {
    return answer;
  }
  const std::optional<LatexMatrix> matrix = generator::latex::read_matrix(stated.sides[1]);
  if (!matrix || stated.sides.size() != 2) {
    throw FormulaError("a matrix is expected here", stated.sides[1][0].place);
  }
  return audit_entries(formulas, *left, *matrix);
}

}  // namespace assur::generator::audit::latex
