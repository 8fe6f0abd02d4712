// Tracking by MINPACK's hybrj: Powell's hybrid method with the Jacobian given.
#include <cminpack.h>

#include "tracking/tracking_methods.hpp"

namespace assur::speed {

namespace {

int evaluate(void* data, int, const double* theta, double* f, double* jacobian, int, int flag) {
  const auto& closure = *static_cast<const TrackingClosure*>(data);
  if (flag == 1) {
    closure.evaluate(theta, f);
  } else {
    Eigen::Map<Eigen::Matrix4d>(jacobian, 4, 4) = closure.jacobian(theta);
  }
  return 0;
}

}  // namespace

TrackingAnswer track_by_minpack(const TrackingSample& sample) {
  TrackingClosure closure(sample);
  Eigen::Vector4d theta = sample.theta;
  Eigen::Vector4d f;
  Eigen::Matrix4d jacobian;
  std::array<double, 4 * (4 + 13) / 2> work;
  const int status = hybrj1(evaluate, &closure, 4, theta.data(), f.data(), jacobian.data(), 4,
                            1e-14, work.data(), static_cast<int>(work.size()));
  // 1: converged; 3: the tolerance is below the rounding errors; 4: progress has become slow.
  if ((status != 1 && status != 3 && status != 4) || !(f.cwiseAbs().maxCoeff() < closed)) {
    return {true, {}};
  }
  return at_angles(theta.data());
}

}  // namespace assur::speed
