// Turns several angles into their directions.
#pragma once

#include <assur/model.hpp>
#include <assur/numeric/pack.hpp>
#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// Finds lane by lane what `assur::direction_of` finds for one angle: compilers call one function
/// for cosine and sine of a number.
template <typename Scalar, std::size_t Lanes>
[[nodiscard]] Direction<PackOf<Scalar, Lanes>> direction_of(PackOf<Scalar, Lanes> angle) {
  Direction<PackOf<Scalar, Lanes>> direction;
  for (std::size_t lane = 0; lane < Lanes; ++lane) {
    const Scalar one = angle[lane];
    direction.cos.put(lane, std::cos(one));
    direction.sin.put(lane, std::sin(one));
  }
  return direction;
}

}  // namespace assur::numeric
