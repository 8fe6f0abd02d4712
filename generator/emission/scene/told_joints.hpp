// Lists the joints of a scene, redundant ones included, for whose forces a state has members.
#pragma once

#include <assur/mechanism/held_pairs.hpp>
#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// A joint for whose force a state has a member.
struct ToldJoint {
  std::string name, member;
  std::vector<mechanism::LinkIndex> links;  ///< each once, in the order of `between`
  std::vector<std::string> link_members;    ///< of a pin of several links
  bool has_moment = false;
  std::vector<std::size_t> pairs;  ///< that hold it, among all of the mechanism

  [[nodiscard]] bool is_pin() const { return links.size() > 2; }
};

/// The joints, in the order of the mechanism's; redundant ones that it lacks are behind them.
[[nodiscard]] std::vector<ToldJoint> told_joints(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
