// Turns an expression into a formula in the syntax of audit files, the same in every process.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace assur::generator::closures {

/// One text for the same mathematics, whatever order and signs GiNaC gives sums and products.
[[nodiscard]] std::string formula_text(const GiNaC::ex& expression);

/// The terms or factors in the order of their texts, for whatever depends on the order in which
/// they are met: names that are given, the first of several errors.
[[nodiscard]] std::vector<GiNaC::ex> ordered_operands(const GiNaC::ex& expression);

}  // namespace assur::generator::closures
