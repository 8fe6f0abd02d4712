#include "emission/scene/specialised_sensitivities.hpp"

#include <string>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The derivatives with respect to the inputs of the solver's group.
std::vector<program::Result> input_columns(const SpecialisedNumbers& numbers,
                                           const std::string& target,
                                           const derivatives::ExpressionMatrix& of_dimensions,
                                           const derivatives::ExpressionMatrix& of_inputs) {
  std::vector<program::Result> results;
  for (std::size_t row = 0; row < of_inputs.size(); ++row) {
    std::size_t place = 0;
    const auto add = [&](const std::vector<GiNaC::ex>& partials, const auto& known) {
      for (std::size_t column = 0; column < partials.size(); ++column) {
        if (!known[column]) {
          results.push_back({program::entry(target, row, place++), partials[column]});
        }
      }
    };
    add(of_inputs[row], numbers.inputs);
    add(of_dimensions[row], numbers.dimensions);
  }
  return results;
}

/// of_dimensions dd/da + of_inputs du/da, for the dimensions d and inputs u that are numbers.
std::vector<program::Result> parameter_columns(const SpecialisedNumbers& numbers,
                                               const std::string& target,
                                               const derivatives::ExpressionMatrix& of_dimensions,
                                               const derivatives::ExpressionMatrix& of_inputs) {
  std::vector<program::Result> results;
  for (std::size_t row = 0; row < of_dimensions.size(); ++row) {
    for (Eigen::Index parameter = 0; parameter < numbers.dimension_gradient.cols(); ++parameter) {
      GiNaC::ex sum;
      const auto add = [&](const std::vector<GiNaC::ex>& partials,
                           const Eigen::MatrixXd& gradient) {
        Eigen::Index row_of_gradient = 0;
        for (const GiNaC::ex& by_variable : partials) {
          sum += by_variable * cpp::exact(gradient(row_of_gradient++, parameter));
        }
      };
      add(of_dimensions[row], numbers.dimension_gradient);
      add(of_inputs[row], numbers.input_gradient);
      results.push_back({program::entry(target, row, static_cast<std::size_t>(parameter)), sum});
    }
  }
  return results;
}

}  // namespace

std::vector<model::ModelFunction> sensitivity_functions(
    const SpecialisedNumbers& numbers, const derivatives::Derivatives& derivatives) {
  const std::vector<model::Parameter> place = {{"const Inputs<Scalar>&", "u"},
                                               {"const Configuration<Scalar>&", "q"}};
  const std::string columns = "parameter_count";
  std::vector<model::ModelFunction> functions = {
      {"parameter_jacobian",
       {"F_a = df/da by the scene's parameters a, through the dimensions and the ground."},
       place,
       {{"Matrix<Scalar, equation_count, " + columns + ">&", "F_a"}},
       parameter_columns(numbers, "F_a", derivatives.dimension_jacobian,
                         derivatives.input_jacobian)},
      {"input_jacobian",
       {"F_u = df/du; the sensitivities solve J dq/da = -(F_a + F_u du/da)."},
       place,
       {{"Matrix<Scalar, equation_count, input_count>&", "F_u"}},
       input_columns(numbers, "F_u", derivatives.dimension_jacobian, derivatives.input_jacobian)},
      {"pose_jacobians",
       {"Partial derivatives of the link frames p, rows (x, y, theta) link by link:",
        "P_q = dp/dq, P_a = dp/da, P_u = dp/du, each with the other two held."},
       place,
       {{"Matrix<Scalar, 3 * link_count, unknown_count>&", "P_q"},
        {"Matrix<Scalar, 3 * link_count, " + columns + ">&", "P_a"},
        {"Matrix<Scalar, 3 * link_count, input_count>&", "P_u"}},
       parameter_columns(numbers, "P_a", derivatives.pose_dimension_jacobian,
                         derivatives.pose_input_jacobian)}};
  std::vector<program::Result>& poses = functions.back().results;
  const std::vector<program::Result> inputs = input_columns(
      numbers, "P_u", derivatives.pose_dimension_jacobian, derivatives.pose_input_jacobian);
  poses.insert(poses.end(), inputs.begin(), inputs.end());
  for (std::size_t row = 0; row < derivatives.pose_unknown_jacobian.size(); ++row) {
    for (std::size_t column = 0; column < derivatives.pose_unknown_jacobian[row].size(); ++column) {
      poses.push_back(
          {program::entry("P_q", row, column), derivatives.pose_unknown_jacobian[row][column]});
    }
  }
  return functions;
}

}  // namespace assur::generator::emission::scene
