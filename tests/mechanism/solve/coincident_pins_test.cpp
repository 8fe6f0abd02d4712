// Law: a group on coincident pins moves freely, however rounding has placed the pins; of two
// independent groups neither changes the answer of the other, whichever is listed first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mechanism/scene_solutions.hpp"

namespace assur::test::coincident_pins {
namespace {

Json pin(const std::string& one, const std::string& other) {
  return {{"type", "revolute"}, {"between", {one, other}}};
}

/// A crank of `length` at `phi`, whose end stands on the ground's pin O, and two equal bars from
/// there.
Json folded_kite(double length, double phi, double x, double y) {
  return {{"parameters", {{"phi", phi}}},
          {"links",
           {{"ground", {{"A", {0, 0}}, {"O", {x, y}}}},
            {"crank", {{"A", {0, 0}}, {"B", {length, 0}}}},
            {"coupler", {{"B", {0, 0}}, {"C", {2, 0}}}},
            {"rocker", {{"O", {0, 0}}, {"C", {2, 0}}}}}},
          {"joints",
           {{"A", pin("ground.A", "crank.A")},
            {"B", pin("crank.B", "coupler.B")},
            {"C", pin("coupler.C", "rocker.C")},
            {"O", pin("ground.O", "rocker.O")}}},
          {"drivers", {{"A", {{"position", "phi"}, {"velocity", 1}}}}}};
}

TEST(CoincidentPins, LetAFoldedKiteTurnWhereverItStands) {
  for (const double length : {1.0, 3.0, 250.0, 1000.0, 12345.0}) {
    for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(-1.0, 0.0),
                               std::pair(0.6, 0.8), std::pair(-5.0 / 13, 12.0 / 13)}) {
      SCOPED_TRACE(testing::Message() << length << " at " << x << ", " << y);
      const Solved kite = solved(folded_kite(length, std::atan2(y, x), length * x, length * y));
      EXPECT_EQ(kite.solution.status, mechanism::SolutionStatus::degenerate);
      EXPECT_EQ(kite.solution.mobility, 1);
    }
  }
}

/// Two bars on a crank carry a pin that coincides with a pin of the crank at every angle. Two more
/// links join the two pins: equal bars, or a slide through both.
TEST(CoincidentPins, AreSoThroughOtherGroupsToo) {
  const Json links = {{"ground", {{"A", {1, 0}}}},
                      {"crank", {{"A", {2, 1}}, {"B", {0, 0}}, {"D", {2, 2}}}},
                      {"one", {{"B", {-3, 3}}, {"C", {-1, 2}}, {"E", {-1, 1}}}},
                      {"other", {{"C", {1, 2}}, {"D", {2, 2}}}}};
  const Json joints = {{"A", pin("ground.A", "crank.A")},
                       {"B", pin("crank.B", "one.B")},
                       {"C", pin("one.C", "other.C")},
                       {"D", pin("other.D", "crank.D")}};
  Json kite = {{"parameters", {{"phi", 0}}},
               {"links", links},
               {"joints", joints},
               {"drivers", {{"A", {{"position", "phi"}}}}}};
  Json slot = kite;
  kite["links"]["left"] = {{"E", {0, 0}}, {"F", {0, 5}}};
  kite["links"]["right"] = {{"G", {3, 4}}, {"F", {0, 0}}};
  kite["joints"]["E"] = pin("one.E", "left.E");
  kite["joints"]["F"] = pin("left.F", "right.F");
  kite["joints"]["G"] = pin("crank.D", "right.G");
  slot["links"]["left"] = {{"E", {-2, 3}}, {"S", {{"through", {-2, 5}}, {"along", {0, -1}}}}};
  slot["links"]["right"] = {{"G", {-1, -1}}, {"S", {{"through", {-1, -1}}, {"along", {0, 1}}}}};
  slot["joints"]["E"] = pin("one.E", "left.E");
  slot["joints"]["S"] = {{"type", "prismatic"}, {"between", {"left.S", "right.S"}}};
  slot["joints"]["G"] = pin("crank.D", "right.G");
  for (const Json& scene : {kite, slot}) {
    for (int step = 0; step <= 20; ++step) {
      SCOPED_TRACE(step);
      const Solved found = solved(scene, {"phi=" + std::to_string(step) + "/10"});
      EXPECT_EQ(found.solution.families.size(), 1U);
      ASSERT_EQ(found.configurations().size(), 2U);  // where the pin is on the other side
      for (const mechanism::Configuration& configuration : found.configurations()) {
        EXPECT_EQ(configuration.regularity, Status::ok);
      }
    }
  }
}

