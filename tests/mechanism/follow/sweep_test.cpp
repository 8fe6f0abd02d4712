// Law: a sweep names branches alike in steps of any size, and rigid bodies move along them.
#include <gtest/gtest.h>

#include <iostream>

#include "command/command.hpp"
#include "largest.hpp"
#include "mechanism/random_sweep.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::sweep_test {
namespace {

using Json = nlohmann::ordered_json;

mechanism::Scene worked_scene(const Json& sweep) {
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json"));
  scene["sweep"] = sweep;
  return mechanism::parse_scene(scene.dump(), "scene");
}

const Json whole_turn = {{"parameter", "phi"}, {"from", 0}, {"to", "2*pi"}, {"count", 37}};

/// On one branch, no two samples may be further apart than the derivatives at both allow.
double largest_jump(const SweepKept& kept) {
  double jump = 0;
  for (const auto& [row, next] : neighbours(kept)) {
    if (next->branch == row->branch) {
      const double step = std::abs(next->parameter - row->parameter);
      jump = largest(jump, (next->pose - row->pose).norm() /
                               (step * std::max(row->slope.norm(), next->slope.norm())));
    }
  }
  return jump;
}

TEST(Sweep, BranchesAndEventsDoNotDependOnTheStep) {
  const mechanism::Scene scene = worked_scene(whole_turn);
  const SweepKept coarse = run_sweep(scene, 37);
  ASSERT_EQ(coarse.events.size(), 4U);
  double shift = 0;
  double shift_of_pose = 0;
  for (const int factor : {10, 100}) {
    const SweepKept fine = run_sweep(scene, 36 * factor + 1);
    const auto fine_branches = fine.branches();
    for (const auto& [place, branch] : coarse.branches()) {
      EXPECT_EQ(fine_branches.at({place.first * factor, place.second}), branch);
    }
    ASSERT_EQ(fine.events.size(), coarse.events.size());
    for (std::size_t index = 0; index < fine.events.size(); ++index) {
      EXPECT_EQ(fine.events[index].text, coarse.events[index].text);
      shift =
          largest(shift, std::abs(fine.events[index].parameter - coarse.events[index].parameter));
      shift_of_pose =
          largest(shift_of_pose, (fine.events[index].pose - coarse.events[index].pose).norm());
    }
    EXPECT_LT(largest_jump(fine), 1.5);
  }
  std::cout << "events move by " << shift << " rad, their configurations by " << shift_of_pose
            << " of some 1000 mm\n";
  EXPECT_LT(shift, 1e-14);
  EXPECT_LT(shift_of_pose, 2e-11);
}

/// The same events are met in the opposite order, with folds as births and births as folds.
TEST(Sweep, DownwardsIsTheSameAsUpwards) {
  const SweepKept up = run_sweep(worked_scene(whole_turn));
  Json reversed = whole_turn;
  std::swap(reversed["from"], reversed["to"]);
  const SweepKept down = run_sweep(worked_scene(reversed));
  ASSERT_EQ(up.rows.size(), down.rows.size());
  ASSERT_EQ(up.events.size(), down.events.size());
  for (std::size_t index = 0; index < up.events.size(); ++index) {
    const SweepEventKept& one = up.events[index];
    const SweepEventKept& other = down.events[down.events.size() - 1 - index];
    EXPECT_NEAR(one.parameter, other.parameter, 1e-14);
    EXPECT_EQ(one.kind() == "fold", other.kind() == "birth");
    EXPECT_EQ(one.step, 35 - other.step);
  }
}

TEST(Sweep, UnitsDoNotMatter) {
  const RandomSweep::Swept swept = RandomSweep::Swept::displacement;
  const SweepKept plain = run_sweep(random_sweep("RRRRRR", swept, 7, 41).scene);
  ASSERT_GT(plain.events.size(), 0U);
  for (const double unit : {1e-6, 1e6}) {
    const SweepKept scaled = run_sweep(random_sweep("RRRRRR", swept, 7, 41, unit).scene);
    EXPECT_EQ(plain.branches(), scaled.branches());
    ASSERT_EQ(plain.events.size(), scaled.events.size());
    for (std::size_t index = 0; index < plain.events.size(); ++index) {
      EXPECT_EQ(plain.events[index].text, scaled.events[index].text);
      EXPECT_NEAR(plain.events[index].parameter * unit, scaled.events[index].parameter,
                  1e-13 * unit);
    }
  }
}

BodyPose pose_of(const Eigen::VectorXd& pose, std::size_t link) {
  const auto row = 4 * static_cast<Eigen::Index>(link);
  return {pose(row), pose(row + 1), std::atan2(pose(row + 3), pose(row + 2))};
}

/// Links 2 to 5 of the scene are the bodies 0 to 3.
void place(RigidBodies& bodies, const Eigen::VectorXd& pose) {
  for (std::size_t body = 0; body < 4; ++body) {
    bodies.poses[body] = pose_of(pose, body + 2);
  }
}

/// Each step of 0.3 rad is followed by rigid bodies in many small steps.
TEST(Sweep, BranchesAreTheMotionsOfRigidBodies) {
  constexpr int small_steps = 20;
  int joins = 0;
  int astray = 0;
  double worst = 0;
  for (const char* kind : {"RRRRRR", "RRRRPR", "RPRRRR", "RRPRPR"}) {
    for (unsigned seed = 1; seed <= 2; ++seed) {
      RandomSweep made = random_sweep(kind, RandomSweep::Swept::crank, seed, 22);
      const SweepKept kept = run_sweep(made.scene);
      for (const auto& [row, next] : neighbours(kept)) {
        if (next->branch != row->branch) {
          continue;
        }
        place(made.bodies, row->pose);
        bool assembled = true;
        for (int small = 1; small <= small_steps && assembled; ++small) {
          made.set_parameter(row->parameter + (next->parameter - row->parameter) *
                                                  static_cast<Real>(small) / small_steps);
          assembled = made.bodies.assemble();
        }
        double apart = 0;
        for (std::size_t body = 0; body < 4; ++body) {
          const BodyPose there = pose_of(next->pose, body + 2);
          const BodyPose& here = made.bodies.poses[body];
          apart = largest(
              apart, static_cast<double>(std::hypot(std::hypot(here.x - there.x, here.y - there.y),
                                                    std::sin((here.theta - there.theta) / 2))));
        }
        ++joins;
        const bool arrived = assembled && apart < 1e-6;
        astray += arrived ? 0 : 1;
        worst = arrived ? largest(worst, apart) : worst;
      }
    }
  }
  std::cout << joins << " pieces of branches, " << astray << " astray, the others within " << worst
            << '\n';
  EXPECT_GT(joins, 200);
  EXPECT_EQ(astray, 0);
}

/// A step that is itself a dead centre: the double configuration is one row or two, of branches
/// that meet there, and the fold is an event at that step.
TEST(Sweep, AStepMayBeADeadCentre) {
  const SweepKept found = run_sweep(worked_scene(whole_turn));
  for (const SweepEventKept& event : found.events) {
    SCOPED_TRACE(event.text);
    for (const double shift : {0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-10, -1e-15, -1e-12, -1e-10}) {
      SCOPED_TRACE(shift);
      Json sweep = whole_turn;
      sweep["from"] = event.parameter + shift - 0.25;
      sweep["to"] = event.parameter + shift + 0.25;
      sweep["count"] = 3;
      const SweepKept kept = run_sweep(worked_scene(sweep));
      ASSERT_EQ(kept.events.size(), 1U);
      EXPECT_EQ(kept.events[0].kind(), event.kind());
      EXPECT_NEAR(kept.events[0].parameter, event.parameter, 2e-14);
      for (const SweepRowKept& row : kept.rows) {
        EXPECT_GT(row.branch, 0);
      }
    }
    // At an end of the sweep. If the pair lies beyond it, the double configuration has no branch.
    for (const bool first : {true, false}) {
      Json sweep = whole_turn;
      sweep["from"] = first ? event.parameter : event.parameter - 0.25;
      sweep["to"] = first ? event.parameter + 0.25 : event.parameter;
      const SweepKept kept = run_sweep(worked_scene(sweep));
      int single = 0;
      for (const SweepRowKept& row : kept.rows) {
        single += row.branch == 0 ? 1 : 0;
      }
      const bool outside = first == (event.kind() == "fold");
      EXPECT_LE(single, outside ? 2 : 0);
      EXPECT_EQ(kept.events.size(), outside ? 0U : 1U);
    }
  }
}

TEST(Sweep, OneStepAndNoRange) {
  Json sweep = whole_turn;
  sweep["count"] = 1;
  EXPECT_EQ(run_sweep(worked_scene(sweep)).rows.size(), 2U);
  sweep = {{"parameter", "phi"}, {"from", 2}, {"to", 2}, {"count", 3}};
  const SweepKept kept = run_sweep(worked_scene(sweep));
  EXPECT_EQ(kept.rows.size(), 12U);
  EXPECT_TRUE(kept.events.empty());
  for (const SweepRowKept& row : kept.rows) {
    EXPECT_EQ(row.branch, row.configuration);
  }
}

}  // namespace
}  // namespace assur::test::sweep_test
