#include "emission/scene/redundancy_tests.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/text/names.hpp>
#include <cmath>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The pose of a feature; a point has the direction of its link.
std::string pose_of(const SolverScene& solver, mechanism::FeatureIndex index, SceneLines& lines) {
  const mechanism::Feature& feature = solver.mechanism().features()[index];
  const LinkFeature<SceneNumber> place = solver.numbers.feature(index, feature.is_line);
  const std::string own = "Pose<Scalar>{" + lines.number(place.x) + ", " + lines.number(place.y) +
                          ", " + lines.direction(place.along) + "}";
  const std::string link = solver.placed(feature.link);
  return link.empty() ? own : "support::pose_in(" + link + ".pose, " + own + ")";
}

/// Where the features of joints are on their links: where all links stand at the origin, no other
/// length tells what rounding is. Those that do not change are one place with the largest
/// coordinates.
std::vector<std::string> own_places(const SolverScene& solver, SceneLines& lines) {
  std::vector<std::string> places;
  double largest = 0;
  for (const mechanism::Joint& joint : solver.mechanism().joints()) {
    for (const mechanism::FeatureIndex index : joint.between) {
      const LinkFeature<SceneNumber> place = solver.numbers.feature(index, false);
      if (may_change(place.x) || may_change(place.y)) {
        places.push_back("Pose<Scalar>{" + lines.number(place.x) + ", " + lines.number(place.y) +
                         ", {}}");
      } else {
        largest = std::max({largest, std::abs(place.x.value()), std::abs(place.y.value())});
      }
    }
  }
  places.push_back("Pose<Scalar>{Scalar(" + cpp::round_trip(largest) + "), Scalar(0.0), {}}");
  return places;
}

/// Expressions for how far redundant joints are from holding. `lines` gets the poses of their
/// features, the largest coordinate of these and of the links' origins as `size`, and the largest
/// of that and of the features' coordinates on their links as `reach`.
std::vector<std::string> gaps(const SolverScene& solver, SceneLines& lines) {
  std::vector<std::string> gaps;
  std::vector<std::string> poses;
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (!solver.is_ground(link)) {
      poses.push_back(solver.placed(link) + ".pose");
    }
  }
  for (const mechanism::RedundantJoint& joint : solver.plan.redundant()) {
    const std::string pair = "redundant_" + std::to_string(gaps.size() + 1);
    lines.add("const std::array<Pose<Scalar>, 2> " + pair + " = {{" +
              pose_of(solver, joint.one, lines) + ", " + pose_of(solver, joint.other, lines) +
              "}};");
    const std::array<bool, 3> holds = mechanism::held_by(solver.mechanism(), joint).holds;
    const bool are_lines = holds[2];
    poses.insert(poses.end(), {pair + "[0]", pair + "[1]"});
    const std::string apart = are_lines  ? "lines_apart("
                              : holds[0] ? "points_apart("
                                         : "point_off_line(";
    gaps.push_back("support::" + apart + pair + "[0], " + pair + "[1]" +
                   (are_lines ? ", size" : "") + ")");
  }
  lines.add("const Scalar size = support::largest_coordinate(std::array<Pose<Scalar>, " +
            std::to_string(poses.size()) + ">{{" + text::joined(poses, ", ") + "}});");
  const std::vector<std::string> places = own_places(solver, lines);
  lines.add(
      "const Scalar reach = (std::max)(size, support::largest_coordinate(std::array<Pose<"
      "Scalar>, " +
      std::to_string(places.size()) + ">{{" + text::joined(places, ", ") + "}}));");
  return gaps;
}

}  // namespace

std::vector<std::string> redundancy_tests(const SolverScene& solver, SceneLines& lines) {
  std::vector<std::string> tests;
  if (solver.plan.redundant().empty()) {
    return tests;
  }
  for (const std::string& gap : gaps(solver, lines)) {
    tests.push_back(gap + " <= slack");
  }
  const std::string slack = "support::redundancy_slack(reach, placed.regularity)";
  const mechanism::NumberIndex given = solver.plan.request().redundancy_tolerance;
  lines.add("const Scalar slack = " +
            (given.exists() ? "(std::max)(" + slack + ", Scalar(" +
                                  lines.number(solver.numbers.number(given)) + "))"
                            : slack) +
            ";");
  return tests;
}

std::vector<std::string> redundant_gap(const SolverScene& solver) {
  if (solver.plan.redundant().empty() || solver.plan.request().redundancy_tolerance.exists()) {
    return {};
  }
  SceneLines lines(solver.parameters, solver.numbers, solver.derivative_order);
  const std::vector<std::string> missed = gaps(solver, lines);
  lines.add("return (std::max)({" + text::joined(missed, ", ") + "}) / reach;");
  return lines.lines();
}

}  // namespace assur::generator::emission::scene
