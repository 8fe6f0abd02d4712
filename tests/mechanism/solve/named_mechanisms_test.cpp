// Law: well-known mechanisms in special position have the assemblies, families and events that are
// known of them.
#include <gtest/gtest.h>

#include <assur/mechanism/report.hpp>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "mechanism/solved.hpp"
#include "mechanism/sweep_runs.hpp"
#include "whole_campaign.hpp"

namespace assur::test::named_mechanisms_test {
namespace {

using Json = nlohmann::json;

/// A four-bar whose crank turns at unit rate.
Json four_bar(double crank, double coupler, double rocker, double ground, const std::string& phi) {
  return {{"parameters", {{"phi", phi}}},
          {"links",
           {{"ground", {{"A", {0, 0}}, {"D", {ground, 0}}}},
            {"crank", {{"A", {0, 0}}, {"B", {crank, 0}}}},
            {"coupler", {{"B", {0, 0}}, {"C", {coupler, 0}}}},
            {"rocker", {{"D", {0, 0}}, {"C", {rocker, 0}}}}}},
          {"joints",
           {{"A", {{"type", "revolute"}, {"between", {"ground.A", "crank.A"}}}},
            {"B", {{"type", "revolute"}, {"between", {"crank.B", "coupler.B"}}}},
            {"C", {{"type", "revolute"}, {"between", {"coupler.C", "rocker.C"}}}},
            {"D", {{"type", "revolute"}, {"between", {"ground.D", "rocker.D"}}}}}},
          {"drivers", {{"A", {{"position", "phi"}, {"velocity", 1}}}}}};
}

TEST(NamedMechanisms, AFlatParallelogramHasNoRates) {
  const mechanism::Plan plan(mechanism::parse_scene(four_bar(2, 3, 2, 3, "0").dump(), "scene"));
  const mechanism::Values values = plan.values();
  const mechanism::Solution solution = plan.solve(values);
  ASSERT_EQ(solution.configurations.size(), 1U);
  EXPECT_EQ(solution.configurations[0].regularity, Status::near_singular);
  const Json links = Json::parse(
      mechanism::report_json({plan, values, solution, "", 0}))["configurations"][0]["links"];
  EXPECT_EQ(links["crank"]["velocity"], Json({0, 0, 1}));
  EXPECT_EQ(links["rocker"]["velocity"], Json({nullptr, nullptr, nullptr}));
}

TEST(NamedMechanisms, AKiteFoldedOnItselfTurnsFreely) {
  const Solved kite(mechanism::parse_scene(four_bar(2, 3, 3, 2, "0").dump(), "scene"));
  EXPECT_EQ(kite.solution.status, mechanism::SolutionStatus::degenerate);
  EXPECT_EQ(kite.solution.mobility, 1);
  ASSERT_EQ(kite.solution.families.size(), 1U);
}

TEST(NamedMechanisms, ThreeEqualParallelCranksMoveBesideTwoAssembliesThatStand) {
  Json scene = {{"links",
                 {{"ground", {{"A", {0, 0}}, {"B", {2, 0}}, {"C", {4, 1}}}},
                  {"platform", {{"a", {0, 0}}, {"b", {2, 0}}, {"c", {4, 1}}}}}},
                {"joints", Json::object()}};
  for (const std::string name : {"A", "B", "C"}) {
    const std::string crank = "crank_" + name;
    const std::string on_platform(1, static_cast<char>(name[0] - 'A' + 'a'));
    scene["links"][crank] = {{"x", {0, 0}}, {"y", {2, 0}}};
    scene["joints"][name] = {{"type", "revolute"}, {"between", {"ground." + name, crank + ".x"}}};
    scene["joints"][on_platform] = {{"type", "revolute"},
                                    {"between", {crank + ".y", "platform." + on_platform}}};
  }
  const Solved cranks(mechanism::parse_scene(scene.dump(), "scene"));
  EXPECT_EQ(cranks.solution.status, mechanism::SolutionStatus::ok);
  ASSERT_EQ(cranks.solution.families.size(), 1U);
  EXPECT_EQ(cranks.solution.families[0].mobility, 1);
  ASSERT_EQ(cranks.configurations().size(), 2U);
  for (const mechanism::Configuration& configuration : cranks.configurations()) {
    EXPECT_EQ(configuration.regularity, Status::ok);
  }
}

/// Parallelogram, antiparallelogram and rhombus pass through their change points, on a step and
/// beside it, and in either order of listing.
TEST(NamedMechanisms, ChangePointsAreCrossings) {
  struct Case {
    double crank, coupler;
    double from, to;
    int crossings;
  };
  for (const Case& at : {Case{2, 3, -1, 1, 1}, Case{2, 2, 2, 4, 1}, Case{3, 2, -1, 7, 3}}) {
    for (const int count : {5, 9, 12, 33}) {
      SCOPED_TRACE(count);
      Json scene = four_bar(at.crank, at.coupler, at.crank, at.coupler, "0");
      scene["sweep"] = {{"parameter", "phi"}, {"from", at.from}, {"to", at.to}, {"count", count}};
      const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
      EXPECT_EQ(kept.count_of("crossing"), at.crossings);
      EXPECT_EQ(static_cast<int>(kept.events.size()), at.crossings);
    }
  }
}

/// What is close to a change point depends on the mechanism's size, not on the length of the sweep.
/// By default one case in seven.
TEST(NamedMechanisms, ChangePointsAreCrossingsOfShortSweepsToo) {
  struct Case {
    double crank, coupler, rocker, ground;
    double at;
  };
  const double half_turn = 3.141592653589793;
  int number = 0;
  for (const Case& bars : {Case{2, 4, 2, 4, 0}, Case{2, 4, 2, 4, half_turn},
                           Case{3, 3, 3, 3, half_turn}, Case{4, 4, 2, 2, 0}}) {
    for (const double half : {1e-1, 1e-2, 4e-3, 1e-3, 1e-4, 1e-5}) {
      for (const double before : {half, 0.63 * half}) {
        for (const int count : {2, 3, 4, 5, 8, 9}) {
          if (number++ % 7 != 0 && !is_whole_campaign()) {
            continue;
          }
          SCOPED_TRACE(testing::Message() << bars.coupler << " " << bars.at << " " << half << " "
                                          << before << " " << count);
          Json scene = four_bar(bars.crank, bars.coupler, bars.rocker, bars.ground, "0");
          scene["sweep"] = {{"parameter", "phi"},
                            {"from", bars.at - before},
                            {"to", bars.at + half},
                            {"count", count}};
          const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
          EXPECT_EQ(kept.count_of("crossing"), 1);
          EXPECT_EQ(kept.events.size(), 1U);
        }
      }
    }
  }
}

/// A rocker that is slightly too short opens the change point at phi = pi into two folds, where
/// coupler and rocker lie in one line: cos^2 (phi / 2) = (a + d - b - c) (a + b + c + d) / (4 a d).
TEST(NamedMechanisms, FoldsBesideAChangePointAreLocated) {
  struct Case {
    double crank, coupler, rocker, ground;
  };
  double worst = 0;
  for (const Case& bars : {Case{1.3, 0.79, 1.3, 0.79}, Case{0.9, 0.9, 0.9, 0.9},
                           Case{0.6, 0.6, 1.25, 1.25}, Case{0.5, 1.2, 0.5, 1.2}}) {
    for (const double opened : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      const double rocker = bars.rocker - opened;
      const long double reach = static_cast<long double>(bars.crank) + bars.ground;
      const long double length = static_cast<long double>(bars.coupler) + rocker;
      const long double square = (reach - length) * (reach + length) /
                                 (4 * static_cast<long double>(bars.crank) * bars.ground);
      const auto gap = static_cast<double>(2 * std::asin(std::sqrt(square)));
      for (const double half : {3.0, 0.3, 0.01}) {
        for (const int count : {2, 61}) {
          SCOPED_TRACE(testing::Message()
                       << bars.crank << " " << opened << " " << half << " " << count);
          const double half_turn = 3.141592653589793;
          Json scene = four_bar(bars.crank, bars.coupler, rocker, bars.ground, "0");
          scene["sweep"] = {{"parameter", "phi"},
                            {"from", half_turn - half},
                            {"to", half_turn + 0.8 * half},
                            {"count", count}};
          const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
          ASSERT_EQ(kept.events.size(), 2U);
          EXPECT_EQ(kept.events[0].text, "fold 1 2");
          EXPECT_EQ(kept.events[1].text, "birth 3 4");
          for (const SweepEventKept& event : kept.events) {
            const double error = std::abs(std::abs(event.parameter - half_turn) - gap) / gap;
            worst = std::max(worst, error);
            EXPECT_LT(error, 1e-4);
          }
        }
      }
    }
  }
  std::cout << "folds beside change points within " << worst << " of their gap\n";
}

/// Where pin B of a kite passes pivot D at a distance, coupler and rocker swing round by half a
/// turn while the crank hardly moves: C stays on its side of the line from B to D, which turns
/// round.
TEST(NamedMechanisms, AKiteThatPassesBesideItsPivotSwingsRound) {
  for (const double beside : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, -1e-12,
                              -1e-10, -1e-9, -1e-8, -1e-7, -1e-5}) {
    for (const double half : {1.0, 0.1, 0.01}) {
      for (const int count : {2, 20, 361}) {
        SCOPED_TRACE(testing::Message() << beside << " " << half << " " << count);
        Json scene = four_bar(0.66, 0.9, 0.9, 0.66 + beside, "0");
        scene["outputs"] = {{"B", "crank.B"}, {"C", "coupler.C"}};
        scene["sweep"] = {
            {"parameter", "phi"}, {"from", -half}, {"to", 0.8 * half}, {"count", count}};
        const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
        std::map<int, std::set<bool>> sides;
        const auto record = [&](const mechanism::SweepRecord& at) {
          EXPECT_EQ(at.event, "");
          const Eigen::Vector2d b = at.state->output("B").position;
          const Eigen::Vector2d to_c = at.state->output("C").position - b;
          const Eigen::Vector2d to_d = Eigen::Vector2d(0.66 + beside, 0) - b;
          sides[at.branch].insert(to_d.x() * to_c.y() > to_d.y() * to_c.x());
        };
        mechanism::sweep(plan, {record, {}, {}});
        EXPECT_EQ(sides.size(), 2U);
        for (const auto& [branch, seen] : sides) {
          EXPECT_EQ(seen.size(), 1U) << "branch " << branch;
        }
      }
    }
  }
}

/// With a shorter rocker B cannot pass D: the branches fold before it, and others are born behind
/// it. Rounding leaves closures open by some 1e-15 of the lengths; at the folds |BD| is only the
/// difference between coupler and rocker.
TEST(NamedMechanisms, AKiteThatCannotPassItsPivotFolds) {
  for (const double shorter : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 5e-13}) {
    SCOPED_TRACE(shorter);
    const double rocker = 0.9 - shorter;
    Json scene = four_bar(0.66, 0.9, rocker, 0.66, "0");
    scene["sweep"] = {{"parameter", "phi"}, {"from", -1}, {"to", 0.8}, {"count", 20}};
    const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
    ASSERT_EQ(kept.events.size(), 2U);
    EXPECT_EQ(kept.events[0].text, "fold 1 2");
    EXPECT_EQ(kept.events[1].text, "birth 3 4");
    const double place = 2 * std::asin((0.9 - rocker) / 1.32);
    const double tolerance = 1e-5 * place + 2e-15;
    EXPECT_NEAR(kept.events[0].parameter, -place, tolerance);
    EXPECT_NEAR(kept.events[1].parameter, place, tolerance);
  }
}

