// The SVG picture of a drawing with the positions of its elements, and the pins' positions in
// configurations.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <map>
#include <string>
#include <vector>

#include "mechanism/xml.hpp"

namespace assur::test {

/// Where a feature is in a configuration, from the poses of `solve` and the scene's own numbers.
inline Eigen::Vector2d place_of(const mechanism::Values& values,
                                const mechanism::Configuration& configuration,
                                const std::string& link, const mechanism::Feature& feature) {
  const assur::Pose<double>& pose = configuration.link(link).pose;
  const double x = values.value_of(feature.x);
  const double y = values.value_of(feature.y);
  return {pose.x + pose.direction.cos * x - pose.direction.sin * y,
          pose.y + pose.direction.sin * x + pose.direction.cos * y};
}

/// The places of all revolute joints and of all pins in slots, by their names.
inline std::map<std::string, Eigen::Vector2d> pins_of(
    const mechanism::Plan& plan, const mechanism::Values& values,
    const mechanism::Configuration& configuration) {
  std::map<std::string, Eigen::Vector2d> pins;
  for (const mechanism::Joint& joint : plan.mechanism().joints()) {
    for (const mechanism::FeatureIndex at : joint.between) {
      const mechanism::Feature& feature = plan.mechanism().features()[at];
      if (!feature.is_line) {
        pins[joint.name] =
            place_of(values, configuration, plan.mechanism().links()[feature.link].name, feature);
      }
    }
  }
  return pins;
}

/// A picture and its elements.
struct Picture {
  explicit Picture(const mechanism::Drawing& drawing)
      : text(drawing_svg(drawing)), root(XmlReader(text).document()) {
    root.collect(elements);
  }
  [[nodiscard]] double number(const std::string& name) const {
    return std::stod(root.attribute(name));
  }
  /// A place of the picture in the scene.
  [[nodiscard]] Eigen::Vector2d in_scene(double u, double v) const {
    return {number("data-x") + u / number("data-scale"),
            number("data-y") - v / number("data-scale")};
  }

  std::string text;
  XmlElement root;
  std::vector<const XmlElement*> elements;
};

}  // namespace assur::test
