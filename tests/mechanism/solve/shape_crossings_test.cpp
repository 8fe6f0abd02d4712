// Law: where a length, a driver between moving links or a bent law brings two motions together,
// both are told as closed forms have them, however rounding displaces the place; and a sweep that
// has a step there tells the crossing.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"
#include "whole_campaign.hpp"

namespace assur::test::shape_crossings_test {
namespace {

using Json = SceneMaker::Json;

/// A mechanism that the parameter s moves at the rate one, singular at a value of s.
struct Case {
  std::string name;
  Json scene;
  double singular;
  double across_x, across_y;   ///< the direction in which C is watched
  std::vector<double> speeds;  ///< of C on each motion, from the least; none where there is a fold

  friend std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }
};

/// The scene with a driver of a joint, whose rates follow from its law.
Json driven(const SceneMaker& maker, const std::string& joint, const std::string& law) {
  Json scene = maker.scene();
  scene["drivers"][joint]["position"] = law;
  return scene;
}

SceneMaker above(double height) {
  SceneMaker maker;
  return maker.point("ground", "A", 0, 0).line("ground", "way", {0, height}, {1, 0});
}

/// A bar from A to C on the line y = 2: x = +-s, or a fold where the bar grows along itself.
Json bar_to(const Json& x, const Json& y) {
  Json scene = above(2)
                   .point("bar", "A", 0, 0)
                   .point("bar", "C", x, y)
                   .slot("on", "ground.way", "bar.C")
                   .scene();
  scene["drivers"] = Json::object();
  return scene;
}

/// Bars of 3 and 1, whose elbow is driven: x^2 = 10 + 6 cos s - height^2.
Json elbow(double height) {
  return driven(above(height)
                    .bar("arm", {{"A", 0}, {"B", 3}})
                    .bar("forearm", {{"B", 0}, {"C", 1}})
                    .slot("on", "ground.way", "forearm.C"),
                "B", "s");
}

/// A rod in a tube about A, along (a, b): its pin C on the line y = c is `c` aside, and at x = +-s.
Json tube(double a, double b, double c) {
  return driven(above(c)
                    .point("tube", "A", 0, 0)
                    .line("tube", "axis", {0, 0}, {1, 0})
                    .line("rod", "axis", {0, 0}, {a, b})
                    .point("rod", "C", -b * c / std::hypot(a, b), a * c / std::hypot(a, b))
                    .slide("slides", "tube.axis", "rod.axis")
                    .slot("on", "ground.way", "rod.C"),
                "slides", "s");
}

/// A parallelogram of 4 and 1, driven between crank and coupler, whose ends are B and C. Where it
/// is flat, w2 = w1 + s' and (w1 + 4 w2)^2 = w1^2 + 4 w2^2.
Json parallelogram() {
  return driven(SceneMaker()
                    .bar("ground", {{"A", 0}, {"D", 4}})
                    .bar("crank", {{"A", 0}, {"B", 1}})
                    .bar("coupler", {{"B", 0}, {"C", 4}})
                    .bar("rocker", {{"D", 0}, {"C", 1}}),
                "B", "s");
}

/// Bars of 1 and 2 from A to a block on the x-axis at b: cos(theta) = (b^2 - 3)/(2 b).
Json stretched(const std::string& law) {
  return driven(SceneMaker()
                    .point("ground", "A", 0, 0)
                    .line("ground", "way", {0, 0}, {1, 0})
                    .line("block", "way", {0, 0}, {1, 0})
                    .point("block", "B", 0, 0)
                    .bar("one", {{"A", 0}, {"C", 1}})
                    .bar("two", {{"C", 0}, {"B", 2}})
                    .slide("slides", "ground.way", "block.way"),
                "slides", law);
}

std::vector<Case> cases() {
  constexpr double pi = std::numbers::pi;
  const double root = std::sqrt(2.0 / 3);
  return {{"bar", bar_to("s", 2), 0, 1, 0, {-1, 1}},
          {"bar that is longest", bar_to(0, "3 - cos(s)"), 0, 1, 0, {-std::sqrt(2), std::sqrt(2)}},
          {"bar that grows", bar_to(0, "2 + s"), 0, 1, 0, {}},
          {"folded elbow", elbow(2), pi, 1, 0, {-std::sqrt(3), std::sqrt(3)}},
          {"stretched elbow", elbow(4), 0, 1, 0, {}},
          {"bent elbow", elbow(std::sqrt(10)), pi / 2, 1, 0, {}},
          {"tube along x", tube(1, 0, 3), 0, 1, 0, {-1, 1}},
          {"tube along 4 3", tube(4, 3, 5), 0, 1, 0, {-1, 1}},
          {"tube along 12 5", tube(12, 5, 13), 0, 1, 0, {-1, 1}},
          {"tube along -15 8", tube(-15, 8, 17), 0, 1, 0, {-1, 1}},
          {"parallelogram", parallelogram(), 0, 0, 1, {-1, 1}},
          {"square law", stretched("3 - s^2/2"), 0, 0, 1, {-root, root}},
          {"cosine", stretched("2 + cos(s)"), 0, 0, 1, {-root, root}},
          {"cosine elsewhere", stretched("2 + cos(s - 1)"), 1, 0, 1, {-root, root}}};
}

class ShapeCrossings : public testing::TestWithParam<Case> {};

std::vector<double> speeds_of(const Case& one, const Configuration& configuration) {
  std::vector<double> speeds;
  for (const Configuration& motion : configuration.branches) {
    const Eigen::Vector2d& velocity = motion.output("C").velocity;
    speeds.push_back(one.across_x * velocity.x() + one.across_y * velocity.y());
  }
  std::ranges::sort(speeds);
  return speeds;
}

TEST_P(ShapeCrossings, HaveBothMotionsAndBesideThemToo) {
  const Case& one = GetParam();
  for (const double aside :
       {0.0, 1e-17, -5.551115123125783e-17, 1e-16, 1e-14, -1e-12, 1e-9, 1e-8}) {
    for (int listing = 0; listing < listings; ++listing) {
      SCOPED_TRACE(testing::Message() << aside << " listing " << listing);
      Json scene = scene_listed(one.scene, listing);
      scene["parameters"]["s"] = {{"value", one.singular + aside}, {"velocity", 1}};
      const Solved solved(mechanism::parse_scene(scene.dump(), "scene"));
      if (one.speeds.empty()) {
        for (const Configuration& configuration : solved.configurations()) {
          EXPECT_TRUE(configuration.branches.empty());
        }
        continue;
      }
      ASSERT_EQ(solved.configurations().size(), 1U);
      const std::vector<double> speeds = speeds_of(one, solved.configurations()[0]);
      ASSERT_EQ(speeds.size(), one.speeds.size());
      for (std::size_t place = 0; place < speeds.size(); ++place) {
        EXPECT_NEAR(speeds[place], one.speeds[place], 1e-7 + std::abs(aside));
      }
    }
  }
}

/// All of these by `ctest -L long`, one in 7 by default.
TEST_P(ShapeCrossings, AreToldByASweepWithAStepThere) {
  const Case& one = GetParam();
  int number = 0;
  if (one.speeds.empty()) {
    return;
  }
  const std::vector<std::pair<double, double>> ranges{{-1, 1},  {1, -1},  {-0.5, 0},
                                                      {0, 0.5}, {0.5, 0}, {0, -0.5}};
  for (const auto& [from, to] : ranges) {
    for (const int count : {3, 20, 21}) {
      for (int listing = 0; listing < listings; ++listing) {
        if (number++ % 7 != 0 && !is_whole_campaign()) {
          continue;
        }
        SCOPED_TRACE(testing::Message()
                     << from << " to " << to << " by " << count << " listing " << listing);
        Json scene = scene_listed(one.scene, listing);
        scene["parameters"]["s"] = {{"value", one.singular}, {"velocity", 1}};
        scene["sweep"] = {{"parameter", "s"},
                          {"from", one.singular + from},
                          {"to", one.singular + to},
                          {"count", count}};
        const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
        std::map<int, int> rows;
        std::vector<std::string> events;
        const auto record = [&](const mechanism::SweepRecord& at) {
          if (at.event.empty()) {
            ++rows[at.branch];
          } else {
            events.push_back(at.event);
            EXPECT_NEAR(at.parameter, one.singular, 1e-11);
          }
        };
        mechanism::sweep(plan, {record, {}, {}});
        EXPECT_EQ(events, std::vector<std::string>{"crossing 1 2"});
        EXPECT_EQ(rows, (std::map<int, int>{{1, count}, {2, count}}));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, ShapeCrossings, testing::ValuesIn(cases()),
                         [](const auto& at) {
                           std::string name = at.param.name;
                           std::erase_if(name, [](char letter) {
                             return std::isalnum(static_cast<unsigned char>(letter)) == 0;
                           });
                           return name;
                         });

}  // namespace
}  // namespace assur::test::shape_crossings_test
