// Turns straight-line C++ that fills a matrix into the matrix's entries.
#pragma once

#include "audit/code/filled_matrix.hpp"

namespace assur::generator::audit::code {

/// Finds what one function, or a file of plain statements, assigns to a matrix:
/// `ARRAY(i, j) = EXPR;`, `ARRAY[i][j] = EXPR;`, indices from 0, or all entries by `ARRAY << EXPR,
/// EXPR, ...;`; and the local variables that the expressions use. An entry that is not assigned is
/// zero, with the place where the matrix is first filled. Throws CodeError for everything else that
/// may change the matrix or a variable: only what is known to be harmless is passed over.
[[nodiscard]] std::vector<CodeEntry> read_cpp_matrix(const std::string& code,
                                                     const AuditedMatrix& matrix,
                                                     closures::ClosureSystem& system);

}  // namespace assur::generator::audit::code
