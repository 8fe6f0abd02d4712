#include "audit/extrapolated_derivative.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace assur::generator::audit {

namespace {

constexpr double safety = 10;
/// Sum of the magnitudes of the differences' weights in an entry of the tableau.
constexpr double most_weight = 2;

struct Difference {
  double value;
  double error;  ///< from the errors of the samples
};

/// The entry of the tableau with the smallest bound.
BoundedValue extrapolated(const std::vector<Difference>& differences) {
  BoundedValue best{0, std::numeric_limits<double>::infinity()};
  std::vector<double> last;  // the previous row
  for (const Difference& difference : differences) {
    if (!std::isfinite(difference.value)) {
      if (!last.empty()) {
        return {0, std::numeric_limits<double>::infinity()};
      }
      continue;
    }
    std::vector<double> row = {difference.value};
    double power = 1;
    for (std::size_t order = 1; order <= last.size(); ++order) {
      power *= 4;
      const double change = (row[order - 1] - last[order - 1]) / (power - 1);
      row.push_back(row[order - 1] + change);
      const double off =
          std::max(std::abs(row[order] - row[order - 1]), std::abs(row[order] - last[order - 1]));
      const double bound = safety * off + most_weight * difference.error;
      if (row.size() > 2 && bound < best.bound) {
        best = {row[order], bound};
      }
    }
    last = std::move(row);
  }
  return best;
}

BoundedValue derivative(const SymmetricSamples& samples,
                        const std::function<Difference(double, double, double)>& difference) {
  std::vector<Difference> differences;
  double step = samples.first_step;
  for (std::size_t at = 0; at < samples.above.size(); ++at, step /= 2) {
    differences.push_back(difference(samples.above[at], samples.below[at], step));
  }
  return extrapolated(differences);
}

}  // namespace

BoundedValue first_derivative(const SymmetricSamples& samples) {
  return derivative(samples, [&](double above, double below, double step) {
    return Difference{(above - below) / (2 * step), samples.error / step};
  });
}

BoundedValue second_derivative(const SymmetricSamples& samples) {
  return derivative(samples, [&](double above, double below, double step) {
    return Difference{(above - 2 * samples.middle + below) / (step * step),
                      4 * samples.error / (step * step)};
  });
}

}  // namespace assur::generator::audit
