// Turns points into the outline of the link that holds them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace assur::mechanism::draw {

/// The corners of the convex hull, counter-clockwise, by their places: two where all points are on
/// one line, one where all are within `same` of the first. Corners that stand out by less than a
/// thousandth of the whole are left out.
[[nodiscard]] std::vector<std::size_t> convex_hull(const std::vector<Eigen::Vector2d>& points,
                                                   double same);

}  // namespace assur::mechanism::draw
