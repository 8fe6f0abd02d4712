// Turns the numbers of a mechanism into which points of a link lie in one place.
#pragma once

#include <array>
#include <assur/mechanism/mechanism.hpp>

namespace assur::mechanism::plan {

/// Where the points of links lie in their links' frames, by the mechanism's own numbers. A point is
/// nowhere, and in no other one's place, where its numbers cannot be told, as of parameters that
/// read one another.
class OwnPlaces {
 public:
  explicit OwnPlaces(const Mechanism& mechanism);

  /// Whether two points of one link are apart by rounding at most, so that no line leads from one
  /// to the other.
  [[nodiscard]] bool coincide(FeatureIndex one, FeatureIndex other) const;

 private:
  Table<FeatureIndex, std::array<double, 2>> places_;
};

}  // namespace assur::mechanism::plan
