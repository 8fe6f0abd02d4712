// Law: limits exclude exactly the configurations beyond them, in solutions and in rows of sweeps; a
// reported part includes the joints that its laws read.
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "mechanism/bars.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::limits_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr double turn = 2 * std::numbers::pi;

/// A crank-rocker with a driven arm on its coupler that follows the rocker.
Json robot() {
  Bars bars;
  bars.four_bar().point("arm", "E", 0, 0).point("arm", "T", 1, 0);
  bars.join("E", {"coupler.E", "arm.E"});
  bars.json()["drivers"]["E"]["position"] = "0.4*joint(D)";
  bars.json()["outputs"]["T"] = "arm.T";
  return bars.json();
}

Solved with_limits(const std::string& joint, double lowest, double highest) {
  Json scene = robot();
  scene["joints"][joint]["limits"] = {lowest, highest};
  return solved(scene);
}

double rocker_angle(const Configuration& configuration) {
  return angle_of(configuration.link("rocker").pose.direction);
}

TEST(Limits, CountAnglesByWholeTurnsAndTheirEndsAsWithin) {
  const Solved all = solved(robot());
  ASSERT_EQ(all.configurations().size(), 2U);
  for (const Configuration& configuration : all.configurations()) {
    const double angle = rocker_angle(configuration);
    for (const double turns : {-3.0, -1.0, 0.0, 1.0, 5.0}) {
      const double at = angle + turns * turn;
      const std::array<std::pair<double, double>, 4> around = {
          {{at, at}, {at, at + 0.1}, {at - 0.1, at}, {at - 0.1, at + 0.1}}};
      for (const auto& [lowest, highest] : around) {
        const Solved within = with_limits("D", lowest, highest);
        ASSERT_EQ(within.configurations().size(), 1U) << lowest << " to " << highest;
        EXPECT_EQ(rocker_angle(within.configurations()[0]), angle);
        EXPECT_EQ(within.solution.left_out, 1U);
      }
      const Solved beyond = with_limits("D", at + 1e-6, at + turn - 1e-6);
      ASSERT_EQ(beyond.configurations().size(), 1U);
      EXPECT_NE(rocker_angle(beyond.configurations()[0]), angle);
    }
  }
  EXPECT_EQ(with_limits("D", -1e9, 1e9).configurations().size(), 2U);
}

TEST(Limits, OfADrivenJointHoldItsLaw) {
  EXPECT_EQ(with_limits("A", 0.7, 0.7).configurations().size(), 2U);
  const Solved none = with_limits("A", 1, 2);
  EXPECT_EQ(none.solution.status, SolutionStatus::no_assembly);
  EXPECT_EQ(none.solution.reason,
            "each of the 2 configurations is beyond the limits of a joint: A by 17.2 deg at least");
}

TEST(Limits, LeaveOutRowsOfASweepWhoseBranchGoesOnBehindThem) {
  constexpr double lowest = 1.2;
  constexpr double highest = 2.2;
  Json scene = robot();
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 6.28}, {"count", 41}};
  const SweepKept all = run_sweep(mechanism::parse_scene(scene.dump(), "all"));
  scene["joints"]["D"]["limits"] = {lowest, highest};
  const SweepKept within = run_sweep(mechanism::parse_scene(scene.dump(), "within"));
  const std::size_t rocker = 3;  // ground, crank, coupler, rocker
  std::vector<SweepRowKept> expected;
  for (const SweepRowKept& row : all.rows) {
    const double angle = std::atan2(row.pose(4 * rocker + 3), row.pose(4 * rocker + 2));
    if (lowest <= angle && angle <= highest) {
      expected.push_back(row);
    }
  }
  ASSERT_EQ(within.rows.size(), expected.size());
  ASSERT_LT(expected.size(), all.rows.size());
  bool is_interrupted = false;
  std::map<int, int> numbers;  // in order of appearance within the limits
  for (std::size_t row = 0; row < expected.size(); ++row) {
    EXPECT_EQ(within.rows[row].step, expected[row].step);
    const int next = static_cast<int>(numbers.size()) + 1;
    EXPECT_EQ(within.rows[row].branch,
              numbers.try_emplace(expected[row].branch, next).first->second);
    EXPECT_EQ(within.rows[row].configuration, 1);
    EXPECT_EQ((within.rows[row].pose - expected[row].pose).norm(), 0);
    is_interrupted = is_interrupted || (row > 0 && expected[row].step > expected[row - 1].step + 1);
  }
  EXPECT_TRUE(is_interrupted);
}

TEST(ReportedPart, KeepsWhatItsLawsRead) {
  const Solved whole = solved(robot());
  Json scene = robot();
  scene["report"] = {{"links", Json::array()}, {"joints", Json::array()}};
  const Solved part = solved(scene);
  ASSERT_EQ(part.configurations().size(), whole.configurations().size());
  for (std::size_t place = 0; place < part.configurations().size(); ++place) {
    EXPECT_EQ(part.configurations()[place].output("T").position,
              whole.configurations()[place].output("T").position);
  }
}

/// The rocker is not reported, but its limits leave out a configuration of the part that is.
TEST(ReportedPart, KeepsWhatHasLimits) {
  Json scene = robot();
  scene["drivers"]["E"]["position"] = 0.5;
  scene["joints"]["D"]["limits"] = {0, 3.1};
  scene["outputs"] = {{"B", "crank.B"}};
  scene["report"] = {{"links", Json::array({"crank"})}, {"joints", Json::array()}};
  const Solved limited = solved(scene);
  EXPECT_EQ(limited.configurations().size(), 1U);
  EXPECT_EQ(limited.solution.left_out, 1U);
  scene["joints"]["D"].erase("limits");
  EXPECT_TRUE(solved(scene).plan.structure().groups.empty());
}

/// Every joint whose limits exclude a configuration is reported, with the least excess in any of
/// them.
TEST(Limits, AreToldByHowMuchTheyAreBroken) {
  Json scene = robot();
  const Solved all = solved(scene);
  std::array<double, 2> angles{};
  for (std::size_t place = 0; place < 2; ++place) {
    angles[place] = rocker_angle(all.configurations()[place]);
  }
  const double highest = std::max(angles[0], angles[1]);
  scene["joints"]["D"]["limits"] = {highest + 0.25, highest + 0.3};
  scene["joints"]["A"]["limits"] = {0.9, 1};
  const Solved none = solved(scene);
  ASSERT_EQ(none.solution.breaches.size(), 2U);
  for (const mechanism::LimitBreach& breach : none.solution.breaches) {
    const bool is_driven = none.plan.mechanism().joints()[breach.joint].name == "A";
    EXPECT_EQ(breach.configurations, 2U);
    EXPECT_NEAR(breach.least, is_driven ? 0.2 : 0.25, 1e-12);
  }
}

}  // namespace
}  // namespace assur::test::limits_test
