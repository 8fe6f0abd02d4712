// The scene of a random group of a given kind.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "kind_in_space.hpp"

namespace assur::test {

inline std::string feature_text(const BodyFeature& feature, bool line) {
  std::ostringstream text;
  text.precision(17);
  const auto x = static_cast<double>(feature.x);
  const auto y = static_cast<double>(feature.y);
  if (line) {
    text << R"({"through": [)" << x << ", " << y << R"(], "along": [)"
         << std::cos(static_cast<double>(feature.angle)) << ", "
         << std::sin(static_cast<double>(feature.angle)) << "]}";
  } else {
    text << "[" << x << ", " << y << "]";
  }
  return text.str();
}

/// The scene file of a group, its links and joints listed in given orders.
template <typename Space>
std::string scene_text(const Space& space, const std::vector<std::size_t>& link_order,
                       const std::vector<std::size_t>& joint_order) {
  const auto& joints = space.bodies.joints;
  const auto link_text = [&](int link) {
    std::string features;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      const bool first = joints[joint].first == link;
      if (first || joints[joint].second == link) {
        features += (features.empty() ? "\"J" : ", \"J") + std::to_string(joint) + "\": " +
                    feature_text(first ? joints[joint].on_first : joints[joint].on_second,
                                 joints[joint].prismatic);
      }
    }
    return features;
  };
  std::string text = R"({"links": {"ground": {)" + link_text(-1) + "}";
  for (const std::size_t link : link_order) {
    text += ", \"L" + std::to_string(link) + "\": {" + link_text(static_cast<int>(link)) + "}";
  }
  text += R"(}, "joints": {)";
  bool first = true;
  for (const std::size_t joint : joint_order) {
    const auto name = [&](int link) {
      return (link < 0 ? std::string("ground") : "L" + std::to_string(link)) + ".J" +
             std::to_string(joint);
    };
    const BodyJoint& at = joints[joint];
    text += std::string(first ? "" : ", ") + "\"J" + std::to_string(joint) + R"(": {"type": ")" +
            (at.prismatic ? "prismatic" : "revolute") + R"(", "between": [")" + name(at.first) +
            R"(", ")" + name(at.second) + R"("]})";
    first = false;
  }
  return text + "}}";
}

}  // namespace assur::test
