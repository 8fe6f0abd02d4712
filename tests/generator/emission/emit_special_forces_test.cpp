// Law: if constraints are redundant or groups singular, an emitted solver has exactly the forces of
// `assur solve`.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "generator/printed_forces.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/loaded_scene.hpp"

namespace assur::test::emit_special_forces_test {
namespace {

/// A parallelogram, driven at A, with a crank and a dyad that it does not load, and a dyad that it
/// carries.
Json parallelogram(double phi) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0], "E": [9, 0], "L": [12, 1], "N": [6, 4]},
      "one": {"A": [0, 0], "B": [2, 0]}, "bar": {"B": [0, 0], "C": [4, 0], "M": [2, 1]},
      "two": {"D": [0, 0], "C": [2, 0]}, "arm": {"E": [0, 0], "G": [1, 0]},
      "p": {"G": [0, 0], "K": [2, 0]}, "q": {"K": [0, 0], "L": [2, 0]},
      "r": {"M": [0, 0], "O": [3, 0]}, "s": {"N": [0, 0], "O": [4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["one.B", "bar.B"]},
      "C": {"type": "revolute", "between": ["bar.C", "two.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "two.D"]},
      "E": {"type": "revolute", "between": ["ground.E", "arm.E"]},
      "G": {"type": "revolute", "between": ["arm.G", "p.G"]},
      "K": {"type": "revolute", "between": ["p.K", "q.K"]},
      "L": {"type": "revolute", "between": ["ground.L", "q.L"]},
      "M": {"type": "revolute", "between": ["bar.M", "r.M"]},
      "N": {"type": "revolute", "between": ["ground.N", "s.N"]},
      "O": {"type": "revolute", "between": ["r.O", "s.O"]}},
    "drivers": {"A": {}, "E": {"position": 1}},
    "gravity": [0, -9.81],
    "masses": {"one": {"mass": 1, "at": [1, 0], "inertia": 0.2},
      "bar": {"mass": 2, "at": [1, 0.5], "inertia": 0.3}, "two": {"mass": 1.5, "at": [0.7, 0.1]},
      "p": {"mass": 1, "at": [1, 0]}, "r": {"mass": 1, "at": [1, 0]}},
    "loads": {"F": {"at": "bar.C", "force": [3, -2]}, "T": {"on": "s", "moment": 4}},
    "want": ["position", "forces"]})");
  scene["drivers"]["A"]["position"] = phi;
  return scene;
}

/// A beam on parallel cranks of the length 3, of which all but two are redundant.
Json cranks(double phi) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "B": [2, 0], "C": [4, 0]},
      "one": {"A": [0, 0], "D": [3, 0]}, "two": {"B": [0, 0], "E": [3, 0]},
      "three": {"C": [0, 0], "F": [3, 0]}, "beam": {"D": [0, 0], "E": [2, 0], "F": [4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["ground.B", "two.B"]},
      "C": {"type": "revolute", "between": ["ground.C", "three.C"]},
      "D": {"type": "revolute", "between": ["one.D", "beam.D"]},
      "E": {"type": "revolute", "between": ["two.E", "beam.E"]},
      "F": {"type": "revolute", "between": ["three.F", "beam.F"]}},
    "drivers": {"A": {"velocity": 2, "acceleration": -1}},
    "gravity": [0, -9.81], "masses": {"beam": {"mass": 2, "at": [1, 1], "inertia": 0.5},
      "two": {"mass": 1, "at": [1, 0]}},
    "loads": {"P": {"at": "beam.F", "force": [1, 2]}, "T": {"on": "one", "moment": 4}},
    "springs": {"K": {"joint": "B", "stiffness": 2, "damping": 0.5}},
    "want": ["position", "velocity", "forces"]})");
  scene["drivers"]["A"]["position"] = phi;
  return scene;
}

