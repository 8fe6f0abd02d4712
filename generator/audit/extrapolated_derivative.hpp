// Derivatives of a function from its values on both sides of a point, with error bounds.
#pragma once

#include <vector>

namespace assur::generator::audit {

/// f(x), and f(x + h) and f(x - h) for h = `first_step`, half of it, a quarter, ...
struct SymmetricSamples {
  double middle = 0;
  double first_step = 1;
  std::vector<double> above;
  std::vector<double> below;
  double error = 0;  ///< a bound on the error of a value
};

struct BoundedValue {
  double value = 0;
  double bound = 0;  ///< on its error; infinite if there is none
};

/// Central differences, extrapolated to step zero (Romberg). The bound is ten times the change in
/// the last steps of the extrapolation, plus the effect of the errors of the values. Steps at which
/// the function has no value are left out if they are the largest.
[[nodiscard]] BoundedValue first_derivative(const SymmetricSamples& samples);
[[nodiscard]] BoundedValue second_derivative(const SymmetricSamples& samples);

}  // namespace assur::generator::audit
