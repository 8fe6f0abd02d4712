// Turns a point that moves across the held axis of its link into the motion of the link's group.
#pragma once

#include <vector>

#include "models/model_kernel.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

/// How a group follows a point across an axis: the unknowns, and the poses at fixed unknowns.
struct AcrossColumns {
  models::SmallVector q, p;
};

/// Closures and poses are linear in the coordinates of a link that has points alone, rotated by the
/// link's direction. A coordinate across the axis is therefore one along the axis of the link
/// turned by a right angle: the derivatives with respect to it are those with respect to the
/// dimension along the axis there.
[[nodiscard]] AcrossColumns across_columns(const GroupModel& model, const models::FlatVariables& d,
                                           const models::FlatVariables& u,
                                           const models::FlatVariables& q,
                                           const models::SmallMatrix& inverse,
                                           const values::AcrossAxis& axis);

}  // namespace assur::mechanism::solve
