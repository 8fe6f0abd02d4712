// Turns an angle into a sum of whole multiples of angles that are not sums themselves.
#pragma once

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// A multiple of a declared angle, of an inverse function, or of an abbreviation of one.
struct AngleTerm {
  GiNaC::ex angle;
  int factor;
};

/// An angle as a sum: its terms by their texts, in the same order in every process, and quarter
/// turns.
struct AngleTerms {
  std::map<std::string, AngleTerm> terms;
  int quarter_turns = 0;
};

/// The terms of an angle, with abbreviations of sums taken apart. Throws NotAlgebraic for numbers
/// other than quarter turns and for multiples that are not whole.
[[nodiscard]] AngleTerms angle_terms(const GiNaC::ex& angle, const ClosureSystem& system);

}  // namespace assur::generator::closures
