#include "emission/scene/sample_poses.hpp"

#include <assur/directions.hpp>
#include <assur/mechanism/error.hpp>

namespace assur::generator::emission::scene {

mechanism::Table<mechanism::LinkIndex, Pose<double>> poses_of_links(
    const mechanism::Plan& plan, const mechanism::Values& values) {
  const mechanism::Solution solution = plan.solve(values);
  if (solution.configurations.empty()) {
    throw mechanism::MechanismError(
        "links",
        "some are solved relative to a moving link, and no configuration at the scene's own "
        "numbers shows how they stand there; give parameters with which it can be assembled");
  }
  mechanism::Table<mechanism::LinkIndex, Pose<double>> poses;
  for (const mechanism::Frame& frame : solution.configurations.front().links) {
    poses.add(frame.pose);
  }
  poses.resize(plan.structure().linkage.links.size());  // blocks, which have no features
  return poses;
}

Pose<double> seen_from(const Pose<double>& frame, const Pose<double>& pose) {
  const Direction<double> back = reversed(frame.direction);
  const double x = pose.x - frame.x;
  const double y = pose.y - frame.y;
  return {back.cos * x - back.sin * y, back.sin * x + back.cos * y, turned(pose.direction, back)};
}

}  // namespace assur::generator::emission::scene
