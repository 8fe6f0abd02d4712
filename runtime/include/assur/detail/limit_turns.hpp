// Limit on the rotations in a Newton step, within which its linearisation is useful.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <cmath>

namespace assur::detail {

/// Shortens a Newton step that turns a link too far for its linearisation. The whole step is scaled
/// so that angles move by at most half a radian; angles of links with short levers have less
/// weight. Such a link's turn moves no joint far and should not limit the others; it is limited
/// alone.
template <typename Model, typename Scalar>
void limit_turns(const Matrix<Scalar, Model::equation_count, Model::unknown_count>& jacobian,
                 Vector<Scalar, Model::unknown_count>& step) {
  using std::abs;
  using std::max;
  using std::min;
  const auto for_each_angle = [](auto use) {
    for (int index = 0; index < Model::unknown_count; ++index) {
      if (is_angle<Model>(index)) {
        use(index);
      }
    }
  };
  const auto lever = [&jacobian](int index) {
    return Scalar(jacobian.col(index).cwiseAbs().maxCoeff());
  };
  Scalar longest(0);
  for_each_angle([&](int index) { longest = max EIGEN_NOT_A_MACRO(longest, lever(index)); });
  Scalar largest(0);
  for_each_angle([&](int index) {
    // A lever of at least a quarter of the longest one counts in full.
    const Scalar weight = min EIGEN_NOT_A_MACRO(Scalar(1), Scalar(4) * lever(index) / longest);
    largest = max EIGEN_NOT_A_MACRO(largest, weight * abs(step(index)));
  });
  const auto limit = Scalar(0.5);
  if (largest > limit) {
    step *= limit / largest;
  }
  for_each_angle([&](int index) {
    step(index) = max EIGEN_NOT_A_MACRO(-limit, min EIGEN_NOT_A_MACRO(limit, step(index)));
  });
}

}  // namespace assur::detail
