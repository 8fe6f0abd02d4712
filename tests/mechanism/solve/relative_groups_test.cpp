// Law: links that hold one another, as a cylinder and the crossed bars of a lift do, are solved
// relative to one of them: all their shapes are found, and move as closed forms say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mechanism/bars.hpp"
#include "mechanism/scene_solutions.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::relative_groups_test {
namespace {

Json lift(double stroke) {
  Json scene = example("scissor_lift_crossed.json");
  scene["parameters"]["stroke"] = {{"value", stroke}, {"velocity", 0.05}};
  scene.erase("sweep");
  return scene;
}

/// The cylinder joins the bars at 0.6 from their middles, which are therefore 0.75 strokes high.
TEST(RelativeGroups, LiftAsHighAsTheirTriangleSays) {
  for (const double stroke : {0.3, 0.7, 1.1}) {
    const Solved scene = solved(with_unit_covariance(lift(stroke)));
    ASSERT_EQ(scene.configurations().size(), 16U) << stroke;
    const double height = 0.75 * stroke;
    const double width = std::sqrt(0.81 - height * height);
    const double slope = -0.5625 * stroke / width;
    for (const Configuration& configuration : scene.configurations()) {
      EXPECT_EQ(configuration.regularity, Status::ok);
      const mechanism::Point& middle = configuration.output("M");
      const double up = middle.position.y() > 0 ? 1 : -1;
      const double right = middle.position.x() > 0 ? 1 : -1;
      EXPECT_NEAR(up * middle.position.y(), height, 1e-14);
      EXPECT_NEAR(right * middle.position.x(), width, 1e-14);
      EXPECT_NEAR(up * middle.velocity.y(), 0.0375, 1e-14);
      EXPECT_NEAR(middle.acceleration.y(), 0, 1e-13);
      const double bend = -0.5625 / width - slope * slope / width;
      EXPECT_NEAR(right * middle.acceleration.x(), 0.0025 * bend, 1e-13);
      EXPECT_NEAR(up * middle.follows.first(1, 3), 0.75, 1e-13);
      EXPECT_NEAR(right * middle.follows.first(0, 3), slope, 1e-13);
      EXPECT_NEAR(middle.follows.second[1](3, 3), 0, 1e-11);
      EXPECT_NEAR(right * middle.follows.second[0](3, 3), bend, 1e-11);
    }
  }
}

/// With the cylinder at its longest, the bars lie on one another and turn freely about both feet;
/// beyond that length there is no assembly.
TEST(RelativeGroups, HaveDeadCentres) {
  const Solved flat = solved(lift(1.2));
  EXPECT_EQ(flat.solution.status, SolutionStatus::degenerate);
  EXPECT_EQ(flat.solution.mobility, 1);
  ASSERT_EQ(flat.solution.families.size(), 1U);
  EXPECT_EQ(flat.solution.families[0].group.place(), 1U);
  EXPECT_EQ(report_of(lift(1.2))["families"][0]["after"]["links"].size(), 1U);  // the ground
  const Solved beyond = solved(lift(1.25));
  EXPECT_EQ(beyond.solution.status, SolutionStatus::no_assembly);
  EXPECT_EQ(
      beyond.plan.obstacle(beyond.values),
      "group 1 (dyad RRR: lower_right, tube, rod, relative to lower_left): the joints C, H, M "
      "fail to close by 0.05 at least");
}

/// If the feet do not meet there, the lift stops where the cylinder is longest.
TEST(RelativeGroups, SweepToTheirFolds) {
  Json scene = lift(1);
  scene["links"]["lower_right"]["D"] = {0.1, 0};
  scene["sweep"] = {{"parameter", "stroke"}, {"from", 1.0}, {"to", 1.3}, {"count", 8}};
  const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
  EXPECT_GT(kept.count_of("fold"), 0);
  for (const SweepEventKept& event : kept.events) {
    EXPECT_EQ(event.kind(), "fold");
    EXPECT_NEAR(event.parameter, 1.2, 1e-9);
  }
}

/// The rod's eye on a pin of three links, listed in any order.
TEST(RelativeGroups, ShareTheirPins) {
  Json scene = lift(1.1);
  scene["joints"].erase("H");
  std::array<std::string, 3> pin = {"lower_right.E", "rod.H", "upper_left.E"};
  std::set<std::string> groups;
  do {
    scene["joints"]["E"]["between"] = pin;
    const Json report = report_of(scene);
    groups.insert(report["groups"].dump());
    ASSERT_EQ(report["configurations"].size(), 16U);
    // 0.6 and 0.9 from the middle: the law of cosines.
    const double apex = std::acos((0.36 + 0.81 - 1.21) / (2 * 0.6 * 0.9));
    for (const Json& configuration : report["configurations"]) {
      EXPECT_NEAR(std::abs(configuration["outputs"]["M"]["position"][1].get<double>()),
                  0.9 * std::sin(apex / 2), 1e-13);
    }
  } while (std::ranges::next_permutation(pin).found);
  EXPECT_EQ(groups.size(), 1U);
}

std::vector<double> rocker_angles(const Json& scene) {
  std::vector<double> angles;
  const Solved bars = solved(scene);
  for (const Configuration& configuration : bars.configurations()) {
    angles.push_back(angle_of(configuration.link("rocker").pose.direction));
  }
  return angles;
}

/// A four-bar whose coupler is a triangle of bars, which has two shapes: it is two four-bars.
TEST(RelativeGroups, AreTrusses) {
  Bars truss;
  truss.point("ground", "D", 3, 0).point("rocker", "D", 0, 0).point("rocker", "S", 2, 0);
  truss.point("one", "X", 0, 0).point("one", "Z", 2, 0).point("one", "B", -1, 0.5);
  truss.point("two", "X", 0, 0).point("two", "Y", 2, 0).point("two", "S", 1, 0.3);
  truss.point("three", "Y", 0, 0).point("three", "Z", 1.5, 0);
  truss.join("B", {"crank.B", "one.B"}).join("S", {"two.S", "rocker.S"});
  truss.join("D", {"ground.D", "rocker.D"}).join("X", {"one.X", "two.X"});
  truss.join("Y", {"two.Y", "three.Y"}).join("Z", {"three.Z", "one.Z"});
  std::vector<double> expected;
  for (const double side : {1, -1}) {
    const double angle = side * std::acos((4 + 4 - 2.25) / 8);
    const double x = 1 + std::cos(angle) - 0.3 * std::sin(angle);
    const double y = -0.5 + std::sin(angle) + 0.3 * std::cos(angle);
    Bars rigid;
    rigid.four_bar().point("coupler", "C", std::hypot(x, y), 0);
    std::ranges::copy(rocker_angles(rigid.json()), std::back_inserter(expected));
  }
  std::vector<double> found = rocker_angles(truss.json());
  std::ranges::sort(expected);
  std::ranges::sort(found);
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t place = 0; place < found.size(); ++place) {
    EXPECT_NEAR(found[place], expected[place], 1e-14);
  }
}

}  // namespace
}  // namespace assur::test::relative_groups_test
