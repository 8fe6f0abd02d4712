// Turns links that form no known group into a known group of some of them, relative to another one,
// and what is left.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <optional>

#include "decomposition.hpp"

namespace assur::mechanism::plan {

/// Links that hold one another, whatever holds them: a group, and the link relative to which it is
/// solved. Together they are one link of what is left, whose shape moves.
struct Cluster {
  FoundGroup group;  ///< with its base
  Component left;    ///< without the group's links; what they held, the base holds
};

/// The smallest cluster among some links, nothing if there is none. Of n links k joints make one
/// where 2 k = 3 (n - 1). Its base is the link of most joints, as the dimensions of what it carries
/// change, and then the one whose name comes first. A pin of three links or more is split into
/// joints of two so that those of the cluster are joined to one another: this is set in the
/// linkage.
[[nodiscard]] std::optional<Cluster> find_cluster(Linkage& linkage, const Component& component);

}  // namespace assur::mechanism::plan
