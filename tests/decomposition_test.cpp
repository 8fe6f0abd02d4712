// Checks how scenes fall into Assur groups: the examples, random chains of the known groups however
// they are listed, and scenes that are no chain of known groups.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "error.hpp"
#include "largest.hpp"
#include "random_chain.hpp"
#include "scene/solve.hpp"

namespace assur::test {
namespace {

using generator::Scene;
using generator::Solution;
using Json = nlohmann::ordered_json;

Json example(const std::string& name) {
  std::ifstream in(std::string(ASSUR_EXAMPLES) + "/" + name + ".json");
  return Json::parse(in);
}

Solution solution_of(const Json& json) {
  const Scene scene = generator::parse_scene(json.dump(), "scene", {});
  return generator::solve(scene, generator::ParameterValues(scene));
}

std::string message_of(const Json& json) {
  try {
    (void)solution_of(json);
  } catch (const generator::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// `dyad RRR 1: coupler rocker` for each group, in the order of their solution.
std::vector<std::string> groups_of(const Solution& solution) {
  std::vector<std::string> lines;
  for (std::size_t index = 0; index < solution.groups.size(); ++index) {
    const generator::FoundGroup& found = solution.groups[index];
    const Group& group = *found.model->group;
    std::string line = group.name() + " " + generator::spell(group, found.kind) + " " +
                       std::to_string(found.model->number) + ":";
    for (const std::string& link : solution.group_links[index]) {
      line += " " + link;
    }
    lines.push_back(line);
  }
  return lines;
}

struct Chain {
  const char* example;
  std::vector<std::string> groups;
};

class ExampleGroups : public testing::TestWithParam<Chain> {};

TEST_P(ExampleGroups, AreThoseOfTheTextbook) {
  EXPECT_EQ(groups_of(solution_of(example(GetParam().example))), GetParam().groups);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ExampleGroups,
    testing::Values(
        Chain{"four_bar_coupler_curve", {"dyad RRR 1: coupler rocker"}},
        Chain{"slider_crank", {"dyad RRP 2: rod piston"}},
        Chain{"shaper_quick_return", {"dyad RPR 3: rocker B", "dyad RRP 2: link ram"}},
        Chain{"watt_six_bar", {"dyad RRR 1: coupler rocker", "dyad RRR 1: upper outer"}},
        Chain{"stephenson_six_bar", {"dyad RRR 1: coupler rocker", "dyad RRR 1: bar lever"}},
        Chain{"stephenson_triad", {"triad RR-RR-RR 1: bar left right coupler"}},
        Chain{"platform_3rpr", {"triad RR-RR-RR 1: leg1 leg2 leg3 platform"}},
        Chain{"jansen_leg", {"dyad RRR 1: j upper", "dyad RRR 1: k c", "dyad RRR 1: f lower"}},
        Chain{"quintero_2011_rrp_rrr", {"tetrad RRP-RRR 2: rod lever slider bar"}}),
    [](const auto& chain) { return std::string(chain.param.example); });

TEST(RandomChains, FallIntoTheGroupsOfWhichTheyWereMade) {
  constexpr unsigned seeds = 2000;
  int groups = 0;
  int pins = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 engine(seed);
    const RandomChain chain(engine);
    for (int listing = 0; listing < 3; ++listing) {
      const ListedChain listed = chain.listed(engine);
      const Decomposition found = decompose(listed.mechanism, listed.placed, listed.spent);
      ASSERT_EQ(found.free.surplus, 0);
      ASSERT_EQ(found.overloaded.surplus, 0);
      std::vector<std::string> lines;
      std::vector<bool> placed = listed.placed;
      for (const Component& component : found.components) {
        const auto group = find_group(found.mechanism, component.links, component.joints);
        ASSERT_TRUE(group.has_value());
        EXPECT_EQ(assur_class_of(found.mechanism, component.links, component.joints),
                  group->model->group->assur_class());
        lines.push_back(described(*group->model, listed.mechanism, component.links));
        for (const int link : component.links) {
          placed[static_cast<std::size_t>(link)] = true;
        }
        for (const int index : component.joints) {
          const auto& joint = found.mechanism.joints[static_cast<std::size_t>(index)];
          EXPECT_TRUE(placed[static_cast<std::size_t>(joint.first)]) << joint.name;
          EXPECT_TRUE(placed[static_cast<std::size_t>(joint.second)]) << joint.name;
        }
      }
      EXPECT_TRUE(std::all_of(placed.begin(), placed.end(), [](bool is) { return is; }));
      std::sort(lines.begin(), lines.end());
      ASSERT_EQ(lines, chain.groups());
      pins += static_cast<int>(listed.mechanism.pins.size());
    }
    groups += static_cast<int>(chain.groups().size());
  }
  std::cout << seeds << " chains of " << groups << " groups, each in three listings with " << pins
            << " pins of several links\n";
}

/// Sums of all coordinates of each configuration: what no order of listing may change.
std::vector<double> fingerprint(const Solution& solution) {
  std::vector<double> sums;
  for (const auto& configuration : solution.configurations) {
    double sum = 0;
    for (const auto& link : configuration.links) {
      sum += link.x.value() + 2 * link.y.value() + link.direction.cos.value() +
             3 * link.direction.sin.value();
    }
    sums.push_back(sum);
  }
  return sums;
}

/// Pins of three links: on the crank, on the ground and inside a group.
TEST(Pins, MayListTheirLinksInAnyOrder) {
  Json scene = example("jansen_leg");
  const Solution reference = solution_of(scene);
  const std::vector<double> expected = fingerprint(reference);
  int listings = 0;
  double worst = 0;
  for (const char* pin : {"M", "B", "U"}) {
    std::vector<std::string> links = scene["joints"][pin]["between"];
    ASSERT_EQ(links.size(), 3U);
    std::sort(links.begin(), links.end());
    do {
      scene["joints"][pin]["between"] = links;
      const Solution solution = solution_of(scene);
      EXPECT_EQ(groups_of(solution), groups_of(reference));
      const std::vector<double> found = fingerprint(solution);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t index = 0; index < found.size(); ++index) {
        worst = largest(worst, std::abs(found[index] - expected[index]));
      }
      ++listings;
    } while (std::next_permutation(links.begin(), links.end()));
  }
  std::cout << listings << " listings, largest difference " << worst << '\n';
  EXPECT_EQ(listings, 18);
  EXPECT_LT(worst, 1e-10);
}

/// Bars of one length each between points of links, all by revolute joints.
class Bars {
 public:
  Bars() {
    scene_["parameters"]["phi"] = 0.7;
    scene_["links"]["ground"]["A"] = {0, 0};
    scene_["links"]["crank"] = {{"A", {0, 0}}, {"B", {1, 0}}};
    join("A", {"ground.A", "crank.A"});
    scene_["drivers"]["A"]["position"] = "phi";
  }
  Bars& point(const std::string& link, const std::string& name, double x, double y) {
    scene_["links"][link][name] = {x, y};
    return *this;
  }
  Bars& join(const std::string& name, const std::vector<std::string>& between) {
    scene_["joints"][name] = {{"type", "revolute"}, {"between", between}};
    return *this;
  }
  /// A crank-rocker: the dyad `coupler`, `rocker` with the joints B, C, D.
  Bars& four_bar() {
    point("ground", "D", 3, 0).point("coupler", "B", 0, 0).point("coupler", "C", 3, 0);
    point("coupler", "E", 1.5, 1).point("rocker", "D", 0, 0).point("rocker", "C", 2, 0);
    return join("B", {"crank.B", "coupler.B"})
        .join("C", {"coupler.C", "rocker.C"})
        .join("D", {"ground.D", "rocker.D"});
  }
  /// A bar with the points P at its origin and Q, by joints with names of their own.
  Bars& bar(const std::string& name, const std::string& from, const std::string& to) {
    point(name, "P", 0, 0).point(name, "Q", 3, 0);
    if (!from.empty()) {
      join(name + "_P", {from, name + ".P"});
    }
    return to.empty() ? *this : join(name + "_Q", {to, name + ".Q"});
  }
  Json& json() { return scene_; }

