// Error of a motion relative to the terms of its sums.
#pragma once

#include <assur/kinematics.hpp>

#include "largest.hpp"
#include "runtime/exact_assembly.hpp"

namespace assur::test {

/// The largest error of the rates, each weighted by the largest entry of its column of J. It is
/// relative to the largest term of J q' = -F_u u', or of its time derivative with the centripetal
/// terms: where large terms cancel, only their digits can be right. The worse of velocity and
/// acceleration.
template <typename Model>
[[nodiscard]] double relative_error(const Assembly<Model, double>& at,
                                    const Vector<double, Model::input_count>& u1,
                                    const Vector<double, Model::input_count>& u2,
                                    const Motion<Model, double>& found,
                                    const Motion<Model, long double>& truth) {
  using Rates = Vector<long double, Model::unknown_count>;
  Matrix<double, Model::equation_count, Model::unknown_count> f_q;
  Matrix<double, Model::equation_count, Model::input_count> f_u;
  Model::jacobian(at.d, at.u, at.q, f_q);
  Model::input_jacobian(at.d, at.u, at.q, f_u);
  const Rates weight = f_q.cwiseAbs().colwise().maxCoeff().transpose().template cast<long double>();
  const auto size = [](const auto& vector) -> long double { return vector.cwiseAbs().maxCoeff(); };
  const auto input_size = [&](const Vector<double, Model::input_count>& rates) -> long double {
    return (f_u * rates.asDiagonal()).cwiseAbs().maxCoeff();
  };
  const auto error = [&](const Vector<double, Model::unknown_count>& value, const Rates& exact) {
    const Rates difference = value.template cast<long double>() - exact;
    return size(difference.cwiseProduct(weight));
  };
  const long double velocity_terms =
      std::max(size(truth.velocity.cwiseProduct(weight)), input_size(u1));
  const long double acceleration_terms =
      std::max({size(truth.acceleration.cwiseProduct(weight)), input_size(u2),
                size(truth.velocity.cwiseAbs2().cwiseProduct(weight))});
  return static_cast<double>(
      largest(error(found.velocity, truth.velocity) / velocity_terms,
              error(found.acceleration, truth.acceleration) / acceleration_terms));
}

}  // namespace assur::test
