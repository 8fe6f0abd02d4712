// Turns one parameter that grows into the motion of the numbers that depend on it.
#pragma once

#include <assur/mechanism/values.hpp>

#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The numbers of a mechanism as series in how far one parameter has grown from its value.
class AlongParameter {
 public:
  AlongParameter(const Values& values, ParameterIndex parameter);

  /// A number that reads no joints.
  [[nodiscard]] models::Series number(NumberIndex index) const;
  /// The law of each driver; one that reads joints which groups place counts as standing still.
  [[nodiscard]] const Table<DriverIndex, models::Series>& laws() const { return laws_; }

 private:
  [[nodiscard]] models::Series law(DriverIndex driver) const;

  const Values& values_;
  Table<ParameterIndex, models::Series> parameters_;
  Table<DriverIndex, models::Series> laws_;
};

}  // namespace assur::mechanism::solve
