// Turns hand-written C++ that fills a matrix into the matrix's entries.
#pragma once

#include "audit/equation_audit.hpp"

namespace assur::generator::audit {

/// Finds what straight-line code assigns to a matrix: `ARRAY(i, j) = EXPR;`, `ARRAY[i][j] = EXPR;`,
/// indices from 0, or all entries by `ARRAY << EXPR, EXPR, ...;`; and the local variables
/// `double name = EXPR;` that the expressions use. An entry that is not assigned is zero, with the
/// place where the matrix is first used. Expressions are read by code_as_formula; their places may
/// count on over the ends of lines, see place_in_code. Throws AuditSyntaxError with a place in the
/// code for what is assigned to the matrix in another way, or cannot be read.
[[nodiscard]] std::vector<PrintedEntry> read_code_matrix(const std::string& code,
                                                         const std::string& file,
                                                         const std::string& array, std::size_t rows,
                                                         std::size_t columns,
                                                         closures::ClosureSystem& system);

}  // namespace assur::generator::audit
