// Turns a closed form into what is certain of all groups of its model, whatever their numbers are.
#pragma once

#include <map>
#include <string>

#include "elimination/eliminate.hpp"
#include "emission/cpp/page.hpp"
#include "pivoting/structured_jacobian.hpp"
#include "program/program.hpp"

namespace assur::generator::emission::model {

/// What symbols are at most, by their names.
using Sizes = std::map<std::string, double>;

/// The groups in question.
struct GroupRange {
  double longest = 1;              ///< no length exceeds this
  bool is_scaled = true;           ///< groups are alike in all sizes: no length is a number
  Sizes numbers = {};              ///< in place of variables
  double rounding_of_numbers = 0;  ///< what a coefficient is off by for them
};

/// What the runtime reads of a final polynomial that is solved by formula: when its discriminant
/// has a certain sign, and when it vouches for configurations that are regular, in order by one
/// key, and close by the formula itself. `polynomial` is the program that computes the final
/// polynomial. Returns the place of that key; zero where nothing is vouched for.
int show_closed_form(const equations::ClosureEquations& equations,
                     const elimination::Elimination& elimination,
                     const pivoting::StructuredJacobian& structured,
                     const program::Program& polynomial, const GroupRange& range, cpp::View& view);

}  // namespace assur::generator::emission::model
