// Law: along a branch of a sweep the angle of a joint that a law reads is counted over whole turns,
// in steps of any size; a law without a value drops only the configurations in which it has none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanism/bars.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::read_angles_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr double turn = 2 * std::numbers::pi;

/// A drag link, all of whose links go around, and a rack on a pinion on its output link.
Json rack_on_drag_link(int turns, int count) {
  return {{"parameters", {{"phi", 0.4}}},
          {"links",
           {{"ground",
             {{"A", {0, 0}}, {"D", {1, 0}}, {"way", {{"through", {0, 9}}, {"along", {1, 0}}}}}},
            {"crank", {{"A", {0, 0}}, {"B", {3, 0}}}},
            {"coupler", {{"B", {0, 0}}, {"C", {2.5, 0}}}},
            {"output", {{"D", {0, 0}}, {"C", {3, 0}}}},
            {"rack", {{"way", {{"through", {0, 0}}, {"along", {1, 0}}}}}}}},
          {"joints",
           {{"A", {{"type", "revolute"}, {"between", {"ground.A", "crank.A"}}}},
            {"B", {{"type", "revolute"}, {"between", {"crank.B", "coupler.B"}}}},
            {"C", {{"type", "revolute"}, {"between", {"coupler.C", "output.C"}}}},
            {"D", {{"type", "revolute"}, {"between", {"ground.D", "output.D"}}}},
            {"S", {{"type", "prismatic"}, {"between", {"ground.way", "rack.way"}}}}}},
          {"drivers", {{"A", {{"position", "phi"}}}, {"S", {{"position", "2*joint(D)"}}}}},
          {"sweep",
           {{"parameter", "phi"}, {"from", 0.4}, {"to", 0.4 + turn * turns}, {"count", count}}}};
}

mechanism::Scene scene_of(const Json& json) { return mechanism::parse_scene(json.dump(), "scene"); }

constexpr Eigen::Index output_cos = Eigen::Index{4} * 3 + 2;
constexpr Eigen::Index rack_x = Eigen::Index{4} * 4;

TEST(ReadAngles, GoOnAlongBranches) {
  const SweepKept fine = run_sweep(scene_of(rack_on_drag_link(3, 3001)));
  std::map<std::pair<int, int>, double> expected;  // by the branch and the step
  for (const SweepRowKept& row : fine.rows) {
    const double angle = std::atan2(row.pose(output_cos + 1), row.pose(output_cos));
    const auto before = expected.find({row.branch, row.step - 1});
    const double near = before == expected.end() ? 0 : before->second;
    expected[{row.branch, row.step}] = angle + turn * std::round((near - angle) / turn);
  }
  ASSERT_EQ(expected.size(), 2U * 3001);
  for (const int count : {3001, 301, 13, 7}) {
    const SweepKept kept = run_sweep(scene_of(rack_on_drag_link(3, count)));
    ASSERT_EQ(kept.rows.size(), 2U * static_cast<std::size_t>(count));
    EXPECT_TRUE(kept.events.empty());
    for (const SweepRowKept& row : kept.rows) {
      const double angle = expected.at({row.branch, row.step * (3000 / (count - 1))});
      EXPECT_NEAR(row.pose(rack_x), 2 * angle, 1e-9) << row.step << " of " << count;
    }
    EXPECT_NEAR(kept.rows.back().pose(rack_x) - kept.rows[1].pose(rack_x), 6 * turn, 1e-9);
  }
}

/// The coupler c shrinks as the crank turns, until after almost three turns the crank's end is
/// farther than 3 - c from D: there both branches end, with the output link on the line from D to
/// the crank's end.
TEST(ReadAngles, GoOnToAFoldHoweverFewTheStepsAre) {
  constexpr double shrinks = 0.09;
  const auto from_fold = [](double phi) {  // with c = 2.5 - shrinks * phi, |BD| = 3 - c
    return 10 - 6 * std::cos(phi) - std::pow(0.5 + shrinks * phi, 2);
  };
  for (const int count : {2, 3, 7, 32}) {
    Json scene = rack_on_drag_link(3, count);
    scene["links"]["coupler"]["C"] = {"2.5 - 0.09*phi", 0};
    const SweepKept kept = run_sweep(scene_of(scene));
    ASSERT_EQ(kept.events.size(), 1U) << count;
    const SweepEventKept& fold = kept.events.front();
    EXPECT_EQ(fold.text, "fold 1 2");
    EXPECT_NEAR(from_fold(fold.parameter), 0, 1e-9);
    const double angle = std::atan2(3 * std::sin(fold.parameter), 3 * std::cos(fold.parameter) - 1);
    const double turns = std::round((fold.parameter - angle) / turn);
    EXPECT_NEAR(fold.pose(rack_x), 2 * (angle + turn * turns), 1e-6) << count;
  }
}

