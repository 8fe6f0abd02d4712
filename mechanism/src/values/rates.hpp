// Turns how a mechanism's parameters and drivers move in time into the rates of a group's numbers.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::values {

/// A number as a function of time: its derivative is its rate, its second derivative the second
/// rate.
[[nodiscard]] Dual in_time(double value, double rate, double second_rate);
[[nodiscard]] double rate_of(const Dual& number);
[[nodiscard]] double second_rate_of(const Dual& number);

/// Fills in the rates of a group whose links change their shapes, from its geometry in time.
void set_rates(const GroupGeometry<Dual>& geometry, const Structure& structure,
               const FoundGroup& group, Values::GroupNumbers& numbers);

}  // namespace assur::mechanism::values
