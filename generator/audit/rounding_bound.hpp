// Turns an expression and a point into its value in double, and a bound of what rounding may do.
#pragma once

#include "closures/closure_points.hpp"

namespace assur::generator::audit {

/// The value and, in units of a rounding of one half ulp, the error of a careful evaluation from
/// inputs that have themselves been rounded.
struct RoundedValue {
  double value = 0;
  double error = 0;  ///< relative to 2^-53
};

/// Values of symbols by name; angles in radians.
using SymbolValues = std::map<GiNaC::ex, RoundedValue, GiNaC::ex_is_less>;

/// The values that a program is given at a point, and those of total derivatives and rates that
/// have been asked of the point.
[[nodiscard]] SymbolValues symbol_values(closures::ClosurePoints& points,
                                         const closures::ClosurePoints::Point& point);

/// The value of an expression without abbreviations. Throws NotAlgebraic for what has no value.
[[nodiscard]] RoundedValue rounded_value(const GiNaC::ex& expression, const SymbolValues& values);

}  // namespace assur::generator::audit
