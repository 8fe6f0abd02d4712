// Law: a group whose prismatic joints close a loop is solved if its angles are compatible: the
// answer is a family with its mobility, or that the group cannot be assembled.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mechanism/scene_solutions.hpp"
#include "mechanism/tied_scene.hpp"
#include "whole_campaign.hpp"

namespace assur::test::tied_slides {
namespace {

/// The length by which links fail to close, read from the reason that there is no assembly.
double told_gap(const Solved& found) {
  const std::string reason = found.plan.obstacle(found.values);
  const std::string words = "fail to close by ";
  const std::size_t place = reason.find(words);
  return place == std::string::npos ? 0 : std::stod(reason.substr(place + words.size()));
}

void expect_family(const Solved& found, int mobility) {
  const Solution& solution = found.solution;
  EXPECT_EQ(solution.status, SolutionStatus::degenerate) << solution.reason;
  EXPECT_EQ(solution.mobility, mobility);
  ASSERT_EQ(solution.families.size(), 1U);
  EXPECT_EQ(solution.families[0].mobility, mobility);
  EXPECT_NE(solution.families[0].reason.find("close a loop"), std::string::npos);
}

void expect_no_assembly(const Solved& found) {
  const Solution& solution = found.solution;
  EXPECT_EQ(solution.status, SolutionStatus::no_assembly) << solution.reason;
  EXPECT_EQ(solution.mobility, 0);
  EXPECT_TRUE(solution.families.empty());
  EXPECT_GT(told_gap(found), 0);
}

/// A drawer on two telescopic rails, 4 apart on the ground; a bar holds it from 3 below the first.
struct Drawer {
  tied::Group group;

