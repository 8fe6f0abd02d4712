// The value of an expression at a point in double, with a bound on its rounding error.
#pragma once

#include "closures/closure_points.hpp"

namespace assur::generator::audit {

/// A value, and a bound on the error of its evaluation in double from inputs that are rounded
/// themselves.
struct RoundedValue {
  double value = 0;
  double error = 0;  ///< absolute, in units of 2^-53
};

/// Values by symbol; angles in radians.
using SymbolValues = std::map<GiNaC::ex, RoundedValue, GiNaC::ex_is_less>;

/// The values that a program receives at a point, and those of the total derivatives and rates that
/// have been solved for there.
[[nodiscard]] SymbolValues symbol_values(closures::ClosurePoints& points,
                                         const closures::ClosurePoints::Point& point);

/// The value of an expression without abbreviations. Throws NotAlgebraic if it has no value.
[[nodiscard]] RoundedValue rounded_value(const GiNaC::ex& expression, const SymbolValues& values);

}  // namespace assur::generator::audit
