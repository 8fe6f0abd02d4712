// Rates of a group's numbers, from the motion of parameters and drivers in time.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::values {

/// A number as a function of time: its derivative is its rate, its second derivative the second
/// rate.
[[nodiscard]] Dual in_time(double value, double rate, double second_rate);
[[nodiscard]] double rate_of(const Dual& number);
[[nodiscard]] double second_rate_of(const Dual& number);

/// Sets the rates of a group with links of variable shape, from its geometry as a function of time.
void set_rates(const GroupGeometry<Dual>& geometry, const Structure& structure,
               const FoundGroup& group, Values::GroupNumbers& numbers);

}  // namespace assur::mechanism::values
