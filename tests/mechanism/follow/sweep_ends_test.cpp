// Law: an event at the very end of a sweep is reported there, in every listing, unit and direction;
// where links turn freely at one value, a step there says so, and branches pass joined.
#include <gtest/gtest.h>

#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::sweep_ends_test {
namespace {

struct FourBar {
  const char* name;
  double crank, coupler, rocker, ground;
  double singular;  ///< the crank's angle at the event, to within rounding
  const char* as_end;
  const char* as_start;

  friend std::ostream& operator<<(std::ostream& out, const FourBar& bar) { return out << bar.name; }
};

/// The crank's angle at which coupler and rocker are in line, to within rounding.
double dead_centre(double crank, double coupler, double rocker, double ground) {
  return std::acos((crank * crank + ground * ground - std::pow(coupler + rocker, 2)) /
                   (2 * crank * ground));
}

SceneMaker::Json scene_of(const FourBar& bar, double unit) {
  return SceneMaker()
      .parameter("phi", 0.0)
      .bar("ground", {{"A", 0.0}, {"D", bar.ground * unit}})
      .bar("crank", {{"A", 0.0}, {"B", bar.crank * unit}})
      .bar("coupler", {{"B", 0.0}, {"C", bar.coupler * unit}})
      .bar("rocker", {{"D", 0.0}, {"C", bar.rocker * unit}})
      .drive("A", "phi", 1, 0)
      .scene();
}

std::vector<std::pair<std::string, double>> events_of(SceneMaker::Json scene, double from,
                                                      double to) {
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", 2}};
  const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  std::vector<std::pair<std::string, double>> events;
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (!at.event.empty()) {
      events.emplace_back(at.event, at.parameter);
    }
  };
  mechanism::sweep(plan, {record, {}, {}});
  return events;
}

class SweepEnds : public testing::TestWithParam<FourBar> {};

