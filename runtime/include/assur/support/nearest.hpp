// The configuration nearest to given link angles.
#pragma once

#include <cmath>
#include <limits>

namespace assur::support {

struct Nearest {
  int configuration = -1;  ///< its index, from 0; -1 if there are none
  double distance = 0;     ///< the square root of the sum of the squared angles, in radians
  double runner_up =
      std::numeric_limits<double>::infinity();  ///< distance of the second nearest, if there is one
};

/// `angles_of(i)` returns the differences between the link angles of configuration i and the given
/// ones.
template <typename AnglesOf>
[[nodiscard]] Nearest nearest(int count, const AnglesOf& angles_of) {
  using Scalar = typename decltype(angles_of(0))::value_type;
  Nearest found;
  for (int index = 0; index < count; ++index) {
    Scalar square = 0;
    for (const Scalar angle : angles_of(index)) {
      square += angle * angle;
    }
    const double distance = std::sqrt(square);
    if (found.configuration < 0 || distance < found.distance) {
      if (found.configuration >= 0) {
        found.runner_up = found.distance;
      }
      found.configuration = index;
      found.distance = distance;
    } else if (distance < found.runner_up) {
      found.runner_up = distance;
    }
  }
  return found;
}

}  // namespace assur::support
