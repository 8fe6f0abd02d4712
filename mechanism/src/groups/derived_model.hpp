// Groups of any size by their graphs: their kernels, and proofs that no configuration is missing.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <string>
#include <vector>

#include "groups/derived_kernel.hpp"

namespace assur::mechanism::groups {

/// A proof for a group with these joints, the features of its links and of the base in one frame,
/// and these directions of the links: those of the configuration whose ball is told.
[[nodiscard]] GroupProof proof_of(const std::vector<ModelJoint>& joints,
                                  const std::vector<JointFeatures<double>>& features,
                                  const std::vector<Direction<double>>& directions);

}  // namespace assur::mechanism::groups
