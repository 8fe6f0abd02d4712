// An angle as a sum of integer multiples of angles that are not sums.
#pragma once

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// A multiple of a declared angle, of an inverse function, or of an abbreviation of one.
struct AngleTerm {
  GiNaC::ex angle;
  int factor;
};

/// An angle as a sum: its terms sorted by their texts, so that every process has the same order,
/// and quarter turns.
struct AngleTerms {
  std::map<std::string, AngleTerm> terms;
  int quarter_turns = 0;
};

/// The terms of an angle, with abbreviations of sums expanded. Throws NotAlgebraic for numbers
/// other than quarter turns and for multiples that are not integers.
[[nodiscard]] AngleTerms angle_terms(const GiNaC::ex& angle, const ClosureSystem& system);

}  // namespace assur::generator::closures
