// Turns the coordinate of a joint and its limits into whether it keeps them.
#pragma once

#include <algorithm>
#include <cmath>

namespace assur::support {

/// How far rounding may have moved a coordinate beyond limits that it keeps.
[[nodiscard]] inline double limit_slack(double lowest, double highest) {
  constexpr double rounding = 1e-12;
  return rounding * (std::max)({1.0, std::abs(lowest), std::abs(highest)});
}

/// Whether a displacement lies between two others, to rounding; the ends count as between.
[[nodiscard]] inline bool is_between(double lowest, double displacement, double highest) {
  const double slack = limit_slack(lowest, highest);
  return lowest - slack <= displacement && displacement <= highest + slack;
}

/// Whether an angle can be turned by whole turns to lie between two others. Radians.
[[nodiscard]] inline bool is_turned_between(double lowest, double angle, double highest) {
  constexpr double turn = 6.283185307179586;
  const double slack = limit_slack(lowest, highest);
  const double first = angle + turn * std::ceil((lowest - slack - angle) / turn);
  return first <= highest + slack;
}

}  // namespace assur::support
