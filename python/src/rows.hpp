// Configurations as rows of numbers, of which arrays are views.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "layout.hpp"

namespace assur::python {

/// Rows of one layout, contiguous in memory; no row may be added once an array views them.
class Rows {
 public:
  Rows(mechanism::Plan plan, std::shared_ptr<const Layout> layout)
      : plan_(std::move(plan)), layout_(std::move(layout)) {}

  /// Rows from stored `numbers`, `regularities` and `reasons`.
  Rows(mechanism::Plan plan, std::shared_ptr<const Layout> layout, std::vector<double> numbers,
       std::vector<unsigned char> regular, std::vector<std::string> reasons)
      : plan_(std::move(plan)),
        layout_(std::move(layout)),
        numbers_(std::move(numbers)),
        regular_(std::move(regular)),
        reasons_(std::move(reasons)) {}

  /// Makes room for a number of rows.
  void reserve(std::size_t rows);
  /// Throws MechanismError for a load that has no value, and then adds nothing.
  void add(const mechanism::Configuration& configuration, const mechanism::Values& values);
  /// Adds a row whose forces are all NaN.
  void add_without_forces(const mechanism::Configuration& configuration,
                          const mechanism::Spread& spread);
  /// Adds a row of NaN.
  void add_gap();

  [[nodiscard]] std::size_t count() const { return regular_.size(); }
  [[nodiscard]] const Layout& layout() const { return *layout_; }
  [[nodiscard]] const double* row(std::size_t at) const {
    return numbers_.data() + at * layout_->width();
  }
  /// One byte for each row, 1 if it is regular.
  [[nodiscard]] const unsigned char* regular() const { return regular_.data(); }
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
  [[nodiscard]] const std::vector<unsigned char>& regularities() const { return regular_; }
  /// If forces are requested, the reason for each row why some force is not determined; empty if
  /// all are.
  [[nodiscard]] const std::vector<std::string>& reasons() const { return reasons_; }

 private:
  mechanism::Plan plan_;
  std::shared_ptr<const Layout> layout_;
  std::vector<double> numbers_;
  std::vector<unsigned char> regular_;
  std::vector<std::string> reasons_;
};

/// All rows, or one of them.
struct RowsView {
  static constexpr std::ptrdiff_t all = -1;

  std::shared_ptr<const Rows> rows;
  std::ptrdiff_t row = all;

  [[nodiscard]] bool is_one() const { return row != all; }
  [[nodiscard]] const double* first() const {
    return rows->row(is_one() ? static_cast<std::size_t>(row) : 0);
  }
};

}  // namespace assur::python
