#include "emission/scene/limit_statements.hpp"

#include "emission/scene/redundancy_tests.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The direction of the link that has a feature; empty for the ground.
OptionalExpression direction_of_link(const SolverScene& solver, mechanism::FeatureIndex feature) {
  const mechanism::LinkIndex link = solver.mechanism().features()[feature].link;
  const bool whole = solver.needs[link] == FrameNeed::everything;
  const OptionalExpression placed = solver.placed(link);
  return placed && whole ? placed->member("pose").member("direction") : placed;
}

/// The angle from the first link of a pin to the second, up to whole turns.
cpp::Expression turned_angle(const SolverScene& solver, const mechanism::Joint& joint) {
  const OptionalExpression first = direction_of_link(solver, joint.between[0]);
  const OptionalExpression second = direction_of_link(solver, joint.between[1]);
  if (!first) {
    return cpp::call("angle_of", {*second});
  }
  return second ? cpp::call("angle_of",
                            {cpp::call("turned", {*second, cpp::call("reversed", {*first})})})
                : cpp::negative(cpp::call("angle_of", {*first}));
}

}  // namespace

cpp::Block limit_statements(const SolverScene& solver) {
  FunctionBody body = solver.body();
  std::vector<cpp::Expression> tests = redundancy_tests(solver, body);
  const auto& joints = solver.mechanism().joints();
  for (const mechanism::JointIndex index : joints.keys()) {
    const mechanism::Joint& joint = joints[index];
    if (!joint.lowest.exists()) {
      continue;
    }
    const bool turns = joint.type == mechanism::JointType::revolute;
    const cpp::Expression coordinate = turns ? turned_angle(solver, joint)
                                             : cpp::variable("placed")
                                                   .member("slide_" + solver.members.joints[index])
                                                   .member("displacement");
    tests.push_back(cpp::call(turns ? "support::is_turned_between" : "support::is_between",
                              {body.number(solver.numbers.number(joint.lowest)), coordinate,
                               body.number(solver.numbers.number(joint.highest))}));
  }
  if (!tests.empty()) {
    body.add(cpp::returned(cpp::infix(" &&\n        ", std::move(tests))));
  }
  return body.block();
}

}  // namespace assur::generator::emission::scene
