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

/// Columns that are linearly independent, each reduced by those before it.
class IndependentColumns {
 public:
  [[nodiscard]] std::size_t count() const { return reduced_.size(); }

  /// Adds a column, unless it depends on the others. Returns whether it was added.
  bool add(Column column) {
    for (const auto& [pivot, earlier] : reduced_) {
      const GiNaC::ex factor = (column[pivot] / earlier[pivot]).normal();
      if (factor.is_zero()) {
        continue;
      }
      for (std::size_t row = 0; row < column.size(); ++row) {
        column[row] = (column[row] - factor * earlier[row]).normal();
      }
    }
    const auto pivot = std::find_if(column.begin(), column.end(),
                                    [](const GiNaC::ex& entry) { return !entry.is_zero(); });
    if (pivot == column.end()) {
      return false;
    }
    reduced_.emplace_back(static_cast<std::size_t>(pivot - column.begin()), std::move(column));
    return true;
  }

 private:
  std::vector<std::pair<std::size_t, Column>> reduced_;  ///< with the row that is not zero
};

}  // namespace

AssemblyByLengths::AssemblyByLengths(std::vector<GiNaC::ex> equations, const GiNaC::lst& lengths)
    : equations_(std::move(equations)) {
  for (const GiNaC::ex& length : lengths) {
    lengths_.emplace_back(length, slopes(equations_, length));
  }
  // Coordinates, whose columns are constant, come first: solving for them keeps roots rational.
  std::stable_partition(lengths_.begin(), lengths_.end(),
                        [](const auto& each) { return is_constant(each.second); });
}

bool AssemblyByLengths::assemble(const CircleAlgebra& algebra, GiNaC::exmap& values) const {
  GiNaC::lst solved_for;
  IndependentColumns independent;
  for (const auto& [length, column] : lengths_) {
    GiNaC::lst with_length = solved_for;
    with_length.append(length);
    if (independent.count() == equations_.size() || has_any(column, with_length)) {
      continue;
    }
    Column there;
    for (const GiNaC::ex& slope : column) {
      there.push_back(algebra.at(slope, values));
    }
    if (independent.add(std::move(there))) {
      solved_for = with_length;
    }
  }
  if (independent.count() != equations_.size()) {
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