/// A piston in two guides on one line, pushed by a crank.
Json guides(double phi) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "rail": {"through": [0, 0], "along": [1, 0]},
        "guide": {"through": [6, 0], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [3, 0]},
      "piston": {"C": [0, 0], "shoe": {"through": [0.5, 0], "along": [1, 0]},
        "stem": {"through": [2, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "piston.C"]},
      "S": {"type": "prismatic", "between": ["ground.rail", "piston.shoe"]},
      "T": {"type": "prismatic", "between": ["ground.guide", "piston.stem"]}},
    "drivers": {"A": {"velocity": 2}},
    "gravity": [0, -9.81], "masses": {"rod": {"mass": 1, "at": [1, 0], "inertia": 0.1},
      "piston": {"mass": 2}},
    "loads": {"P": {"at": "piston.C", "force": [-5, 0]}}, "want": ["position", "forces"]})");
  scene["drivers"]["A"]["position"] = phi;
  return scene;
}

struct Compared {
  int told = 0, unknown = 0;
  int by_one = 0;             ///< numbers that only one of the two tells
  double worst = 0;           ///< difference in parts of the largest number
  double worst_singular = 0;  ///< the same in doubtful configurations
};

/// Expects that the same numbers are told, and are equal to the digits that the configuration
/// keeps. With `is_lattice`, numbers of a configuration that is not regular are equal to two
/// digits, and may be told by one alone: the two round differently, and decide differently where
/// two digits end.
Compared compare(const std::vector<NamedScene>& scenes, const std::string& scalar = "double",
                 double most = 1e-9, bool is_lattice = false) {
  Compared result;
  for_each_printed(
      scenes, printed_states(scenes, code_that_prints_forces, scalar),
      [&](const Solved& known, const Configuration& configuration, std::istream& printed) {
        const auto told = numbers_of(read_forces(printed, known));
        const auto solved = numbers_of(mechanism::forces_of(known.values, configuration));
        double unit = 1;
        for (const ToldNumber& number : solved) {
          unit = std::isfinite(number.value) ? std::max(unit, std::abs(number.value)) : unit;
        }
        for (std::size_t place = 0; place < told.size(); ++place) {
          const bool is_known = std::isfinite(solved[place].value);
          const bool is_told = std::isfinite(told[place].value);
          const bool is_doubtful = is_lattice && configuration.regularity != Status::ok;
          if (is_told != is_known && is_doubtful) {
            ++result.by_one;
            continue;
          }
          EXPECT_EQ(is_told, is_known)
              << told[place].of << " " << told[place].value << " " << solved[place].value;
          ++(is_known ? result.told : result.unknown);
          if (is_known) {
            double& worst = is_doubtful ? result.worst_singular : result.worst;
            worst = largest(worst, std::abs(told[place].value - solved[place].value) / unit);
          }
        }
      });
  std::cout << result.told << " numbers told, " << result.unknown << " not determined, "
            << result.by_one << " told by one alone; difference at most " << result.worst << "\n";
  EXPECT_GT(result.told, 0);
  EXPECT_LT(result.worst, most);
  return result;
}

constexpr double pi = std::numbers::pi;

/// At a change point and beside it: with all links in one line, the efforts depend on the branch.
TEST(EmitSpecialForces, AreThoseOfSolveAtAndBesideAChangePoint) {
  std::vector<NamedScene> scenes;
  for (const double phi : is_whole_campaign()
                              ? std::vector{pi / 2, 0.7, 0.0, 1e-9, 1e-6, 1e-3, pi, -pi / 2}
                              : std::vector{0.7, 0.0, 1e-6, 1e-3, pi}) {
    scenes.push_back({"at_" + std::to_string(scenes.size()), parallelogram(phi)});
  }
  EXPECT_GT(compare(scenes).unknown, 0);
}

/// Without loads on the singular group, no force grows beside it, and more is determined.
TEST(EmitSpecialForces, AreThoseOfSolveWhereTheSingularGroupIsNotLoaded) {
  Json scene = parallelogram(0);
  scene["masses"].erase("bar");
  scene["masses"].erase("two");
  scene["masses"].erase("r");
  scene["loads"] = {{"T", {{"on", "one"}, {"moment", 4}}}};
  EXPECT_GT(compare({{"unloaded", scene}}).unknown, 0);
}