/// The bounds place the middle pin of two bars in line only to the square root of a rounding error.
TEST(CoincidentPins, AreSoBehindBarsInLine) {
  for (const auto& [c, s] : {std::pair(1.0, 0.0), std::pair(0.6, 0.8), std::pair(-0.8, 0.6)}) {
    SCOPED_TRACE(c);
    const auto turned = [c = c, s = s](double x, double y) {
      return Json({c * x - s * y, s * x + c * y});
    };
    const Json scene = {{"links",
                         {{"ground", {{"A", {0, 0}}, {"C", turned(5, 0)}, {"F", turned(2, 1)}}},
                          {"one", {{"A", {0, 0}}, {"B", {2, 0}}, {"D", {2, 1}}}},
                          {"other", {{"B", {0, 0}}, {"C", {3, 0}}}},
                          {"left", {{"D", {0, 0}}, {"E", {3, 4}}}},
                          {"right", {{"F", {0, 0}}, {"E", {5, 0}}}}}},
                        {"joints",
                         {{"A", pin("ground.A", "one.A")},
                          {"B", pin("one.B", "other.B")},
                          {"C", pin("ground.C", "other.C")},
                          {"D", pin("one.D", "left.D")},
                          {"E", pin("left.E", "right.E")},
                          {"F", pin("ground.F", "right.F")}}}};
    const Solved found = solved(scene);
    EXPECT_EQ(found.solution.status, mechanism::SolutionStatus::degenerate);
    EXPECT_EQ(found.solution.mobility, 1);
  }
}

/// A platform stands on a pin and on two bars that fit exactly; between pin and platform is a bar
/// of no length, which spins.
TEST(CoincidentPins, OfABarLetItSpin) {
  const std::vector<std::pair<double, double>> turns = {{1, 0}, {0, 1}, {0.6, 0.8}, {-0.8, 0.6}};
  const std::vector<std::vector<std::string>> listings = {{"none", "left", "right", "platform"},
                                                          {"platform", "none", "left", "right"},
                                                          {"right", "platform", "none", "left"},
                                                          {"left", "right", "platform", "none"}};
  for (const auto& [c, s] : turns) {
    const auto turned = [c = c, s = s](double x, double y) {
      return Json({c * x - s * y, s * x + c * y});
    };
    const Json parts = {{"none", {{"M", {-1, -2}}, {"N", {-1, -2}}}},
                        {"left", {{"P", {-2, 4}}, {"Q", {-3, 2}}}},
                        {"right", {{"R", {-4, 2}}, {"S", {-2, 1}}}},
                        {"platform", {{"N", {0, 0}}, {"Q", {-1, 1}}, {"S", {-1, 1}}}}};
    for (const std::vector<std::string>& listing : listings) {
      SCOPED_TRACE(testing::Message() << c << " " << s << " " << listing[0]);
      Json scene = {
          {"links",
           {{"ground", {{"M", turned(0, -1)}, {"P", turned(0, 2)}, {"R", turned(0, 2)}}}}}};
      for (const std::string& link : listing) {
        scene["links"][link] = parts[link];
      }
      scene["joints"] = {{"M", pin("ground.M", "none.M")},  {"N", pin("none.N", "platform.N")},
                         {"P", pin("ground.P", "left.P")},  {"Q", pin("left.Q", "platform.Q")},
                         {"R", pin("ground.R", "right.R")}, {"S", pin("right.S", "platform.S")}};
      const Solved found = solved(scene);
      EXPECT_EQ(found.solution.status, mechanism::SolutionStatus::degenerate);
      EXPECT_EQ(found.solution.mobility, 1);
      EXPECT_TRUE(found.configurations().empty());
    }
  }
}

TEST(CoincidentPins, DoNotHideThatAnotherGroupCannotReach) {
  const Json kite = {{"a", {{"A", {0, 0}}, {"B", {1, 0}}}}, {"b", {{"B", {0, 0}}, {"D", {1, 0}}}}};
  const Json far = {{"c", {{"G", {0, 0}}, {"E", {1, 0}}}}, {"d", {{"E", {0, 0}}, {"H", {1, 0}}}}};
  for (const auto& [first, second] : {std::pair(kite, far), std::pair(far, kite)}) {
    Json scene = {
        {"links", {{"ground", {{"A", {0, 0}}, {"D", {0, 0}}, {"G", {5, 0}}, {"H", {9, 0}}}}}}};
    scene["links"].update(first);
    scene["links"].update(second);
    scene["joints"] = {{"A", pin("ground.A", "a.A")}, {"B", pin("a.B", "b.B")},
                       {"D", pin("ground.D", "b.D")}, {"G", pin("ground.G", "c.G")},
                       {"E", pin("c.E", "d.E")},      {"H", pin("ground.H", "d.H")}};
    const Solved found = solved(scene);
    EXPECT_EQ(found.solution.status, mechanism::SolutionStatus::no_assembly);
    EXPECT_TRUE(found.solution.families.empty());
  }
}

