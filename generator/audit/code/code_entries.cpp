#include "audit/code/code_entries.hpp"

namespace assur::generator::audit::code {

GiNaC::ex CodeEntry::value() const {
  if (text.empty()) {
    return 0;
  }
  if (!cell.value) {
    throw closures::FormulaError(cell.reason, cell.place);
  }
  return *cell.value;
}

Cell CodeReader::cell_of(Tokens value, std::vector<Spelled>* used) {
  Cell cell = read_expression(value, variables_, &types_, used);
  const std::size_t from = value.front().offset;
  const std::size_t to = value.back().offset + value.back().spelling.size();
  cell.source = {code_.substr(from, to - from), value.front().place};
  return cell;
}

void CodeReader::set_entry(std::size_t row, std::size_t column, const Spelled& entry, Cell cell) {
  if (row >= audited_.rows || column >= audited_.columns) {
    throw CodeError(
        audited_.array + " is audited as " + audited_.size_text() + ", and this entry is outside",
        entry.place);
  }
  cell.sort = Sort::real;
  filled_ = filled_.value_or(entry.place);
  variables_.set(entry, std::move(cell));
}

std::vector<CodeEntry> CodeReader::entries_of(const Variable& matrix, std::size_t first_index) {
  if (!filled_) {
    throw CodeError("nothing is assigned to " + audited_.array, {1, 1});
  }
  std::vector<CodeEntry> entries;
  for (std::size_t row = 0; row < audited_.rows; ++row) {
    for (std::size_t column = 0; column < audited_.columns; ++column) {
      const auto cell = matrix.cells.find("[" + std::to_string(row + first_index) + "][" +
                                          std::to_string(column + first_index) + "]");
      const bool is_set = cell != matrix.cells.end();
      if (!is_set && matrix.origin == Variable::Origin::own && !matrix.zero) {
        throw CodeError("row " + std::to_string(row + 1) + ", column " +
                            std::to_string(column + 1) + " of " + audited_.array +
                            " is never assigned, and " + audited_.array +
                            " begins without values; set it to zero first",
                        matrix.place);
      }
      entries.push_back(is_set ? CodeEntry{cell->second.source, cell->second}
                               : CodeEntry{{"", *filled_}, {}});
    }
  }
  return entries;
}

std::vector<CodeEntry> CodeReader::entries_of(const std::vector<Cell>& cells,
                                              closures::Place place) const {
  if (cells.size() != audited_.rows * audited_.columns) {
    throw CodeError(audited_.array + " is audited as " + audited_.size_text() + ", and gives " +
                        std::to_string(cells.size()) + " values",
                    place);
  }
  std::vector<CodeEntry> entries;
  for (const Cell& cell : cells) {
    if (cell.source.empty()) {  // the assigned expression cannot be read
      throw CodeError(cell.reason, cell.place);
    }
    entries.push_back({cell.source, cell});
  }
  return entries;
}

}  // namespace assur::generator::audit::code
