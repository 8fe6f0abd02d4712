// Turns a group of a mechanism whose neighbours are placed into a problem in the model's own terms,
// and the model's answer back into the mechanism's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/group_problem.hpp"
#include "scene/grouping.hpp"

namespace assur::generator {

/// The links of a mechanism as far as they are placed.
using PlacedLinks = std::vector<std::optional<LinkState>>;

/// A group with its links in normal form: the first assignment of roles under which they have one.
struct PosedGroup {
  const FoundGroup* group = nullptr;
  const RoleAssignment* roles = nullptr;
  GroupProblem problem;
};

/// The group with its links in normal form, before its neighbours are placed; otherwise nothing,
/// and `obstacle` says which link has none under any assignment.
[[nodiscard]] std::optional<PosedGroup> in_normal_form(const Mechanism& mechanism,
                                                       const FoundGroup& group,
                                                       const ParameterValues& values,
                                                       std::string& obstacle);

/// The group's problem where its neighbours are placed; otherwise nothing, and `obstacle` says
/// which link has no normal form under any assignment.
[[nodiscard]] std::optional<PosedGroup> posed(const Mechanism& mechanism, const FoundGroup& group,
                                              const PlacedLinks& placed,
                                              const ParameterValues& values, std::string& obstacle);

/// A frame's own origin and axes, seen from a frame that is given in it.
[[nodiscard]] Pose<Dual> own_frame(const Pose<Dual>& local);

/// Places the group's links, in the mechanism's own frames.
void place_links(const PosedGroup& posed, const GroupState& state, PlacedLinks& placed);

/// How the mechanism measures a slide of the group: sense * (displacement + shift).
struct SlideMeasure {
  double sense;
  Dual shift;
};
[[nodiscard]] SlideMeasure slide_measure(const Mechanism& mechanism, const PosedGroup& posed,
                                         int model_joint, const ParameterValues& values);

/// A slide of the group as the mechanism measures it: between the points that its features name.
[[nodiscard]] SlideState mechanism_slide(const Mechanism& mechanism, const PosedGroup& posed,
                                         const SlideState& slide, const ParameterValues& values);

/// The mechanism's joint that plays a joint of the group.
[[nodiscard]] const MechanismJoint& played_joint(const Mechanism& mechanism,
                                                 const RoleAssignment& roles, int joint);

}  // namespace assur::generator
