#include "groups/loop_equations.hpp"

#include <cmath>

namespace assur::mechanism::groups {

namespace {

Eigen::VectorXcd complex_closures(const PlacedLinks<double>& placed) {
  Eigen::VectorXcd result(static_cast<Eigen::Index>(placed.closures.size() / 2));
  for (Eigen::Index loop = 0; loop < result.size(); ++loop) {
    const auto place = static_cast<std::size_t>(2 * loop);
    result(loop) = {placed.closures[place], placed.closures[place + 1]};
  }
  return result;
}

}  // namespace

LoopEquations loop_equations(const Loops& loops,
                             const std::vector<JointFeatures<double>>& features) {
  // The closures are linear in the directions, so that a direction may be zero here.
  const auto closures = [&](int angle, int slide) {
    std::vector<Direction<double>> directions(static_cast<std::size_t>(loops.angle_count), {0, 0});
    if (angle > 0) {
      directions[static_cast<std::size_t>(angle - 1)] = {1, 0};
    }
    std::vector<double> displacements(static_cast<std::size_t>(loops.slide_count), 0);
    if (slide >= 0) {
      displacements[static_cast<std::size_t>(slide)] = 1;
    }
    return complex_closures(place_links(loops, features, directions, displacements));
  };
  LoopEquations result;
  const auto count = static_cast<Eigen::Index>(loops.loop_count());
  result.of_angles.resize(count, loops.angle_count + 1);
  result.of_slides.resize(count, loops.slide_count);
  for (int angle = 0; angle <= loops.angle_count; ++angle) {
    result.of_angles.col(angle) = closures(angle, -1);
    if (angle > 0) {
      result.of_angles.col(angle) -= result.of_angles.col(0);
    }
  }
  for (std::size_t joint = 0; joint < loops.joints.size(); ++joint) {
    if (const int slide = loops.slide[joint]; slide >= 0) {
      const int angle = loops.angle_of(loops.joints[joint].second);
      result.slide_angles.push_back(angle);
      result.of_slides.col(slide) = closures(angle, slide) - closures(angle, -1);
    }
  }
  return result;
}

Eigen::VectorXcd closures_at(const LoopEquations& equations, const ComplexConfiguration& at) {
  const Eigen::Index loops = equations.loop_count();
  Eigen::VectorXcd along(at.s.size());
  Eigen::VectorXcd against(at.s.size());
  for (Eigen::Index slide = 0; slide < at.s.size(); ++slide) {
    const Complex theta = at.theta(equations.slide_angles[static_cast<std::size_t>(slide)]);
    along(slide) = at.s(slide) * theta;
    against(slide) = at.s(slide) / theta;
  }
  Eigen::VectorXcd result(2 * loops);
  result.head(loops) = equations.of_angles * at.theta + equations.of_slides * along;
  result.tail(loops) = equations.of_angles.conjugate() * at.theta.cwiseInverse() +
                       equations.of_slides.conjugate() * against;
  return result;
}

Eigen::MatrixXcd jacobian_at(const LoopEquations& equations, const ComplexConfiguration& at) {
  const Complex i(0, 1);
  const Eigen::Index loops = equations.loop_count();
  const Eigen::Index angles = equations.angle_count();
  Eigen::MatrixXcd result(2 * loops, angles + equations.slide_count());
  for (Eigen::Index angle = 1; angle <= angles; ++angle) {
    const Complex theta = at.theta(angle);
    result.col(angle - 1).head(loops) = i * theta * equations.of_angles.col(angle);
    result.col(angle - 1).tail(loops) = -i / theta * equations.of_angles.col(angle).conjugate();
  }
  for (Eigen::Index slide = 0; slide < equations.slide_count(); ++slide) {
    const int angle = equations.slide_angles[static_cast<std::size_t>(slide)];
    const Complex theta = at.theta(angle);
    const Eigen::VectorXcd along = theta * equations.of_slides.col(slide);
    const Eigen::VectorXcd against = equations.of_slides.col(slide).conjugate() / theta;
    result.col(angles + slide).head(loops) = along;
    result.col(angles + slide).tail(loops) = against;
    if (angle > 0) {
      result.col(angle - 1).head(loops) += i * at.s(slide) * along;
      result.col(angle - 1).tail(loops) -= i * at.s(slide) * against;
    }
  }
  return result;
}

ComplexConfiguration stepped(const ComplexConfiguration& from, const Eigen::VectorXcd& step) {
  const Complex i(0, 1);
  const Eigen::Index angles = from.theta.size() - 1;
  ComplexConfiguration result = from;
  for (Eigen::Index angle = 1; angle <= angles; ++angle) {
    result.theta(angle) *= std::exp(i * step(angle - 1));
  }
  result.s += step.tail(from.s.size());
  return result;
}

}  // namespace assur::mechanism::groups
