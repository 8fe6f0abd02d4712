#include "draw/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace assur::mechanism::draw {

namespace {

constexpr double slack = 1e-3;

double cross(const Eigen::Vector2d& one, const Eigen::Vector2d& other) {
  return one.x() * other.y() - one.y() * other.x();
}

}  // namespace

std::vector<std::size_t> convex_hull(const std::vector<Eigen::Vector2d>& points, double same) {
  if (points.empty()) {
    return {};
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return std::pair(points[one].x(), points[one].y()) <
           std::pair(points[other].x(), points[other].y());
  });
  Eigen::Vector2d lowest = points[0];
  Eigen::Vector2d highest = points[0];
  for (const Eigen::Vector2d& point : points) {
    lowest = lowest.cwiseMin(point);
    highest = highest.cwiseMax(point);
  }
  const double whole_size = (highest - lowest).norm();
  if (whole_size <= same) {
    return {order[0]};
  }
  const double least = slack * whole_size;
  std::vector<std::size_t> hull;
  // The lower half from left to right, then the upper half back.
  const auto add_half = [&](auto first, auto last) {
    const std::size_t fixed = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= fixed + 2) {
        const Eigen::Vector2d& before = points[hull[hull.size() - 2]];
        const Eigen::Vector2d whole = points[*first] - before;
        const Eigen::Vector2d part = points[hull.back()] - before;
        if (cross(part, whole) > least * whole.norm()) {
          break;
        }
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // the other half begins with this point
  };
  add_half(order.begin(), order.end());
  add_half(order.rbegin(), order.rend());
  return hull;
}

}  // namespace assur::mechanism::draw
