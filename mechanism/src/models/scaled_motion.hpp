// Motion of a group from its numbers in any unit of length.
#pragma once

#include <assur/mechanism/group_model.hpp>

#include "models/model_kernel.hpp"

namespace assur::mechanism::models {

/// Computes the results of `ModelKernel::move`, in the unit of the given lengths. A model's own
/// function divides by products of as many lengths as it has unknowns, which exceed the range of
/// double if the unit is far from the group's size. Such numbers are first scaled to a unit near
/// that size, by a power of two, so that no digit is lost.
void move_in_any_unit(const GroupModel& model, const FlatVariables& d, const FlatVariables& u,
                      const FlatVariables& q, const MotionQuery& query, GroupMotion& motion);

}  // namespace assur::mechanism::models
