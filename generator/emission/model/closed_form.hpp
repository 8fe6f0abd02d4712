// Turns a closed form into bounds that hold for all groups of its model, whatever their numbers.
#pragma once

#include <map>
#include <string>

#include "elimination/eliminate.hpp"
#include "emission/cpp/page.hpp"
#include "pivoting/structured_jacobian.hpp"
#include "program/program.hpp"

namespace assur::generator::emission::model {

/// Upper bounds of the sizes of symbols, by their names.
using Sizes = std::map<std::string, double>;

/// The groups for which the bounds hold.
struct GroupRange {
  double longest = 1;              ///< no length exceeds this
  bool is_scaled = true;           ///< groups may be of any scale: no length is a number
  Sizes numbers = {};              ///< the sizes of variables that are numbers
  double rounding_of_numbers = 0;  ///< the error of a coefficient that these cause
};

/// Shows what the runtime reads of a final polynomial that is solved by formula: when the sign of
/// its discriminant is certain, and when the discriminant proves that configurations are regular,
/// ordered by one key, and closed by the formula itself. `polynomial` is the program that computes
/// the final polynomial. Returns the place of that key; zero where there is no such proof.
int show_closed_form(const equations::ClosureEquations& equations,
                     const elimination::Elimination& elimination,
                     const pivoting::StructuredJacobian& structured,
                     const program::Program& polynomial, const GroupRange& range, cpp::View& view);

}  // namespace assur::generator::emission::model
