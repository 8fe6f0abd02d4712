// Tracking by the GNU Scientific Library's hybridsj, its scaled hybrid method with the Jacobian
// given.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multiroots.h>

#include "tracking/tracking_methods.hpp"

namespace assur::speed {

namespace {

int residual(const gsl_vector* theta, void* data, gsl_vector* f) {
  static_cast<const TrackingClosure*>(data)->evaluate(theta->data, f->data);
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* theta, void* data, gsl_matrix* J) {
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(J->data) = static_cast<const TrackingClosure*>(data)->jacobian(theta->data);
  return GSL_SUCCESS;
}

int both(const gsl_vector* theta, void* data, gsl_vector* f, gsl_matrix* J) {
  residual(theta, data, f);
  return jacobian(theta, data, J);
}

/// The workspace, made once.
gsl_multiroot_fdfsolver* solver() {
  static gsl_multiroot_fdfsolver* made = [] {
    gsl_set_error_handler_off();
    return gsl_multiroot_fdfsolver_alloc(gsl_multiroot_fdfsolver_hybridsj, 4);
  }();
  return made;
}

}  // namespace

TrackingAnswer track_by_gsl(const TrackingSample& sample) {
  TrackingClosure closure(sample);
  gsl_multiroot_function_fdf system = {residual, jacobian, both, 4, &closure};
  const gsl_vector_const_view start = gsl_vector_const_view_array(sample.theta.data(), 4);
  gsl_multiroot_fdfsolver* workspace = solver();
  gsl_multiroot_fdfsolver_set(workspace, &system, &start.vector);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const int status = gsl_multiroot_fdfsolver_iterate(workspace);
    if (gsl_multiroot_test_residual(workspace->f, 1e-13) == GSL_SUCCESS) {
      return at_angles(workspace->x->data);
    }
    if (status != GSL_SUCCESS) {
      break;
    }
  }
  if (gsl_multiroot_test_residual(workspace->f, closed) == GSL_SUCCESS) {
    return at_angles(workspace->x->data);
  }
  return {true, {}};
}

}  // namespace assur::speed
