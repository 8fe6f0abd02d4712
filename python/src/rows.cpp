#include "rows.hpp"

#include <algorithm>

namespace assur::python {

void Rows::reserve(std::size_t rows) {
  numbers_.reserve(rows * layout_->width());
  regular_.reserve(rows);
}

void Rows::add(const mechanism::Configuration& configuration, const mechanism::Values& values) {
  if (layout_->forces.columns.empty()) {
    add_without_forces(configuration, values.spread());
    return;
  }
  auto [forces, reason] = layout_->forces_of(plan_, values, configuration);
  add_without_forces(configuration, values.spread());
  std::ranges::copy(forces, numbers_.end() - static_cast<std::ptrdiff_t>(forces.size()));
  reasons_.back() = std::move(reason);
}

void Rows::add_without_forces(const mechanism::Configuration& configuration,
                              const mechanism::Spread& spread) {
  add_gap();
  layout_->write(plan_, configuration, spread,
                 numbers_.data() + numbers_.size() - layout_->width());
  regular_.back() = configuration.regularity == Status::ok ? 1 : 0;
}

void Rows::add_gap() {
  numbers_.resize(numbers_.size() + layout_->width(), std::numeric_limits<double>::quiet_NaN());
  regular_.push_back(0);
  if (!layout_->forces.columns.empty()) {
    reasons_.emplace_back();
  }
}

}  // namespace assur::python
