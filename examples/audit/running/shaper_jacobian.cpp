// The Jacobian of a quick-return shaper, as one might write it: a loop over the loops of links, a
// block for each, and a helper. It has a slip; `assur audit --run shaper.audit` finds it.
#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace {

struct Bar {
  double length;
  double angle;
  int column;
};

Eigen::Vector2d turned(const Bar& bar) {
  return bar.length * Eigen::Vector2d(-std::sin(bar.angle), std::cos(bar.angle));
}

}  // namespace

struct Shaper {
  double crank, lever, link;
};

/// Rows: both loops, x and y. Columns: theta, s, phi, x.
void shaper_jacobian(const Shaper& shaper, double theta, double s, double phi,
                     Eigen::Ref<Eigen::Matrix4d> jacobian) {
  const std::array<std::array<Bar, 2>, 2> loops = {
      {{{{s, theta, 0}, {0, phi, 2}}}, {{{shaper.lever, theta, 0}, {shaper.link, phi, 2}}}}};
  jacobian.setZero();
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    for (const Bar& bar : loops[loop]) {
      jacobian.block<2, 1>(static_cast<Eigen::Index>(2 * loop), bar.column) += turned(bar);
    }
  }
  jacobian.block<2, 1>(0, 1) << std::sin(theta), std::cos(theta);
  jacobian(2, 3) = -1;
}
