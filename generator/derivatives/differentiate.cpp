#include "derivatives/differentiate.hpp"

#include <functional>

namespace assur::generator::derivatives {

namespace {

using equations::VariableList;

VariableList listed(const std::deque<equations::Variable>& variables) {
  VariableList list;
  for (const equations::Variable& variable : variables) {
    list.push_back(&variable);
  }
  return list;
}

VariableList joined(const std::deque<equations::Variable>& first,
                    const std::deque<equations::Variable>& second) {
  VariableList list = listed(first);
  for (const equations::Variable& variable : second) {
    list.push_back(&variable);
  }
  return list;
}

VariableList with_dimensions(VariableList variables,
                             const equations::ImplicitEquations& equations) {
  for (const equations::Variable& dimension : equations.dimensions) {
    variables.push_back(&dimension);
  }
  return variables;
}

ExpressionMatrix jacobian_of(const std::vector<GiNaC::ex>& functions,
                             const std::deque<equations::Variable>& variables,
                             const equations::Vocabulary& vocabulary) {
  ExpressionMatrix matrix;
  for (const GiNaC::ex& function : functions) {
    matrix.push_back(vocabulary.gradient(function, listed(variables)));
  }
  return matrix;
}

/// The derivative of a function along the variables' rates of one order, not expanded.
GiNaC::ex along(GiNaC::symbol equations::Variable::*rate, const GiNaC::ex& function,
                const VariableList& variables, const equations::Vocabulary& vocabulary) {
  const std::vector<GiNaC::ex> gradient = vocabulary.gradient(function, variables);
  GiNaC::ex total;
  for (std::size_t index = 0; index < variables.size(); ++index) {
    total += gradient[index] * variables[index]->*rate;
  }
  return total;
}

/// d(function)/dt along the rates of the variables.
GiNaC::ex time_derivative(const GiNaC::ex& function, const VariableList& variables,
                          const equations::Vocabulary& vocabulary) {
  return along(&equations::Variable::rate, function, variables, vocabulary).expand();
}

/// The part of d(function)/dt due to second rates, for a function of the variables and their rates.
GiNaC::ex along_second_rates(const GiNaC::ex& function, const VariableList& variables) {
  GiNaC::ex total;
  for (const equations::Variable* variable : variables) {
    total += function.diff(variable->rate) * variable->second_rate;
  }
  return total;
}

/// d(function)/dt of a function of the variables, and the part of d2(function)/dt2 that depends
/// only on first rates.
struct TimeDerivatives {
  GiNaC::ex first;
  GiNaC::ex second_of_rates;
};

TimeDerivatives time_derivatives(const GiNaC::ex& function, const VariableList& moving,
                                 const equations::Vocabulary& vocabulary) {
  const GiNaC::ex first = time_derivative(function, moving, vocabulary);
  return {first, time_derivative(first, moving, vocabulary)};
}

/// d2(function)/dt2, where only `accelerated` variables have second rates.
GiNaC::ex second_time_derivative(const GiNaC::ex& function, const TimeDerivatives& derivatives,
                                 const VariableList& accelerated,
                                 const equations::Vocabulary& vocabulary) {
  return (derivatives.second_of_rates +
          along(&equations::Variable::second_rate, function, accelerated, vocabulary))
      .expand();
}

/// d3(function)/dt3, where only `jerked` variables have third rates.
GiNaC::ex third_time_derivative(const GiNaC::ex& function, const TimeDerivatives& derivatives,
                                const VariableList& moving, const VariableList& jerked,
                                const equations::Vocabulary& vocabulary) {
  const GiNaC::ex second =
      (derivatives.second_of_rates + along_second_rates(derivatives.first, moving)).expand();
  return (time_derivative(second, moving, vocabulary) + along_second_rates(second, moving) +
          along(&equations::Variable::third_rate, function, jerked, vocabulary))
      .expand();
}

/// Derivatives of (x, y, theta) of every link, by one rule for expressions and one for angles.
ExpressionMatrix over_poses(const equations::ClosureEquations& equations,
                            const std::function<GiNaC::ex(const GiNaC::ex&)>& of_coordinate,
                            const std::function<GiNaC::ex(const equations::AngleSum&)>& of_angle) {
  ExpressionMatrix rows;
  for (const equations::LinkPose& pose : equations.poses) {
    rows.push_back(
        {of_coordinate(pose.origin.x), of_coordinate(pose.origin.y), of_angle(pose.angle)});
  }
  return rows;
}

ExpressionMatrix pose_jacobian(const equations::ClosureEquations& equations,
                               const std::deque<equations::Variable>& variables) {
  ExpressionMatrix matrix;
  for (const equations::LinkPose& pose : equations.poses) {
    for (const GiNaC::ex& coordinate : {pose.origin.x, pose.origin.y}) {
      matrix.push_back(equations.vocabulary.gradient(coordinate, listed(variables)));
    }
    std::vector<GiNaC::ex>& row = matrix.emplace_back();
    for (const equations::Variable& variable : variables) {
      row.emplace_back(pose.angle.factor(variable));
    }
  }
  return matrix;
}

}  // namespace

ExpressionMatrix closure_jacobian(const equations::ImplicitEquations& equations) {
  return jacobian_of(equations.residuals, equations.unknowns, equations.vocabulary);
}

ResidualDerivatives differentiate_residuals(const equations::ImplicitEquations& equations) {
  const equations::Vocabulary& vocabulary = equations.vocabulary;
  const std::vector<GiNaC::ex>& residuals = equations.residuals;
  const VariableList inputs = listed(equations.inputs);
  const VariableList moving = joined(equations.unknowns, equations.inputs);
  const VariableList everything = with_dimensions(moving, equations);

  ResidualDerivatives result;
  result.jacobian = closure_jacobian(equations);
  result.dimension_jacobian = jacobian_of(residuals, equations.dimensions, vocabulary);
  result.input_jacobian = jacobian_of(residuals, equations.inputs, vocabulary);
  for (const GiNaC::ex& residual : residuals) {
    result.velocity_rhs.push_back(-time_derivative(residual, inputs, vocabulary));
    const TimeDerivatives derivatives = time_derivatives(residual, moving, vocabulary);
    result.acceleration_rhs.push_back(
        -second_time_derivative(residual, derivatives, inputs, vocabulary));
    result.jerk_rhs.push_back(
        -third_time_derivative(residual, derivatives, moving, inputs, vocabulary));
    result.curvature_rhs.push_back(
        -time_derivatives(residual, everything, vocabulary).second_of_rates);
  }
  return result;
}

Derivatives differentiate(const equations::ClosureEquations& equations) {
  const equations::Vocabulary& vocabulary = equations.vocabulary;
  const VariableList moving = joined(equations.unknowns, equations.inputs);
  const VariableList everything = with_dimensions(moving, equations);

  Derivatives result{differentiate_residuals(equations), {}, {}, {}, {}, {}, {}};
  result.pose_unknown_jacobian = pose_jacobian(equations, equations.unknowns);
  result.pose_dimension_jacobian = pose_jacobian(equations, equations.dimensions);
  result.pose_input_jacobian = pose_jacobian(equations, equations.inputs);
  const auto angle_rate = [&](const equations::AngleSum& angle, auto rate) {
    GiNaC::ex total;
    for (const equations::Variable* variable : moving) {
      total += angle.factor(*variable) * rate(*variable);
    }
    return total;
  };
  result.pose_velocity = over_poses(
      equations,
      [&](const GiNaC::ex& coordinate) { return time_derivative(coordinate, moving, vocabulary); },
      [&](const equations::AngleSum& angle) {
        return angle_rate(angle, [](const equations::Variable& variable) { return variable.rate; });
      });
  result.pose_acceleration = over_poses(
      equations,
      [&](const GiNaC::ex& coordinate) {
        return second_time_derivative(coordinate, time_derivatives(coordinate, moving, vocabulary),
                                      moving, vocabulary);
      },
      [&](const equations::AngleSum& angle) {
        return angle_rate(angle,
                          [](const equations::Variable& variable) { return variable.second_rate; });
      });
  result.pose_curvature = over_poses(
      equations,
      [&](const GiNaC::ex& coordinate) {
        return time_derivatives(coordinate, everything, vocabulary).second_of_rates;
      },
      [](const equations::AngleSum& /*angle*/) { return GiNaC::ex(0); });
  return result;
}

}  // namespace assur::generator::derivatives
