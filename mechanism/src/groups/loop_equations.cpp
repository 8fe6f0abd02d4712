#include "groups/loop_equations.hpp"

#include <cmath>
#include <numbers>

namespace assur::mechanism::groups {

LoopEquations loop_equations(const Loops& loops,
                             const std::vector<JointFeatures<double>>& features) {
  const auto closures_at = [&](Eigen::Index angle, Eigen::Index slide) {
    std::vector<Direction<double>> directions(static_cast<std::size_t>(loops.angle_count), {0, 0});
    if (angle > 0) {
      directions[static_cast<std::size_t>(angle - 1)] = {1, 0};
    }
    std::vector<double> displacements(static_cast<std::size_t>(loops.slide_count), 0);
    if (slide >= 0) {
      displacements[static_cast<std::size_t>(slide)] = 1;
    }
    const std::vector<double> closures =
        place_links(loops, features, directions, displacements).closures;
    Eigen::VectorXcd result(loops.loop_count());
    for (Eigen::Index loop = 0; loop < result.size(); ++loop) {
      const auto place = static_cast<std::size_t>(2 * loop);
      result(loop) = {closures[place], closures[place + 1]};
    }
    return result;
  };
  const std::vector<int> along = slide_angles_of(loops);
  const Eigen::VectorXi slide_angles =
      Eigen::Map<const Eigen::VectorXi>(along.data(), loops.slide_count);
  return assur::loops::loop_equations<assur::loops::AnySizes>(loops.loop_count(), loops.angle_count,
                                                              slide_angles, closures_at);
}

double GeneralEquations::next_length() {
  return std::uniform_real_distribution<double>(-1, 1)(engine_);
}

loops::Complex GeneralEquations::next_turn() {
  return std::polar(1.0, std::numbers::pi * next_length());
}

LoopEquations GeneralEquations::next() {
  std::vector<JointFeatures<double>> features;
  for (const ModelJoint& joint : loops_.joints) {
    JointFeatures<double>& one = features.emplace_back();
    for (LinkFeature<double>* feature : {&one.on_first, &one.on_second}) {
      const double x = next_length();
      const double y = next_length();
      const loops::Complex along = joint.prismatic ? next_turn() : 1.0;
      *feature = {joint.prismatic, x, y, {along.real(), along.imag()}};
    }
  }
  return loop_equations(loops_, features);
}

GeneralEquations::Closed GeneralEquations::next_closed() {
  Closed result{next(), {}};
  result.at.theta.setOnes(loops_.angle_count + 1);
  for (Eigen::Index angle = 1; angle < result.at.theta.size(); ++angle) {
    result.at.theta(angle) = next_turn();
  }
  result.at.s.resize(loops_.slide_count);
  for (loops::Complex& s : result.at.s) {
    s = next_length();
  }
  // A joint that closes a loop is moved on its second link to its place on the first one.
  const Eigen::VectorXcd open = assur::loops::closures_at(result.equations, result.at);
  for (Eigen::Index loop = 0; loop < result.equations.loop_count(); ++loop) {
    const int joint = loops_.closing[static_cast<std::size_t>(loop)];
    const int angle = loops_.angle_of(loops_.joints[static_cast<std::size_t>(joint)].second);
    result.equations.of_angles(loop, angle) -= open(loop) / result.at.theta(angle);
  }
  return result;
}

}  // namespace assur::mechanism::groups
