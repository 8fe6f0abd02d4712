#include "emission/model/model_functions.hpp"

#include <set>
#include <utility>

namespace assur::generator::emission::model {

namespace {

void append(std::vector<program::Result>& results, const std::string& target,
            const std::vector<GiNaC::ex>& vector) {
  for (std::size_t row = 0; row < vector.size(); ++row) {
    results.push_back({program::entry(target, row), vector[row]});
  }
}

void append(std::vector<program::Result>& results, const std::string& target,
            const derivatives::ExpressionMatrix& matrix) {
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    for (std::size_t column = 0; column < matrix[row].size(); ++column) {
      results.push_back({program::entry(target, row, column), matrix[row][column]});
    }
  }
}

template <typename Values>
std::vector<program::Result> results_of(const std::string& target, const Values& values) {
  std::vector<program::Result> results;
  append(results, target, values);
  return results;
}

/// Parameters of functions: the point of evaluation, and rates.
struct FunctionParameters {
  Parameter dimensions{"const Dimensions<Scalar>&", "d"};
  Parameter inputs{"const Inputs<Scalar>&", "u"};
  Parameter configuration{"const Configuration<Scalar>&", "q"};
  Parameter rates{"const Vector<Scalar, unknown_count>&", "q_rate"};
  Parameter second_rates{"const Vector<Scalar, unknown_count>&", "q_second_rate"};
  Parameter input_rates{"const Vector<Scalar, input_count>&", "u_rate"};
  Parameter input_second_rates{"const Vector<Scalar, input_count>&", "u_second_rate"};
  Parameter input_third_rates{"const Vector<Scalar, input_count>&", "u_third_rate"};
  Parameter dimension_rates{"const Vector<Scalar, dimension_count>&", "d_rate"};

  [[nodiscard]] std::vector<Parameter> place() const { return {dimensions, inputs, configuration}; }
  [[nodiscard]] std::vector<Parameter> place_with(const std::vector<Parameter>& more) const {
    std::vector<Parameter> list = place();
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }
};

}  // namespace

void add_frame(std::size_t place, const equations::LinkPose& pose, bool has_origin,
               std::vector<program::Result>& results) {
  const std::string frame = "[" + std::to_string(place) + "]";
  if (has_origin) {
    results.push_back({{"poses", frame + ".x"}, pose.origin.x});
    results.push_back({{"poses", frame + ".y"}, pose.origin.y});
  }
  results.push_back({{"poses", frame + ".direction.cos"}, pose.direction.x});
  results.push_back({{"poses", frame + ".direction.sin"}, pose.direction.y});
}

std::vector<equations::NamedQuantity> known_quantities(
    const equations::ImplicitEquations& equations,
    const std::vector<const equations::Vocabulary*>& vocabularies) {
  std::set<std::string> taken;
  for (const equations::Variable& unknown : equations.unknowns) {
    for (const GiNaC::symbol& rate : {unknown.rate, unknown.second_rate, unknown.third_rate}) {
      taken.insert(rate.get_name());
    }
  }
  std::vector<equations::NamedQuantity> known;
  for (const equations::Vocabulary* vocabulary : vocabularies) {
    for (const equations::NamedQuantity& quantity : vocabulary->quantities()) {
      if (taken.insert(quantity.symbol.get_name()).second) {
        known.push_back(quantity);
      }
    }
  }
  return known;
}

