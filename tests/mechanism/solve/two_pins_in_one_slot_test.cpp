// Law: two pins of one link in one straight slot are a prismatic joint that may stand either way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "mechanism/scene_maker.hpp"
#include "mechanism/scene_solutions.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::two_pins_in_one_slot {
namespace {

/// How a link with two pins and a link with a slot are joined.
enum class Joined : unsigned char {
  pins,       ///< by two pins in the slot
  one_way,    ///< by a slide along the line from the first pin to the second
  other_way,  ///< by a slide back along that line
};

/// The lengths of a mechanism, in units that have no common part.
struct Lengths {
  std::array<double, 8> at;
};

Lengths random_lengths(std::minstd_rand& random) {
  std::uniform_real_distribution<double> length(0.5, 2.5);
  Lengths lengths{};
  std::ranges::generate(lengths.at, [&] { return length(random); });
  return lengths;
}

void join(const std::string& slot, const std::string& link, std::array<double, 2> first,
          std::array<double, 2> second, Joined joined, SceneMaker& scene) {
  if (joined == Joined::pins) {
    scene.point(link, "P", first[0], first[1]).point(link, "Q", second[0], second[1]);
    scene.slot("SP", slot, link + ".P").slot("SQ", slot, link + ".Q");
    return;
  }
  const double sense = joined == Joined::one_way ? 1 : -1;
  scene.point(link, "P", first[0], first[1]).point(link, "Q", second[0], second[1]);
  scene.line(link, "along", {first[0], first[1]},
             {sense * (second[0] - first[0]), sense * (second[1] - first[1])});
  scene.slide("SP", slot, link + ".along");
}

/// A crank moves a slider with two pins in a slot of the ground, or with the slot and two pins on
/// the ground.
Json slider(const Lengths& length, bool has_slot, Joined joined) {
  const auto& [r, l, x, y, d, cx, cy, offset] = length.at;
  SceneMaker scene;
  scene.bar("ground", {{"O", 0}}).bar("crank", {{"O", 0}, {"A", r}});
  scene.bar("rod", {{"A", 0}, {"C", 2 + l}}).point("slider", "C", cx, -cy);
  scene.line(has_slot ? "slider" : "ground", "slot", {x, -y}, {0.8, 0.6});
  join(has_slot ? "slider.slot" : "ground.slot", has_slot ? "ground" : "slider", {offset, 0.2},
       {offset + d, 0.2 - x}, joined, scene);
  return scene.drive("O", 0.4, 1, 0.5).scene();
}

/// A sleeve with two pins turns on the tip of a crank and slides on a rod with a slot that turns on
/// the ground: neither is placed before the other.
Json sleeve(const Lengths& length, Joined joined) {
  const auto& [r, l, x, y, d, cx, cy, offset] = length.at;
  SceneMaker scene;
  scene.bar("ground", {{"O", 0}, {"D", 2 + l}}).bar("crank", {{"O", 0}, {"A", r}});
  scene.point("sleeve", "A", x / 4, y / 4).bar("rod", {{"D", 0}});
  scene.line("rod", "slot", {0.1 * cx, 0.1 * cy}, {1, 0.3});
  join("rod.slot", "sleeve", {offset, 0.2}, {offset - d, 0.2 + x}, joined, scene);
  return scene.drive("O", 0.4, 1, 0.5).scene();
}

std::array<Json, 3> each_way(const std::string& kind, const Lengths& length) {
  std::array<Json, 3> scenes;
  for (const Joined joined : {Joined::pins, Joined::one_way, Joined::other_way}) {
    scenes.at(static_cast<std::size_t>(joined)) =
        kind == "sleeve" ? sleeve(length, joined) : slider(length, kind == "slot", joined);
  }
  return scenes;
}

/// The largest difference of poses and rates of links.
double difference(const Configuration& one, const Configuration& other) {
  double largest = 0;
  for (const mechanism::LinkIndex link : one.links.keys()) {
    const mechanism::Frame& first = one.links[link];
    const mechanism::Frame& second = other.links[link];
    largest = std::max({largest, std::abs(first.pose.x - second.pose.x),
                        std::abs(first.pose.y - second.pose.y),
                        std::abs(first.pose.direction.cos - second.pose.direction.cos),
                        std::abs(first.pose.direction.sin - second.pose.direction.sin)});
  }
  return largest;
}

double difference_of_rates(const Configuration& one, const Configuration& other) {
  double largest = 0;
  for (const mechanism::LinkIndex link : one.links.keys()) {
    const double size = 1 + other.links[link].acceleration.cwiseAbs().maxCoeff();
    largest = std::max(
        {largest,
         (one.links[link].velocity - other.links[link].velocity).cwiseAbs().maxCoeff() / size,
         (one.links[link].acceleration - other.links[link].acceleration).cwiseAbs().maxCoeff() /
             size});
  }
  return largest;
}

const mechanism::SlideState& slide_of(const Solved& found, const Configuration& state,
                                      const std::string& name) {
  return *std::ranges::find_if(state.slides, [&](const mechanism::SlideState& slide) {
    return found.plan.mechanism().joints()[slide.joint].name == name;
  });
}

class TwoPinsInOneSlot : public testing::TestWithParam<std::string> {};

TEST_P(TwoPinsInOneSlot, AreAPrismaticJointThatMayStandEitherWay) {
  std::minstd_rand random(56);
  double worst = 0;
  double worst_rate = 0;
  std::size_t compared = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const std::array<Json, 3> scenes = each_way(GetParam(), random_lengths(random));
    for (int listing = 0; listing < listings; ++listing) {
      const Solved pins = solved(scene_listed(scenes[0], listing));
      std::size_t others = 0;
      for (const std::size_t way : {1U, 2U}) {
        const Solved slides = solved(scene_listed(scenes.at(way), listing));
        others += slides.configurations().size();
        for (const Configuration& wanted : slides.configurations()) {
          const auto nearest = std::ranges::min_element(
              pins.configurations(), {},
              [&](const Configuration& one) { return difference(one, wanted); });
          ASSERT_NE(nearest, pins.configurations().end());
          worst = std::max(worst, difference(*nearest, wanted));
          if (wanted.regularity != Status::ok) {
            continue;
          }
          worst_rate = std::max(worst_rate, difference_of_rates(*nearest, wanted));
          for (const std::string pin : {"SP", "SQ"}) {
            const auto& slide = slide_of(slides, wanted, "SP");
            const auto& own = slide_of(pins, *nearest, pin);
            const double size = 1 + std::abs(slide.acceleration);
            EXPECT_NEAR(own.velocity, slide.velocity, 1e-8 * size);
            EXPECT_NEAR(own.acceleration, slide.acceleration, 1e-8 * size);
            if (pin == "SP") {
              EXPECT_NEAR(own.displacement, slide.displacement, 1e-10);
            }
          }
          ++compared;
        }
      }
      EXPECT_EQ(pins.configurations().size(), others);
    }
  }
  EXPECT_GT(compared, 150U);
  EXPECT_LT(worst, 1e-10);
  EXPECT_LT(worst_rate, 1e-8);
  std::printf("%zu configurations, largest difference %.1e, of rates %.1e\n", compared, worst,
              worst_rate);
}

