// Shapes that represent the links and joints of a mechanism.
#pragma once

#include <assur/mechanism/drawing.hpp>

#include "draw/anchors.hpp"

namespace assur::mechanism::draw {

/// The shapes, and the points to which they refer.
struct Symbols {
  std::vector<Shape> shapes;
  std::vector<Anchor> points;
};

/// The data that determine the symbols: the looks of the links, and the ranges of joints.
struct Appearance {
  const Mechanism& mechanism;
  const FeatureFrames& frames;
  const LinkPoses& poses;
  const Reaches& reaches;
  double size;  ///< of the mechanism
};

/// Links without a pose are not drawn.
[[nodiscard]] Symbols symbols_of(const Appearance& appearance);

}  // namespace assur::mechanism::draw
