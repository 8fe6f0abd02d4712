// Directions of several angles at once.
#pragma once

#include <assur/model.hpp>
#include <assur/numeric/pack.hpp>
#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// `assur::direction_of`, lane by lane: compilers call one function for the cosine and sine of a
/// number.
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
