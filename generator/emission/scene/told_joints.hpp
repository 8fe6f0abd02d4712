// The joints whose forces a state reports, redundant joints included.
#pragma once

#include <assur/mechanism/held_pairs.hpp>
#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// A joint with a member of the state for its force.
struct ToldJoint {
  std::string name, member;
  std::vector<mechanism::LinkIndex> links;  ///< each once, in the order of `between`
  std::vector<std::string> link_members;    ///< for a pin of several links
  bool has_moment = false;
  std::vector<std::size_t> pairs;  ///< its pairs, among those of the mechanism

  [[nodiscard]] bool is_pin() const { return links.size() > 2; }
};

/// The joints in the order of the mechanism; redundant ones that it does not contain follow.
[[nodiscard]] std::vector<ToldJoint> told_joints(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
