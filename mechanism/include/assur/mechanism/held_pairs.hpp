// Turns all joints of a mechanism, redundant ones among them, into pairs of features that they
// hold.
#pragma once

#include <array>
#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// Two features, and which coordinates (x, y, theta) of the second one in the frame of the first
/// are held; a driver may prescribe one of them. For a pin on a line, the line is the first.
struct HeldPair {
  FeatureIndex first, second;
  std::array<bool, 3> holds;
  DriverIndex driver = {};
  int driven = 0;  ///< the coordinate that the driver prescribes
  /// The two features in the order in which the joint is described.
  std::array<FeatureIndex, 2> between = {};
  std::string joint = {};  ///< the name of the joint to which the pair belongs
};

/// Whether a joint was not described, but stands in for what is left of a redundant joint.
[[nodiscard]] bool is_stand_in(const Joint& joint, const std::vector<RedundantJoint>& redundant);

/// The pair of features that a redundant joint holds.
[[nodiscard]] HeldPair held_by(const Mechanism& mechanism, const RedundantJoint& joint);

/// The pairs that all described joints hold; those that are solved for come first.
[[nodiscard]] std::vector<HeldPair> held_pairs(const Mechanism& mechanism,
                                               const std::vector<RedundantJoint>& redundant);
/// Those of them that are joints of two links.
[[nodiscard]] std::vector<HeldPair> pairs_of_two_links(
    const Mechanism& mechanism, const std::vector<RedundantJoint>& redundant);

}  // namespace assur::mechanism
