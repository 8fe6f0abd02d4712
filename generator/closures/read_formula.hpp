// Reads a printed formula as an expression in the symbols of a closure system.
#pragma once

#include <assur/text/expression.hpp>
#include <functional>
#include <span>

#include "closures/closure_system.hpp"
#include "closures/statement.hpp"

namespace assur::generator::closures {

/// A part of a formula that cannot be read, and its place.
struct FormulaError : std::runtime_error {
  FormulaError(const std::string& what, Place at) : std::runtime_error(what), place(at) {}
  Place place;
};

/// Names of one formula in addition to those of the system.
struct LocalNames {
  std::map<std::string, std::string> stands_for;  ///< another name: `j` for `a3`
  std::map<std::string, GiNaC::ex> meanings;
};

/// Numbers are exact: 0.1 is 1/10. Besides the functions of scenes a formula may call d(e, x), D(e,
/// x), rate(e), rate2(e) (see ClosureSystem) and pow(e, n). Throws FormulaError.
[[nodiscard]] GiNaC::ex read_formula(const PlacedText& text, ClosureSystem& system,
                                     const LocalNames& locals = {});

/// The expression of a tree from another reader. `place_of` returns the place of a column. Besides
/// the functions above a tree may contain `derivative` with two arguments: the partial one of a
/// closure, the total one of anything else.
[[nodiscard]] GiNaC::ex expression_of(const text::Expression& tree,
                                      const std::function<Place(std::size_t)>& place_of,
                                      ClosureSystem& system, const LocalNames& locals = {});

/// The functions of formulas besides those of scenes.
[[nodiscard]] std::span<const text::ExpressionFunction> formula_functions();

/// A sum or difference of vectors point(x, y) and polar(length, angle).
[[nodiscard]] equations::Vector2 read_vector(const PlacedText& text, ClosureSystem& system);

}  // namespace assur::generator::closures
