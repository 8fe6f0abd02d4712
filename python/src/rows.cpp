#include "rows.hpp"

namespace assur::python {

void Rows::reserve(std::size_t rows) {
  numbers_.reserve(rows * layout_->width());
  regular_.reserve(rows);
}

void Rows::add(const mechanism::Configuration& configuration, const mechanism::Spread& spread) {
  const std::size_t end = numbers_.size();
  numbers_.resize(end + layout_->width(), std::numeric_limits<double>::quiet_NaN());
  layout_->write(plan_, configuration, spread, numbers_.data() + end);
  regular_.push_back(configuration.regularity == Status::ok ? 1 : 0);
}

}  // namespace assur::python
