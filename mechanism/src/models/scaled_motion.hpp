// Turns the numbers of one group in any unit of length into its motion.
#pragma once

#include <assur/mechanism/group_model.hpp>

#include "models/model_kernel.hpp"

namespace assur::mechanism::models {

/// Sets what `ModelKernel::move` sets, in the unit of the given lengths. A model's own function
/// divides by products of as many lengths as it has unknowns, which leave the range of double if
/// the unit is far from the group's size. Such numbers are first brought to a unit near that size,
/// by a power of two, so that no digit is lost.
void move_in_any_unit(const GroupModel& model, const FlatVariables& d, const FlatVariables& u,
                      const FlatVariables& q, const MotionQuery& query, GroupMotion& motion);

}  // namespace assur::mechanism::models
