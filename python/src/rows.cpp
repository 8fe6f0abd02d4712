#include "rows.hpp"

namespace assur::python {

void Rows::reserve(std::size_t rows) {
  numbers_.reserve(rows * layout_->width());
  regular_.reserve(rows);
}

void Rows::add(const mechanism::Configuration& configuration, const mechanism::Spread& spread) {
  add_gap();
  layout_->write(plan_, configuration, spread,
                 numbers_.data() + numbers_.size() - layout_->width());
  regular_.back() = configuration.regularity == Status::ok ? 1 : 0;
}

void Rows::add_gap() {
  numbers_.resize(numbers_.size() + layout_->width(), std::numeric_limits<double>::quiet_NaN());
  regular_.push_back(0);
}

}  // namespace assur::python