std::vector<ModelFunction> residual_functions(const equations::ImplicitEquations& equations,
                                              const derivatives::ResidualDerivatives& derivatives) {
  const FunctionParameters in;
  std::vector<ModelFunction> functions;
  functions.push_back({"residual",
                       {"f: " + equations.residuals_meaning + ", zero when assembled."},
                       in.place(),
                       {{"Vector<Scalar, equation_count>&", "f"}},
                       results_of("f", equations.residuals)});
  functions.push_back({"jacobian",
                       {"J = df/dq."},
                       in.place(),
                       {{"Matrix<Scalar, equation_count, unknown_count>&", "J"}},
                       results_of("J", derivatives.jacobian)});
  functions.push_back({"dimension_jacobian",
                       {"F_d = df/dd; the sensitivities solve J dq/dd = -F_d."},
                       in.place(),
                       {{"Matrix<Scalar, equation_count, dimension_count>&", "F_d"}},
                       results_of("F_d", derivatives.dimension_jacobian)});
  functions.push_back({"input_jacobian",
                       {"F_u = df/du; the sensitivities solve J dq/du = -F_u."},
                       in.place(),
                       {{"Matrix<Scalar, equation_count, input_count>&", "F_u"}},
                       results_of("F_u", derivatives.input_jacobian)});
  functions.push_back({"velocity_rhs",
                       {"Right-hand side of J dq/dt = rhs for the rates du/dt of the inputs."},
                       in.place_with({in.input_rates}),
                       {{"Vector<Scalar, equation_count>&", "rhs"}},
                       results_of("rhs", derivatives.velocity_rhs)});
  functions.push_back({"acceleration_rhs",
                       {"Right-hand side of J d2q/dt2 = rhs: centripetal and Coriolis terms of the",
                        "rates dq/dt, du/dt, and the second rates d2u/dt2 of the inputs."},
                       in.place_with({in.rates, in.input_rates, in.input_second_rates}),
                       {{"Vector<Scalar, equation_count>&", "rhs"}},
                       results_of("rhs", derivatives.acceleration_rhs)});
  functions.push_back(
      {"jerk_rhs",
       {"Right-hand side of J d3q/dt3 = rhs from the lower rates, and the rates of the",
        "inputs up to the third."},
       in.place_with({in.rates, in.second_rates, in.input_rates, in.input_second_rates,
                      in.input_third_rates}),
       {{"Vector<Scalar, equation_count>&", "rhs"}},
       results_of("rhs", derivatives.jerk_rhs)});
  functions.push_back(
      {"curvature_rhs",
       {"Right-hand side of J d2q/dt2 = rhs where the dimensions move too and dd/dt and",
        "du/dt are constant: second derivatives along a line in (d, u)."},
       in.place_with({in.rates, in.dimension_rates, in.input_rates}),
       {{"Vector<Scalar, equation_count>&", "rhs"}},
       results_of("rhs", derivatives.curvature_rhs)});
  return functions;
}

std::vector<ModelFunction> model_functions(const equations::ClosureEquations& equations,
                                           const derivatives::Derivatives& derivatives) {
  const FunctionParameters in;
  std::vector<ModelFunction> functions = residual_functions(equations, derivatives);
  ModelFunction poses{"link_poses",
                      {"Frames of the links in the fixed frame."},
                      in.place(),
                      {{"Poses<Scalar, link_count>&", "poses"}},
                      {}};
  for (const structure::LinkIndex link : equations.poses.keys()) {
    add_frame(link.place(), equations.poses[link], true, poses.results);
  }
  functions.push_back(std::move(poses));
  ModelFunction pose_jacobians{
      "pose_jacobians",
      {"Partial derivatives of the link frames p, rows (x, y, theta) link by link:",
       "P_q = dp/dq, P_d = dp/dd, P_u = dp/du, each with the other two held."},
      in.place(),
      {{"Matrix<Scalar, 3 * link_count, unknown_count>&", "P_q"},
       {"Matrix<Scalar, 3 * link_count, dimension_count>&", "P_d"},
       {"Matrix<Scalar, 3 * link_count, input_count>&", "P_u"}},
      results_of("P_q", derivatives.pose_unknown_jacobian)};
  append(pose_jacobians.results, "P_d", derivatives.pose_dimension_jacobian);
  append(pose_jacobians.results, "P_u", derivatives.pose_input_jacobian);
  functions.push_back(std::move(pose_jacobians));
  functions.push_back({"link_velocities",
                       {"Velocity (vx, vy, omega) of each link's frame, one row per link."},
                       in.place_with({in.rates, in.input_rates}),
                       {{"Matrix<Scalar, link_count, 3>&", "v"}},
                       results_of("v", derivatives.pose_velocity)});
  functions.push_back(
      {"link_accelerations",
       {"Acceleration (ax, ay, alpha) of each link's frame, one row per link."},
       in.place_with({in.rates, in.second_rates, in.input_rates, in.input_second_rates}),
       {{"Matrix<Scalar, link_count, 3>&", "a"}},
       results_of("a", derivatives.pose_acceleration)});
  functions.push_back(
      {"pose_curvatures",
       {"d2p/dt2 of the link frames p for constant dq/dt, dd/dt and du/dt, one row per link;",
        "second rates add their part by the pose Jacobians."},
       in.place_with({in.rates, in.dimension_rates, in.input_rates}),
       {{"Matrix<Scalar, link_count, 3>&", "p"}},
       results_of("p", derivatives.pose_curvature)});
  if (!equations.compatibility.empty()) {
    ModelFunction compatibility{
        "compatibility",
        {"(cos, sin) of each sum of angles that must vanish: assembled only at (1, 0)."},
        {in.dimensions, in.inputs},
        {{"Matrix<Scalar, compatibility_count, 2>&", "c"}},
        {}};
    for (std::size_t row = 0; row < equations.compatibility.size(); ++row) {
      const equations::Vector2 direction = equations.compatibility[row].direction();
      compatibility.results.push_back({program::entry("c", row, 0), direction.x});
      compatibility.results.push_back({program::entry("c", row, 1), direction.y});
    }
    functions.push_back(std::move(compatibility));
  }
  return functions;
}

