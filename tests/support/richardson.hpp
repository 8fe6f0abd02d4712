// Derivatives of vector functions by Richardson extrapolation of central differences.
#pragma once

#include <Eigen/Core>

namespace assur::test {

/// A derivative, and the change by its last extrapolation, an estimate of its error.
template <typename Vector>
struct Difference {
  Vector derivative;
  double uncertainty = 0;
};

/// Central differences at steps h, h/2 and h/4, extrapolated to order h^6. `at(offset)` gives the
/// function's value.
template <typename Vector, typename At>
Difference<Vector> richardson(const At& at, double h) {
  const auto central = [&](double step) -> Vector { return (at(step) - at(-step)) / (2 * step); };
  const Vector coarse = central(h);
  const Vector middle = central(h / 2);
  const Vector fine = central(h / 4);
  const Vector first = middle + (middle - coarse) / 3;
  const Vector second = fine + (fine - middle) / 3;
  const Vector last = second + (second - first) / 15;
  return {last, static_cast<double>((last - second).cwiseAbs().maxCoeff())};
}

/// The result of least estimated error over several steps, each a quarter of the previous one.
template <typename Vector, typename At>
Difference<Vector> best_richardson(const At& at, double h, int steps) {
  Difference<Vector> best = richardson<Vector>(at, h);
  for (int step = 1; step < steps; ++step) {
    h /= 4;
    const Difference<Vector> next = richardson<Vector>(at, h);
    if (!(best.uncertainty <= next.uncertainty)) {
      best = next;
    }
  }
  return best;
}

}  // namespace assur::test