 private:
  Json scene_;
};

TEST(Pins, OfFourLinksMayListTheirLinksInAnyOrder) {
  Bars bars;
  std::vector<std::string> pin = {"crank.B"};
  for (const int number : {1, 2, 3}) {
    const std::string bar = "bar" + std::to_string(number);
    const std::string rocker = "rocker" + std::to_string(number);
    bars.point(bar, "B", 0, 0).point(bar, "C", 3, 0);
    bars.point("ground", rocker, 3, number - 2);
    bars.point(rocker, "D", 0, 0).point(rocker, "C", 2, 0);
    bars.join("C" + std::to_string(number), {bar + ".C", rocker + ".C"});
    bars.join("D" + std::to_string(number), {"ground." + rocker, rocker + ".D"});
    pin.push_back(bar + ".B");
  }
  std::sort(pin.begin(), pin.end());
  int listings = 0;
  do {
    bars.join("B", pin);
    const Solution solution = solution_of(bars.json());
    EXPECT_EQ(groups_of(solution),
              (std::vector<std::string>{"dyad RRR 1: bar1 rocker1", "dyad RRR 1: bar2 rocker2",
                                        "dyad RRR 1: bar3 rocker3"}));
    EXPECT_EQ(solution.configurations.size(), 8U);
    ++listings;
  } while (std::next_permutation(pin.begin(), pin.end()));
  EXPECT_EQ(listings, 24);
}

TEST(Drivers, InARowPlaceTheirLinksOneAfterTheOther) {
  Bars bars;
  bars.four_bar();  // on the arm that is driven against the crank
  bars.point("arm", "A", 0, 0).point("arm", "B", 0.5, 0);
  bars.join("K", {"crank.B", "arm.A"}).join("B", {"arm.B", "coupler.B"});
  bars.json()["drivers"]["K"]["position"] = 0.4;
  EXPECT_EQ(groups_of(solution_of(bars.json())),
            std::vector<std::string>{"dyad RRR 1: coupler rocker"});
  // The other end first: the order of the drivers says nothing.
  Json drivers = {{"K", {{"position", 0.4}}}, {"A", {{"position", "phi"}}}};
  bars.json()["drivers"] = drivers;
  EXPECT_EQ(groups_of(solution_of(bars.json())),
            std::vector<std::string>{"dyad RRR 1: coupler rocker"});
}

TEST(Branches, ThatAreIndependentComeSmallerFirst) {
  Json scene = example("stephenson_triad");
  const Json four_bar = example("four_bar_coupler_curve");
  for (const char* link : {"coupler", "rocker"}) {
    scene["links"][std::string("second_") + link] = four_bar["links"][link];
  }
  for (const auto& [name, value] : four_bar["parameters"].items()) {
    scene["parameters"][name] = value;
  }
  scene["links"]["ground"]["D2"] = {"ground", 0};
  scene["joints"]["B2"] = {{"type", "revolute"}, {"between", {"crank.B", "second_coupler.B"}}};
  scene["joints"]["C2"] = {{"type", "revolute"},
                           {"between", {"second_coupler.C", "second_rocker.C"}}};
  scene["joints"]["D2"] = {{"type", "revolute"}, {"between", {"ground.D2", "second_rocker.D"}}};
  const Solution solution = solution_of(scene);
  EXPECT_EQ(groups_of(solution),
            (std::vector<std::string>{"dyad RRR 1: second_coupler second_rocker",
                                      "triad RR-RR-RR 1: bar left right coupler"}));
  EXPECT_EQ(solution.configurations.size(),
            2 * solution_of(example("stephenson_triad")).configurations.size());
}

/// A dyad of the crank and a second crank-rocker that is all right and must not be blamed.
TEST(Imbalance, NamesTheLinksAndJointsThatAreHeldTooOften) {
  Bars bars;
  bars.four_bar().bar("strut", "coupler.E", "ground.A");
  bars.point("ground", "H", 1, -2).bar("left", "crank.B", "").bar("right", "ground.H", "");
  bars.join("T", {"left.Q", "right.Q"});
  EXPECT_EQ(message_of(bars.json()),
            "scene: joints: over-constrained by 1: the joints B, C, D, strut_P, strut_Q hold the "
            "links coupler, rocker, strut more often than they can move; take a joint or a driver "
            "away");
}

TEST(Imbalance, NamesTheLinksThatKeepAFreedom) {
  Bars bars;
  bars.four_bar().bar("left", "coupler.E", "").bar("right", "left.Q", "");
  EXPECT_EQ(message_of(bars.json()),
            "scene: links: under-constrained by 2: the links left, right keep a freedom; drive one "
            "of their joints, or add a joint");
  Bars undriven;
  undriven.four_bar().json().erase("drivers");
  EXPECT_EQ(
      message_of(undriven.json()),
      "scene: links: under-constrained by 1: the links crank, coupler, rocker keep a freedom; "
      "drive one of their joints, or add a joint");
}

/// As many freedoms as constraints, and no structure all the same.
TEST(Imbalance, NamesBothAtOnce) {
  Bars bars;
  bars.four_bar().bar("strut", "coupler.E", "ground.A").bar("loose", "crank.B", "");
  EXPECT_EQ(message_of(bars.json()),
            "scene: joints: over-constrained by 1: the joints B, C, D, strut_P, strut_Q hold the "
            "links coupler, rocker, strut more often than they can move; take a joint or a driver "
            "away; elsewhere under-constrained by 1: the links loose keep a freedom; drive one of "
            "their joints, or add a joint");
}

TEST(Imbalance, OfDriversNamesTheJointBetweenPlacedLinks) {
  Bars bars;
  bars.four_bar().point("other", "A", 0, 0).point("other", "B", 1, 0).point("ground", "F", 0, 1);
  bars.join("F", {"ground.F", "other.A"}).join("G", {"other.B", "crank.B"});
  bars.json()["drivers"]["F"]["position"] = 0.1;
  EXPECT_EQ(
      message_of(bars.json()),
      "scene: joints: over-constrained by 2: the joints G join links that are placed already; "
      "take a joint or a driver away");
  Bars twice;
  twice.four_bar().json()["drivers"]["C"]["position"] = 0;
  EXPECT_EQ(message_of(twice.json()),
            "scene: drivers.C: the driven joint must join the ground, or a driven link, to a link "
            "that nothing else drives");
}

/// Six links of class four: a contour of four links, two of them on bars to the ground.
TEST(UnknownGroup, OfClassFourIsNamed) {
  Bars bars;
  for (const char* link : {"one", "two", "three", "four"}) {
    bars.point(link, "P", 0, 0).point(link, "Q", 2, 0).point(link, "R", 1, 1);
  }
  bars.point("ground", "F", 3, 3).point("ground", "G", 3, -3);
  bars.join("12", {"one.Q", "two.P"}).join("23", {"two.Q", "three.P"});
  bars.join("34", {"three.Q", "four.P"}).join("41", {"four.Q", "one.P"});
  bars.bar("five", "one.R", "crank.B").bar("six", "two.R", "ground.F");
  bars.join("G", {"ground.G", "three.R"});
  EXPECT_EQ(message_of(bars.json()),
            "scene: links: the links one, two, three, four, five, six can only be solved together, "
            "as a group of class 4 with 6 links, which is not known here (known: dyad, triad, "
            "tetrad)");
}

TEST(UnknownGroup, OfClassFiveIsNamed) {
  Bars bars;
  for (const char* link : {"one", "two", "three", "four", "five"}) {
    bars.point(link, "P", 0, 0).point(link, "Q", 2, 0).point(link, "R", 1, 1);
  }
  bars.point("ground", "F", 3, 3).point("ground", "G", 3, -3);
  bars.join("12", {"one.Q", "two.P"}).join("23", {"two.Q", "three.P"});
  bars.join("34", {"three.Q", "four.P"}).join("45", {"four.Q", "five.P"});
  bars.join("51", {"five.Q", "one.P"}).bar("six", "two.R", "crank.B");
  bars.join("F", {"ground.F", "one.R"}).join("G", {"ground.G", "four.R"});
  EXPECT_EQ(message_of(bars.json()),
            "scene: links: the links one, two, three, four, five, six can only be solved together, "
            "as a group of class 5 with 6 links, which is not known here (known: dyad, triad, "
            "tetrad)");
}

}  // namespace
}  // namespace assur::test
