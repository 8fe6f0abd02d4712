// Turns a configuration of moving inputs into that of the same branch a step further on.
#pragma once

#include <assur/kinematics.hpp>
#include <cmath>

namespace assur {

/// Where a model's inputs are and how they move with a parameter.
template <typename Model>
struct InputMotion {
  typename Model::template Inputs<double> u;
  Vector<double, Model::input_count> rate;
  Vector<double, Model::input_count> second_rate;
};

/// A point of a branch: a configuration and its derivatives to the parameter.
template <typename Model>
struct BranchPoint {
  typename Model::template Configuration<double> q;
  Motion<Model, double> motion;
  int orientation = 0;  ///< the sign of det J, which a branch keeps and those it may meet have not
};

namespace detail {

/// The sign of det J by the pivots of its elimination; zero only where one vanishes.
template <typename Model>
[[nodiscard]] int orientation(const typename Model::template Dimensions<double>& d,
                              const typename Model::template Inputs<double>& u,
                              const typename Model::template Configuration<double>& q) {
  Vector<double, Model::pivot_count> pivots;
  Vector<double, Model::pivot_count> sizes;
  double terms = 0;
  Model::degeneracies(d, u, q, pivots, sizes, terms);
  int sign = Model::determinant_sign;
  for (const double pivot : pivots) {
    sign *= (pivot > 0 ? 1 : 0) - (pivot < 0 ? 1 : 0);
  }
  return sign;
}

/// Largest entry; lengths count by the size of the group.
template <typename Model>
[[nodiscard]] double turn_of(const Vector<double, Model::unknown_count>& step,
                             double inverse_size) {
  double largest = 0;
  for (int index = 0; index < Model::unknown_count; ++index) {
    const bool is_angle = Model::unknowns[static_cast<std::size_t>(index)].is_angle;
    largest = std::max(largest, std::abs(step(index)) * (is_angle ? 1 : inverse_size));
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
  std::apply(
      [&](auto&... member) {
        Eigen::Index index = 0;
        (turn_slightly(member, step(index++)), ...);
      },
      q.members());
}

}  // namespace detail

/// Where a branch begins: a configuration that `assemblies` found, with its derivatives.
template <typename Model>
[[nodiscard]] BranchPoint<Model> branch_point(
    const typename Model::template Dimensions<double>& d, const InputMotion<Model>& inputs,
    const typename Model::template Configuration<double>& q) {
  BranchPoint<Model> point;
  point.q = q;
  Model::motion(d, inputs.u, q, inputs.rate, inputs.second_rate, point.motion.velocity,
                point.motion.acceleration);
  point.orientation = detail::orientation<Model>(d, inputs.u, q);
  return point;
}

namespace detail {

/// What a step may be for its end to be taken for the same branch.
struct StepLimits {
  double prediction = 0.4;   ///< of the way, radians
  double correction = 0.2;   ///< the first, of the prediction, radians
  double contraction = 0.3;  ///< of a correction to the one before
  double defect = 0.03;      ///< of the way against both ends' derivatives, radians
  double settled = 1e-7;     ///< the last correction; its square is left
  double shortest = 2e-3;    ///< a step, as a part of the way asked for
};

/// One step: predicted to second order, corrected by Newton's steps. False if anything speaks
/// against the end being of the same branch.
template <typename Model>
[[nodiscard]] bool step_along(const typename Model::template Dimensions<double>& d,
                              const InputMotion<Model>& inputs, double width, double inverse_size,
                              const BranchPoint<Model>& start, BranchPoint<Model>& end) {
  constexpr StepLimits limits;
  using Unknowns = Vector<double, Model::unknown_count>;
  const Unknowns predicted =
      width * start.motion.velocity + width * width / 2 * start.motion.acceleration;
  if (!(turn_of<Model>(predicted, inverse_size) < limits.prediction)) {
    return false;
  }
  end.q = start.q;
  move_slightly<Model>(end.q, predicted);
  Unknowns way = predicted;
  double previous = 0;
  for (int correction = 0;; ++correction) {
    Vector<double, Model::equation_count> f;
    Matrix<double, Model::unknown_count, Model::equation_count> inverse;
    Model::residual(d, inputs.u, end.q, f);
    Model::inverse_jacobian(d, inputs.u, end.q, inverse);
    const Unknowns step = -(inverse * f);
    const double turn = turn_of<Model>(step, inverse_size);
    const double limit = correction == 0 ? limits.correction : limits.contraction * previous;
    if (!(turn <= std::max(limit, limits.settled))) {
      return false;
    }
    move_slightly<Model>(end.q, step);
    way += step;
    if (turn <= limits.settled) {
      break;
    }
    previous = turn;
  }
  end.orientation = orientation<Model>(d, inputs.u, end.q);
  if (end.orientation != start.orientation) {
    return false;
  }
  Model::motion(d, inputs.u, end.q, inputs.rate, inputs.second_rate, end.motion.velocity,
                end.motion.acceleration);
  const Unknowns defect =
      way - width / 2 * (start.motion.velocity + end.motion.velocity) -
      width * width * (1.0 / 12) * (start.motion.acceleration - end.motion.acceleration);
  return turn_of<Model>(defect, inverse_size) <= limits.defect;
}

}  // namespace detail

/// Follows a branch from one value of a parameter to another; `path(value)` gives the inputs'
/// motion. Steps are halved until prediction, correction and the derivatives at both ends agree.
/// ok: `point` is the branch's at `to`. no_convergence: within 0.2% of the way from `from`,
/// where `point` is then, the branch ends or comes too close to another; what follows is for
/// `assemblies` to say. A change to a branch that this one could meet would show in the sign of det
/// J; that other branches are far enough away is experience, not proof: docs/performance.md counts.
template <typename Model, typename Path>
[[nodiscard]] Status track(const typename Model::template Dimensions<double>& d, const Path& path,
                           double& from, double to, BranchPoint<Model>& point) {
  const double inverse_size = 1 / longest_length(d);
  const double shortest = std::abs(to - from) * detail::StepLimits().shortest;
  double width = to - from;
  bool halved = false;
  while (from != to) {
    const double next = std::abs(to - from) <= std::abs(width) ? to : from + width;
    BranchPoint<Model> end;
    if (detail::step_along<Model>(d, path(next), next - from, inverse_size, point, end)) {
      point = end;
      from = next;
      width = halved ? width : 2 * width;
      halved = false;
      continue;
    }
    width = (next - from) / 2;
    halved = true;
    if (!(std::abs(width) > shortest)) {
      return Status::no_convergence;
    }
  }
  return Status::ok;
}

}  // namespace assur
