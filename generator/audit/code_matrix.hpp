// Turns hand-written C++ that fills a matrix into the matrix's entries.
#pragma once

#include "audit/equation_audit.hpp"

namespace assur::generator {

/// Finds the assignments `ARRAY(i, j) = EXPR;` or `ARRAY[i][j] = EXPR;`, indices from 0, and the
/// local variables `double name = EXPR;` that they use. An entry that is not assigned is zero.
/// `a.b` is read as a_b and `a[2]` as a_2; `std::` is skipped. Throws AuditSyntaxError with a place
/// in the code for what is assigned to the array in another way.
[[nodiscard]] std::vector<PrintedEntry> read_code_matrix(const std::string& code,
                                                         const std::string& file,
                                                         const std::string& array, std::size_t rows,
                                                         std::size_t columns,
                                                         ClosureSystem& system);

}  // namespace assur::generator
