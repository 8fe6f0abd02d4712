// The entries of a matrix, or the values, that straight-line C++ or MATLAB computes.
#pragma once

#include "audit/code/code_entries.hpp"

namespace assur::generator::audit::code {

/// Finds what one function, or a file of statements, assigns to a matrix: `ARRAY(i, j) = EXPR`,
/// `ARRAY[i][j] = EXPR`, indices from 0, or `ARRAY << EXPR, ...`; or, if ARRAY is the name of a
/// function, its return value or the values of its output parameters. Throws CodeError for any
/// other code.
[[nodiscard]] std::vector<CodeEntry> read_cpp_matrix(const std::string& code,
                                                     const AuditedMatrix& matrix,
                                                     closures::ClosureSystem& system);

/// Finds what one function, or a script, assigns to a matrix: `ARRAY(i, j) = EXPR`, indices from 1,
/// or `ARRAY = [EXPR, EXPR; EXPR, EXPR]`, with or without commas; or the results of a function
/// named ARRAY. Refuses other code as read_cpp_matrix does.
[[nodiscard]] std::vector<CodeEntry> read_matlab_matrix(const std::string& code,
                                                        const AuditedMatrix& matrix,
                                                        closures::ClosureSystem& system);

}  // namespace assur::generator::audit::code
