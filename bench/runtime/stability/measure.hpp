// The error of a method's answer against the reference.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "families.hpp"
#include "methods.hpp"

namespace assur::stability {

enum class Quantity : unsigned char { sensitivities, velocity, acceleration };
inline constexpr std::array<Quantity, 3> quantities = {Quantity::sensitivities, Quantity::velocity,
                                                       Quantity::acceleration};
inline constexpr std::array<const char*, 3> quantity_names = {"sensitivities", "velocity",
                                                              "acceleration"};

/// max |x - truth| / max |truth| over the weighted unknowns, the largest over the columns; infinite
/// if any number is not finite.
template <typename Computed, typename True, typename Weights>
[[nodiscard]] double relative_error(const Computed& computed, const True& truth,
                                    const Weights& weights) {
  if (!computed.allFinite()) {
    return std::numeric_limits<double>::infinity();
  }
  double worst = 0;
  for (Eigen::Index column = 0; column < truth.cols(); ++column) {
    Real difference(0);
    Real size(0);
    for (Eigen::Index row = 0; row < truth.rows(); ++row) {
      const Real& exact = truth(row, column);
      difference =
          std::max(difference, Real(weights(row) * abs(Real(computed(row, column)) - exact)));
      size = std::max(size, Real(weights(row) * abs(exact)));
    }
    worst = std::max(worst, static_cast<double>(Real(difference / size)));
  }
  return worst;
}

template <typename Model>
[[nodiscard]] bool has(const Answer<Model>& answer, Quantity quantity) {
  return quantity != Quantity::sensitivities || answer.has_sensitivities;
}

template <typename Model>
[[nodiscard]] double error_of(const Answer<Model>& answer, const Truth<Model>& truth,
                              Quantity quantity) {
  switch (quantity) {
    case Quantity::sensitivities:
      return std::max(relative_error(answer.sensitivities.to_dimensions,
                                     truth.sensitivities.to_dimensions, truth.weights),
                      relative_error(answer.sensitivities.to_inputs, truth.sensitivities.to_inputs,
                                     truth.weights));
    case Quantity::velocity:
      return relative_error(answer.motion.velocity, truth.motion.velocity, truth.weights);
    case Quantity::acceleration:
      return relative_error(answer.motion.acceleration, truth.motion.acceleration, truth.weights);
  }
  return std::numeric_limits<double>::infinity();
}

/// An answer with fewer than two correct digits is wrong: another branch, or rounding only.
inline constexpr double wrong_error = 0.01;
[[nodiscard]] inline bool is_wrong(double error) { return !(error <= wrong_error); }

}  // namespace assur::stability