/// Law: the positions of a rack on the output link of a four-bar depend neither on how many steps a
/// sweep has nor on whether its steps are where branches meet.
class RackOnAFourBar {
 public:
  RackOnAFourBar(double ground, double crank, double coupler, double output)
      : scene_(rack_on_drag_link(1, 2)) {
    scene_["links"]["ground"]["D"] = {ground, 0};
    scene_["links"]["crank"]["B"] = {crank, 0};
    scene_["links"]["coupler"]["C"] = {coupler, 0};
    scene_["links"]["output"]["C"] = {output, 0};
  }

  void follows(const std::string& law) { scene_["drivers"]["S"]["position"] = law; }
  [[nodiscard]] SweepKept swept(double from, double to, int count) {
    scene_["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", count}};
    return run_sweep(scene_of(scene_));
  }

 private:
  Json scene_;
};

/// A parallelogram: its output link follows the crank, or turns against it; both ways meet at each
/// half turn, where the counts of their turns differ.
TEST(ReadAngles, GoStraightThroughTheChangePointsOfAParallelogram) {
  constexpr double quarter = turn / 4;
  RackOnAFourBar parallelogram(3, 2, 3, 2);
  const SweepKept fine = parallelogram.swept(quarter, 9 * quarter, 3000);  // no step meets one
  ASSERT_TRUE(fine.events.empty());
  const double against = fine.rows[fine.rows.size() - 2].pose(rack_x);
  EXPECT_LT(against, -4 * turn);
  for (const int count : {2, 3, 5, 9, 17, 512}) {
    const SweepKept kept = parallelogram.swept(quarter, 9 * quarter, count);
    EXPECT_TRUE(kept.events.empty()) << count << ": " << kept.events.front().text;
    ASSERT_GE(kept.rows.size(), 4U);
    EXPECT_NEAR(kept.rows.back().pose(rack_x), 2 * 9 * quarter, 1e-6) << count;
    EXPECT_NEAR(kept.rows[kept.rows.size() - 2].pose(rack_x), against, 1e-6) << count;
  }
}

/// The first step, or every step, is where the two motions meet.
TEST(ReadAngles, AreCountedFromAChangePointOfAParallelogram) {
  RackOnAFourBar parallelogram(3, 2, 3, 2);
  for (const int count : {2, 3, 5, 9, 17, 512}) {
    const SweepKept kept = parallelogram.swept(0, 4 * turn - 0.6, count);
    ASSERT_EQ(kept.events.size(), 1U) << count;
    EXPECT_EQ(kept.events.front().text, "crossing 1 2");
    const double one = kept.rows.back().pose(rack_x);
    const double other = kept.rows[kept.rows.size() - 2].pose(rack_x);
    EXPECT_NEAR(std::max(one, other), 2 * (4 * turn - 0.6), 1e-6) << count;
  }
  for (const int count : {3, 5, 9}) {
    EXPECT_EQ(parallelogram.swept(0, 2 * turn, count).events.size(), 1U) << count;
  }
}

/// A crank-rocker, whose rocker stands still twice in each turn.
TEST(ReadAngles, AreNotLostWhereTheLinkTurnsBack) {
  RackOnAFourBar crank_rocker(3.2, 1, 3, 2.5);
  const double expected = crank_rocker.swept(0.4, 0.5, 2).rows.front().pose(rack_x);
  for (const int count : {2, 17, 513}) {
    const SweepKept kept = crank_rocker.swept(0.4, 0.4 + 20 * turn, count);
    EXPECT_TRUE(kept.events.empty()) << count;
    ASSERT_EQ(kept.rows.size(), 2U * static_cast<std::size_t>(count));
    EXPECT_NEAR(kept.rows[kept.rows.size() - 2].pose(rack_x), expected, 1e-9) << count;
  }
}

/// A kite whose output link turns by half a turn within a hundredth of the crank's angle.
TEST(ReadAngles, AreNotLostWhereALinkTurnsAtOnce) {
  RackOnAFourBar kite(1, 1.01, 3, 3);
  const SweepKept fine = kite.swept(0.4, 0.4 + 2.3 * turn, 5001);
  ASSERT_TRUE(fine.events.empty());
  for (const int count : {2, 5, 17, 513}) {
    const SweepKept kept = kite.swept(0.4, 0.4 + 2.3 * turn, count);
    EXPECT_TRUE(kept.events.empty()) << count;
    ASSERT_EQ(kept.rows.size(), 2U * static_cast<std::size_t>(count));
    EXPECT_NEAR(kept.rows.back().pose(rack_x), fine.rows.back().pose(rack_x), 1e-9) << count;
  }
}

