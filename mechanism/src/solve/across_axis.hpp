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

/// A point of a link that moves across the link's axis; the places are those of `AcrossAxis`.
struct AcrossOnTheMove {
  std::size_t dimension, angle;
  models::Series way;
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

/// The closures and poses of a group that moves, with points that move across axes.
void expand(const GroupModel& model, const models::FlatSeries& d, const models::FlatSeries& u,
            const models::FlatSeries& q, const std::vector<AcrossOnTheMove>& across,
            models::MovingGroup& moving);

}  // namespace assur::mechanism::solve
