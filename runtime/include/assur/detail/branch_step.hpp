// Turns a point of a branch into the next, or into a refusal where that may be of another branch.
#pragma once

#include <algorithm>
#include <assur/branch_point.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
#include <assur/kinematics.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

/// Largest entry, NaN if there is one; lengths count by the size of the group.
template <typename Model>
[[nodiscard]] double turn_of(const Vector<double, Model::unknown_count>& step,
                             double inverse_size) {
  double largest = 0;
  for (int index = 0; index < Model::unknown_count; ++index) {
    const double turn = std::abs(step(index)) * (is_angle<Model>(index) ? 1 : inverse_size);
    if (turn > largest || std::isnan(turn)) {
      largest = turn;
    }
  }
  return largest;
}

/// A turn of at most 0.4 radians by the first terms of its sine and cosine. Their squares' sum is
/// off by at most 1e-5; normalising leaves the square of that, and after the next, small turn
/// nothing.
inline void turn_slightly(Direction<double>& direction, double angle) {
  const double square = angle * angle;
  const double cosine = 1 - square * (1.0 / 2 - square * (1.0 / 24));
  const double sine = angle * (1 - square * (1.0 / 6 - square * (1.0 / 120)));
  direction = normalised(turned(direction, {cosine, sine}));
}
inline void turn_slightly(double& length, double step) { length += step; }

template <typename Model>
void move_slightly(typename Model::template Configuration<double>& q,
                   const Vector<double, Model::unknown_count>& step) {
  for_each_member(q, [&step](auto& member, std::size_t index) {
    turn_slightly(member, step(static_cast<Eigen::Index>(index)));
  });
}

/// What a step may be for its end to be taken for the same branch.
struct StepLimits {
  double prediction = 0.4;       ///< of the way, radians
  double correction = 0.2;       ///< the first, of the prediction, radians
  double contraction = 0.3;      ///< of a correction to the one before
  double defect = 0.03;          ///< of the way against both ends' derivatives, radians
  double settled = 1e-7;         ///< the last correction; its square is left
  double nearly_settled = 2e-5;  ///< a correction whose inverse does for the last, too
  /// A step, as a part of the way asked for. The last step that is refused is at most two of these,
  /// and a branch has ended within twice that step wherever it was measured: within 0.2%.
  double shortest = 5e-4;
};

/// Moves a configuration as predicted and corrects it by Newton's steps; `way` is all that it has
/// moved by then, `inverse` J^-1 before the last step. False where prediction or steps are too long
/// to stay on a branch.
template <typename Model>
[[nodiscard, gnu::always_inline]] inline bool predict_and_correct(
    const typename Model::template Dimensions<double>& d,
    const typename Model::template Inputs<double>& u, double inverse_size,
    const Vector<double, Model::unknown_count>& predicted,
    typename Model::template Configuration<double>& q, Vector<double, Model::unknown_count>& way,
    Matrix<double, Model::unknown_count, Model::equation_count>& inverse) {
  constexpr StepLimits limits;
  using Unknowns = Vector<double, Model::unknown_count>;
  if (!(turn_of<Model>(predicted, inverse_size) < limits.prediction)) {
    return false;
  }
  move_slightly<Model>(q, predicted);
  way = predicted;
  Vector<double, Model::equation_count> f;
  for (double limit = limits.correction;;) {
    Model::residual(d, u, q, f);
    Model::inverse_jacobian(d, u, q, inverse);
    const Unknowns step = -product(inverse, f);
    const double turn = turn_of<Model>(step, inverse_size);
    if (!(turn <= (std::max)(limit, limits.settled))) {
      return false;
    }
    move_slightly<Model>(q, step);
    way += step;
    if (turn <= limits.settled) {
      return true;
    }
    limit = limits.contraction * turn;
    if (turn <= limits.nearly_settled) {
      // The same inverse once more leaves of what it finds as much as it has found of this step.
      Model::residual(d, u, q, f);
      const Unknowns rest = -product(inverse, f);
      const double found = turn_of<Model>(rest, inverse_size);
      move_slightly<Model>(q, rest);
      way += rest;
      if (found * found <= limits.settled * limits.settled * turn) {
        return true;
      }
    }
  }
}

/// One step: predicted to second order, corrected by Newton's steps. False if anything speaks
/// against the end being of the same branch.
template <typename Model>
[[nodiscard]] bool step_along(const typename Model::template Dimensions<double>& d,
                              const InputMotion<Model>& inputs, double width, double inverse_size,
                              const BranchPoint<Model>& start, BranchPoint<Model>& end) {
  using Unknowns = Vector<double, Model::unknown_count>;
  const Unknowns predicted =
      width * start.motion.velocity + width * width / 2 * start.motion.acceleration;
  Unknowns way;
  Matrix<double, Model::unknown_count, Model::equation_count> inverse;
  end.q = start.q;
  if (!predict_and_correct<Model>(d, inputs.u, inverse_size, predicted, end.q, way, inverse)) {
    return false;
  }
  const Pivots<Model, double> pivots = pivots_at<Model, double>(d, inputs.u, end.q);
  end.status = regularity_of(pivots, derivative_rounding<double>()).status;
  end.orientation = orientation_of(pivots);
  if (!is_solvable(end.status) || end.orientation != start.orientation) {
    return false;
  }
  Model::motion(d, inputs.u, end.q, inputs.rate, inputs.second_rate, end.motion.velocity,
                end.motion.acceleration);
  const Unknowns defect =
      way - width / 2 * (start.motion.velocity + end.motion.velocity) -
      width * width * (1.0 / 12) * (start.motion.acceleration - end.motion.acceleration);
  return turn_of<Model>(defect, inverse_size) <= StepLimits().defect;
}

}  // namespace assur::detail
