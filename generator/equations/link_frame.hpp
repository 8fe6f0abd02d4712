// Normal form of a link: a local frame and the smallest number of dimensions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "equations/variable.hpp"
#include "structure/kind.hpp"

namespace assur::generator::equations {

/// A joint as a feature of a link, in the link's frame. A revolute joint is a point; a prismatic
/// joint is a directed line, given by the foot of the perpendicular from the frame's origin.
struct Feature {
  structure::JointIndex joint;
  bool line;
  Vector2 point;       ///< the point, or the foot on the line
  AngleSum direction;  ///< of the line, against the link's x-axis
};

/// The normal form of a link. The x-axis runs along the first prismatic joint, or else from the
/// first revolute joint to the second; the origin is the first revolute joint, or else the
/// intersection of the first two lines. A link of k joints has 2k - 3 remaining dimensions. The
/// links of a group without a name keep the axes of the scene and have one or two more.
struct LinkFrame {
  std::vector<Feature> features;  ///< in the order of the link's word
  std::string description;        ///< `origin at B, x-axis toward C`

  [[nodiscard]] const Feature& feature_of(structure::JointIndex joint) const;
};

/// Declares a dimension by its name, quantity and meaning. The variable must keep its address.
using DeclareDimension =
    std::function<const Variable&(const std::string&, Variable::Quantity, const std::string&)>;

/// The frame of `link` in the model's representative kind, whose features refer to the variables of
/// its dimensions.
[[nodiscard]] LinkFrame link_frame(const structure::Model& model, structure::LinkIndex link,
                                   const DeclareDimension& new_dimension);

}  // namespace assur::generator::equations