  Drawer(int spacing, int bar, const tied::Vector& along = {1, 0}) {
    group = tied::group_of("PP-PP-RR");
    const auto in_world = [&](long long x, long long y) {
      return tied::Vector{along.x * x - along.y * y, along.y * x + along.x * y};
    };
    const std::array<std::array<tied::Vector, 2>, 6> places = {
        {{in_world(0, 0), in_world(1, 0)},
         {in_world(2, 0), in_world(5, 0)},
         {in_world(0, 4), in_world(-1, 4)},
         {in_world(2, 4), in_world(5, spacing)},
         {in_world(2, -3), in_world(2, -3)},
         {in_world(2 + bar, -3), in_world(7, 0)}}};
    for (std::size_t place = 0; place < places.size(); ++place) {
      group.joints[place].along = along;
      group.joints[place].on_first = places.at(place)[0];
      group.joints[place].on_second = places.at(place)[1];
    }
  }
};

/// Both intermediate slides float wherever the bar lets the drawer stand: at two places, at one, or
/// nowhere if the bar is too short. Unequal rails let it stand nowhere.
TEST(TiedSlides, CarryDrawersOnEqualRailsOnly) {
  const Fraction fifth = Fraction(1) / 5;
  std::mt19937 random(1);
  for (const tied::Vector& along :
       {tied::Vector{1, 0}, tied::Vector{0, 1}, tied::Vector{3 * fifth, 4 * fifth},
        tied::Vector{-4 * fifth, 3 * fifth}}) {
    for (const int exponent : {-300, -60, -1, 0, 7, 60, 300}) {
      for (int listing = 0; listing < 3; ++listing) {
        const double unit = std::ldexp(1.0, exponent);
        SCOPED_TRACE("in 2^" + std::to_string(exponent));
        const auto solved_with = [&](const Drawer& drawer) {
          return solved(tied::SceneOfGroup(drawer.group, unit, random).scene());
        };
        expect_family(solved_with(Drawer(4, 5, along)), 2);
        expect_family(solved_with(Drawer(4, 3, along)), 2);
        for (const Drawer& drawer :
             {Drawer(5, 5, along), Drawer(3, 5, along), Drawer(4, 2, along)}) {
          const Solved none = solved_with(drawer);
          expect_no_assembly(none);
          EXPECT_NEAR(told_gap(none) / unit, 1, 0.01);
        }
      }
    }
  }
}

/// Rail spacings that differ only by the rounding of coordinates count as equal.
TEST(TiedSlides, CarryDrawersThatRoundingHasMoved) {
  for (const double far : {0.0, 1.0, 1e3, 1e6}) {
    for (const double turn : {0.1, 0.7, 2.3}) {
      const auto at = [&](double x, double y) {
        return Json{far + std::cos(turn) * x - std::sin(turn) * y,
                    far / 3 + std::sin(turn) * x + std::cos(turn) * y};
      };
      const auto line = [&](double x, double y) {
        return Json{{"through", at(x, y)}, {"along", {std::cos(turn), std::sin(turn)}}};
      };
      const Json plain = {{"through", {0, 0}}, {"along", {1, 0}}};
      const auto joint = [](const std::string& type, const std::string& one,
                            const std::string& other) {
        return Json{{"type", type}, {"between", {one, other}}};
      };
      const auto scene = [&](double spacing) {
        return Json{{"links",
                     {{"ground", {{"A", line(0, 0)}, {"C", line(0.3, 0.4)}, {"E", at(0.2, -0.3)}}},
                      {"one", {{"A", plain}, {"B", plain}}},
                      {"two", {{"C", plain}, {"D", plain}}},
                      {"drawer",
                       {{"B", plain},
                        {"D", {{"through", {0.1, spacing}}, {"along", {1, 0}}}},
                        {"F", {0, 0}}}},
                      {"bar", {{"E", {0, 0}}, {"F", {0.5, 0}}}}}},
                    {"joints",
                     {{"A", joint("prismatic", "ground.A", "one.A")},
                      {"B", joint("prismatic", "one.B", "drawer.B")},
                      {"C", joint("prismatic", "ground.C", "two.C")},
                      {"D", joint("prismatic", "two.D", "drawer.D")},
                      {"E", joint("revolute", "ground.E", "bar.E")},
                      {"F", joint("revolute", "bar.F", "drawer.F")}}}};
      };
      SCOPED_TRACE(testing::Message() << far << " away, turned by " << turn);
      expect_family(solved(scene(0.4)), 2);
      expect_no_assembly(solved(scene(0.4 + 1e-6)));
    }
  }
}

const std::vector<std::pair<std::string, int>> kinds = {
    {"PPP", 6},       {"PP-PP-RR", 10}, {"PP-RR-PP", 10}, {"RR-PP-PP", 10}, {"PP-PP-RP", 16},
    {"PP-RP-PP", 16}, {"RP-PP-PP", 16}, {"PP-PP-PR", 19}, {"PP-PR-PP", 19}, {"PR-PP-PP", 19},
    {"PP-PP-PP", 20}, {"RPP-RPP", 7},   {"PPR-PPR", 18},  {"PRP-PRP", 18},  {"PPP-RPP", 21},
    {"RPP-PPP", 21},  {"PPP-PPR", 23},  {"PPP-PRP", 23},  {"PPR-PPP", 23},  {"PRP-PPP", 23},
    {"PPP-PPP", 24}};

class Lattice {
 public:
  explicit Lattice(unsigned seed) : random_(seed) {}

  /// A group among small whole numbers; its slides are along one line, two, or any.
  [[nodiscard]] tied::Group group(const std::string& kind) {
    tied::Group group = tied::group_of(kind);
    const std::size_t lines = 1 + random_() % 3;
    const bool is_closed = random_() % 3 == 0;
    for (tied::TiedJoint& joint : group.joints) {
      joint.along = lines_.at(lines == 3 ? random_() % lines_.size() : random_() % lines);
      joint.on_first = {any(3), any(3)};
      const long long across = is_closed || random_() % 4 != 0 ? 0 : any(1);
      const long long by = any(2);
      const tied::Vector& along = joint.along;
      joint.on_second = joint.slides
                            ? joint.on_first + tied::Vector{along.x * by - along.y * across,
                                                            along.y * by + along.x * across}
                            : joint.on_first + tied::Vector{any(1), any(1)};
    }
    return group;
  }
  [[nodiscard]] std::mt19937& random() { return random_; }

