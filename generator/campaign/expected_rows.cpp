#include "campaign/expected_rows.hpp"

#include <array>
#include <assur/mechanism/campaign.hpp>
#include <assur/text/quoted.hpp>
#include <cmath>

namespace assur::generator::campaign {

namespace {

constexpr double most_exact = 0x1p53;

bool is_whole(double number) {
  return number >= 0 && number <= most_exact && number == std::floor(number);
}

}  // namespace

ExpectedRows::ExpectedRows(const Description& description)
    : description_(description), axes_(axes_of(description)) {
  const auto [first, last] =
      mechanism::part_of(description.items, description.shard.number, description.shard.count);
  next_ = first;
  last_ = last;
}

std::string ExpectedRows::difference(std::size_t column, double found, double expected) const {
  return found == expected ? ""
                           : text::in_quotes(description_.columns[column].name) + " is " +
                                 number_text(found) + " instead of " + number_text(expected);
}

std::string ExpectedRows::fault(const double* row) {
  for (std::size_t column = 0; column < description_.columns.size(); ++column) {
    if (description_.columns[column].kind == mechanism::Column::Kind::whole &&
        !is_whole(row[column])) {
      return text::in_quotes(description_.columns[column].name) + " is " +
             number_text(row[column]) + ", which is not a whole number from 0";
    }
  }
  const bool goes_on = configuration_ < configurations_;
  if (!goes_on && next_ == last_) {
    return "the row comes after the last one of the shard";
  }
  next_ += goes_on ? 0 : 1;
  const std::string fault = difference(0, row[0], static_cast<double>(next_ - 1));
  return fault.empty() && !axes_.empty() ? fault_of_cell(row) : fault;
}

std::string ExpectedRows::fault_of_cell(const double* row) {
  std::uint64_t rest = next_ - 1;
  for (std::size_t axis = axes_.size(); axis-- > 0;) {
    const auto& [name, from, to, count] = axes_[axis];
    const double value = mechanism::value_at({{}, from, to, count}, rest % count);
    if (std::string fault = difference(1 + axis, row[1 + axis], value); !fault.empty()) {
      return fault;
    }
    rest /= count;
  }
  const std::size_t first = 1 + axes_.size();
  const double* const cell = row + first;
  if (configuration_ == configurations_) {
    configurations_ = cell[0];
    families_ = cell[1];
    configuration_ = 0;
  }
  configuration_ += configurations_ > 0 ? 1 : 0;
  const std::array<double, 3> expected = {configurations_, families_, configuration_};
  for (std::size_t number = 0; number < expected.size(); ++number) {
    if (std::string fault = difference(first + number, cell[number], expected[number]);
        !fault.empty()) {
      return fault;
    }
  }
  const bool has_configuration = cell[3] < static_cast<double>(mechanism::Outcome::beyond_limits);
  return has_configuration == (configurations_ > 0)
             ? ""
             : "the outcome does not fit the number of configurations";
}

std::string ExpectedRows::lack() const {
  return next_ == last_ && configuration_ == configurations_
             ? ""
             : "the table is incomplete: it ends at item " + std::to_string(next_) + " of " +
                   std::to_string(last_);
}

}  // namespace assur::generator::campaign
