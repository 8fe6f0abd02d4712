// Law: the examples fall into the Assur groups of the textbook, and random chains of known groups
// into the groups of which they were made, however they are listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "largest.hpp"
#include "mechanism/bars.hpp"
#include "mechanism/random_chain.hpp"

namespace assur::test::decomposition_test {
namespace {

using Json = nlohmann::ordered_json;

Json example(const std::string& name) {
  std::ifstream in(std::string(ASSUR_EXAMPLES) + "/" + name + ".json");
  return Json::parse(in);
}

/// `dyad RRR 1: coupler rocker` for each group, in the order of their solution.
std::vector<std::string> groups_of(const Solved& solved) {
  const mechanism::Structure& structure = solved.plan.structure();
  std::vector<std::string> lines;
  for (const mechanism::FoundGroup& found : structure.groups) {
    std::string line = found.model->group->name + " " + found.kind + " " +
                       std::to_string(found.model->number) + ":";
    for (const std::string& link : structure.names_of(found.links)) {
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
  EXPECT_EQ(groups_of(solved(example(GetParam().example))), GetParam().groups);
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
        Chain{"jansen_leg", {"dyad RRR 1: k c", "dyad RRR 1: j upper", "dyad RRR 1: f lower"}},
        Chain{"quintero_2011_rrp_rrr", {"tetrad RRP-RRR 2: rod lever slider bar"}},
        Chain{"scissor_lift_crossed",
              {"dyad RRR 1: lower_right tube rod", "dyad RRP 2: lower_left lower_right tube rod D",
               "dyad RRR 1: upper_left upper_right", "dyad RPR 3: table F"}}),
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
      const mechanism::plan::Decomposition found =
          mechanism::plan::decompose(listed.linkage, listed.bodies);
      ASSERT_EQ(found.free.surplus, 0);
      ASSERT_EQ(found.overloaded.surplus, 0);
      std::vector<std::string> lines;
      mechanism::Table<LinkIndex, bool> placed = listed.bodies.placed;
      for (const mechanism::plan::Component& component : found.components) {
        if (component.joints.empty()) {  // a driven link
          continue;
        }
        const auto group =
            mechanism::plan::find_group(found.linkage, component.links, component.joints);
        ASSERT_TRUE(group.has_value());
        EXPECT_EQ(mechanism::plan::assur_class_of(found.linkage, component.links, component.joints),
                  group->model->group->assur_class);
        std::vector<std::string> names;
        for (const LinkIndex link : component.links) {
          names.push_back(listed.linkage.links[link]);
          placed[link] = true;
        }
        lines.push_back(described(*group->model, names));
        for (const ElementaryJointIndex index : component.joints) {
          const mechanism::ElementaryJoint& joint = found.linkage.joints[index];
          EXPECT_TRUE(placed[joint.first]) << joint.name;
          EXPECT_TRUE(placed[joint.second]) << joint.name;
        }
      }
      EXPECT_TRUE(std::all_of(placed.begin(), placed.end(), [](bool is) { return is; }));
      std::sort(lines.begin(), lines.end());
      ASSERT_EQ(lines, chain.groups());
      pins += static_cast<int>(listed.linkage.pins.size());
    }
    groups += static_cast<int>(chain.groups().size());
  }
  std::cout << seeds << " chains of " << groups << " groups, each in three listings with " << pins
            << " pins of several links\n";
}

/// A sum over all coordinates for each configuration, which no order of listing may change.
std::vector<double> fingerprint(const Solved& solved) {
  std::vector<double> sums;
  for (const auto& configuration : solved.configurations()) {
    double sum = 0;
    for (const auto& link : configuration.links) {
      sum += link.pose.x + 2 * link.pose.y + link.pose.direction.cos + 3 * link.pose.direction.sin;
    }
    sums.push_back(sum);
  }
  return sums;
}

/// Pins of three links: on the crank, on the ground and inside a group.
TEST(Pins, MayListTheirLinksInAnyOrder) {
  Json scene = example("jansen_leg");
  const Solved reference = solved(scene);
  const std::vector<double> expected = fingerprint(reference);
  int listings = 0;
  double worst = 0;
  const std::map<std::string, std::vector<std::string>> pins = {
      {"M", {"crank", "j", "k"}}, {"B", {"ground", "upper", "c"}}, {"U", {"k", "c", "lower"}}};
  for (const auto& [pin, joined] : pins) {
    std::vector<std::string> links = joined;
    std::sort(links.begin(), links.end());
    do {
      scene["joints"][pin] = {{"type", "revolute"}, {"links", links}};
      const Solved solution = solved(scene);
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
    const Solved solution = solved(bars.json());
    EXPECT_EQ(groups_of(solution),
              (std::vector<std::string>{"dyad RRR 1: bar1 rocker1", "dyad RRR 1: bar2 rocker2",
                                        "dyad RRR 1: bar3 rocker3"}));
    EXPECT_EQ(solution.configurations().size(), 8U);
    ++listings;
  } while (std::next_permutation(pin.begin(), pin.end()));
  EXPECT_EQ(listings, 24);
}

TEST(Drivers, InARowPlaceTheirLinksOneAfterTheOther) {
  Bars bars;
  bars.four_bar();  // its coupler moves to an arm that is driven against the crank
  bars.point("arm", "A", 0, 0).point("arm", "B", 0.5, 0);
  bars.join("K", {"crank.B", "arm.A"}).join("B", {"arm.B", "coupler.B"});
  bars.json()["drivers"]["K"]["position"] = 0.4;
  EXPECT_EQ(groups_of(solved(bars.json())), std::vector<std::string>{"dyad RRR 1: coupler rocker"});
  // The outer driver first: the order of the drivers does not matter.
  Json drivers = {{"K", {{"position", 0.4}}}, {"A", {{"position", "phi"}}}};
  bars.json()["drivers"] = drivers;
  EXPECT_EQ(groups_of(solved(bars.json())), std::vector<std::string>{"dyad RRR 1: coupler rocker"});
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
  scene["points"]["D2"] = {"ground", 0};
  scene["links"]["ground"].push_back("D2");
  scene["joints"]["B2"] = {{"type", "revolute"}, {"between", {"crank.B", "second_coupler.B"}}};
  scene["joints"]["C2"] = {{"type", "revolute"},
                           {"between", {"second_coupler.C", "second_rocker.C"}}};
  scene["joints"]["D2"] = {{"type", "revolute"}, {"between", {"ground.D2", "second_rocker.D"}}};
  const Solved solution = solved(scene);
  EXPECT_EQ(groups_of(solution),
            (std::vector<std::string>{"dyad RRR 1: second_coupler second_rocker",
                                      "triad RR-RR-RR 1: bar left right coupler"}));
  EXPECT_EQ(solution.configurations().size(),
            2 * solved(example("stephenson_triad")).configurations().size());
}

}  // namespace
}  // namespace assur::test::decomposition_test
