// Law: if a mechanism without its redundant constraints has a family, it is listed where all
// constraints together leave it; otherwise the configurations that they leave are listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanism/redundant_cranks.hpp"

namespace assur::test {
namespace {

/// Where the tip of the first crank is on the pivot of another one, these two cranks and the
/// coupler could turn about that pivot; the third crank blocks them, in any listing and unit.
TEST(RedundantFamilies, ThatTheThirdCrankBlocksAreNone) {
  const std::array<Place, 2> others = {{{2, 0}, {1, 1}}};
  for (const std::string first : {"A", "F", "M"}) {
    for (const bool swaps : {false, true}) {
      for (const double unit : {1.0, 0x1p-60, 0x1p60}) {
        SCOPED_TRACE(first + (swaps ? " swapped, in " : ", in ") + std::to_string(unit));
        RedundantCranks cranks(2 * unit);
        cranks.add(first, {0, 0}).drive(first);
        cranks.add(swaps ? "H" : "B", {others[0].x * unit, others[0].y * unit});
        cranks.add(swaps ? "B" : "H", {others[1].x * unit, others[1].y * unit});
        const Plan plan = cranks.planned(0.7);
        for (const double beside : {0.0, 1e-15, -1e-12, 1e-9, -1e-7, 1e-6, 1e-4}) {
          const Solution found = plan.solve(plan.values({{"phi", beside}}));
          EXPECT_TRUE(found.families.empty()) << beside;
          ASSERT_EQ(found.configurations.size(), 1U) << beside;
          const Configuration& only = found.configurations[0];
          EXPECT_EQ(only.regularity, Status::ok) << beside;
          EXPECT_NEAR(only.link("coupler").pose.direction.sin, 0, 1e-14);
          EXPECT_NEAR(only.link("coupler").velocity(2), 0, 1e-12);
          for (const std::string crank : {"crank B", "crank H"}) {
            EXPECT_NEAR(only.link(crank).pose.direction.sin, std::sin(beside), 1e-14);
            EXPECT_NEAR(only.link(crank).pose.direction.cos, 1, 1e-8);
            EXPECT_NEAR(only.link(crank).velocity(2), 1, 1e-12);
          }
        }
      }
    }
  }
}

/// A second crank in the same place turns with the other one and leaves the family, at the scene's
/// own values and at others.
TEST(RedundantFamilies, ThatADoubledCrankLeavesAreListed) {
  RedundantCranks cranks(2);
  cranks.add("A", {0, 0}).add("B", {2, 0}).add("C", {2, 0}).drive("A");
  for (const double own : {0.7, 0.0}) {
    const Plan plan = cranks.planned(own);
    const Solution found = plan.solve(plan.values({{"phi", 0.0}}));
    EXPECT_EQ(found.status, SolutionStatus::degenerate) << own;
    EXPECT_EQ(found.mobility, 1) << own;
    EXPECT_TRUE(found.configurations.empty()) << own;
    ASSERT_EQ(found.families.size(), 1U) << own;
    EXPECT_EQ(plan.solve(plan.values({{"phi", 1.0}})).configurations.size(), 2U) << own;
  }
}

/// Of two such mechanisms side by side, one or both are blocked.
TEST(RedundantFamilies, AreToldOneByOne) {
  for (const bool doubled : {false, true}) {
    RedundantCranks cranks(2);
    cranks.add("A", {0, 0}).add("B", {2, 0}).add("C", doubled ? Place{2, 0} : Place{1, 1});
    cranks.drive("A").begin("second");
    cranks.add("P", {10, 0}).add("Q", {11, -1}).add("R", {12, 0}).drive("P");
    const Plan plan = cranks.planned(0.7);
    EXPECT_EQ(plan.redundant().size(), 2U);
    const Solution found = plan.solve(plan.values({{"phi", 0.0}}));
    EXPECT_EQ(found.families.size(), doubled ? 1U : 0U);
    EXPECT_EQ(found.mobility, doubled ? 1 : 0);
    ASSERT_EQ(found.configurations.size(), doubled ? 0U : 1U);
    if (!doubled) {
      EXPECT_NEAR(found.configurations[0].link("coupler").pose.direction.cos, 1, 1e-14);
      EXPECT_NEAR(found.configurations[0].link("second").pose.direction.cos, 1, 1e-14);
    }
  }
}

/// A sweep passes through such a place with its one branch.
TEST(RedundantFamilies, ThatAreBlockedEndNoBranch) {
  RedundantCranks cranks(2);
  cranks.add("A", {0, 0}).add("B", {1, 1}).add("C", {2, 0}).drive("A");
  cranks.json()["sweep"] = {{"parameter", "phi"}, {"from", -0.5}, {"to", 0.5}, {"count", 9}};
  int rows = 0;
  const auto record = [&](const mechanism::SweepRecord& at) {
    EXPECT_EQ(at.event, "") << at.step;
    EXPECT_EQ(at.branch, 1);
    if (at.event.empty()) {
      EXPECT_NEAR(at.state->link("crank C").velocity(2), 1, 1e-9) << at.step;
      ++rows;
    }
  };
  mechanism::sweep(cranks.planned(0.7), {record, {}, {}});
  EXPECT_EQ(rows, 9);
}

}  // namespace
}  // namespace assur::test
