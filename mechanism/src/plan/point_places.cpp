#include "point_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::plan {

namespace {

/// The values of the parameters; NaN for a parameter that reads itself, directly or through others.
Table<ParameterIndex, double> values_of_parameters(const Mechanism& mechanism) {
  Table<ParameterIndex, double> values(mechanism.parameters().size(),
                                       std::numeric_limits<double>::quiet_NaN());
  for (bool finds_any = true; finds_any;) {
    finds_any = false;
    for (const ParameterIndex parameter : mechanism.parameters().keys()) {
      if (std::isnan(values[parameter])) {
        values[parameter] =
            mechanism.numbers()[mechanism.parameters()[parameter].value].formula.evaluate<double>(
                [&](ParameterIndex read) { return values[read]; });
        finds_any = finds_any || !std::isnan(values[parameter]);
      }
    }
  }
  return values;
}

}  // namespace

PointPlaces::PointPlaces(const Mechanism& mechanism) {
  const Table<ParameterIndex, double> values = values_of_parameters(mechanism);
  const auto value = [&](NumberIndex number) {
    return mechanism.numbers()[number].formula.evaluate<double>(
        [&](ParameterIndex read) { return values[read]; });
  };
  for (const Feature& feature : mechanism.features()) {
    places_.add({value(feature.x), value(feature.y)});
  }
}

bool PointPlaces::coincide(FeatureIndex one, FeatureIndex other) const {
  constexpr double rounding = 1e-9;
  const auto [x, y] = places_[one];
  const auto [other_x, other_y] = places_[other];
  return std::hypot(x - other_x, y - other_y) <=
         rounding * std::max(std::hypot(x, y), std::hypot(other_x, other_y));
}

}  // namespace assur::mechanism::plan