TEST_P(TwoPinsInOneSlot, AreFoundInTheTimeOfDyads) {
  std::minstd_rand random(56);
  const Solved pins = solved(each_way(GetParam(), random_lengths(random))[0]);
  for (const mechanism::FoundGroup& group : pins.plan.structure().groups) {
    EXPECT_EQ(group.model->group->name, "dyad");
  }
}

/// The second pin names a line of its own that lies in the same place: shifted along, of another
/// length, and of the other sense, in numbers that are rounded.
TEST_P(TwoPinsInOneSlot, MayNameALineEach) {
  std::minstd_rand random(56);
  double worst = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Json scene = each_way(GetParam(), random_lengths(random))[0];
    Json apart = scene;
    const std::string name = scene["joints"]["SQ"]["between"][0];
    const std::string link = name.substr(0, name.find('.'));
    const Json slot = scene["links"][link]["slot"];
    const auto number = [&](const char* key, int axis) {
      return slot[key][static_cast<std::size_t>(axis)].get<double>();
    };
    Json& other = apart["links"][link]["other"];
    for (const int axis : {0, 1}) {
      other["through"].push_back(number("through", axis) + 0.7 * number("along", axis));
      other["along"].push_back(-0.3 * number("along", axis));
    }
    apart["joints"]["SQ"]["between"][0] = link + ".other";
    const Solved one = solved(scene);
    const Solved two = solved(apart);
    for (const mechanism::FoundGroup& group : two.plan.structure().groups) {
      EXPECT_EQ(group.model->group->name, "dyad");
    }
    const double shift = 0.7 * std::hypot(number("along", 0), number("along", 1));
    ASSERT_EQ(one.configurations().size(), two.configurations().size());
    for (std::size_t place = 0; place < one.configurations().size(); ++place) {
      const Configuration& first = one.configurations()[place];
      const Configuration& second = two.configurations()[place];
      worst = std::max({worst, difference(first, second),
                        std::abs(slide_of(one, first, "SQ").displacement - shift +
                                 slide_of(two, second, "SQ").displacement)});
    }
  }
  EXPECT_LT(worst, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, TwoPinsInOneSlot, testing::Values("pins", "slot", "sleeve"),
                         [](const auto& of) { return of.param; });

