// Whether roots that the root finder leaves undecided really are beyond the given precision.
#pragma once

#include <algorithm>
#include <assur/numeric/trigonometric_roots.hpp>
#include <cmath>

namespace assur::test {

/// |T| where clusters of roots were reported, in units of the error that T has there. Roots that
/// are left together although T rises well above its error between them give a large number. -1 if
/// nothing was left undecided.
template <typename Scalar, std::size_t Degree>
double largest_cluster_value(const TrigonometricPolynomial<Scalar, Degree>& T,
                             Scalar coefficient_error) {
  const auto found = numeric::trigonometric_roots<Scalar, Degree>(T, coefficient_error);
  Scalar sum = numeric::magnitude(T.cosine[0]);
  for (std::size_t k = 1; k <= Degree; ++k) {
    sum += numeric::magnitude(T.cosine[k]) + numeric::magnitude(T.sine[k]);
  }
  const auto error = numeric::transform_error<Scalar, Degree>(coefficient_error, sum);
  double worst = -1;
  for (std::size_t cluster = 0; cluster < found.cluster_count; ++cluster) {
    const double angle = found.clusters[cluster].angle;
    const Direction<Scalar> x =
        normalised(Direction<Scalar>{Scalar(std::cos(angle)), Scalar(std::sin(angle))});
    Direction<Scalar> multiple = x;
    Scalar value = T.cosine[0];
    for (std::size_t k = 1; k <= Degree; ++k) {
      value += T.cosine[k] * multiple.cos + T.sine[k] * multiple.sin;
      multiple = turned(multiple, x);
    }
    worst = std::max(worst, std::abs(static_cast<double>(value / error)));
  }
  return worst;
}

}  // namespace assur::test
