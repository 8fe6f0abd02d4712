// Turns a scene into its assembly configurations, with the states of its links, slides and points.
#pragma once

#include <string>
#include <vector>

#include "scene/group_problem.hpp"
#include "scene/grouping.hpp"

namespace assur::generator {

enum class SolutionStatus : unsigned char { ok, no_assembly, degenerate };

/// A prismatic or pin-in-slot joint: displacement between the features that the scene names.
struct JointState {
  std::string name;
  Dual displacement;
  double velocity;
  double acceleration;
};

/// One assembly configuration of the whole mechanism.
struct AssemblyConfiguration {
  std::vector<LinkState> links;  ///< of the scene's links
  std::vector<JointState> joints;
  std::vector<PointState> outputs;
  Status regularity = Status::ok;
  double residual = 0;
};

struct Solution {
  SolutionStatus status = SolutionStatus::ok;
  int mobility = 0;
  std::string reason;  ///< why it is degenerate
  std::vector<FoundGroup> groups;
  std::vector<std::vector<std::string>> group_links;  ///< in the order of the scene
  std::vector<AssemblyConfiguration> configurations;
  int undecided = 0;  ///< places where no arithmetic here tells whether there are configurations
};

/// Solves a scene: the driven links, then its Assur groups one after the other; every combination
/// of their configurations is one of the mechanism. Throws InputError for a scene that is over- or
/// under-constrained, or holds a group that is not known.
[[nodiscard]] Solution solve(const Scene& scene, const ParameterValues& values);

}  // namespace assur::generator
