// Motions through a configuration at which the constraints lose rank.
#pragma once

#include <optional>
#include <vector>

#include "moving_constraints.hpp"

namespace assur::mechanism::solve {

/// A motion through a configuration, to second order.
struct Motion {
  MovingConstraints::Parts parts;
  bool is_known_twice;  ///< whether its second order is known
};

/// The motions q(t) with F(q(t), t) = 0 through a configuration, order by order:
///
///     J q_k = -f_k,    f_k the constraints' coefficient without q_k.
///
/// Where J = F'(q) has full column rank there is one motion. Otherwise let N span its kernel and W
/// that of its transpose. There is no motion unless W' f_1 = 0 (at a fold the rates are unbounded).
/// If it holds, q_1 = p + N c, and the next order determines c: W' f_2(c) = 0, quadratic equations,
/// the tangent cone. At a simple root, W' f_(k + 1) = 0 is linear in the part of q_k along N. At a
/// multiple one, branches touch or J is singular along a whole branch: then W' f_4 is quadratic in
/// the part of q_2 along N that W' f_3 = 0 leaves undetermined.
///
/// N and W are chosen in echelon form along the groups in the order of placement, N zero before a
/// group and W behind it, so that each group's few equations are solved separately for each root of
/// the earlier ones.
///
/// Where J nearly loses rank, the place of exact rank loss is located first, and used if all
/// constraints hold there up to rounding.
///
/// Returns nothing where the motion of the drivers or features is unknown. No motion is found where
/// a group has more than two unknowns of its own in c, or where its equations hold no information.
[[nodiscard]] std::optional<std::vector<Motion>> motions_through(const MovingConstraints& F);

}  // namespace assur::mechanism::solve
