// Turns a statement whose left side is a matrix of the map into findings.
#pragma once

#include "audit/latex/paper_formulas.hpp"
#include "audit/latex/paper_statements.hpp"

namespace assur::generator::audit::latex {

/// The findings of a statement about matrices.
struct MatrixAnswer {
  std::size_t columns = 0;  ///< zero where the findings are not of single entries
  std::vector<Finding> findings;
};

/// `J = \begin{pmatrix} ... \end{pmatrix}` entry by entry, and `dq/da = -[df/dq]^{-1} df/da`, which
/// is audited as `df/dq dq/da = -df/da`. Nothing where no matrix of the map stands on the left.
/// Throws FormulaError.
[[nodiscard]] std::optional<MatrixAnswer> audit_matrix_statement(PaperFormulas& formulas,
                                                                 const Stated& stated);

}  // namespace assur::generator::audit::latex
