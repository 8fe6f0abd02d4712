#include "sweep_range.hpp"

#include <assur/mechanism/mechanism.hpp>
#include <cmath>

namespace assur::mechanism::follow {

SweepObserver expect_sweep(const Plan& plan, const Values& values, SweepObserver observer) {
  if (!plan.request().sweep) {
    throw MechanismError("sweep", "the request has no sweep");
  }
  plan.expect_usable(values);
  const Sweep& range = *plan.request().sweep;
  if (!std::isfinite(values.value_of(range.to) - values.value_of(range.from))) {
    throw MechanismError("sweep", "the range from 'from' to 'to' is not finite");
  }
  if (!observer.record) {
    observer.record = [](const SweepRecord&) {};
  }
  if (!observer.solved) {
    observer.solved = [](double, const Solution&) {};
  }
  if (!observer.progress) {
    observer.progress = [](int) {};
  }
  return observer;
}

}  // namespace assur::mechanism::follow
