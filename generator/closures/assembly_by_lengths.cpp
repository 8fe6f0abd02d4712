#include "closures/assembly_by_lengths.hpp"

#include <algorithm>

namespace assur::generator::closures {

namespace {

using Column = std::vector<GiNaC::ex>;

Column slopes(const std::vector<GiNaC::ex>& equations, const GiNaC::ex& length) {
  Column column;
  for (const GiNaC::ex& equation : equations) {
    column.push_back(equation.diff(GiNaC::ex_to<GiNaC::symbol>(length)));
  }
  return column;
}

bool is_constant(const Column& column) {
  return std::all_of(column.begin(), column.end(),
                     [](const GiNaC::ex& slope) { return GiNaC::is_a<GiNaC::numeric>(slope); });
}

bool has_any(const Column& column, const GiNaC::lst& symbols) {
  return std::any_of(column.begin(), column.end(), [&](const GiNaC::ex& slope) {
    return std::any_of(symbols.begin(), symbols.end(),
                       [&](const GiNaC::ex& symbol) { return slope.has(symbol); });
  });
}

bool are_independent(const std::vector<Column>& columns, const CircleAlgebra& algebra,
                     const GiNaC::exmap& values) {
  GiNaC::matrix matrix(static_cast<unsigned>(columns.size()),
                       static_cast<unsigned>(columns[0].size()));
  for (unsigned row = 0; row < matrix.rows(); ++row) {
    for (unsigned place = 0; place < matrix.cols(); ++place) {
      matrix(row, place) = algebra.at(columns[row][place], values);
    }
  }
  return matrix.rank() == columns.size();
}

}  // namespace

AssemblyByLengths::AssemblyByLengths(std::vector<GiNaC::ex> equations, const GiNaC::lst& lengths)
    : equations_(std::move(equations)) {
  for (const GiNaC::ex& length : lengths) {
    lengths_.emplace_back(length, slopes(equations_, length));
  }
  // Coordinates, whose columns are constant, come first: solving for them leaves roots rational.
  std::stable_partition(lengths_.begin(), lengths_.end(),
                        [](const auto& each) { return is_constant(each.second); });
}

bool AssemblyByLengths::assemble(const CircleAlgebra& algebra, GiNaC::exmap& values) const {
  GiNaC::lst solved_for;
  std::vector<Column> columns;
  for (const auto& [length, column] : lengths_) {
    GiNaC::lst with_length = solved_for;
    with_length.append(length);
    if (columns.size() == equations_.size() || has_any(column, with_length)) {
      continue;
    }
    columns.push_back(column);
    if (are_independent(columns, algebra, values)) {
      solved_for = with_length;
    } else {
      columns.pop_back();
    }
  }
  if (columns.size() != equations_.size()) {
    return false;
  }
  GiNaC::exmap others = values;
  for (const GiNaC::ex& length : solved_for) {
    others.erase(length);
  }
  GiNaC::lst system;
  for (const GiNaC::ex& equation : equations_) {
    system.append(algebra.at(equation, others) == 0);
  }
  const GiNaC::ex solution = equations_.empty() ? GiNaC::lst() : GiNaC::lsolve(system, solved_for);
  for (const GiNaC::ex& assignment : solution) {
    values[assignment.lhs()] = assignment.rhs();
  }
  return true;
}

}  // namespace assur::generator::closures
