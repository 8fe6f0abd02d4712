// Relative errors of the answers to the derivative tasks.
#pragma once

#include "derivatives/tetrad_samples.hpp"

namespace assur::speed {

/// J alone.
template <typename Scalar>
struct JacobianAnswer {
  Matrix<Scalar, 4, 4> by_unknowns;
};

/// J and the derivatives with respect to dimensions and inputs.
template <typename Scalar>
struct ClosureAnswer {
  Matrix<Scalar, 4, 4> by_unknowns;
  Matrix<Scalar, 4, 8> by_dimensions;
  Matrix<Scalar, 4, 4> by_inputs;
};

template <typename Scalar>
struct MotionAnswer {
  Motion<Model01, Scalar> motion;
  Status status = Status::ok;
};

/// All sensitivities, velocity and acceleration.
template <typename Scalar>
struct DerivativesAnswer {
  Sensitivities<Model01, Scalar> sensitivities;
  Motion<Model01, Scalar> motion;
  Status status = Status::ok;
};

/// max |x - truth| / max |truth|, infinite if any number is not finite.
template <typename Computed, typename True>
[[nodiscard]] double relative_error(const Computed& computed, const True& truth) {
  Precise difference(0);
  Precise size(0);
  for (Eigen::Index column = 0; column < truth.cols(); ++column) {
    for (Eigen::Index row = 0; row < truth.rows(); ++row) {
      if (!std::isfinite(computed(row, column))) {
        return std::numeric_limits<double>::infinity();
      }
      const Precise& exact = truth(row, column);
      const Precise off = abs(precise(computed(row, column)) - exact);
      difference = off > difference ? off : difference;
      size = abs(exact) > size ? abs(exact) : size;
    }
  }
  return cln::double_approx(difference / size);
}

/// The largest over the columns, each relative to its own size.
template <typename Computed, typename True>
[[nodiscard]] double column_error(const Computed& computed, const True& truth) {
  double worst = 0;
  for (Eigen::Index column = 0; column < truth.cols(); ++column) {
    worst = std::max(worst, relative_error(computed.col(column), truth.col(column)));
  }
  return worst;
}

template <typename Scalar>
[[nodiscard]] double error_of(const JacobianAnswer<Scalar>& answer, const TetradTruth& truth) {
  return relative_error(answer.by_unknowns, truth.by_unknowns);
}
template <typename Scalar>
[[nodiscard]] double error_of(const ClosureAnswer<Scalar>& answer, const TetradTruth& truth) {
  const auto& F = truth.by_dimensions_and_inputs;
  return std::max({relative_error(answer.by_unknowns, truth.by_unknowns),
                   relative_error(answer.by_dimensions, F.leftCols<8>()),
                   relative_error(answer.by_inputs, F.rightCols<4>())});
}
template <typename Scalar>
[[nodiscard]] double error_of(const MotionAnswer<Scalar>& answer, const TetradTruth& truth) {
  if (!is_solvable(answer.status)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(relative_error(answer.motion.velocity, truth.velocity),
                  relative_error(answer.motion.acceleration, truth.acceleration));
}
template <typename Scalar>
[[nodiscard]] double error_of(const DerivativesAnswer<Scalar>& answer, const TetradTruth& truth) {
  if (!is_solvable(answer.status)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(
      {column_error(answer.sensitivities.to_dimensions, truth.sensitivities.leftCols<8>()),
       column_error(answer.sensitivities.to_inputs, truth.sensitivities.rightCols<4>()),
       relative_error(answer.motion.velocity, truth.velocity),
       relative_error(answer.motion.acceleration, truth.acceleration)});
}

}  // namespace assur::speed
