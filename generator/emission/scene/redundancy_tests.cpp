#include "emission/scene/redundancy_tests.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/held_pairs.hpp>
#include <cmath>

#include "emission/scene/carried_links.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The positions of the joints' features on their links. Where all links stand at the origin, no
/// other length gives a scale for rounding. Those that do not change are replaced by one point with
/// the largest coordinates.
std::vector<cpp::Expression> feature_places(const SolverScene& solver, const FunctionBody& body) {
  std::vector<cpp::Expression> places;
  const auto add = [&places](const cpp::Expression& x, const cpp::Expression& y) {
    places.push_back(cpp::braces("Pose<Scalar>", {x, y, cpp::braces("")}));
  };
  double largest = 0;
  for (const mechanism::Joint& joint : solver.mechanism().joints()) {
    for (const mechanism::FeatureIndex index : joint.between) {
      const LinkFeature<SceneNumber> place = solver.numbers.feature(index, false);
      if (may_change(place.x) || may_change(place.y)) {
        add(body.number(place.x), body.number(place.y));
      } else {
        largest = std::max({largest, std::abs(place.x.value()), std::abs(place.y.value())});
      }
    }
  }
  add(cpp::number(largest), cpp::number(0));
  return places;
}

cpp::Name maximum() { return cpp::scalar_only("(std::max)"); }

/// Expressions for the errors of the redundant joints. `body` gets the poses of their features, the
/// largest coordinate of these and of the links' origins as `size`, and the largest of that and of
/// the features' coordinates on their links as `reach`.
std::vector<cpp::Expression> gaps(const SolverScene& solver, FunctionBody& body) {
  std::vector<cpp::Expression> gaps;
  std::vector<cpp::Expression> poses;
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (const OptionalExpression placed = solver.placed(link)) {
      poses.push_back(placed->member("pose"));
    }
  }
  const cpp::Expression size = cpp::variable("size");
  for (const mechanism::RedundantJoint& joint : solver.plan.redundant()) {
    const cpp::Expression pair = cpp::variable("redundant_" + std::to_string(gaps.size() + 1));
    body.add(
        cpp::declared("const std::array<Pose<Scalar>, 2>", pair,
                      cpp::braces("", {cpp::braces("", {pose_of(solver, joint.one, body),
                                                        pose_of(solver, joint.other, body)})})));
    const std::array<bool, 3> holds = mechanism::held_by(solver.mechanism(), joint).holds;
    const bool are_lines = holds[2];
    std::vector<cpp::Expression> compared = {pair.item(0), pair.item(1)};
    poses.insert(poses.end(), compared.begin(), compared.end());
    if (are_lines) {
      compared.push_back(size);
    }
    gaps.push_back(cpp::call(are_lines  ? "support::lines_apart"
                             : holds[0] ? "support::points_apart"
                                        : "support::point_off_line",
                             std::move(compared)));
  }
  const auto largest = [](std::vector<cpp::Expression> of) {
    return cpp::call("support::largest_coordinate", {cpp::array("Pose<Scalar>", std::move(of))});
  };
  body.add(cpp::declared("const Scalar", size, largest(std::move(poses))));
  body.add(cpp::declared("const Scalar", cpp::variable("reach"),
                         cpp::call(maximum(), {size, largest(feature_places(solver, body))})));
  return gaps;
}

}  // namespace

std::vector<cpp::Expression> redundancy_tests(const SolverScene& solver, FunctionBody& body) {
  std::vector<cpp::Expression> tests;
  if (solver.plan.redundant().empty()) {
    return tests;
  }
  const cpp::Expression slack = cpp::variable("slack");
  for (const cpp::Expression& gap : gaps(solver, body)) {
    tests.push_back(cpp::infix(" <= ", {gap, slack}));
  }
  const cpp::Expression rounding =
      cpp::call("support::redundancy_slack",
                {cpp::variable("reach"), cpp::variable("placed").member("regularity")});
  const mechanism::NumberIndex given = solver.plan.request().redundancy_tolerance;
  body.add(cpp::declared(
      "const Scalar", slack,
      given.exists() ? cpp::call(maximum(), {rounding, body.number(solver.numbers.number(given))})
                     : rounding));
  return tests;
}

cpp::Block redundant_gap(const SolverScene& solver) {
  if (solver.plan.redundant().empty() || solver.plan.request().redundancy_tolerance.exists()) {
    return {};
  }
  FunctionBody body = solver.body();
  const cpp::Expression most = cpp::call(maximum(), {cpp::braces("", gaps(solver, body))});
  body.add(cpp::returned(cpp::quotient(most, cpp::variable("reach"))));
  return body.block();
}

}  // namespace assur::generator::emission::scene
