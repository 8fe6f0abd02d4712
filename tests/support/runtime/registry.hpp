// One list of the types of all generated models.
#pragma once

#include <assur/dyad/models.hpp>
#include <assur/tetrad/models.hpp>
#include <assur/triad/models.hpp>
#include <tuple>

namespace assur::test {

/// Every generated model of every group.
using AllModelsTuple = decltype(std::tuple_cat(dyad::Models(), triad::Models(), tetrad::Models()));

}  // namespace assur::test
