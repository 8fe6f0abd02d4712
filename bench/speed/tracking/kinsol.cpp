// Tracking by SUNDIALS' KINSOL: Newton's method with the Jacobian given and its dense solver.
#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "tracking/tracking_methods.hpp"

namespace assur::speed {

namespace {

int residual(N_Vector theta, N_Vector f, void* data) {
  static_cast<const TrackingClosure*>(data)->evaluate(NV_DATA_S(theta), NV_DATA_S(f));
  return 0;
}

int jacobian(N_Vector theta, N_Vector, SUNMatrix J, void* data, N_Vector, N_Vector) {
  Eigen::Map<Eigen::Matrix4d>(SUNDenseMatrix_Data(J)) =
      static_cast<const TrackingClosure*>(data)->jacobian(NV_DATA_S(theta));
  return 0;
}

/// Memory, matrix and solver are made once, as the examples of SUNDIALS do for many solves.
class Solver {
 public:
  Solver() {
    SUNContext_Create(nullptr, &context_);
    theta_ = N_VNew_Serial(4, context_);
    scale_ = N_VNew_Serial(4, context_);
    N_VConst(1, scale_);
    matrix_ = SUNDenseMatrix(4, 4, context_);
    linear_ = SUNLinSol_Dense(theta_, matrix_, context_);
    memory_ = KINCreate(context_);
    KINInit(memory_, residual, theta_);
    KINSetLinearSolver(memory_, linear_, matrix_);
    KINSetJacFn(memory_, jacobian);
    KINSetFuncNormTol(memory_, 1e-13);
    KINSetScaledStepTol(memory_, 1e-14);
    KINSetMaxSetupCalls(memory_, 1);  // one Jacobian per iteration: faster here than the default
    KINSetNumMaxIters(memory_, 50);
    KINSetPrintLevel(memory_, 0);
    KINSetErrHandlerFn(
        memory_, [](int, const char*, const char*, char*, void*) {}, nullptr);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    KINFree(&memory_);
    SUNLinSolFree(linear_);
    SUNMatDestroy(matrix_);
    N_VDestroy(scale_);
    N_VDestroy(theta_);
    SUNContext_Free(&context_);
  }

  [[nodiscard]] TrackingAnswer follow(const TrackingSample& sample) {
    TrackingClosure closure(sample);
    KINSetUserData(memory_, &closure);
    double* theta = NV_DATA_S(theta_);
    std::copy(sample.theta.begin(), sample.theta.end(), theta);
    const int status = KINSol(memory_, theta_, KIN_NONE, scale_, scale_);
    Eigen::Vector4d f;
    closure.evaluate(theta, f.data());
    if (status < 0 || !(f.cwiseAbs().maxCoeff() < closed)) {
      return {true, {}};
    }
    return at_angles(theta);
  }

 private:
  SUNContext context_ = nullptr;
  N_Vector theta_ = nullptr;
  N_Vector scale_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  void* memory_ = nullptr;
};

}  // namespace

TrackingAnswer track_by_kinsol(const TrackingSample& sample) {
  static Solver solver;
  return solver.follow(sample);
}

}  // namespace assur::speed
