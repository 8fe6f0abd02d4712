// Pairs of features that the joints of a mechanism hold together, redundant joints included.
#pragma once

#include <array>
#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// Two features, and the coordinates (x, y, theta) of the second one in the frame of the first that
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

/// Whether a joint was not described, but replaces a redundant joint with fewer constraints.
[[nodiscard]] bool is_stand_in(const Joint& joint, const std::vector<RedundantJoint>& redundant);

/// The pair of features that a redundant joint holds.
[[nodiscard]] HeldPair held_by(const Mechanism& mechanism, const RedundantJoint& joint);

/// The pairs that all described joints hold; joints that are solved, not redundant ones, come
/// first.
[[nodiscard]] std::vector<HeldPair> held_pairs(const Mechanism& mechanism,
                                               const std::vector<RedundantJoint>& redundant);
/// The pairs of joints between two links.
[[nodiscard]] std::vector<HeldPair> pairs_of_two_links(
    const Mechanism& mechanism, const std::vector<RedundantJoint>& redundant);

}  // namespace assur::mechanism
