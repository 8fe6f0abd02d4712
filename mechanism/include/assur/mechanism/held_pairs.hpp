// Turns all joints of a mechanism, redundant ones among them, into pairs of features that they
// hold.
#pragma once

#include <array>
#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism {

/// Two features, and which coordinates (x, y, theta) of the second one in the frame of the first
/// are told; the driver says what one of them is. Of a pin and a line the line is the first.
struct HeldPair {
  FeatureIndex first, second;
  std::array<bool, 3> holds;
  DriverIndex driver = {};
  int driven = 0;  ///< the coordinate that the driver tells
};

/// Whether a joint is not one that was described, but stands in for what is left of a redundant
/// one.
[[nodiscard]] bool is_stand_in(const Joint& joint, const std::vector<RedundantJoint>& redundant);

/// What a redundant joint holds.
[[nodiscard]] HeldPair held_by(const Mechanism& mechanism, const RedundantJoint& joint);

/// What all joints hold that were described, those that are solved for first.
[[nodiscard]] std::vector<HeldPair> held_pairs(const Mechanism& mechanism,
                                               const std::vector<RedundantJoint>& redundant);

}  // namespace assur::mechanism
