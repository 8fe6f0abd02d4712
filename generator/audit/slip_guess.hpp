// Guesses the slip that explains the wrong entries of a program.
#pragma once

#include "audit/rounding_bound.hpp"

namespace assur::generator::audit {

/// The values that a program computes, and those that it should compute, at the same points.
struct ComputedMatrix {
  std::size_t rows;
  std::size_t columns;
  std::vector<GiNaC::ex> derived;  ///< row by row, without abbreviations
  std::vector<SymbolValues> points;
  std::vector<std::vector<double>> computed;  ///< of each point, row by row
  std::vector<bool> angles;                   ///< entries for which whole turns do not count
  double slack;  ///< part of the error bound, in units of 2^-53, by which a guess may be off
};

/// The first of a list of common slips that reproduces the computed values at all points: a sign, a
/// factor (a number, or a length, rate, sine or cosine too many or too few), an exchanged row,
/// column or entry, a term left out or of the wrong sign, sine for cosine, degrees for radians, one
/// quantity for another or left out, the values of the point before, single precision. Empty if
/// there is none.
[[nodiscard]] std::string guessed_slip(const ComputedMatrix& matrix, std::size_t entry,
                                       const closures::ClosureSystem& system);

}  // namespace assur::generator::audit
