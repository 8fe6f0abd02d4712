// Convex hull of points, the outline of a link.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace assur::mechanism::draw {

/// The indices of the corners of the convex hull, counter-clockwise: two if all points are on one
/// line, one if all are within `same` of the first. Corners that protrude by less than a thousandth
/// of the whole are omitted.
[[nodiscard]] std::vector<std::size_t> convex_hull(const std::vector<Eigen::Vector2d>& points,
                                                   double same);

}  // namespace assur::mechanism::draw