TEST(EmitSpecialForces, OfRedundantConstraintsAreThoseOfSolve) {
  std::vector<NamedScene> scenes;
  for (const double phi : is_whole_campaign() ? std::vector{0.5, pi / 2, 1e-3, 2.0, pi / 3}
                                              : std::vector{0.5, pi / 2}) {
    scenes.push_back({"cranks_" + std::to_string(scenes.size()), cranks(phi)});
    scenes.push_back({"guides_" + std::to_string(scenes.size()), guides(phi)});
  }
  Json rounded = cranks(0.5);  // within the slack of redundant constraints
  rounded["links"]["three"]["F"] = {3 + 2e-12, 0};
  scenes.push_back({"rounded", rounded});
  EXPECT_GT(compare(scenes).unknown, 0);
}

/// Where two links share a force at a pin, the force on a third one is told. A rocker is doubled on
/// the same two pins.
TEST(EmitSpecialForces, OnALinkThatTwoOthersCarryTogetherAreThoseOfSolve) {
  const Json scene = Json::parse(R"({
    "points": {"A": [0, 0], "B": [1, 2], "C": [5, 3], "D": [4, 0]},
    "links": {"ground": ["A", "D"], "crank": ["A", "B"], "beam": ["B", "C"], "one": ["D", "C"],
      "two": ["D", "C"]},
    "drivers": {"A": {"position": 1, "velocity": 3}},
    "masses": {"beam": {"mass": 2, "at": [1, 0.3], "inertia": 0.1}}, "gravity": [0, -9.81],
    "want": ["position", "velocity", "acceleration", "forces"]})");
  const Compared compared = compare({{"doubled_rocker", scene}});
  EXPECT_EQ(compared.told, 2 * 20);
  EXPECT_EQ(compared.unknown, 2 * 8);
}

TEST(EmitSpecialForces, OfRedundantConstraintsAreToldInFloat) {
  EXPECT_GT(compare({{"guides", guides(1)}}, "float", 1e-4).unknown, 0);
}

/// A tolerance allows constraints that do not quite hold: directions below it do not count.
TEST(EmitSpecialForces, OfRedundantConstraintsWithAToleranceAreThoseOfSolve) {
  Json scene = cranks(0.5);
  scene["redundancy"] = {{"tolerance", 0.01}};
  EXPECT_GT(compare({{"tolerant", scene}}).unknown, 0);
}

/// A rod that lies on its crank brings the ends of a spring together: the spring has no direction
/// there, and what it does not load is told.
TEST(EmitSpecialForces, OfASpringWithoutADirectionAreThoseOfSolve) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0.1, 0.2], "D": [3.1, 0.2], "E": [5, 0]},
      "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [1, 0]},
      "arm": {"D": [0, 0], "C": [3, 0]}, "other": {"E": [0, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "arm.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "arm.D"]},
      "E": {"type": "revolute", "between": ["ground.E", "other.E"]}},
    "drivers": {"A": {"position": 0.7}, "E": {"position": 0.3}},
    "gravity": [0, -9.81], "masses": {"other": {"mass": 2, "at": [1, 0]}, "arm": {"mass": 1}},
    "springs": {"K": {"between": ["ground.A", "rod.C"], "stiffness": 5, "length": 0.3}},
    "want": ["position", "forces"]})");
  std::vector<NamedScene> scenes = {{"with_length", scene}};
  scene["springs"]["K"]["length"] = 0;
  scenes.push_back({"without_length", scene});
  scene["springs"]["K"]["damping"] = 2;
  scenes.push_back({"with_damper_at_rest", scene});
  scene["drivers"]["A"]["velocity"] = 1;
  scenes.push_back({"with_damper", scene});
  const Compared compared = compare(scenes);
  EXPECT_GT(compared.unknown, 0);
  if (is_whole_campaign()) {
    EXPECT_GT(compare({scenes.front()}, "float", 1e-4).unknown, 0);
  }
}

