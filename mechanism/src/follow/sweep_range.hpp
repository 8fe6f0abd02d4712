// Values of a sweep's steps, and checks of the request.
#pragma once

#include <assur/mechanism/sweep.hpp>

namespace assur::mechanism::follow {

/// The value of the swept parameter at a step; steps count from 0.
[[nodiscard]] inline double value_at_step(double from, double to, int step, int count) {
  const int last = count - 1;
  return last == 0 ? from : from + (to - from) * (static_cast<double>(step) / last);
}

/// The request of the same configurations without the results that are derived from positions.
[[nodiscard]] inline Request positions_of(Request request) {
  request.want.velocity = request.want.acceleration = request.want.sensitivity = false;
  request.want.coefficients = false;
  request.covariance.reset();
  return request;
}

/// Throws MechanismError for a request without a sweep, and for one that cannot be run. Returns the
/// observer with missing functions replaced by functions without effect.
[[nodiscard]] SweepObserver expect_sweep(const Plan& plan, const Values& values,
                                         SweepObserver observer);

}  // namespace assur::mechanism::follow
