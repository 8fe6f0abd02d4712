// Mobility of a family once the redundant constraints hold as well.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// Returns the mobility that all constraints together leave a family, at most the family's own. Its
/// own `links`, and those that are joined to them and that the family does not place, are moved,
/// from many starting positions, until all constraints hold, and from there a motion is followed.
/// Zero means that no motion was found, although isolated positions of the family may remain.
[[nodiscard]] int left_mobility(const Family& family, const AllConstraints& constraints,
                                const std::vector<LinkIndex>& links);

}  // namespace assur::mechanism::solve