/// With moving drivers nothing is known of rates at the change point; at rest the resultant on the
/// ground is known there.
TEST(EmitSpecialForces, OfMovingDriversAtAChangePointAreThoseOfSolve) {
  std::vector<NamedScene> scenes;
  for (const double velocity : {0.0, 1.0}) {
    Json scene = parallelogram(0);
    scene["drivers"]["A"]["velocity"] = velocity;
    scene["drivers"]["E"]["velocity"] = 1;
    scenes.push_back({"moving_" + std::to_string(scenes.size()), scene});
    // Nothing that is loaded and known needs a force across the line: what is unknown might.
    scene["masses"] = {{"two", {{"mass", 1.5}, {"at", {0.7, 0.1}}}}};
    scene.erase("loads");
    scenes.push_back({"moving_" + std::to_string(scenes.size()), scene});
  }
  EXPECT_GT(compare(scenes).unknown, 0);
}

class EmitSpecialForcesOfScenes : public DrivenScenes {};

/// On a lattice of whole numbers springs have ends that coincide, links lie in one line, and
/// drivers move through change points. A scene in which a link has no direction is not emitted, nor
/// one with more than 4096 configurations, nor one whose links are solved relative to a moving link
/// where nothing can be assembled.
TEST_P(EmitSpecialForcesOfScenes, OnALatticeAreThoseOfSolve) {
  if (!is_whole_campaign()) {
    GTEST_SKIP() << "compiling the solvers takes minutes";
  }
  std::vector<NamedScene> scenes;
  int refused = 0;
  const TemporaryDirectory directory;
  for_each_scene(60, 60, Places::lattice, [&](const RandomDrivenScene& made, unsigned seed) {
    Json json = loaded(made.scene(), seed);
    json["want"] = {"position", "forces"};
    const auto file = directory.write("scene.json", json.dump());
    const CommandResult emitted =
        run_assur("emit --scene " + file.string() + " --output " + directory.path().string());
    if (emitted.status == 0) {
      scenes.push_back({"scene_" + std::to_string(seed), json});
    } else {
      const auto says = [&](const char* text) {
        return emitted.messages.find(text) != std::string::npos;
      };
      EXPECT_TRUE(says("no direction") || says("relative to a moving link") ||
                  says("an emitted solver lists 4096 at most"))
          << emitted.messages;
      ++refused;
    }
  });
  std::cout << refused << " refused; ";
  const Compared compared = compare(scenes, "double", 1e-9, true);
  EXPECT_LT(compared.by_one, 0.01 * compared.told);
}

INSTANTIATE_TEST_SUITE_P(Ties, EmitSpecialForcesOfScenes,
                         testing::Values(Ties::drivers, Ties::groups,
                                         Ties::drivers_in_larger_groups),
                         name_of_ties);

/// At the change point rates are unknown, and so all forces of the parallelogram, while those of
/// the other group do not depend on the parallelogram's configuration.
TEST(EmitSpecialForces, OfOtherGroupsAreToldWhereRatesAreNotKnown) {
  std::vector<NamedScene> scenes;
  for (const double phi : {0.0, 0.7}) {
    Json scene = parallelogram(phi);
    scene["drivers"]["A"]["velocity"] = 1;
    scene["drivers"]["E"]["velocity"] = 1;
    scenes.push_back({"moving_" + std::to_string(scenes.size()), scene});
  }
  std::vector<std::vector<ToldNumber>> first;  // configuration of each scene
  for_each_printed(
      scenes, printed_states(scenes, code_that_prints_forces),
      [&](const Solved& known, const Configuration& configuration, std::istream& printed) {
        const auto told = numbers_of(read_forces(printed, known));
        if (&configuration == &known.configurations().front()) {
          first.push_back(told);
        }
      });
  ASSERT_EQ(first.size(), 2U);
  for (std::size_t place = 0; place < first[0].size(); ++place) {
    const std::string& of = first[0][place].of;
    const bool is_other = of == "E" || of == "G" || of == "K" || of == "L";
    if (is_other || (of == "effort" && place == 1)) {
      EXPECT_NEAR(first[0][place].value, first[1][place].value, 1e-12) << of;
    } else if (of == "A" || of == "B" || of == "C" || of == "D") {
      EXPECT_TRUE(std::isnan(first[0][place].value) || first[0][place].value == 0) << of;
    }
  }
}

}  // namespace
}  // namespace assur::test::emit_special_forces_test
