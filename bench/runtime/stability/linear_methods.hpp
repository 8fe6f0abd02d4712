// Methods that take a configuration as given and solve linear equations for its derivatives.
#pragma once

#include <Eigen/LU>
#include <assur/special_points.hpp>

#include "problem.hpp"
#include "runtime/taylor.hpp"

namespace assur::stability {

template <typename Model>
[[nodiscard]] Answer<Model> generated(const Geometry<Model, double>& g) {
  Answer<Model> answer;
  answer.status = sensitivities<Model, double>(g.d, g.u, g.q, answer.sensitivities);
  if (is_solvable(answer.status)) {
    answer.status = motion<Model, double>(g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.motion);
  }
  return answer;
}

/// The generated Jacobian and right-hand sides, solved by one of Eigen's factorisations.
template <typename Model, template <typename...> typename Factorisation>
[[nodiscard]] Answer<Model> factored(const Geometry<Model, double>& g) {
  using Square = Matrix<double, Model::equation_count, Model::unknown_count>;
  Answer<Model> answer;
  Square jacobian;
  Model::jacobian(g.d, g.u, g.q, jacobian);
  const Factorisation<Square> factors(jacobian);
  Matrix<double, Model::equation_count, Model::dimension_count> by_dimensions;
  Matrix<double, Model::equation_count, Model::input_count> by_inputs;
  Model::dimension_jacobian(g.d, g.u, g.q, by_dimensions);
  Model::input_jacobian(g.d, g.u, g.q, by_inputs);
  answer.sensitivities.to_dimensions = factors.solve(-by_dimensions);
  answer.sensitivities.to_inputs = factors.solve(-by_inputs);
  Vector<double, Model::equation_count> rhs;
  Model::velocity_rhs(g.d, g.u, g.q, g.u_rate, rhs);
  answer.motion.velocity = factors.solve(rhs);
  Model::acceleration_rhs(g.d, g.u, g.q, answer.motion.velocity, g.u_rate, g.u_second_rate, rhs);
  answer.motion.acceleration = factors.solve(rhs);
  if constexpr (requires { factors.isInvertible(); }) {
    answer.status = factors.isInvertible() ? Status::ok : Status::singular;
  }
  return answer;
}
template <typename Model>
[[nodiscard]] Answer<Model> partial_pivot_lu(const Geometry<Model, double>& g) {
  return factored<Model, Eigen::PartialPivLU>(g);
}
template <typename Model>
[[nodiscard]] Answer<Model> full_pivot_lu(const Geometry<Model, double>& g) {
  return factored<Model, Eigen::FullPivLU>(g);
}

/// Forward automatic differentiation of the residual to second order, then partial pivoting.
template <typename Model>
class AutomaticDifferentiation {
  using Moving = test::Taylor<double>;
  using Unknowns = Vector<double, Model::unknown_count>;
  using Lengths = Vector<double, Model::dimension_count>;
  using Ends = Vector<double, Model::input_count>;
  using Residual = Vector<Moving, Model::equation_count>;

 public:
  [[nodiscard]] static Answer<Model> answer(const Geometry<Model, double>& g) {
    using Square = Matrix<double, Model::equation_count, Model::unknown_count>;
    Answer<Model> result;
    const Unknowns rest = Unknowns::Zero();
    const Lengths fixed = Lengths::Zero();
    const Ends held = Ends::Zero();
    Square jacobian;
    for (int column = 0; column < Model::unknown_count; ++column) {
      first(residual(g, Unknowns::Unit(column), fixed, held, held), jacobian, column);
    }
    const Eigen::PartialPivLU<Square> factors(jacobian);
    Matrix<double, Model::equation_count, Model::dimension_count> by_dimensions;
    for (int column = 0; column < Model::dimension_count; ++column) {
      first(residual(g, rest, Lengths::Unit(column), held, held), by_dimensions, column);
    }
    Matrix<double, Model::equation_count, Model::input_count> by_inputs;
    for (int column = 0; column < Model::input_count; ++column) {
      first(residual(g, rest, fixed, Ends::Unit(column), held), by_inputs, column);
    }
    result.sensitivities.to_dimensions = factors.solve(-by_dimensions);
    result.sensitivities.to_inputs = factors.solve(-by_inputs);
    Vector<double, Model::equation_count> rhs;
    first(residual(g, rest, fixed, g.u_rate, held), rhs, 0);
    result.motion.velocity = factors.solve(-rhs);
    const Residual f = residual(g, result.motion.velocity, fixed, g.u_rate, g.u_second_rate);
    for (int row = 0; row < Model::equation_count; ++row) {
      rhs(row) = -2 * f(row).c2;
    }
    result.motion.acceleration = factors.solve(rhs);
    return result;
  }

 private:
  static Residual residual(const Geometry<Model, double>& g, const Unknowns& q_rate,
                           const Lengths& d_rate, const Ends& u_rate, const Ends& u_second_rate) {
    using test::all_moving;
    using test::Rates;
    const Unknowns rest = Unknowns::Zero();
    const Lengths fixed = Lengths::Zero();
    const Ends held = Ends::Zero();
    Residual f;
    Model::residual(all_moving<typename Model::template Dimensions<Moving>>(
                        g.d, Rates<Lengths>{d_rate, fixed, fixed}),
                    all_moving<typename Model::template Inputs<Moving>>(
                        g.u, Rates<Ends>{u_rate, u_second_rate, held}),
                    all_moving<typename Model::template Configuration<Moving>>(
                        g.q, Rates<Unknowns>{q_rate, rest, rest}),
                    f);
    return f;
  }
  template <typename Derived>
  static void first(const Residual& f, Derived& to, int column) {
    for (int row = 0; row < Model::equation_count; ++row) {
      to(row, column) = f(row).c1;
    }
  }
};
template <typename Model>
[[nodiscard]] Answer<Model> automatic_differentiation(const Geometry<Model, double>& g) {
  return AutomaticDifferentiation<Model>::answer(g);
}

/// The two special Assur points; velocity and acceleration only.
template <typename Model>
[[nodiscard]] Answer<Model> special_points(const Geometry<Model, double>& g) {
  Answer<Model> answer;
  answer.has_sensitivities = false;
  answer.status =
      special_point_motion<Model, double>(g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.motion);
  return answer;
}

}  // namespace assur::stability
