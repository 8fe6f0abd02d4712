// Turns straight-line MATLAB or Octave that fills a matrix into the matrix's entries.
#pragma once

#include "audit/code/code_entries.hpp"

namespace assur::generator::audit::code {

/// Finds what one function, or a script, assigns to a matrix: `ARRAY(i, j) = EXPR`, indices from 1,
/// or `ARRAY = [EXPR, EXPR; EXPR, EXPR]`, with or without commas; or what a function named ARRAY
/// gives. Refuses as read_cpp_matrix does.
[[nodiscard]] std::vector<CodeEntry> read_matlab_matrix(const std::string& code,
                                                        const AuditedMatrix& matrix,
                                                        closures::ClosureSystem& system);

}  // namespace assur::generator::audit::code
