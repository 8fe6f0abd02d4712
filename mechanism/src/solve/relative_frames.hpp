// Frames as seen from other frames, and where slides are along their lines.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The frame `other` in the axes of the frame `one`, with all rates and derivatives; both are given
/// in a third frame.
[[nodiscard]] Frame seen_from(const Frame& one, const Frame& other);

/// The line of a slide and the feature that moves along it. Of a prismatic joint, the line is the
/// first feature.
struct SlideFeatures {
  FeatureIndex line, other;
};
[[nodiscard]] SlideFeatures features_of_slide(const Mechanism& mechanism, JointIndex slide);

/// The state of a slide: how far its second feature is from the origin of its line along it, with
/// rates and derivatives, which follow from those of the links.
[[nodiscard]] SlideState measured_slide(const Values& values, const Table<LinkIndex, Frame>& links,
                                        JointIndex slide);

}  // namespace assur::mechanism::solve
