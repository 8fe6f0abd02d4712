// Turns the speeds of drives into the sweep that shows one period of a mechanism.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The drives of a mechanism, by how often they come back to where they were.
class DrivePeriod {
 public:
  /// A drive that comes back so often in a minute.
  void add(double cycles_per_minute) { cycles_.push_back(cycles_per_minute); }
  /// Half the time that the sweep takes, in seconds; 0 without a drive that moves in time.
  [[nodiscard]] double half() const;
  /// A drive that nothing but a parameter moves, between two values.
  void add_hand(const std::string& parameter, double from, double to);
  /// One period around the drawing, after which all drives are back: after the slowest's, where
  /// their speeds are no whole numbers. The drawing itself is a step of it. Without a drive that
  /// moves in time, the whole way of the first parameter; nothing if there is none either.
  [[nodiscard]] std::optional<ForeignSweep> sweep(const ForeignMechanism& mechanism) const;

 private:
  std::vector<double> cycles_;
  std::optional<ForeignSweep> hand_;
};

}  // namespace assur::mechanism::foreign
