// Prints an expression in the syntax of audit files, the same in every process.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace assur::generator::closures {

/// One text for equal mathematics, whatever order and signs GiNaC gives sums and products.
[[nodiscard]] std::string formula_text(const GiNaC::ex& expression);

/// The terms or factors sorted by their texts, for results that depend on the order of visits: new
/// names, the first of several errors.
[[nodiscard]] std::vector<GiNaC::ex> ordered_operands(const GiNaC::ex& expression);

}  // namespace assur::generator::closures
