// Statements of the displayed equations of a paper, and the audit of those about matrices.
#pragma once

#include <optional>

#include "audit/latex/paper_formulas.hpp"
#include "audit/latex/paper_map.hpp"

namespace assur::generator::audit::latex {

/// One statement of a displayed equation.
struct Stated {
  std::string label;
  closures::Place place;
  Tokens tokens;
  std::vector<Tokens> sides = {};
  std::string defines = {};                          ///< the name that it defines, if any
  std::string closure = {};                          ///< the closure that it prints, if any
  std::optional<closures::FormulaError> error = {};  ///< why it cannot be read
};

/// The statements of a paper, except those that the map skips. Throws FormulaError for a file that
/// cannot be read.
[[nodiscard]] std::vector<Stated> paper_statements(const Tokens& tokens, PaperMap& map);

/// The findings of a statement about matrices.
struct MatrixAnswer {
  std::size_t columns = 0;  ///< zero if the findings are not about single entries
  std::vector<Finding> findings;
};

/// `J = \begin{pmatrix} ... \end{pmatrix}` entry by entry, and `dq/da = -[df/dq]^{-1} df/da`, which
/// is audited as `df/dq dq/da = -df/da`. Empty if the left side is not a matrix of the map. Throws
/// FormulaError.
[[nodiscard]] std::optional<MatrixAnswer> audit_matrix_statement(PaperFormulas& formulas,
                                                                 const Stated& stated);

}  // namespace assur::generator::audit::latex
