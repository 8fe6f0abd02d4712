#include "audit/code/filled_matrix.hpp"

namespace assur::generator::audit::code {

CodeEntry FilledMatrix::entry(Tokens value, const LocalValues& locals) const {
  const std::size_t from = value.front().offset;
  const std::size_t to = value.back().offset + value.back().spelling.size();
  return {locals.formula(value).text, locals.names(), code_.substr(from, to - from)};
}

void FilledMatrix::assign(std::size_t row, std::size_t column, const CodeName& name, Tokens value,
                          LocalValues& locals) {
  if (row >= matrix_.rows || column >= matrix_.columns) {
    throw CodeError(
        matrix_.array + " is audited as " + matrix_.size_text() + ", and this entry is outside",
        name.place);
  }
  if (value.empty()) {
    throw CodeError("a value is missing", name.place);
  }
  first_ = first_.value_or(name.place);
  entries_[row * matrix_.columns + column] = entry(value, locals);
  locals.set(name, value);
}

void FilledMatrix::assign_all(const std::vector<Tokens>& values, closures::Place place,
                              const LocalValues& locals) {
  if (values.size() != entries_.size()) {
    throw CodeError(matrix_.array + " is audited as " + matrix_.size_text() + ", and this lists " +
                        std::to_string(values.size()) + " entries",
                    place);
  }
  first_ = first_.value_or(place);
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (values[at].empty()) {
      throw CodeError("a value is missing", place);
    }
    entries_[at] = entry(values[at], locals);
  }
}

std::vector<CodeEntry> FilledMatrix::entries() {
  if (!first_) {
    throw CodeError("nothing is assigned to " + matrix_.array, {1, 1});
  }
  for (std::size_t at = 0; undefined_ && at < entries_.size(); ++at) {
    if (entries_[at].text.empty()) {
      throw CodeError("row " + std::to_string(at / matrix_.columns + 1) + ", column " +
                          std::to_string(at % matrix_.columns + 1) + " of " + matrix_.array +
                          " is never assigned, and " + matrix_.array +
                          " begins without values; set it to zero first",
                      *undefined_);
    }
  }
  for (CodeEntry& entry : entries_) {
    entry.text.place = entry.text.empty() ? *first_ : entry.text.place;
  }
  return entries_;
}

}  // namespace assur::generator::audit::code
