// Turns a family of a mechanism without its redundant constraints into what they leave of it.
#pragma once

#include <assur/mechanism/solution.hpp>

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// The mobility that all constraints together leave a family: they are closed by the links that the
/// family does not place, from many places, and a motion is followed from where they close. At most
/// the family's own; zero where no motion was found, be it that some of its places are left.
[[nodiscard]] int left_mobility(const Family& family, AllConstraints& constraints);

}  // namespace assur::mechanism::solve
