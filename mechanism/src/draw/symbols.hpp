// Turns a mechanism into the shapes by which its links and joints are drawn.
#pragma once

#include <assur/mechanism/drawing.hpp>

#include "draw/anchors.hpp"

namespace assur::mechanism::draw {

/// The shapes, and the points that they refer to.
struct Symbols {
  std::vector<Shape> shapes;
  std::vector<Anchor> points;
};

/// What the choice of symbols depends on: how the links look, and how far joints go.
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
