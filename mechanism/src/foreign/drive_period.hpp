// Sweep over one period of a mechanism, from the speeds of its drives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The drives of a mechanism, by their cycles a minute.
class DrivePeriod {
 public:
  /// Adds a drive by its number of cycles a minute.
  void add(double cycles_per_minute) { cycles_.push_back(cycles_per_minute); }
  /// Half the duration of the sweep, in seconds; 0 without a drive that moves in time.
  [[nodiscard]] double half() const;
  /// Adds a drive that only a parameter moves, between two values.
  void add_hand(const std::string& parameter, double from, double to);
  /// One common period of all drives around the drawing, or the slowest one's period if their
  /// speeds are not whole numbers. The drawing itself is a step of it. Without a drive that moves
  /// in time, the whole range of the first parameter; nothing if there is none either.
  [[nodiscard]] std::optional<ForeignSweep> sweep(const ForeignMechanism& mechanism) const;

 private:
  std::vector<double> cycles_;
  std::optional<ForeignSweep> hand_;
};

}  // namespace assur::mechanism::foreign