/// Two folded kites, two bars with two assemblies, and a kite folded on the end of one of these: in
/// any listing each of the first two has one family, and the last has one for each assembly.
TEST(IndependentGroups, AreToldToMoveOnceForEachChoiceOfWhatHoldsThem) {
  const std::vector<Json> parts = {
      {{"a", {{"A", {0, 0}}, {"B", {1, 0}}}}, {"b", {{"B", {0, 0}}, {"C", {1, 0}}}}},
      {{"d", {{"D", {0, 0}}, {"E", {2, 0}}}}, {"e", {{"E", {0, 0}}, {"F", {2, 0}}}}},
      {{"g", {{"G", {0, 0}}, {"H", {3, 0}}, {"K", {1, 1}}, {"M", {1, 1}}}},
       {"h", {{"H", {0, 0}}, {"J", {3, 0}}}}},
      {{"k", {{"K", {0, 0}}, {"L", {4, 0}}}}, {"l", {{"L", {0, 0}}, {"M", {4, 0}}}}}};
  const Json joints = {
      {"A", pin("ground.A", "a.A")}, {"B", pin("a.B", "b.B")}, {"C", pin("ground.C", "b.C")},
      {"D", pin("ground.D", "d.D")}, {"E", pin("d.E", "e.E")}, {"F", pin("ground.F", "e.F")},
      {"G", pin("ground.G", "g.G")}, {"H", pin("g.H", "h.H")}, {"J", pin("ground.J", "h.J")},
      {"K", pin("g.K", "k.K")},      {"L", pin("k.L", "l.L")}, {"M", pin("g.M", "l.M")}};
  std::vector<std::size_t> listing = {0, 1, 2, 3};
  do {
    nlohmann::ordered_json scene = {{"links",
                                     {{"ground",
                                       {{"A", {0, 0}},
                                        {"C", {0, 0}},
                                        {"D", {5, 0}},
                                        {"F", {5, 0}},
                                        {"G", {0, 5}},
                                        {"J", {4, 5}}}}}}};
    for (const std::size_t part : listing) {
      scene["links"].update(parts[part]);
      for (const auto& [name, joint] : joints.items()) {
        if (parts[part].dump().find("\"" + name + "\"") != std::string::npos) {
          scene["joints"][name] = joint;
        }
      }
    }
    const Solved found(mechanism::parse_scene(scene.dump(), "scene"));
    EXPECT_EQ(found.solution.status, mechanism::SolutionStatus::degenerate);
    std::map<std::string, int> families;
    for (const mechanism::Family& family : found.solution.families) {
      std::string placed;
      for (const mechanism::LinkIndex link : found.plan.mechanism().links().keys()) {
        placed += family.is_placed[link] ? " " + found.plan.mechanism().links()[link].name : "";
      }
      ++families[family.reason.substr(0, family.reason.find(" leaves")) + " after" + placed];
    }
    EXPECT_EQ(families.size(), 3U);
    for (const auto& [family, count] : families) {
      EXPECT_EQ(count, family.find('K') != std::string::npos ? 2 : 1) << family;
    }
  } while (std::next_permutation(listing.begin(), listing.end()));
}

/// Two bars that just meet, or just do not, beside two others that are in line or far away.
TEST(IndependentGroups, DoNotBlurOneAnother) {
  const auto dyad = [](const std::string& name, double one, double other) {
    return Json{{name + "_one", {{"A", {0, 0}}, {"B", {one, 0}}}},
                {name + "_other", {{"B", {0, 0}}, {"C", {other, 0}}}}};
  };
  const auto joints = [](const std::string& name) {
    return Json{{name + "A", pin("ground." + name + "A", name + "_one.A")},
                {name + "B", pin(name + "_one.B", name + "_other.B")},
                {name + "C", pin("ground." + name + "C", name + "_other.C")}};
  };
  struct Neighbour {
    double from, to, length;
  };
  for (const Neighbour& beside : {Neighbour{5, 7, 1}, Neighbour{5, 7, 1 + 1e-12},
                                  Neighbour{1e3, 1e3 + 1, 1}, Neighbour{1e6, 1e6 + 1, 1}}) {
    for (const double excess : {-1e-10, -1e-11, -1e-12, 1e-12, 1e-11, 1e-10}) {
      for (const bool first : {true, false}) {
        SCOPED_TRACE(testing::Message() << beside.from << " " << excess << " " << first);
        const Json near = dyad("near", 1, 0.7 + excess);
        const Json other = dyad("other", beside.length, beside.length);
        Json scene = {{"links",
                       {{"ground",
                         {{"nearA", {0, 0}},
                          {"nearC", {1.7, 0}},
                          {"otherA", {beside.from, 0}},
                          {"otherC", {beside.to, 0}}}}}},
                      {"joints", Json::object()}};
        scene["links"].update(first ? other : near);
        scene["links"].update(first ? near : other);
        scene["joints"].update(joints("near"));
        scene["joints"].update(joints("other"));
        const std::size_t beside_it = beside.to - beside.from < 2 * beside.length ? 2 : 1;
        EXPECT_EQ(solved(scene).configurations().size(), excess > 0 ? 2 * beside_it : 0);
      }
    }
  }
}

}  // namespace
}  // namespace assur::test::coincident_pins
