// Tests of joint coordinates against their limits.
#pragma once

#include <algorithm>
#include <assur/support/batch_limits.hpp>
#include <cmath>
#include <limits>

namespace assur::support {

/// The tolerance by which rounding may move a coordinate beyond limits that it keeps.
template <typename Scalar>
[[nodiscard]] Scalar limit_slack(Scalar lowest, Scalar highest) {
  constexpr Scalar rounding =
      (std::max)(static_cast<Scalar>(1e-12), 32 * std::numeric_limits<Scalar>::epsilon());
  return rounding * (std::max)({Scalar(1), std::abs(lowest), std::abs(highest)});
}

/// Whether a displacement lies between two others, to rounding; the ends count as between.
template <typename Scalar>
[[nodiscard]] bool is_between(Scalar lowest, Scalar displacement, Scalar highest) {
  const Scalar slack = limit_slack(lowest, highest);
  return lowest - slack <= displacement && displacement <= highest + slack;
}

/// Whether an angle lies between two others after addition of whole turns. Radians.
template <typename Scalar>
[[nodiscard]] bool is_turned_between(Scalar lowest, Scalar angle, Scalar highest) {
  constexpr auto turn = static_cast<Scalar>(6.283185307179586);
  const Scalar slack = limit_slack(lowest, highest);
  const Scalar first = angle + turn * std::ceil((lowest - slack - angle) / turn);
  return first <= highest + slack;
}

}  // namespace assur::support
