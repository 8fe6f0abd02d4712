// Turns links that form no known group into a known group of some of them, solved relative to
// another link, and the rest.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <optional>

#include "decomposition.hpp"

namespace assur::mechanism::plan {

/// Links that hold one another, whatever holds them: a group, and the link relative to which it is
/// solved, its base. In the rest of the component they are one link whose shape moves.
struct Cluster {
  FoundGroup group;  ///< with its base
  Component rest;    ///< of the component; the base takes over the joints of the group's links
};

/// The smallest cluster among some links, nothing if there is none. n links with k joints are a
/// cluster where 2 k = 3 (n - 1). Its base is the link with the most joints, since the dimensions
/// of the links that it carries change, and then the one whose name comes first. A pin of three
/// links or more is split into joints of two in such a way that the links of the cluster are joined
/// to one another; this is changed in `linkage`.
[[nodiscard]] std::optional<Cluster> find_cluster(Linkage& linkage, const Component& component);

}  // namespace assur::mechanism::plan
