// Turns straight-line C++ that fills a matrix, or gives some values, into these.
#pragma once

#include "audit/code/code_entries.hpp"

namespace assur::generator::audit::code {

/// Finds what one function, or a file of statements, assigns to a matrix: `ARRAY(i, j) = EXPR`,
/// `ARRAY[i][j] = EXPR`, indices from 0, or `ARRAY << EXPR, ...`; or, where ARRAY is the name of a
/// function, what this returns or sets through its parameters. Throws CodeError for everything that
/// is not known to compute just that.
[[nodiscard]] std::vector<CodeEntry> read_cpp_matrix(const std::string& code,
                                                     const AuditedMatrix& matrix,
                                                     closures::ClosureSystem& system);

}  // namespace assur::generator::audit::code
