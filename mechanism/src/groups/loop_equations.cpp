#include "groups/loop_equations.hpp"

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

}  // namespace assur::mechanism::groups