/// Sweeps have the branches of both ways, also through the change point of equal crank and rod.
TEST(TwoPinsInOneSlotSweep, HasTheBranchesOfBothWays) {
  Lengths length{{1, -1, 0.5, 0, 1, 0, 0, 0.3}};  // the crank and the rod are both 1
  for (const bool is_equal : {true, false}) {
    length.at[1] = is_equal ? -1 : 0.5;
    std::vector<SweepKept> kept;
    for (const Joined joined : {Joined::pins, Joined::one_way, Joined::other_way}) {
      SceneMaker scene;
      scene.parameter("phi", 0.3).bar("ground", {{"O", 0}});
      scene.bar("crank", {{"O", 0}, {"A", length.at[0]}});
      scene.bar("rod", {{"A", 0}, {"C", 2 + length.at[1]}}).point("slider", "C", 0, 0);
      scene.line("ground", "slot", {0, 0}, {1, 0});
      join("ground.slot", "slider", {-0.5, 0}, {1, 0}, joined, scene);
      kept.push_back(run_sweep(mechanism::parse_scene(
          scene.drive("O", "phi", 1, 0).sweep("phi", 0.1, 6.1, 61).scene().dump(), "scene", {})));
    }
    EXPECT_EQ(kept[0].rows.size(), kept[1].rows.size() + kept[2].rows.size());
    const auto branches = [](const SweepKept& sweep) {
      std::set<int> numbers;
      for (const SweepRowKept& row : sweep.rows) {
        numbers.insert(row.branch);
      }
      return numbers.size();
    };
    EXPECT_EQ(branches(kept[0]), branches(kept[1]) + branches(kept[2])) << is_equal;
    EXPECT_EQ(kept[0].count_of("unresolved"), 0);
  }
}

/// Limits, laws and sensitivities read the second pin as any other slide.
TEST(SecondPins, HaveLimitsAndSensitivities) {
  std::minstd_rand random(7);
  Json json = slider(random_lengths(random), false, Joined::pins);
  json["parameters"] = {{"phi", 0.4}};
  json["drivers"]["O"]["position"] = "phi";
  json["want"] = {"position", "velocity", "sensitivity"};
  const Solved all = solved(json);
  ASSERT_GE(all.configurations().size(), 2U);
  std::vector<double> places;
  for (const Configuration& state : all.configurations()) {
    const auto& slide = slide_of(all, state, "SQ");
    EXPECT_NEAR(slide.follows.first(0, 0), slide.velocity, 1e-12);
    places.push_back(slide.displacement);
  }
  std::ranges::sort(places);
  const double between = (places[0] + places[1]) / 2;
  json["joints"]["SQ"]["limits"] = {between, 1e3};
  const Solved some = solved(json);
  EXPECT_EQ(some.configurations().size(), places.size() - 1);
  EXPECT_EQ(some.solution.left_out, 1U);
  Json reading = json;
  reading["joints"]["SQ"].erase("limits");
  reading["links"]["ground"]["T"] = reading["links"]["dial"]["T"] = {5, 5};
  reading["joints"]["T"] = {{"type", "revolute"}, {"between", {"ground.T", "dial.T"}}};
  reading["drivers"]["T"] = {{"position", "joint(SQ)"}};
  const Solved read = solved(reading);
  ASSERT_EQ(read.configurations().size(), places.size());
  for (const Configuration& state : read.configurations()) {
    const auto& slide = slide_of(read, state, "SQ");
    EXPECT_NEAR(std::sin(slide.displacement), state.link("dial").pose.direction.sin, 1e-12);
    EXPECT_NEAR(state.link("dial").velocity(2), slide.velocity, 1e-12);
  }
}

/// Pins at one place, or in slots that are written differently, are no such pair.
TEST(SecondPins, AreSolvedAsBeforeWhereTheSlotsAreNotWrittenAlike) {
  std::minstd_rand random(9);
  Json json = slider(random_lengths(random), false, Joined::pins);
  const std::size_t count = solved(json).configurations().size();
  json["parameters"] = {{"zero", 0}};
  json["links"]["ground"]["slot2"] = json["links"]["ground"]["slot"];
  json["joints"]["SQ"]["between"][0] = "ground.slot2";
  EXPECT_EQ(solved(json).plan.structure().linkage.second_pins.size(), 1U);
  json["links"]["ground"]["slot2"]["along"][0] = "0.8 + zero";
  const Solved other = solved(json);
  EXPECT_TRUE(other.plan.structure().linkage.second_pins.empty());
  EXPECT_EQ(other.configurations().size(), count);
}

}  // namespace
}  // namespace assur::test::two_pins_in_one_slot
