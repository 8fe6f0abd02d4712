// Motion of a group due to a point that moves across the held axis of its link.
#pragma once

#include <vector>

#include "models/model_kernel.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

/// Derivatives with respect to a point's coordinate across an axis: of the unknowns, and of the
/// poses at fixed unknowns.
struct AcrossColumns {
  models::SmallVector q, p;
};

/// In the coordinates of a link that has points alone, rotated by the link's direction, closures
/// and poses are linear. A coordinate across the axis is therefore one along the axis of the link
/// turned by a right angle, and has the derivatives of the dimension along that axis.
[[nodiscard]] AcrossColumns across_columns(const GroupModel& model, const models::FlatVariables& d,
                                           const models::FlatVariables& u,
                                           const models::FlatVariables& q,
                                           const models::SmallMatrix& inverse,
                                           const values::AcrossAxis& axis);

}  // namespace assur::mechanism::solve
