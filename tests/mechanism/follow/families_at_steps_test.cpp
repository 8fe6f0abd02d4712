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

/// Events at the value 0 to within rounding, and the places of each branch, in units of `unit`, at
/// every step.
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
      if (std::abs(at.parameter) < 1e-13) {
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

/// A four-bar whose point C passes (5, 3) or (5, -3) with the crank on the ground, and a dyad of
/// equal legs from C to (5, 3): it turns freely at the first place, and is stretched at the second.
SceneMaker::Json family_beside_a_birth(double unit) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .point("ground", "O", 0, 0)
      .point("ground", "D", 9 * unit, 0)
      .point("ground", "E", 5 * unit, 3 * unit)
      .bar("crank", {{"O", 0.0}, {"B", unit}})
      .bar("coupler", {{"B", 0.0}, {"C", 5 * unit}})
      .bar("rocker", {{"D", 0.0}, {"C", 5 * unit}})
      .bar("first", {{"C", 0.0}, {"F", 3 * unit}})
      .bar("second", {{"E", 0.0}, {"F", 3 * unit}})
      .drive("O", "phi", 1, 0)
      .scene();
}

/// A stretched dyad, and two more that each of its configurations carries.
SceneMaker::Json stretched_with_two_more(double unit) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .point("ground", "O", 0, 0)
      .point("ground", "G", -3 * unit, -4 * unit)
      .point("ground", "H", 4 * unit, -4 * unit)
      .point("ground", "K", -unit, 3 * unit)
      .bar("crank", {{"O", 0.0}, {"B", unit}})
      .bar("u0", {{"B", 0.0}, {"C", std::sqrt(8.0) * unit}})
      .bar("v0", {{"G", 0.0}, {"C", std::sqrt(8.0) * unit}})
      .bar("u1", {{"B", 0.0}, {"E", 3 * unit}})
      .bar("v1", {{"H", 0.0}, {"E", std::sqrt(10.0) * unit}})
      .bar("u2", {{"C", 0.0}, {"F", std::sqrt(2.0) * unit}})
      .bar("v2", {{"K", 0.0}, {"F", std::sqrt(37.0) * unit}})
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

TEST_P(FamiliesAtSteps, HaveNoRowsBesideABirth) {
  in_units(family_beside_a_birth, [](const SceneMaker::Json& scene, double unit) {
    const Swept found = swept(scene, unit, -0.1, 0.1, 21);
    EXPECT_EQ(found.events, (Events{"birth 3 4", "degenerate 1 2 / 1 2"}));
    EXPECT_EQ(found.rows_at(0), 1);
    EXPECT_TRUE(found.places.at(3).contains(0));
    const Swept ends = swept(scene, unit, -0.1, 0, 21);
    EXPECT_EQ(ends.events, Events{"degenerate 1 2 /"});
    EXPECT_TRUE(ends.places.at(0).contains(0)) << "a configuration on no branch";
    const Swept back = swept(scene, unit, 0.1, -0.1, 21);
    EXPECT_LT(longest_jump(back), 0.3);
  });
}

/// All branches end at the last step, where rounding places their folds on either side of it.
TEST_P(FamiliesAtSteps, AreNotFoldsAtTheEnd) {
  in_units(stretched_with_two_more, [](const SceneMaker::Json& scene, double unit) {
    const Swept found = swept(scene, unit, -0.1, 0, 201);
    EXPECT_EQ(found.events, (Events{"fold 1 2", "fold 3 5", "fold 4 6", "fold 7 8"}));
    EXPECT_EQ(found.rows_at(0), 4);
    EXPECT_LT(longest_jump(found), 0.5);
  });
}

INSTANTIATE_TEST_SUITE_P(Listings, FamiliesAtSteps, testing::Range(0, listings));

}  // namespace
}  // namespace assur::test::families_at_steps_test
