// Error of second rates, from the regularity of a configuration and its motion.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <cmath>

namespace assur::support {

/// The factor by which the relative error of second rates exceeds that of rates. In J q'' = -H(q',
/// q') - ... an error of q' is multiplied by `loose`, the size of J^-1. Near a fold q'' grows by
/// the same factor; at a crossing it does not. `rate` and `second_rate` are the largest entries of
/// q' and q'', angles multiplied by the `size` of the group.
template <typename Scalar>
[[nodiscard]] Scalar second_rate_loss(Scalar loose, Scalar rate, Scalar second_rate, Scalar size) {
  const Scalar speed = rate * rate / size;
  const Scalar largest = (std::max)(second_rate, speed);
  return largest > 0 ? (std::max)(Scalar(1), loose * speed / largest) : Scalar(1);
}

/// The relative error of second rates, estimated from the pivots.
template <typename Model, typename Scalar>
[[nodiscard]] Scalar second_rate_error(const Regularity<Scalar>& standing,
                                       const Vector<Scalar, Model::unknown_count>& rate,
                                       const Vector<Scalar, Model::unknown_count>& second_rate,
                                       Scalar size) {
  const auto largest = [size](const Vector<Scalar, Model::unknown_count>& of) {
    Scalar result = 0;
    for (int row = 0; row < Model::unknown_count; ++row) {
      result = (std::max)(result, std::abs(of(row)) * (detail::is_angle<Model>(row) ? size : 1));
    }
    return result;
  };
  const Scalar error = standing.error();
  return std::isfinite(error) ? error * second_rate_loss(1 / standing.firmness, largest(rate),
                                                         largest(second_rate), size)
                              : error;
}

}  // namespace assur::support
