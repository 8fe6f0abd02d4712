#include "emission/scene/redundancy_tests.hpp"

#include <assur/text/names.hpp>

namespace assur::generator::emission::scene {

namespace {

/// Where a feature stands, as a pose; a point's direction is its link's.
std::string pose_of(const SolverScene& solver, mechanism::FeatureIndex index, SceneLines& lines) {
  const mechanism::Feature& feature = solver.mechanism().features()[index];
  const LinkFeature<SceneNumber> place = solver.numbers.feature(index, feature.is_line);
  const std::string own = "Pose<Scalar>{" + lines.number(place.x) + ", " + lines.number(place.y) +
                          ", " + lines.direction(place.along) + "}";
  const std::string link = solver.placed(feature.link);
  return link.empty() ? own : "support::pose_in(" + link + ".pose, " + own + ")";
}

}  // namespace

std::vector<std::string> redundancy_tests(const SolverScene& solver, SceneLines& lines) {
  std::vector<std::string> tests;
  const std::vector<mechanism::RedundantJoint>& joints = solver.plan.redundant();
  if (joints.empty()) {
    return tests;
  }
  std::vector<std::string> poses;
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (!solver.is_ground(link)) {
      poses.push_back(solver.placed(link) + ".pose");
    }
  }
  for (const mechanism::RedundantJoint& joint : joints) {
    const std::string pair = "redundant_" + std::to_string(tests.size() + 1);
    lines.add("const std::array<Pose<Scalar>, 2> " + pair + " = {{" +
              pose_of(solver, joint.one, lines) + ", " + pose_of(solver, joint.other, lines) +
              "}};");
    const bool are_lines = solver.mechanism().features()[joint.one].is_line;
    poses.insert(poses.end(), {pair + "[0]", pair + "[1]"});
    tests.push_back((are_lines ? "support::lines_apart(" : "support::points_apart(") + pair +
                    "[0], " + pair + "[1]" + (are_lines ? ", size" : "") + ") <= slack");
  }
  lines.add("const Scalar size = support::largest_coordinate(std::array<Pose<Scalar>, " +
            std::to_string(poses.size()) + ">{{" + text::joined(poses, ", ") + "}});");
  const std::string slack = "support::redundancy_slack(size, placed.regularity)";
  const mechanism::NumberIndex given = solver.plan.request().redundancy_tolerance;
  lines.add("const Scalar slack = " +
            (given.exists() ? "(std::max)(" + slack + ", Scalar(" +
                                  lines.number(solver.numbers.number(given)) + "))"
                            : slack) +
            ";");
  return tests;
}

}  // namespace assur::generator::emission::scene
