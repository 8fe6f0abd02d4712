#include "emission/model/special_point_functions.hpp"

namespace assur::generator::emission::model {

namespace {

void append(std::vector<program::Result>& results, const std::string& target, std::size_t row,
            const std::vector<GiNaC::ex>& values) {
  for (std::size_t column = 0; column < values.size(); ++column) {
    results.push_back({program::entry(target, row, column), values[column]});
  }
}

/// `BCG` for side 0 and `EDF` for side 1.
const std::string& neighbour(const equations::ClosureEquations& equations,
                             const special_points::SpecialPointSide& side) {
  return equations.model->group->links()[side.by];
}
const std::string& word(const equations::ClosureEquations& equations,
                        const special_points::SpecialPoint& point) {
  return equations.model->group->links()[point.link];
}

}  // namespace

SpecialPointFunctions special_point_functions(const equations::ClosureEquations& equations,
                                              const special_points::SpecialPoints& special) {
  const Parameter dimensions{"const Dimensions<Scalar>&", "d"};
  const Parameter inputs{"const Inputs<Scalar>&", "u"};
  const Parameter configuration{"const Configuration<Scalar>&", "q"};
  const Parameter points{"const Matrix<Scalar, closure_link_count, 2>&", "S"};
  const Parameter normals{"const Matrix<Scalar, 2 * closure_link_count, 2>&", "n"};
  const Parameter rates{"const Vector<Scalar, unknown_count>&", "q_rate"};
  const Parameter input_rates{"const Vector<Scalar, input_count>&", "u_rate"};
  const Parameter input_second_rates{"const Vector<Scalar, input_count>&", "u_second_rate"};

  ModelFunction lines{
      "special_point_lines",
      {"The lines n . S = c on which the unknowns move a special point in parallel,",
       "along n: rows (n_x, n_y, c), two per closure link. S is measured from the origin of the",
       "link's frame, in the directions of the fixed frame."},
      {dimensions, inputs, configuration},
      {{"Matrix<Scalar, 2 * closure_link_count, 3>&", "lines"}},
      {}};
  ModelFunction lengths{
      "special_point_lengths",
      {"The signed lengths L: on side i of its link a special point at S moves by",
       "the sum over k of L(i, k) dq_k/dt along the unit normal n of its line."},
      {dimensions, inputs, configuration, points, normals},
      {{"Matrix<Scalar, 2 * closure_link_count, unknown_count>&", "L"}},
      {}};
  ModelFunction velocities{
      "special_point_velocities",
      {"The velocity of each special point by each side, without the terms of dq/dt."},
      {dimensions, inputs, configuration, points, input_rates},
      {{"Matrix<Scalar, 2 * closure_link_count, 2>&", "v"}},
      {}};
  ModelFunction accelerations{
      "special_point_accelerations",
      {"The acceleration of each special point by each side, without the terms of d2q/dt2:",
       "centripetal and Coriolis terms, and the second rates of the inputs."},
      {dimensions, inputs, configuration, points, rates, input_rates, input_second_rates},
      {{"Matrix<Scalar, 2 * closure_link_count, 2>&", "a"}},
      {}};

  SpecialPointFunctions result;
  std::size_t row = 0;
  for (std::size_t index = 0; index < special.points.size(); ++index) {
    const special_points::SpecialPoint& point = special.points[index];
    result.symbols.emplace_back(point.x, program::entry("S", index, 0));
    result.symbols.emplace_back(point.y, program::entry("S", index, 1));
    for (const special_points::SpecialPointSide& side : point.sides) {
      const std::string name = "n_" + word(equations, point) + "_" + neighbour(equations, side);
      const GiNaC::symbol n_x(name + "_x");
      const GiNaC::symbol n_y(name + "_y");
      result.symbols.emplace_back(n_x, program::entry("n", row, 0));
      result.symbols.emplace_back(n_y, program::entry("n", row, 1));
      append(lines.results, "lines", row, {side.normal.x, side.normal.y, side.offset});
      std::vector<GiNaC::ex> along;
      for (const equations::Vector2& contribution : side.contributions) {
        along.push_back((contribution.x * n_x + contribution.y * n_y).expand());
      }
      append(lengths.results, "L", row, along);
      append(velocities.results, "v", row, {side.known_velocity.x, side.known_velocity.y});
      append(accelerations.results, "a", row,
             {side.known_acceleration.x, side.known_acceleration.y});
      ++row;
    }
  }
  result.functions = {std::move(lines), std::move(lengths), std::move(velocities),
                      std::move(accelerations)};
  return result;
}

std::vector<std::string> special_point_lines(const equations::ClosureEquations& equations,
                                             const special_points::SpecialPoints& special) {
  if (!special.defined) {
    return {"This model has no special points: " + special.reason + "."};
  }
  std::vector<std::string> lines;
  for (const special_points::SpecialPoint& point : special.points) {
    std::string line;
    for (const special_points::SpecialPointSide& side : point.sides) {
      line += line.empty() ? "S_" + word(equations, point) + " is moved by " : ", and by ";
      line += equations.unknowns[side.moving[0]].name + " and " +
              equations.unknowns[side.moving[1]].name + " through " + neighbour(equations, side);
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace assur::generator::emission::model
