// Turns formulas in a scene's parameters into C++.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace assur::generator::emission::scene {

/// Whether a formula is a number, of any form: `sin(1/2)` is one.
[[nodiscard]] bool is_constant(const GiNaC::ex& formula);

/// The formula with its symbols by their names, numbers as doubles, and the functions of <cmath>.
/// The text is the same in every process.
[[nodiscard]] std::string cpp_formula(const GiNaC::ex& formula);

}  // namespace assur::generator::emission::scene
