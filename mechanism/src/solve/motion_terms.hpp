// Turns the motion of a group's dimensions and inputs into the size of the terms whose sum it is,
// against which this sum is measured.
#pragma once

#include "group_branches.hpp"
#include "moving_shape.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

/// The terms of a group's dimensions and inputs, which move as in d and u, at a configuration q. A
/// rate may be what cancellation has left: the rate of a length is zero where the length is at its
/// maximum, although its ends move, and so is the rate of a law at its maximum.
[[nodiscard]] MotionTerms motion_terms(const GroupModel& model, const Values::GroupNumbers& numbers,
                                       const ShapeSpeed& speed, const models::FlatSeries& d,
                                       const models::FlatSeries& u, const models::FlatVariables& q);

}  // namespace assur::mechanism::solve
