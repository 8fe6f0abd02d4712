// Models of the campaign on bare metal by number: closed forms with angles and displacements, and
// polynomials of degree four and six.
#pragma once

#include <assur/dyad/model_01.hpp>
#include <assur/dyad/model_02.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_12.hpp>
#include <assur/triad/model_01.hpp>
#include <tuple>

namespace assur::test::metal {

using Models =
    std::tuple<dyad::Model01, dyad::Model02, triad::Model01, tetrad::Model01, tetrad::Model12>;

}  // namespace assur::test::metal