std::vector<ModelFunction> position_functions(const equations::ClosureEquations& /*equations*/,
                                              elimination::Elimination& elimination) {
  const Parameter dimensions{"const Dimensions<Scalar>&", "d"};
  const Parameter inputs{"const Inputs<Scalar>&", "u"};
  const Parameter first{"const Configuration<Scalar>&", "q"};
  const bool trigonometric = elimination.first->is_angle();
  std::vector<ModelFunction> functions;

  ModelFunction polynomial{
      "position_polynomial",
      {"The final polynomial T in " + elimination.first->name + ", free of all other unknowns:"},
      {dimensions, inputs},
      {},
      {}};
  if (trigonometric) {
    polynomial.doc.emplace_back("T = sum over k of cosine[k] cos(k x) + sine[k] sin(k x).");
    polynomial.outputs = {{"TrigonometricPolynomial<Scalar, polynomial_degree>&", "T"}};
  } else {
    polynomial.doc.emplace_back("T = sum over k of T(k) x^k.");
    polynomial.outputs = {{"Vector<Scalar, static_cast<int>(polynomial_degree) + 1>&", "T"}};
  }
  for (std::size_t power = 0; power < elimination.polynomial.size(); ++power) {
    const std::string place = "[" + std::to_string(power) + "]";
    const equations::Vector2& pair = elimination.polynomial[power];
    if (trigonometric) {
      polynomial.results.push_back({{"T", ".cosine" + place}, pair.x});
      polynomial.results.push_back({{"T", ".sine" + place}, pair.y});
    } else {
      polynomial.results.push_back({program::entry("T", power), pair.x});
    }
  }
  functions.push_back(std::move(polynomial));

  if (elimination.second != nullptr) {
    const bool angle = elimination.second->is_angle();
    functions.push_back(
        {"second_equations",
         {"The reduced equations, one per row, where " + elimination.first->name + " is known: " +
              (angle ? "e(i, 0) cos z + e(i, 1) sin z + e(i, 2) = 0"
                     : "e(i, 0) z^2 + e(i, 1) z + e(i, 2) = 0"),
          "with z = " + elimination.second->name + "."},
         {dimensions, inputs, first},
         {{"Matrix<Scalar, 2, 3>&", "e"}},
         {}});
    for (std::size_t row = 0; row < elimination.in_second.size(); ++row) {
      for (std::size_t part = 0; part < 3; ++part) {
        functions.back().results.push_back(
            {program::entry("e", row, part), elimination.in_second[row][part]});
      }
    }
  }

  ModelFunction complete{"complete",
                         {"The other unknowns, from those of the reduced equations."},
                         {dimensions, inputs},
                         {{"Configuration<Scalar>&", "q"}},
                         {}};
  for (const elimination::BackSubstitution& step : elimination.reduction.steps) {
    const GiNaC::ex inverse = elimination.vocabulary.name_reciprocal(
        "inverse_" + step.unknown->name, step.denominator, "that " + step.degeneracy);
    const std::string unknown = "." + step.unknown->name;
    if (step.unknown->is_angle()) {
      complete.results.push_back({{"q", unknown + ".cos"}, step.numerators[0] * inverse});
      complete.results.push_back({{"q", unknown + ".sin"}, step.numerators[1] * inverse});
    } else {
      complete.results.push_back({{"q", unknown}, step.numerators[0] * inverse});
    }
  }
  functions.push_back(std::move(complete));
  return functions;
}

}  // namespace assur::generator::emission::model