/// Each of several parallelograms in a row may fold over at their common change point.
TEST(NamedMechanisms, ChangePointsOfParallelogramsInARowAreCrossings) {
  for (const double half : {1.0, 0.1, 0.01}) {
    for (const int parallelograms : {1, 2, 3}) {
      SCOPED_TRACE(testing::Message() << parallelograms << " parallelograms, " << half);
      Json scene = {
          {"parameters", {{"phi", 0}}},
          {"links", {{"ground", {{"A", {0, 0}}}}, {"crank", {{"A", {0, 0}}, {"N", {6, 0}}}}}},
          {"joints", {{"A", {{"type", "revolute"}, {"between", {"ground.A", "crank.A"}}}}}},
          {"drivers", {{"A", {{"position", "phi"}}}}},
          {"want", {"position"}}};
      std::string before = "crank";
      int place = 0;
      for (int index = 0; index < parallelograms; ++index) {
        const std::string number = std::to_string(index);
        const int length = 11 - 2 * index;
        place += length;
        const std::string coupler = "coupler" + number;
        const std::string rocker = "rocker" + number;
        scene["links"]["ground"]["D" + number] = {place, 0};
        scene["links"][coupler] = {{"B", {0, 0}}, {"C", {length, 0}}};
        scene["links"][rocker] = {{"D", {0, 0}}, {"C", {6, 0}}, {"N", {6, 0}}};
        const auto joined = [](const std::string& one, const std::string& other) {
          return Json{{"type", "revolute"}, {"between", {one, other}}};
        };
        scene["joints"]["B" + number] = joined(before + ".N", coupler + ".B");
        scene["joints"]["C" + number] = joined(coupler + ".C", rocker + ".C");
        scene["joints"]["D" + number] = joined("ground.D" + number, rocker + ".D");
        before = rocker;
      }
      const double half_turn = 3.141592653589793;
      scene["sweep"] = {{"parameter", "phi"},
                        {"from", half_turn - half},
                        {"to", half_turn + 0.8 * half},
                        {"count", 20}};
      const SweepKept kept = run_sweep(mechanism::parse_scene(scene.dump(), "scene"));
      ASSERT_EQ(kept.events.size(), 1U);
      EXPECT_EQ(kept.events[0].kind(), "crossing");
      EXPECT_EQ(std::count(kept.events[0].text.begin(), kept.events[0].text.end(), ' '),
                1 << parallelograms);
    }
  }
}

}  // namespace
}  // namespace assur::test::named_mechanisms_test
