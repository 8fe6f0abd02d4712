// Law: events of a mechanism with redundant constraints name only branches that have rows, and no
// branches of the mechanism without these constraints.
#include <gtest/gtest.h>

#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <map>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"

namespace assur::test::own_branches_test {
namespace {

using Events = std::vector<std::string>;

struct Swept {
  Events events;
  std::map<int, int> rows;  ///< of each branch
};

Swept swept(SceneMaker::Json scene, double from, double to, int count) {
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", count}};
  const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  Swept result;
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (at.event.empty()) {
      ++result.rows[at.branch];
    } else {
      result.events.push_back(at.event);
    }
  };
  mechanism::sweep(plan, {record, {}, {}});
  return result;
}

/// A four-bar that has its rocker twice.
SceneMaker::Json doubled(double crank, double coupler, double rocker, double ground) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .bar("ground", {{"A", 0.0}, {"D", ground}})
      .bar("crank", {{"A", 0.0}, {"B", crank}})
      .bar("coupler", {{"B", 0.0}, {"C", coupler}})
      .bar("rocker", {{"D", 0.0}, {"C", rocker}})
      .bar("again", {{"D", 0.0}, {"C", rocker}})
      .drive("A", "phi", 1, 0)
      .scene();
}

/// Three equal cranks on one coupler, and a four-bar beside them. Without the third crank there
/// would be twice as many branches; they meet where the cranks lie on the ground.
SceneMaker::Json three_cranks(double velocity = 1) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .bar("ground", {{"A0", 0.0}, {"A1", 1.0}, {"A2", 2.0}, {"E", 20.0}, {"H", 23.0}})
      .bar("coupler", {{"B0", 0.0}, {"B1", 1.0}, {"B2", 2.0}})
      .bar("crank0", {{"A0", 0.0}, {"B0", 2.0}})
      .bar("crank1", {{"A1", 0.0}, {"B1", 2.0}})
      .bar("crank2", {{"A2", 0.0}, {"B2", 2.0}})
      .bar("other_crank", {{"E", 0.0}, {"F", 2.0}})
      .bar("other_coupler", {{"F", 0.0}, {"G", 3.0}})
      .bar("other_rocker", {{"H", 0.0}, {"G", 2.0}})
      .drive("A0", "phi", velocity, 0)
      .drive("E", "phi", velocity, 0)
      .scene();
}

TEST(OwnBranches, CrossWithoutOthers) {
  for (const double velocity : {1, 0}) {
    const Swept found = swept(three_cranks(velocity), -1, 1, 5);
    EXPECT_EQ(found.events, Events{"crossing 1 2"});
    EXPECT_EQ(found.rows, (std::map<int, int>{{1, 5}, {2, 5}})) << "velocity " << velocity;
  }
}

TEST(OwnBranches, BecomeDegenerateWithoutOthers) {
  const SceneMaker::Json kite = doubled(4, 2, 2, 4);
  EXPECT_EQ(swept(kite, 0, 1, 3).events, Events{"degenerate / 1 2"});
}

/// The branches begin and end as if there were one rocker.
TEST(OwnBranches, BeginAndEnd) {
  const Swept found = swept(doubled(1.3, 0.72, 1.11, 1.9), -2, 2, 9);
  EXPECT_EQ(found.events, (Events{"birth 1 2", "fold 1 2"}));
  EXPECT_EQ(found.rows.size(), 2U);
}

}  // namespace
}  // namespace assur::test::own_branches_test
