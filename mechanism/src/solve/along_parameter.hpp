// The numbers of a mechanism as power series along one growing parameter.
#pragma once

#include <assur/mechanism/values.hpp>

#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The numbers of a mechanism as power series in the increase of one parameter from its value.
class AlongParameter {
 public:
  AlongParameter(const Values& values, ParameterIndex parameter);

  /// A number whose formula reads no joints.
  [[nodiscard]] models::Series number(NumberIndex index) const;
  /// The law of each driver; a law that reads joints placed by groups counts as constant.
  [[nodiscard]] const Table<DriverIndex, models::Series>& laws() const { return laws_; }

 private:
  [[nodiscard]] models::Series law(DriverIndex driver) const;

  const Values& values_;
  Table<ParameterIndex, models::Series> parameters_;
  Table<DriverIndex, models::Series> laws_;
};

}  // namespace assur::mechanism::solve
