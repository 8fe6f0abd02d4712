#include "emission/scene/limit_statements.hpp"

#include <assur/text/names.hpp>

#include "emission/scene/redundancy_tests.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The direction of the link that has a feature; empty for the ground.
std::string direction_of_link(const SolverScene& solver, mechanism::FeatureIndex feature) {
  const mechanism::LinkIndex link = solver.mechanism().features()[feature].link;
  const bool whole = solver.needs[link] == FrameNeed::everything;
  return solver.is_ground(link) ? "" : solver.placed(link) + (whole ? ".pose.direction" : "");
}

/// The angle from the first link of a pin to the second, up to whole turns.
std::string turned_angle(const SolverScene& solver, const mechanism::Joint& joint) {
  const std::string first = direction_of_link(solver, joint.between[0]);
  const std::string second = direction_of_link(solver, joint.between[1]);
  return first.empty()    ? "angle_of(" + second + ")"
         : second.empty() ? "-angle_of(" + first + ")"
                          : "angle_of(turned(" + second + ", reversed(" + first + ")))";
}

}  // namespace

std::vector<std::string> limit_statements(const SolverScene& solver) {
  SceneLines lines(solver.parameters, solver.numbers, solver.derivative_order);
  std::vector<std::string> tests = redundancy_tests(solver, lines);
  const auto& joints = solver.mechanism().joints();
  for (const mechanism::JointIndex index : joints.keys()) {
    const mechanism::Joint& joint = joints[index];
    if (!joint.lowest.exists()) {
      continue;
    }
    const bool turns = joint.type == mechanism::JointType::revolute;
    tests.push_back((turns ? "support::is_turned_between(" : "support::is_between(") +
                    lines.number(solver.numbers.number(joint.lowest)) + ", " +
                    (turns ? turned_angle(solver, joint)
                           : "placed.slide_" + solver.members.joints[index] + ".displacement") +
                    ", " + lines.number(solver.numbers.number(joint.highest)) + ")");
  }
  if (!tests.empty()) {
    lines.add("return " + text::joined(tests, " &&\n        ") + ";");
  }
  return lines.lines();
}

}  // namespace assur::generator::emission::scene
