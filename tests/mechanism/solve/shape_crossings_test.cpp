// Law: where a length, a driver between moving links or a bent law makes two motions meet, both are
// reported as closed forms have them, however rounding displaces the place, and a sweep with a step
// there reports the crossing.
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
Json elbow(double height, double unit = 1) {
  return driven(above(height * unit)
                    .bar("arm", {{"A", 0}, {"B", 3 * unit}})
                    .bar("forearm", {{"B", 0}, {"C", unit}})
                    .slot("on", "ground.way", "forearm.C"),
                "B", "s");
}

/// A rod in a tube about A, along (a, b): its pin C, `c` aside, is on the line y = c at +-s.
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

/// The rates of C across, from the least, and its second rates in the same order.
std::vector<std::pair<double, double>> rates_of(const Case& one,
                                                const Configuration& configuration) {
  const Eigen::Vector2d across(one.across_x, one.across_y);
  std::vector<std::pair<double, double>> rates;
  for (const Configuration& motion : configuration.branches) {
    const mechanism::Point& pin = motion.output("C");
    rates.emplace_back(across.dot(pin.velocity), across.dot(pin.acceleration));
  }
  std::ranges::sort(rates);
  return rates;
}

/// Each motion is odd in s, so its second rate is its slope times that of s.
TEST_P(ShapeCrossings, HaveBothMotionsAndBesideThemToo) {
  const Case& one = GetParam();
  constexpr double second_rate = 0.5;
  for (const double aside :
       {0.0, 1e-17, -5.551115123125783e-17, 1e-16, 1e-14, -1e-12, 1e-9, 1e-8}) {
    for (int listing = 0; listing < listings; ++listing) {
      SCOPED_TRACE(testing::Message() << aside << " listing " << listing);
      Json scene = scene_listed(one.scene, listing);
      scene["parameters"]["s"] = {
          {"value", one.singular + aside}, {"velocity", 1}, {"acceleration", second_rate}};
      const Solved solved(mechanism::parse_scene(scene.dump(), "scene"));
      if (one.speeds.empty()) {
        for (const Configuration& configuration : solved.configurations()) {
          EXPECT_TRUE(configuration.branches.empty());
        }
        continue;
      }
      ASSERT_EQ(solved.configurations().size(), 1U);
      const auto rates = rates_of(one, solved.configurations()[0]);
      ASSERT_EQ(rates.size(), one.speeds.size());
      for (std::size_t place = 0; place < rates.size(); ++place) {
        EXPECT_NEAR(rates[place].first, one.speeds[place], 1e-7 + std::abs(aside));
        EXPECT_NEAR(rates[place].second, second_rate * one.speeds[place], 1e-6);
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

TEST(ShapeCrossingsInOtherUnits, HaveTheSameMotions) {
  for (const double unit : {1e-3, 1e3, std::ldexp(1, -390), std::ldexp(1, 390)}) {
    SCOPED_TRACE(unit);
    const double root = std::sqrt(3);
    const Case one{"elbow", elbow(2, unit), std::numbers::pi, 1 / unit, 0, {-root, root}};
    Json scene = one.scene;
    scene["parameters"]["s"] = {{"value", one.singular}, {"velocity", 1}, {"acceleration", 0.5}};
    const Solved solved(mechanism::parse_scene(scene.dump(), "scene"));
    ASSERT_EQ(solved.configurations().size(), 1U);
    const auto rates = rates_of(one, solved.configurations()[0]);
    ASSERT_EQ(rates.size(), 2U);
    for (std::size_t place = 0; place < 2; ++place) {
      EXPECT_NEAR(rates[place].first, one.speeds[place], 1e-9);
      EXPECT_NEAR(rates[place].second, one.speeds[place] / 2, 1e-9);
    }
  }
}

/// Links L1 to L4 in a loop that a slide drives, which is solved relative to L1. Where it is flat,
/// the motions of the loop shape the group that stands on the ground differently.
Json loop(const std::vector<double>& numbers, double along_l3, double along_ground) {
  const auto at = [&](std::size_t place) { return numbers[place]; };
  Json scene = SceneMaker()
                   .point("ground", "O", at(0), at(1))
                   .line("ground", "h", {at(2), at(3)}, {along_ground, 0})
                   .point("L1", "P", 0, 0)
                   .point("L1", "Q", 0, at(4))
                   .point("L1", "O", at(5), at(6))
                   .point("L2", "P", at(7), at(8))
                   .point("L2", "R", at(9), at(10))
                   .point("L2", "S", at(11), at(12))
                   .point("L3", "Q", at(13), 0)
                   .line("L3", "way", {at(14), at(15)}, {0, along_l3})
                   .point("L4", "R", at(16), at(17))
                   .line("L4", "way", {at(18), at(19)}, {0, along_l3})
                   .slide("slides", "L4.way", "L3.way")
                   .slot("on", "ground.h", "L2.S")
                   .scene();
  scene["drivers"]["slides"]["position"] = "s";
  return scene;
}

std::vector<double> pose_of(const Configuration& configuration, double near) {
  const Pose<double>& pose = configuration.link("L2").pose;
  return {pose.x, pose.y,
          near + std::remainder(angle_of(pose.direction) - near, 2 * std::numbers::pi)};
}

TEST(ShapeCrossingsOfRelativeGroups, HaveTheRatesOfTheConfigurationsBeside) {
  constexpr double h = 1e-3;
  const std::vector<std::pair<double, Json>> scenes{
      {0, loop({-1, -1, 0, 1, 2, -1, 2, 0, 1, -1, 1, -3, 2, 1, 0, 1, -1, 1, -1, 2}, -1, 1)},
      {-2, loop({1, 2, 2, -2, 1, -2, 3, 1, 1, 1, 3, -3, 0, 3, 6, -3, -1, 5, 3, 4}, 1, -1)}};
  for (const auto& [singular, given] : scenes) {
    for (int listing = 0; listing < listings; ++listing) {
      SCOPED_TRACE(testing::Message() << singular << " listing " << listing);
      const auto at = [&, singular = singular, &given = given](double time) {
        Json scene = scene_listed(given, listing);
        const double moved = time + time * time / 4;
        scene["parameters"]["s"] = {
            {"value", singular + moved}, {"velocity", 1}, {"acceleration", 0.5}};
        return Solved(mechanism::parse_scene(scene.dump(), "scene"));
      };
      const Solved here = at(0);
      const Solved before = at(-h);
      const Solved after = at(h);
      ASSERT_EQ(here.configurations().size(), 2U);
      for (const Configuration& configuration : here.configurations()) {
        ASSERT_EQ(configuration.branches.size(), 2U);
        for (const Configuration& motion : configuration.branches) {
          const mechanism::Frame& told = motion.link("L2");
          const double angle = angle_of(told.pose.direction);
          const std::vector<double> middle = pose_of(motion, angle);
          double least = 1;
          for (const Configuration& one : before.configurations()) {
            for (const Configuration& other : after.configurations()) {
              const std::vector<double> from = pose_of(one, angle);
              const std::vector<double> to = pose_of(other, angle);
              double miss = 0;
              for (int row = 0; row < 3; ++row) {
                const auto place = static_cast<std::size_t>(row);
                const double rate = (to[place] - from[place]) / (2 * h);
                const double second = (to[place] - 2 * middle[place] + from[place]) / (h * h);
                miss = std::max({miss, std::abs(told.velocity(row) - rate),
                                 std::abs(told.acceleration(row) - second)});
              }
              least = std::min(least, miss);
            }
          }
          EXPECT_LT(least, 1e-3);
        }
      }
    }
  }
}

}  // namespace
}  // namespace assur::test::shape_crossings_test
