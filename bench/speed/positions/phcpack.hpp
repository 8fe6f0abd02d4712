// Turns an RRR-RRR tetrad into all its configurations by the homotopy continuation of PHCpack.
#pragma once

#include <assur/tetrad/model_01.hpp>
#include <optional>

#include "positions/position_samples.hpp"

namespace assur::speed {

struct PhcAnswer {
  Found<tetrad::Model01> found;
  double solving_ns = 0;  ///< as PHCpack states it, without its start and its files
  double call_ns = 0;     ///< processor time of the process
};

/// The black-box solver on the two squared loop closures as Laurent polynomials in
/// exp(i theta_BCG) and exp(i theta_EDF), mixed volume 6. Empty if the program fails.
[[nodiscard]] std::optional<PhcAnswer> solve_by_phc(const PositionSample<tetrad::Model01>& sample);

}  // namespace assur::speed