/// Ends a few roundings before the event, at it and behind it: one in 4, by `ctest -L long` all.
TEST_P(SweepEnds, AreToldAlike) {
  const FourBar& bar = GetParam();
  int number = 0;
  for (const int roundings : {-10, -1, 0, 3, 20}) {
    const double end = bar.singular + roundings * std::numeric_limits<double>::epsilon();
    for (const double unit : {1.0, 3.0, 0.1, std::ldexp(1, -300), std::ldexp(1, 300)}) {
      for (int listing = 0; listing < listings; ++listing) {
        if (number++ % 4 != 0 && !is_whole_campaign()) {
          continue;
        }
        SCOPED_TRACE(testing::Message()
                     << roundings << " roundings, unit " << unit << ", listing " << listing);
        const SceneMaker::Json scene = scene_listed(scene_of(bar, unit), listing);
        for (const bool ends : {true, false}) {
          const auto events =
              ends ? events_of(scene, end - 0.25, end) : events_of(scene, end, end - 0.25);
          ASSERT_EQ(events.size(), 1U);
          EXPECT_EQ(events[0].first, ends ? bar.as_end : bar.as_start);
          EXPECT_LE(events[0].second, end);
          EXPECT_NEAR(events[0].second, end, 2e-14);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , SweepEnds,
    testing::Values(FourBar{"stretched", 1.3, 0.72, 1.11, 1.9, dead_centre(1.3, 0.72, 1.11, 1.9),
                            "fold 1 2", "birth 1 2"},
                    FourBar{"stretched, long", 3.3, 3.78, 1.13, 1.9,
                            dead_centre(3.3, 3.78, 1.13, 1.9), "fold 1 2", "birth 1 2"},
                    FourBar{"parallelogram", 1.3, 1.9, 1.3, 1.9, std::numbers::pi, "crossing 1 2",
                            "crossing 1 2"},
                    FourBar{"rhombus", 0.7, 0.7, 0.7, 0.7, std::numbers::pi, "crossing 1 2",
                            "crossing 1 2"}));

/// At 0 the crank of a kite lies on its ground, and the two other links turn freely.
TEST(SweepEndsInSelfMotion, AreToldFromBothSides) {
  const FourBar kite{"kite", 4, 2, 2, 4, 0, "", ""};
  using Events = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(events_of(scene_of(kite, 1), -1, 0), (Events{{"degenerate 1 2 /", 0}}));
  EXPECT_EQ(events_of(scene_of(kite, 1), 0, 1), (Events{{"degenerate / 1 2", 0}}));
}

/// A law that reads a four-bar 1e-12 before its dead centre has no known acceleration there if the
/// crank moves. The derivatives of places, and so the branches, do not depend on its velocity.
TEST(SweepEndsBesideADeadCentre, AreRowsOfKnownBranches) {
  const double end = dead_centre(2, 2.5, 2, 4) - 1e-12;
  std::map<double, std::vector<std::pair<int, double>>> rows;  // branch and angle, by velocity
  for (const double velocity : {0.0, 1.0}) {
    SceneMaker::Json scene = SceneMaker()
                                 .parameter("phi", 0.0)
                                 .bar("ground", {{"O", 0.0}, {"D", 4.0}})
                                 .point("ground", "P", 0, 8)
                                 .point("ground", "Q", 5, 9)
                                 .bar("crank", {{"O", 0.0}, {"B", 2.0}})
                                 .bar("coupler", {{"B", 0.0}, {"C", 2.5}})
                                 .bar("rocker", {{"D", 0.0}, {"C", 2.0}})
                                 .bar("arm", {{"P", 0.0}, {"S", 1.0}})
                                 .bar("rod", {{"S", 0.0}, {"T", 4.0}})
                                 .bar("lever", {{"Q", 0.0}, {"T", 4.0}})
                                 .drive("O", "phi", velocity, 0)
                                 .scene();
    scene["drivers"]["P"] = {{"position", "2*joint(D)+1"}};
    scene["sweep"] = {{"parameter", "phi"}, {"from", end - 0.01}, {"to", end}, {"count", 3}};
    const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
    const auto record = [&](const mechanism::SweepRecord& at) {
      if (at.event.empty() && at.step == 2) {
        EXPECT_NE(at.branch, 0);
        rows[velocity].emplace_back(at.branch, at.state->output("C").position.x());
      }
    };
    mechanism::sweep(plan, {record, {}, {}});
  }
  EXPECT_EQ(rows[0].size(), 4U);
  EXPECT_EQ(rows[0], rows[1]);
}

/// A scissor lift whose bars are all upright at 90 degrees, on one line: each pair above the lowest
/// turns freely there, and the branches pass joined.
class UprightScissors : public testing::TestWithParam<int> {};

TEST_P(UprightScissors, GoOn) {
  const int stages = GetParam();
  constexpr double upright = std::numbers::pi / 2;
  SceneMaker maker;
  maker.parameter("phi", 1.0)
      .line("ground", "way", {0, 0}, {1, 0})
      .line("foot", "way", {0, 0}, {1, 0})
      .point("foot", "S", 0, 0)
      .slide("way", "ground.way", "foot.way")
      .point("ground", "L0", 0, 0)
      .drive("L0", "phi", 1, 0);
  std::string right = "S";
  for (int stage = 1; stage <= stages; ++stage) {
    const std::string above = std::to_string(stage);
    const std::string below = std::to_string(stage - 1);
    maker.bar("rising" + above, {{"L" + below, 0}, {"M" + above, 5}, {"R" + above, 10}})
        .bar("falling" + above, {{right, 0}, {"M" + above, 5}, {"L" + above, 10}});
    right = "R" + above;
  }
  for (const double width : {0.5, 1e-3, 1e-6}) {
    for (const int count : {4, 5}) {
      for (int listing = 0; listing < (is_whole_campaign() ? listings : 1); ++listing) {
        SCOPED_TRACE(testing::Message() << width << " " << count << " listing " << listing);
        SceneMaker::Json scene = scene_listed(maker.scene(), listing);
        scene["sweep"] = {{"parameter", "phi"},
                          {"from", upright - width},
                          {"to", upright + width},
                          {"count", count}};
        const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
        std::vector<std::string> events;
        std::map<int, std::set<std::string>>
            sides;  // of each branch: which pairs stand on their heads
        std::map<int, int> rows;
        const auto record = [&](const mechanism::SweepRecord& at) {
          if (!at.event.empty()) {
            events.push_back(at.event.substr(0, at.event.find(' ')));
            EXPECT_EQ(at.parameter, upright);
            return;
          }
          if (at.branch == 0) {
            return;  // The lowest pair is folded: a family, to within rounding.
          }
          ++rows[at.branch];
          std::string side;
          for (int stage = 1; stage <= stages; ++stage) {
            const std::string name = std::to_string(stage);
            side += at.state->output("L" + name).position.y() >
                            at.state->output("L" + std::to_string(stage - 1)).position.y()
                        ? '+'
                        : '-';
          }
          sides[at.branch].insert(side);
        };
        mechanism::sweep(plan, {record, {}, {}});
        const bool is_on_it = count % 2 == 1;
        EXPECT_EQ(events, std::vector<std::string>(is_on_it ? 1 : 0, "degenerate"));
        EXPECT_EQ(rows.size(), 1U << (stages - 1));
        for (const auto& [branch, number] : rows) {
          EXPECT_EQ(number, is_on_it ? count - 1 : count);
          EXPECT_EQ(sides[branch].size(), 1U) << "branch " << branch;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, UprightScissors, testing::Values(2, 3, 4));

}  // namespace
}  // namespace assur::test::sweep_ends_test
