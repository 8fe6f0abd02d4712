// Groups that are solved relative to a moving link, found in components without a supported group.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <optional>

#include "decomposition.hpp"

namespace assur::mechanism::plan {

/// Links that are rigid among themselves, however they are held: a group, and its base, the link
/// relative to which it is solved. In the rest of the component they are one link of variable
/// shape.
struct Cluster {
  FoundGroup group;  ///< with its base
  Component rest;    ///< of the component; the base has the joints of the group's links
};

/// The smallest cluster among some links, nothing if there is none. n links with k joints are a
/// cluster if 2 k = 3 (n - 1). Its base is the link with the most joints, since the dimensions of
/// the links that it carries vary, and then the one whose name comes first. A pin of three links or
/// more is split into joints of two such that the links of the cluster are joined to one another;
/// `linkage` is changed accordingly.
[[nodiscard]] std::optional<Cluster> find_cluster(Linkage& linkage, const Component& component);

}  // namespace assur::mechanism::plan