/// A chain that begins to close with its output link near pi, which one of the two branches passes
/// at once: both begin with the same count.
TEST(ReadAngles, BeginWithOneCountWhereTwoBranchesAreBorn) {
  RackOnAFourBar born(1, 3, 2, 1.9);
  const SweepKept fine = born.swept(2.8, 5.8, 3001);
  ASSERT_EQ(fine.events.size(), 1U);
  for (const int count : {2, 3, 5, 17}) {
    const SweepKept kept = born.swept(2.8, 5.8, count);
    ASSERT_EQ(kept.events.size(), 1U) << count;
    EXPECT_EQ(kept.events.front().text, "birth 1 2") << count;
    for (const std::size_t from_end : {1U, 2U}) {
      EXPECT_NEAR(kept.rows[kept.rows.size() - from_end].pose(rack_x),
                  fine.rows[fine.rows.size() - from_end].pose(rack_x), 1e-9)
          << count;
    }
  }
}

/// Two configurations of a four-bar, with the output link slightly below and slightly above pi. The
/// law has no value for the positive angle. That configuration does not continue the other, so the
/// sweep does not count its angle from the other's, which is negative.
TEST(ReadAngles, AreNotCountedFromABranchBeside) {
  constexpr int steps = 5;
  Json json = rack_on_drag_link(1, steps);
  json["links"]["ground"]["D"] = {4, 0};
  json["links"]["crank"]["B"] = {1, 0};
  json["links"]["coupler"]["C"] = {1.2, 0};
  json["links"]["output"]["C"] = {2, 0};
  json["drivers"]["S"]["position"] = "sqrt(-joint(D))";
  json["sweep"]["from"] = 0.1;
  json["sweep"]["to"] = 0.2;
  const SweepKept kept = run_sweep(scene_of(json));
  EXPECT_TRUE(kept.events.empty());
  ASSERT_EQ(kept.rows.size(), std::size_t{steps});
  for (const SweepRowKept& row : kept.rows) {
    const double angle = std::atan2(row.pose(output_cos + 1), row.pose(output_cos));
    EXPECT_NEAR(row.pose(rack_x), std::sqrt(-angle), 1e-9) << row.step;
  }
}

TEST(ReadAngles, GoOnAlongABranchThatIsFollowedAlone) {
  const mechanism::Scene scene = scene_of(rack_on_drag_link(3, 13));
  const mechanism::Plan plan(scene);
  const SweepKept all = run_sweep(scene);
  for (const int branch : {1, 2}) {
    std::vector<double> racks;
    const auto record = [&](const mechanism::SweepRecord& row) {
      racks.push_back(row.state->link("rack").pose.x);
    };
    const auto end =
        sweep_branch(plan, static_cast<std::size_t>(branch), {record, nullptr, nullptr});
    EXPECT_FALSE(end.has_value());
    std::size_t place = 0;
    for (const SweepRowKept& row : all.rows) {
      if (row.branch == branch) {
        ASSERT_LT(place, racks.size());
        EXPECT_NEAR(racks[place++], row.pose(rack_x), 1e-9);
      }
    }
  }
}

/// A rack on the output link of a flat parallelogram, which has two motions: in each motion that is
/// known, the rack moves as the output link does.
TEST(ReadAngles, HaveNoRatesOfTheirOwnAtAChangePoint) {
  for (const double phi : {-1.5, -0.5, 0.5, 1.5}) {
    Json scene = rack_on_drag_link(1, 2);
    scene["parameters"]["phi"] = {{"value", phi * std::numbers::pi}, {"velocity", 1}};
    scene["links"]["ground"]["D"] = {3, 0};
    scene["links"]["crank"]["B"] = {0, 2};
    scene["links"]["coupler"]["C"] = {3, 0};
    scene["links"]["output"]["C"] = {0, 2};
    const mechanism::Plan plan(scene_of(scene));
    const mechanism::Solution found = plan.solve(plan.values());
    ASSERT_EQ(found.configurations.size(), 1U);
    std::vector<Configuration> known = found.configurations[0].branches;
    if (found.configurations[0].rates_known) {
      known.push_back(found.configurations[0]);
    }
    for (const Configuration& motion : known) {
      EXPECT_NEAR(motion.link("rack").velocity(0), 2 * motion.link("output").velocity(2), 1e-6);
    }
  }
}

