// Turns a configuration into the error of its derivatives to a parameter that moves drivers.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// Returns a bound on the relative error that rounding causes in the derivatives s of a
/// configuration with respect to the parameter p of a column. They are judged by all constraints
/// f(q, p) = 0 of all bodies at once, where J s + f_p = 0. If row i of f misses zero by e, q is off
/// by dq = e J^-1 u_i, where u_i is the unit vector of that row, and s by J^-1 H(s, dq), where H
/// are the second derivatives of f; the effects of all rows are added up. An estimate group by
/// group would have to assume that every error has the direction that is worst for the next group;
/// here an error in the angle of a crank affects what follows only as much as the crank turns it.
/// Infinite where J has no inverse, where laws read joints, where a parameter moves more than
/// drivers, where constraints are redundant, and for mechanisms of more than 100 links.
[[nodiscard]] double slope_error(const Values& values, const Configuration& configuration,
                                 Eigen::Index column);

}  // namespace assur::mechanism::solve
