// Turns a closure system into the pipeline's equations: polynomials in named quantities.
#pragma once

#include <string>
#include <vector>

#include "closures/circle_algebra.hpp"
#include "closures/closure_system.hpp"
#include "equations/implicit_equations.hpp"

namespace assur::generator::closures {

/// The closures as f(q, d, u) = 0: the unknowns q, the parameters that are held as dimensions d and
/// those that move as inputs u. Sines and cosines become parts of directions; abbreviations, roots
/// and divisors become named quantities, roots and divisors with the degeneracy that ends them.
/// The emitted code uses the names of `types` itself everywhere, and `locals` in functions. Throws
/// NotAlgebraic, with the closure's name, for what is not a polynomial in such quantities.
[[nodiscard]] equations::ImplicitEquations implicit_form(const ClosureSystem& system,
                                                         const std::vector<std::string>& types,
                                                         const std::vector<std::string>& locals);

}  // namespace assur::generator::closures
