// The rows that must stand in a table with a description, one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// The rows of a shard: one for each sample; for each cell of a map one for each configuration, or
/// one alone.
class ExpectedRows {
 public:
  /// Of a description from which a summary can be made.
  explicit ExpectedRows(const Description& description);

  /// What is wrong with the next row; empty if it is the one that must follow.
  [[nodiscard]] std::string fault(const double* row);
  /// What is missing behind the last row; empty if nothing is.
  [[nodiscard]] std::string lack() const;

 private:
  [[nodiscard]] std::string fault_of_cell(const double* row);
  [[nodiscard]] std::string difference(std::size_t column, double found, double expected) const;

  const Description& description_;
  std::vector<NamedAxis> axes_;
  std::uint64_t next_, last_;  ///< the next item without a row, and the one behind all
  double configurations_ = 0, families_ = 0;  ///< of the last cell
  double configuration_ = 0;                  ///< the last one of that cell
};

}  // namespace assur::generator::campaign
