// Bounds for the closed form of a model that hold for all its groups, whatever their numbers.
#pragma once

#include <map>
#include <string>

#include "elimination/eliminate.hpp"
#include "emission/cpp/page.hpp"
#include "pivoting/structured_jacobian.hpp"
#include "program/program.hpp"

namespace assur::generator::emission::model {

/// Upper bounds of the magnitudes of symbols, by their names.
using Sizes = std::map<std::string, double>;

/// The groups for which the bounds hold.
struct GroupRange {
  double longest = 1;              ///< no length exceeds this
  bool is_scaled = true;           ///< groups of any scale: no length is a number
  Sizes numbers = {};              ///< magnitudes of variables that are numbers
  double rounding_of_numbers = 0;  ///< error that these cause in a coefficient
};

/// Shows the values that the runtime needs for a final polynomial that is solved by formula: when
/// the sign of its discriminant is certain, and when the discriminant proves that configurations
/// are regular, ordered by one key, and closed by the formula itself. `polynomial` is the program
/// that computes the final polynomial. Returns the index of that key; zero if there is no such
/// proof.
int show_closed_form(const equations::ClosureEquations& equations,
                     const elimination::Elimination& elimination,
                     const pivoting::StructuredJacobian& structured,
                     const program::Program& polynomial, const GroupRange& range, cpp::View& view);

}  // namespace assur::generator::emission::model