 private:
  [[nodiscard]] long long any(int most) {
    return static_cast<long long>(random_() % static_cast<unsigned>(2 * most + 1)) - most;
  }

  std::mt19937 random_;
  const std::array<tied::Vector, 5> lines_ = {{{1, 0}, {3, 4}, {0, 1}, {4, -3}, {1, 1}}};
};

/// Every kind on a lattice, where all links but one bar move in parallel: arithmetic over fractions
/// decides whether a group closes and what its mobility is.
TEST(TiedSlides, AreToldAsExactArithmeticHasThem) {
  const unsigned groups = is_whole_campaign() ? 1000 : 60;
  std::map<int, int> mobilities;
  int open = 0;
  for (const auto& [kind, model] : kinds) {
    for (unsigned seed = 0; seed < groups; ++seed) {
      Lattice lattice(seed);
      const tied::Group group = lattice.group(kind);
      const tied::Truth truth = tied::ExactSolution(group).truth();
      const std::array<double, 5> units = {1, 0x1p-300, 0x1p300, 0x1p-40, 0x1p13};
      const Json scene =
          tied::SceneOfGroup(group, units.at(seed % units.size()), lattice.random()).scene();
      SCOPED_TRACE(kind + ", seed " + std::to_string(seed) + ": " + scene.dump());
      const Solved found = solved(scene);
      ASSERT_EQ(found.plan.structure().groups.size(), 1U);
      EXPECT_EQ(found.plan.structure().groups[mechanism::GroupIndex(0)].model->number, model);
      if (truth.closes) {
        expect_family(found, truth.mobility);
        ++mobilities[truth.mobility];
      } else {
        expect_no_assembly(found);
        ++open;
      }
      if (HasFailure()) {
        return;
      }
    }
  }
  std::cout << open << " cannot be assembled";
  for (const auto& [mobility, count] : mobilities) {
    std::cout << ", " << count << " with mobility " << mobility;
  }
  std::cout << '\n';
  EXPECT_GT(open, static_cast<int>(groups));
  EXPECT_GT(mobilities.size(), 3U);
}

/// The scene with `mark` behind the names of links, features and joints.
Json marked(const Json& scene, const std::string& mark) {
  Json result = {{"links", Json::object()}, {"joints", Json::object()}};
  const auto name_of = [&](const std::string& link) {
    return link == "ground" ? link : link + mark;
  };
  for (const auto& [link, features] : scene["links"].items()) {
    for (const auto& [feature, place] : features.items()) {
      result["links"][name_of(link)][feature + mark] = place;
    }
  }
  for (const auto& [joint, entry] : scene["joints"].items()) {
    Json between = Json::array();
    for (const Json& end : entry["between"]) {
      const auto text = end.get<std::string>();
      const std::size_t dot = text.find('.');
      between.push_back(name_of(text.substr(0, dot)) + text.substr(dot) + mark);
    }
    result["joints"][joint + mark] = {{"type", entry["type"]}, {"between", between}};
  }
  return result;
}

/// Two scenes on one ground.
Json side_by_side(const Json& one, const Json& other) {
  Json result = marked(one, "1");
  const Json second = marked(other, "2");
  result["links"]["ground"].update(second["links"]["ground"]);
  for (const auto& [link, features] : second["links"].items()) {
    if (link != "ground") {
      result["links"][link] = features;
    }
  }
  result["joints"].update(second["joints"]);
  return result;
}

Json dyad(double length) {
  return {{"links",
           {{"ground", {{"A", {0, -10}}, {"C", {8, -10}}}},
            {"left", {{"A", {0, 0}}, {"P", {length, 0}}}},
            {"right", {{"P", {0, 0}}, {"C", {5, 0}}}}}},
          {"joints",
           {{"A", {{"type", "revolute"}, {"between", {"ground.A", "left.A"}}}},
            {"P", {{"type", "revolute"}, {"between", {"left.P", "right.P"}}}},
            {"C", {{"type", "revolute"}, {"between", {"right.C", "ground.C"}}}}}}};
}

/// Groups that move do not hide one another, whatever is listed first; one that cannot be assembled
/// leaves none of them.
TEST(TiedSlides, StandBesideOtherGroups) {
  std::mt19937 random(1);
  const auto scene_of = [&](const Drawer& drawer) {
    return tied::SceneOfGroup(drawer.group, 1, random).scene();
  };
  const Json equal = scene_of(Drawer(4, 5));
  const Json unequal = scene_of(Drawer(5, 5));
  Json crossed = equal;  // its angles contradict each other
  crossed["links"]["L1"]["B"]["along"] = {1, 7};
  const auto mobilities = [](const Json& one, const Json& other) {
    const Solved found = solved(side_by_side(one, other));
    EXPECT_EQ(found.solution.status, found.solution.families.empty() ? SolutionStatus::no_assembly
                                                                     : SolutionStatus::degenerate);
    std::multiset<int> result;
    for (const mechanism::Family& family : found.solution.families) {
      result.insert(family.mobility);
    }
    return result;
  };
  using Mobilities = std::multiset<int>;
  for (const bool swaps : {false, true}) {
    const auto of = [&](const Json& one, const Json& other) {
      return swaps ? mobilities(other, one) : mobilities(one, other);
    };
    EXPECT_EQ(of(equal, equal), (Mobilities{2, 2}));
    EXPECT_EQ(of(equal, unequal), Mobilities{});
    EXPECT_EQ(of(equal, crossed), (Mobilities{0, 2}));
    EXPECT_EQ(of(unequal, crossed), Mobilities{});
    EXPECT_EQ(of(equal, dyad(5)), Mobilities{2});
    EXPECT_EQ(of(equal, dyad(1)), Mobilities{});
  }
}

/// The bar is hinged where two bars meet, at (4, -7) or (4, -13): it reaches from 1, 2 or 0.
TEST(TiedSlides, AreSolvedForEachConfigurationOfWhatHoldsThem) {
  for (const auto& [bar, families] : {std::pair(8, 1U), std::pair(14, 2U), std::pair(6, 0U)}) {
    std::mt19937 random(1);
    Json scene = side_by_side(tied::SceneOfGroup(Drawer(4, bar).group, 1, random).scene(), dyad(5));
    scene["links"]["ground"] = {{"B1", {{"through", {0, 0}}, {"along", {1, 0}}}},
                                {"D1", {{"through", {0, 4}}, {"along", {1, 0}}}},
                                {"A2", {0, -10}},
                                {"C2", {8, -10}}};
    scene["links"]["left2"]["F1"] = {5, 0};
    Json& between = scene["joints"]["F1"]["between"];
    for (Json& end : between) {
      if (end == "ground.F1") {
        end = "left2.F1";
      }
    }
    const Solved found = solved(scene);
    EXPECT_EQ(found.solution.families.size(), families) << bar;
    for (const mechanism::Family& family : found.solution.families) {
      EXPECT_EQ(family.mobility, 2);
    }
    if (families == 0) {
      EXPECT_NEAR(told_gap(found), 1, 0.01);
    }
  }
}

/// Two links, one on the other, connect the ground by slides to the coupler of a parallelogram,
/// which does not turn; an antiparallelogram's does. Near the flat position rounding turns the
/// coupler by much more than one rounding, and the angles remain compatible.
TEST(TiedSlides, HangOnCouplersThatRoundingTurns) {
  for (const double phi : {1.0, 0.1, 1e-3, 1e-5, -1e-5, 2.0}) {
    const auto pin = [](const std::string& one, const std::string& other) {
      return Json{{"type", "revolute"}, {"between", {one, other}}};
    };
    const auto slide = [](const std::string& one, const std::string& other) {
      return Json{{"type", "prismatic"}, {"between", {one, other}}};
    };
    const auto line = [](double x, double y) {
      return Json{{"through", {0.3, 0.1}}, {"along", {x, y}}};
    };
    const Json scene = {{"parameters", {{"phi", phi}}},
                        {"links",
                         {{"ground", {{"A", {0, 0}}, {"O", {4, 0}}, {"S", line(1, 0)}}},
                          {"crank", {{"A", {0, 0}}, {"B", {1, 0}}}},
                          {"coupler", {{"B", {0, 0}}, {"C", {4, 0}}, {"U", line(1, 1)}}},
                          {"rocker", {{"O", {0, 0}}, {"C", {1, 0}}}},
                          {"one", {{"S", line(1, 0)}, {"T", line(0, 1)}}},
                          {"two", {{"T", line(0, 1)}, {"U", line(1, 1)}}}}},
                        {"joints",
                         {{"A", pin("ground.A", "crank.A")},
                          {"B", pin("crank.B", "coupler.B")},
                          {"C", pin("coupler.C", "rocker.C")},
                          {"O", pin("ground.O", "rocker.O")},
                          {"S", slide("ground.S", "one.S")},
                          {"T", slide("one.T", "two.T")},
                          {"U", slide("two.U", "coupler.U")}}},
                        {"drivers", {{"A", {{"position", "phi"}}}}}};
    const Solved found = solved(scene);
    EXPECT_EQ(found.solution.mobility, 1) << phi;
    ASSERT_EQ(found.solution.families.size(), 2U) << phi;
    EXPECT_EQ(std::min(found.solution.families[0].mobility, found.solution.families[1].mobility),
              0);
  }
}

/// Three slides in a row, of which the second is hardly tilted. It closes an offset between the
/// others by moving the farther the smaller the tilt is, up to a limit. Without an offset the tilt
/// takes a freedom as soon as it is more than rounding.
TEST(TiedSlides, CloseAcrossLinesThatAreHardlyTilted) {
  const auto row = [](double tilt, double offset) {
    const auto line = [&](double y, double slope) {
      return Json{{"through", {0, y}}, {"along", {1, slope}}};
    };
    const auto slide = [](const std::string& one, const std::string& other) {
      return Json{{"type", "prismatic"}, {"between", {one, other}}};
    };
    return solved(Json{{"links",
                        {{"ground", {{"B", line(0, 0)}, {"D", line(1, 0)}}},
                         {"one", {{"B", line(0, 0)}, {"C", line(0, tilt)}}},
                         {"two", {{"C", line(0, tilt)}, {"D", line(1 + offset, 0)}}}}},
                       {"joints",
                        {{"B", slide("ground.B", "one.B")},
                         {"C", slide("one.C", "two.C")},
                         {"D", slide("two.D", "ground.D")}}}});
  };
  for (const double tilt : {1.0, 1e-3, 1e-6, 1e-7}) {
    expect_family(row(tilt, 1), 1);
  }
  for (const double tilt : {1e-8, 1e-10, 1e-13, 0.0}) {
    const Solved none = row(tilt, 1);
    expect_no_assembly(none);
    EXPECT_NEAR(told_gap(none), 1, 0.01);
  }
  for (const double tilt : {1.0, 1e-3, 1e-6, 1e-8, 1e-10, 1e-13}) {
    expect_family(row(tilt, 0), 1);
  }
  expect_family(row(0, 0), 2);
}

}  // namespace
}  // namespace assur::test::tied_slides
