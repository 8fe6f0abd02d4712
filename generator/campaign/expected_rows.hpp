// The rows that a table must contain by its description, one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// The rows of a shard: for a sample one per item; for a map one per configuration of a cell, or
/// one for a cell without any.
class ExpectedRows {
 public:
  /// The description must allow a summary.
  explicit ExpectedRows(const Description& description);

  /// The error of the next row; empty if it is the one that must follow.
  [[nodiscard]] std::string fault(const double* row);
  /// The rows missing after the last one; empty if there are none.
  [[nodiscard]] std::string lack() const;

 private:
  [[nodiscard]] std::string fault_of_cell(const double* row);
  [[nodiscard]] std::string difference(std::size_t column, double found, double expected) const;

  const Description& description_;
  std::vector<NamedAxis> axes_;
  std::uint64_t next_, last_;                 ///< the next item without a row, and the end
  double configurations_ = 0, families_ = 0;  ///< for the last cell
  double configuration_ = 0;                  ///< the last one of that cell
};

}  // namespace assur::generator::campaign
