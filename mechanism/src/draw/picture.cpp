// Scale and place of a drawing in its picture.
#include <algorithm>
#include <cmath>

#include "draw/svg_parts.hpp"

namespace assur::mechanism::draw {

namespace {

constexpr double edge = 17;
constexpr double tallest = 330;  ///< the tallest drawing, so that a picture fits a column of a page

}  // namespace

Picture picture_of(const Drawing& drawing, double legend) {
  Eigen::Vector2d lowest = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d highest = -lowest;
  const auto include = [&](const std::vector<Eigen::Vector2d>& points) {
    for (const Eigen::Vector2d& point : points) {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
  };
  for (const Stance& stance : drawing.stances) {
    include(stance.points);
  }
  for (const Stance& stance : drawing.motion) {
    include(stance.points);
  }
  for (const Trace& trace : drawing.traces) {
    include(trace.points);
  }
  for (const ForceArrow& force : drawing.forces) {
    include({force.at + drawing.length_of_force * force.force});
  }
  const Eigen::Vector2d size = highest - lowest;
  const double room = Picture::width - 2 * edge;
  double scale = std::min(room / size.x(), tallest / size.y());
  if (!std::isfinite(scale)) {
    scale = 1;  // all points coincide
  }
  const double side = (Picture::width - scale * size.x()) / 2;
  return {scale * size.y() + 2 * edge + legend, scale, lowest.x() - side / scale,
          highest.y() + edge / scale};
}

double round_length(double longest) {
  const double power = std::pow(10, std::floor(std::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= longest) {
      return factor * power;
    }
  }
  return power;
}

}  // namespace assur::mechanism::draw
