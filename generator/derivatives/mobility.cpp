#include "derivatives/mobility.hpp"

#include <algorithm>
#include <span>

#include "equations/seeded_numbers.hpp"
#include "error.hpp"

namespace assur::generator::derivatives {

namespace {

/// An angle of a compatibility condition that occurs in no earlier condition.
const equations::Variable& angle_to_solve_for(const equations::ClosureEquations& equations,
                                              std::size_t condition) {
  const auto earlier_ones = std::span(equations.compatibility).first(condition);
  for (const std::deque<equations::Variable>* list : {&equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      if (equations.compatibility[condition].factor(variable) == 0) {
        continue;
      }
      const bool taken = std::any_of(
          earlier_ones.begin(), earlier_ones.end(),
          [&](const equations::AngleSum& earlier) { return earlier.factor(variable) != 0; });
      if (!taken) {
        return variable;
      }
    }
  }
  throw GeneratorError("mobility", equations.model->title(), "an angle condition without an angle");
}

/// The reason why angles are over-determined, for the verdict; empty if they are not.
std::string cause(const equations::ClosureEquations& equations) {
  if (equations.compatibility.empty()) {
    return "";
  }
  std::string text = "prismatic joints alone close " +
                     std::string(equations.compatibility.size() == 1 ? "a loop" : "loops") +
                     ", so its angles are over-determined (";
  for (std::size_t index = 0; index < equations.compatibility.size(); ++index) {
    text += (index == 0 ? "" : "; ") + equations.compatibility[index].text() + " = 0";
  }
  return text + ")";
}

}  // namespace

GiNaC::exmap random_assembly(const equations::ClosureEquations& equations, unsigned seed) {
  equations::SeededNumbers random(seed);
  GiNaC::exmap values;
  GiNaC::lst lengths;
  for (const std::deque<equations::Variable>* list :
       {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      if (variable.is_angle()) {
        const equations::Vector2 direction = random.direction();
        values[variable.cosine] = direction.x;
        values[variable.sine] = direction.y;
      } else {
        lengths.append(variable.value);
      }
    }
  }
  for (std::size_t index = 0; index < equations.compatibility.size(); ++index) {
    const equations::Variable& angle = angle_to_solve_for(equations, index);
    const int factor = equations.compatibility[index].factor(angle);
    equations::AngleSum rest = equations.compatibility[index];
    rest.add(angle, -factor);
    const equations::Vector2 direction = rest.direction();
    values[angle.cosine] = direction.x.subs(values);
    values[angle.sine] = (-factor * direction.y).subs(values);
  }
  GiNaC::lst closures;
  for (const GiNaC::ex& residual : equations.residuals) {
    closures.append(equations.vocabulary.expand(residual).subs(values) == 0);
  }
  const GiNaC::ex solution = GiNaC::lsolve(closures, lengths);
  if (solution.nops() == 0) {
    throw GeneratorError("mobility", equations.model->title(), "no assembly at random angles");
  }
  GiNaC::exmap free;
  for (const GiNaC::ex& length : lengths) {
    free[length] = random.number();
  }
  for (const GiNaC::ex& assignment : solution) {
    values[assignment.lhs()] = assignment.rhs().subs(free);
  }
  return values;
}

Mobility mobility_of(const equations::ClosureEquations& equations,
                     const ExpressionMatrix& jacobian) {
  const auto rows = static_cast<unsigned>(jacobian.size());
  const auto columns = static_cast<unsigned>(equations.unknowns.size());
  unsigned rank = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const GiNaC::exmap values = random_assembly(equations, seed);
    GiNaC::matrix at_point(rows, columns);
    for (unsigned row = 0; row < rows; ++row) {
      for (unsigned column = 0; column < columns; ++column) {
        at_point(row, column) = equations.vocabulary.expand(jacobian[row][column]).subs(values);
      }
    }
    rank = std::max(rank, at_point.rank());
  }
  Mobility result{columns, rank, columns - rank, false, ""};
  result.rigid = result.freedom == 0 && rows == columns && equations.compatibility.empty();
  const std::string count = "generic rank " + std::to_string(rank) + " of " + std::to_string(rows) +
                            " equations in " + std::to_string(columns) + " unknowns";
  result.reason = equations.compatibility.empty() ? count : count + ": " + cause(equations);
  return result;
}

}  // namespace assur::generator::derivatives
