// Law: a branch that leads through a family has no row at the step of the family, which is an event
// that names it, also where other branches cross or are born there; no branch is moved to another
// configuration.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::families_at_steps_test {
namespace {

using Events = std::vector<std::string>;

/// Events at the value 0, and the places of each branch, in units of `unit`, at every step.
struct Swept {
  Events events;
  std::map<int, std::map<double, Eigen::VectorXd>> places;

  [[nodiscard]] int rows_at(double parameter) const {
    return static_cast<int>(std::ranges::count_if(
        places, [&](const auto& branch) { return branch.second.contains(parameter); }));
  }
};

Swept swept(SceneMaker::Json scene, double unit, double from, double to, int count) {
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", count}};
  const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  Swept result;
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (!at.event.empty()) {
      if (at.parameter == 0) {
        result.events.push_back(at.event);
      }
      return;
    }
    Eigen::VectorXd places(2 * static_cast<Eigen::Index>(at.state->outputs.size()));
    Eigen::Index row = 0;
    for (const auto& output : at.state->outputs) {
      places.segment<2>(row) = output.position / unit;
      row += 2;
    }
    EXPECT_TRUE(result.places[at.branch].emplace(at.parameter, places).second);
  };
  mechanism::sweep(plan, {record, {}, {}});
  return result;
}

/// How far a branch is at 0 from its rows a little before or after.
double longest_jump(const Swept& found) {
  double longest = 0;
  for (const auto& [branch, places] : found.places) {
    const auto here = places.find(0);
    for (const auto& [parameter, place] : places) {
      if (here != places.end() && std::abs(parameter) < 1e-2) {
        longest = std::max(longest, (place - here->second).norm());
      }
    }
  }
  return longest;
}

/// Three equal legs under a congruent platform. With the driven crank on the ground, four branches
/// lead through the family in which the platform translates; two cross where it is turned by half a
/// turn.
SceneMaker::Json platform_on_legs(double unit) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .point("ground", "O", -unit, 0)
      .point("ground", "G", 2 * unit, 0)
      .point("ground", "H", unit, unit)
      .bar("crank", {{"O", 0.0}, {"B", unit}})
      .bar("first", {{"B", 0.0}, {"P", 2 * unit}})
      .bar("second", {{"G", 0.0}, {"Q", 2 * unit}})
      .bar("third", {{"H", 0.0}, {"R", 2 * unit}})
      .point("platform", "P", 0, 0)
      .point("platform", "Q", 2 * unit, 0)
      .point("platform", "R", unit, unit)
      .drive("O", "phi", 1, 0)
      .scene();
}

/// A crank whose pin passes the pivot of a slotted lever, which then turns freely, and a
/// parallelogram that is flat in the same position.
SceneMaker::Json lever_and_parallelogram(double unit) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .bar("ground", {{"O", 0.0}, {"W", unit}, {"D", 3 * unit}})
      .bar("crank", {{"O", 0.0}, {"B", unit}})
      .bar("lever", {{"W", 0.0}, {"T", unit}})
      .line("lever", "slot", {0, 0}, {1, 0})
      .slot("S", "lever.slot", "crank.B")
      .bar("coupler", {{"B", 0.0}, {"C", 3 * unit}})
      .bar("rocker", {{"D", 0.0}, {"C", unit}})
      .drive("O", "phi", 1, 0)
      .scene();
}

class FamiliesAtSteps : public testing::TestWithParam<int> {
 protected:
  /// Checks a scene in one unit for each listing, and by `ctest -L long` in all.
  template <typename Check>
  static void in_units(SceneMaker::Json (*make)(double), const Check& check) {
    constexpr std::array units = {1.0, 3.0, 1e-3};
    for (std::size_t index = 0; index < units.size(); ++index) {
      if (is_whole_campaign() || index == static_cast<std::size_t>(GetParam())) {
        SCOPED_TRACE(units[index]);
        check(scene_listed(make(units[index]), GetParam()), units[index]);
      }
    }
  }
};

TEST_P(FamiliesAtSteps, HaveNoRowsBesideACrossing) {
  in_units(platform_on_legs, [](const SceneMaker::Json& scene, double unit) {
    for (const int count : {3, 81}) {
      const Swept found = swept(scene, unit, -0.1, 0.1, count);
      EXPECT_EQ(found.events, (Events{"crossing 1 2", "degenerate 3 4 5 6 / 3 4 5 6"}));
      EXPECT_EQ(found.rows_at(0), 2);
      EXPECT_LT(longest_jump(found), 0.1);
    }
  });
}

TEST_P(FamiliesAtSteps, HaveNoRowsWhereASweepBeginsOrEnds) {
  in_units(platform_on_legs, [](const SceneMaker::Json& scene, double unit) {
    for (const double end : {-0.1, 0.1}) {
      for (const bool begins : {true, false}) {
        const Swept found =
            begins ? swept(scene, unit, 0, end, 21) : swept(scene, unit, end, 0, 21);
        ASSERT_EQ(found.events.size(), 1U);
        EXPECT_EQ(found.events.front().substr(0, 10), "degenerate");
        EXPECT_EQ(found.rows_at(end), 6);
        EXPECT_LE(found.rows_at(0), 2);
        EXPECT_LT(longest_jump(found), 0.2);
      }
    }
  });
}

TEST_P(FamiliesAtSteps, AreEventsBesideCrossings) {
  in_units(lever_and_parallelogram, [](const SceneMaker::Json& scene, double unit) {
    for (const int count : {3, 81}) {
      const Swept found = swept(scene, unit, -0.1, 0.1, count);
      EXPECT_EQ(found.events,
                (Events{"crossing 1 2", "crossing 3 4", "degenerate 1 2 3 4 / 1 2 3 4"}));
      EXPECT_EQ(found.rows_at(0), 0);
      EXPECT_EQ(found.rows_at(0.1), 4);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Listings, FamiliesAtSteps, testing::Range(0, listings));

}  // namespace
}  // namespace assur::test::families_at_steps_test
