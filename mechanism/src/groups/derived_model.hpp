// Kernels of groups of any size, from their graphs, and proofs that no configuration is missing.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <string>
#include <vector>

#include "groups/derived_kernel.hpp"

namespace assur::mechanism::groups {

/// A proof for a group with these joints, the features of its links and of the base in one frame,
/// and the directions of the links in the configuration whose ball is returned.
[[nodiscard]] GroupProof proof_of(const std::vector<ModelJoint>& joints,
                                  const std::vector<JointFeatures<double>>& features,
                                  const std::vector<Direction<double>>& directions);

}  // namespace assur::mechanism::groups
