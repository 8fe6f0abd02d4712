// Frames relative to other frames, and displacements of slides along their lines.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The frame `other` in the axes of the frame `one`, with all rates and derivatives; both are given
/// in a third frame.
[[nodiscard]] Frame seen_from(const Frame& one, const Frame& other);

/// The line of a slide and the feature that moves along it. The line of a prismatic joint is its
/// first feature.
struct SlideFeatures {
  FeatureIndex line, other;
};
[[nodiscard]] SlideFeatures features_of_slide(const Mechanism& mechanism, JointIndex slide);

/// The state of a slide: the displacement of its second feature along its line from the line's
/// origin, with the rates and derivatives that follow from those of the links.
[[nodiscard]] SlideState measured_slide(const Values& values, const Table<LinkIndex, Frame>& links,
                                        JointIndex slide);

}  // namespace assur::mechanism::solve
