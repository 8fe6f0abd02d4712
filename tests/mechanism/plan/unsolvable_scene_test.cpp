// Law: a scene that is no chain of driven links and known groups is refused in one line that names
// the links or joints at fault.
#include <gtest/gtest.h>

#include "mechanism/bars.hpp"

namespace assur::test::unsolvable_scene_test {
namespace {

using Json = nlohmann::ordered_json;

/// A second dyad on the crank is correct and must not be blamed.
TEST(Imbalance, NamesTheLinksAndJointsThatAreHeldTooOften) {
  Bars bars;
  bars.four_bar().bar("strut", "coupler.E", "ground.A");
  bars.point("ground", "H", 1, -2).bar("left", "crank.B", "").bar("right", "ground.H", "");
  bars.join("T", {"left.Q", "right.Q"});
  EXPECT_EQ(message_of(bars.json()),
            "scene: joints: over-constrained by 1: the joints B, C, D, strut_P, strut_Q constrain "
            "the links coupler, rocker, strut more than their freedoms allow; take a joint or a "
            "driver away; without constraints of B the mechanism can be assembled, but then these "
            "constraints are violated by 0.217 at least");
}

TEST(Imbalance, NamesTheLinksThatKeepAFreedom) {
  Bars bars;
  bars.four_bar().bar("left", "coupler.E", "").bar("right", "left.Q", "");
  EXPECT_EQ(message_of(bars.json()),
            "scene: links: under-constrained by 2: the links left, right can still move; drive "
            "one of their joints, or add a joint");
  Bars undriven;
  undriven.four_bar().json().erase("drivers");
  EXPECT_EQ(message_of(undriven.json()),
            "scene: links: under-constrained by 1: the links crank, coupler, rocker can still "
            "move; drive one of their joints, or add a joint");
}

/// Freedoms and constraints balance, but some links are over-constrained and one is loose.
TEST(Imbalance, NamesBothAtOnce) {
  Bars bars;
  bars.four_bar().bar("strut", "coupler.E", "ground.A").bar("loose", "crank.B", "");
  bars.bar("tail", "loose.Q", "");  // it rests where it is drawn
  EXPECT_EQ(message_of(bars.json()),
            "scene: joints: over-constrained by 1: the joints B, C, D, strut_P, strut_Q constrain "
            "the links coupler, rocker, strut more than their freedoms allow; take a joint or a "
            "driver away; elsewhere under-constrained by 1: the link loose can still move; drive "
            "one of its joints, or add a joint");
}

TEST(Coordinates, AreOfAUnitThatDoublesHold) {
  for (const auto& [factor, message] :
       {std::pair(1e-130,
                  "links: all coordinates are smaller than 2^-400; give the lengths "
                  "in another unit"),
        std::pair(1e130,
                  "links.ground.D: a coordinate is larger than 2^400; give the "
                  "lengths in another unit")}) {
    Bars bars;
    bars.four_bar();
    for (Json& link : bars.json()["links"]) {
      for (Json& point : link) {
        point = {factor * point[0].get<double>(), factor * point[1].get<double>()};
      }
    }
    EXPECT_EQ(message_of(bars.json()), message);
  }
}

TEST(Imbalance, OfDriversNamesTheJointBetweenPlacedLinks) {
  Bars bars;
  bars.four_bar().point("other", "A", 0, 0).point("other", "B", 1, 0).point("ground", "F", 0, 1);
  bars.join("F", {"ground.F", "other.A"}).join("G", {"other.B", "crank.B"});
  bars.json()["drivers"]["F"]["position"] = 0.1;
  EXPECT_EQ(
      message_of(bars.json()),
      "scene: joints: over-constrained by 2: the joint G joins links that are placed already; "
      "take a joint or a driver away; without constraints of G the mechanism can be assembled, but "
      "then these constraints are violated by 0.51 at least");
}

TEST(Drivers, BetweenPlacedLinksAreNamed) {
  Bars bars;
  bars.four_bar().point("ground", "F", 0, 1).point("crank", "F", 0, 1);
  bars.join("F", {"ground.F", "crank.F"}).json()["drivers"]["F"]["position"] = 0;
  EXPECT_EQ(message_of(bars.json()),
            "scene: drivers.F: the driven joint joins the links ground, crank, which are placed "
            "already; take this driver or another one away");
}

TEST(Drivers, TooManyBetweenMovingLinksAreNamed) {
  Bars bars;
  bars.four_bar().json()["drivers"]["C"]["position"] = 0;
  EXPECT_EQ(
      message_of(bars.json()),
      "scene: joints: over-constrained by 1: the joints B, D constrain the link coupler more than "
      "its freedoms allow; take a joint or a driver away; without constraints of B the mechanism "
      "can be assembled, but then these constraints are violated by 1.33 at least");
}

TEST(Drivers, InACircleBetweenMovingLinksAreNamed) {
  Bars bars;
  bars.four_bar().point("coupler", "F", 1, 1).point("rocker", "F", 1, 1);
  bars.join("F", {"coupler.F", "rocker.F"});
  bars.json()["drivers"]["C"]["position"] = 0;
  bars.json()["drivers"]["F"]["position"] = 0;
  EXPECT_EQ(message_of(bars.json()),
            "scene: drivers.F: the driven joint joins the links coupler, rocker, which other "
            "drivers tie together already; take this driver or another one away");
}

TEST(Drivers, OfAPinOfManyLinksAreNamed) {
  Bars bars;
  bars.four_bar().bar("bar", "crank.B", "ground.D");
  bars.json()["joints"]["B"]["between"] = {"crank.B", "coupler.B", "bar.P"};
  bars.json()["drivers"]["B"]["position"] = 0;
  EXPECT_EQ(message_of(bars.json()),
            "scene: drivers.B: a driver moves a joint of two links; give each link a pin of its "
            "own");
}

/// Six links of class four: a contour of four links, two of them on bars to the ground.
// Seven links in a ring, three of which bars hold, and two the ground: ten links.
TEST(UnknownGroup, OfTooManyLinksIsNamed) {
  Bars bars;
  const std::vector<std::string> ring{"one", "two", "three", "four", "five", "six", "seven"};
  for (const std::string& link : ring) {
    bars.point(link, "P", 0, 0).point(link, "Q", 2, 0).point(link, "R", 1, 1);
  }
  for (std::size_t link = 0; link < ring.size(); ++link) {
    bars.join("J" + std::to_string(link),
              {ring[link] + ".Q", ring[(link + 1) % ring.size()] + ".P"});
  }
  bars.point("ground", "F", 3, 3).point("ground", "G", 3, -3).point("ground", "H", 4, -3);
  bars.point("ground", "I", 5, 1);
  bars.bar("eight", "two.R", "crank.B").bar("nine", "five.R", "ground.F");
  bars.bar("ten", "six.R", "ground.H");
  bars.join("G", {"ground.G", "one.R"}).join("I", {"ground.I", "four.R"});
  EXPECT_EQ(message_of(bars.json()),
            "scene: links: the links one, two, three, four, five, six, seven, eight, nine, ten can "
            "only be solved together, as a group of class 7 with 10 links, which is not solved "
            "here: groups of at most 8 links are solved");
}

}  // namespace
}  // namespace assur::test::unsolvable_scene_test
