// Turns a configuration into the error of its derivatives to a parameter that moves drivers.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The relative error that rounding leaves to the derivatives s of a configuration to the parameter
/// of a column, of all constraints f(q, p) = 0 body by body: J s + f_p = 0. A row of f that is open
/// by e moves q by dq = e J^-1 r, r that row, and s by J^-1 H(s, dq), H the second derivatives of
/// f; what all rows do is added up. Group by group every error counts as if it pointed the way that
/// hurts the next group most; here what a crank's angle leaves open counts behind it by what that
/// turns there. Infinite where J has no inverse, where laws read joints, where a parameter moves
/// more than drivers, where constraints are redundant, and for mechanisms of more than 100 links.
[[nodiscard]] double slope_error(const Values& values, const Configuration& configuration,
                                 Eigen::Index column);

}  // namespace assur::mechanism::solve
