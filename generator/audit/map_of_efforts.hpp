// Tells which wrong matrix is printed where the transpose of a map of velocities is expected.
#pragma once

#include "audit/equation_audit.hpp"

namespace assur::generator::audit {

/// Adds a note to the wrong entries of a transposed matrix if all that is printed is the map of
/// velocities itself, its inverse, or the transposed inverse.
void explain_map_of_efforts(closures::ClosurePoints& points, const PrintedMatrix& matrix,
                            std::vector<Finding>& findings);

}  // namespace assur::generator::audit