TEST(Laws, WithoutAValueDropTheirConfigurationsAlone) {
  Bars bars;
  bars.four_bar().point("arm", "E", 0, 0).point("arm", "T", 1, 0);
  bars.join("E", {"coupler.E", "arm.E"});
  bars.json()["drivers"]["E"]["position"] = "joint(D)";
  bars.json()["outputs"]["T"] = "arm.T";
  const Solved all = solved(bars.json());
  ASSERT_EQ(all.configurations().size(), 2U);
  const auto angle = [](const Configuration& one) {
    return angle_of(one.link("rocker").pose.direction);
  };
  const double middle = (angle(all.configurations()[0]) + angle(all.configurations()[1])) / 2;
  bars.json()["drivers"]["E"]["position"] = "sqrt(joint(D) - (" + std::to_string(middle) + "))";
  const Solved one = solved(bars.json());
  ASSERT_EQ(one.configurations().size(), 1U);
  EXPECT_EQ(one.solution.status, SolutionStatus::ok);
  EXPECT_GT(angle(one.configurations()[0]), middle);
  EXPECT_EQ(one.solution.dropped, 1U);
  EXPECT_EQ(one.solution.drop_reason, "drivers.E.position: the value is not a finite number");
  EXPECT_NE(report_text(one.report())
                .find("dropped: 1 choice of configurations of earlier groups: drivers.E.position"),
            std::string::npos);
  EXPECT_NE(report_json(one.report()).find("\"dropped\""), std::string::npos);
  EXPECT_EQ(report_json(all.report()).find("\"dropped\""), std::string::npos);
}

/// One of the two branches of the sweep has rows where the law has a value; the other has none.
TEST(Laws, WithoutAValueDropRowsOfASweep) {
  Json scene = rack_on_drag_link(1, 41);
  scene["drivers"]["S"]["position"] = "sqrt(1.5 - joint(D))";
  const SweepKept kept = run_sweep(scene_of(scene));
  EXPECT_EQ(kept.steps, 41);
  EXPECT_GT(kept.rows.size(), 5U);
  EXPECT_LT(kept.rows.size(), 77U);
  for (const SweepRowKept& row : kept.rows) {
    EXPECT_GE(row.pose(rack_x), 0);
  }
}

/// A branch ends where the law loses its value, and another one, a turn behind, begins there, in
/// steps of any size. The triangle of crank and coupler gives the place.
TEST(Laws, EndAndBeginBranchesWhereverTheStepsAre) {
  constexpr double crank = 3;
  constexpr double coupler = 2.5;
  constexpr double output = 3;
  constexpr double last = 6;  // the angle of the output link beyond which the law has no value
  const double x = 1 + output * std::cos(last);
  const double y = output * std::sin(last);
  const double distance = std::hypot(x, y);
  const double corner =
      std::acos((crank * crank + distance * distance - coupler * coupler) / (2 * crank * distance));
  for (const int count : {2, 3, 17, 101, 2000}) {
    Json scene = rack_on_drag_link(2, count);
    scene["drivers"]["S"]["position"] = "sqrt(6 - joint(D))";
    const SweepKept kept = run_sweep(scene_of(scene));
    EXPECT_EQ(kept.rows.size(), 2U * static_cast<std::size_t>(count));
    ASSERT_EQ(kept.events.size(), 6U) << count << " steps";
    for (const SweepEventKept& event : kept.events) {
      const double here =
          std::min(std::abs(std::remainder(event.parameter - std::atan2(y, x) - corner, turn)),
                   std::abs(std::remainder(event.parameter - std::atan2(y, x) + corner, turn)));
      EXPECT_LT(here, 1e-6) << count << " steps, " << event.text;
    }
  }
}

/// The parallel motion's angle is that of the crank, so its law loses its value where the motions
/// meet, and has one again a turn behind. The antiparallel one turns by tan(D/2) = -5 tan(phi/2).
TEST(Laws, LoseTheirValueAtAChangePointWhereverTheStepsAre) {
  constexpr double last = 7;
  const double parallel = last - turn;
  const double antiparallel = -turn - 2 * std::atan(5 * std::tan(parallel / 2));
  RackOnAFourBar parallelogram(3, 2, 3, 2);
  parallelogram.follows("sqrt(pi - joint(D))");
  for (const int count : {2, 3, 17, 50, 101, 102, 201, 401, 513, 1001, 1501}) {
    const SweepKept kept = parallelogram.swept(0.4, last, count);
    EXPECT_GE(kept.count_of("unresolved"), 1) << count << " steps";
    ASSERT_GE(kept.rows.size(), 4U);
    const double one = kept.rows.back().pose(rack_x);
    const double other = kept.rows[kept.rows.size() - 2].pose(rack_x);
    EXPECT_NEAR(std::min(one, other), std::sqrt(turn / 2 - parallel), 1e-6) << count << " steps";
    EXPECT_NEAR(std::max(one, other), std::sqrt(turn / 2 - antiparallel), 1e-6)
        << count << " steps";
  }
}

}  // namespace
}  // namespace assur::test::read_angles_test
