// Input and answer of a tracking method, and the closures in the form that the peers take.
#pragma once

#include "derivatives/eigen_by_hand.hpp"
#include "tracking/tracking_samples.hpp"

namespace assur::speed {

/// A configuration, or empty with a report that there is none.
struct TrackingAnswer {
  bool reported = false;
  Model01::Configuration<double> q;
};

/// f(theta) and J(theta) at the end of the step.
class TrackingClosure {
 public:
  explicit TrackingClosure(const TrackingSample& sample)
      : d_(sample.d), u_(sample.at(sample.to).u) {}

  void evaluate(const double* theta, double* f) const {
    Eigen::Map<Eigen::Vector4d>(f, 4) = vectors(theta).closure(u_);
  }
  [[nodiscard]] Eigen::Matrix4d jacobian(const double* theta) const {
    return vectors(theta).jacobian();
  }
  [[nodiscard]] HandVectors vectors(const double* theta) const {
    Eigen::Vector4d c;
    Eigen::Vector4d s;
    for (int index = 0; index < 4; ++index) {
      c(index) = std::cos(theta[index]);
      s(index) = std::sin(theta[index]);
    }
    return {d_, c, s};
  }
  [[nodiscard]] const Model01::Inputs<double>& inputs() const { return u_; }

 private:
  const Model01::Dimensions<double>& d_;
  Model01::Inputs<double> u_;
};

[[nodiscard]] inline TrackingAnswer at_angles(const double* theta) {
  return {false,
          {direction_of(theta[0]), direction_of(theta[1]), direction_of(theta[2]),
           direction_of(theta[3])}};
}

/// A residual above this is not a solution, whatever the solver reports.
inline constexpr double closed = 1e-10;

[[nodiscard]] TrackingAnswer track_by_kinsol(const TrackingSample& sample);
[[nodiscard]] TrackingAnswer track_by_gsl(const TrackingSample& sample);
[[nodiscard]] TrackingAnswer track_by_minpack(const TrackingSample& sample);
[[nodiscard]] TrackingAnswer track_by_solvespace(const TrackingSample& sample);

}  // namespace assur::speed
