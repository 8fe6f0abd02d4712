// Points of a link that coincide, by the numbers of the mechanism.
#pragma once

#include <array>
#include <assur/mechanism/mechanism.hpp>

namespace assur::mechanism::plan {

/// The places of points in the frames of their links, computed from the mechanism's own numbers. A
/// point whose numbers cannot be computed, for example because parameters read one another, has no
/// place and coincides with no other point.
class PointPlaces {
 public:
  explicit PointPlaces(const Mechanism& mechanism);

  /// Whether two points of one link are apart by rounding at most, so that they define no line.
  [[nodiscard]] bool coincide(FeatureIndex one, FeatureIndex other) const;

 private:
  Table<FeatureIndex, std::array<double, 2>> places_;
};

}  // namespace assur::mechanism::plan
