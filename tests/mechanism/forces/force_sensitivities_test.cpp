// Law: the derivatives of efforts and forces are the differences of those of scenes that are solved
// again with one parameter moved, in motion and in special position.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/loaded_scene.hpp"
#include "mechanism/scene_solutions.hpp"
#include "richardson.hpp"

namespace assur::test::force_sensitivities_test {
namespace {

using mechanism::Forces;

/// All numbers of forces, one after the other.
Eigen::VectorXd numbers_of(const Forces& forces) {
  std::vector<double> numbers(forces.efforts.begin(), forces.efforts.end());
  for (const mechanism::JointForce& joint : forces.joints) {
    for (const auto& [link, force] : joint.on) {
      numbers.insert(numbers.end(), {force.x(), force.y()});
    }
    numbers.push_back(joint.moment);
  }
  numbers.insert(numbers.end(),
                 {forces.ground.force.x(), forces.ground.force.y(), forces.ground.moment});
  return Eigen::Map<Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
}

double distance(const Configuration& one, const Configuration& other) {
  double most = 0;
  for (const mechanism::LinkIndex link : one.links.keys()) {
    const auto& a = one.links[link].pose;
    const auto& b = other.links[link].pose;
    most = std::max({most, std::abs(a.x - b.x), std::abs(a.y - b.y),
                     std::abs(a.direction.cos - b.direction.cos),
                     std::abs(a.direction.sin - b.direction.sin)});
  }
  return most;
}

/// The forces of the configuration next to another one, with one parameter moved.
Eigen::VectorXd forces_near(const Plan& plan, const std::string& parameter, double value,
                            const Configuration& configuration) {
  const Values values = plan.values({{parameter, value}});
  const Solution solution = plan.solve(values);
  const auto& all = solution.configurations;
  const auto nearest = std::ranges::min_element(
      all, {}, [&](const Configuration& one) { return distance(one, configuration); });
  return nearest == all.end() ? Eigen::VectorXd()
                              : numbers_of(mechanism::forces_of(values, *nearest));
}

struct Largest {
  int compared = 0, undetermined = 0, not_trusted = 0;
  double error = 0;
};

/// Differences that change by more than this part when they are refined say nothing.
constexpr double trusted = 1e-7;

void check(const Json& json, const std::vector<std::string>& parameters, Largest& most) {
  const Solved scene = solved(json);
  for (const Configuration& configuration : scene.configurations()) {
    if (configuration.regularity != Status::ok || !configuration.rates_known) {
      continue;
    }
    const Eigen::VectorXd here = numbers_of(mechanism::forces_of(scene.values, configuration));
    const std::vector<Forces> sensitivities =
        mechanism::force_sensitivities(scene.values, configuration);
    for (const std::string& name : parameters) {
      SCOPED_TRACE(name);
      const auto index = index_of(scene.plan.mechanism().parameters(), name);
      const Eigen::VectorXd told = numbers_of(sensitivities[index.place()]);
      ASSERT_EQ(told.size(), here.size());
      if (!told.allFinite() || !here.allFinite()) {
        ++most.undetermined;
        continue;
      }
      bool is_found = true;
      const auto difference = best_richardson<Eigen::VectorXd>(
          [&](double offset) {
            Eigen::VectorXd there = forces_near(
                scene.plan, name, scene.values.parameter(index) + offset, configuration);
            is_found = is_found && there.size() == here.size();
            return is_found ? there : here;
          },
          1e-3, 3);
      const double unit = std::max({1.0, here.cwiseAbs().maxCoeff(), told.cwiseAbs().maxCoeff()});
      if (!is_found || !(difference.uncertainty < trusted * unit)) {
        ++most.not_trusted;
        continue;
      }
      ++most.compared;
      most.error = largest(most.error, (difference.derivative - told).cwiseAbs().maxCoeff() / unit);
    }
  }
}

void expect_small(const Largest& most) {
  std::cout << most.compared << " derivatives of all forces, error " << most.error << "; "
            << most.undetermined << " not determined, " << most.not_trusted
            << " differences not trusted\n";
  EXPECT_GT(most.compared, 0);
  EXPECT_LT(most.not_trusted, most.compared);
  EXPECT_LT(most.error, 1e-6);
}

/// Masses, loads and springs whose numbers follow a parameter of the scene.
/// On a lattice the ends of straight springs coincide in places, where these have no direction;
/// with the length 0 they need none.
Json following(Json scene, const std::string& parameter, Places places) {
  for (auto& [name, mass] : scene["masses"].items()) {
    mass["mass"] = "2 + 0.1*sin(" + parameter + ")";
    mass["at"] = {"0.3*" + parameter, 1};
  }
  for (auto& [name, load] : scene["loads"].items()) {
    if (load.contains("moment")) {
      load["moment"] = parameter + "^2";
    }
  }
  for (auto& [name, spring] : scene["springs"].items()) {
    if (spring.contains("joint")) {
      spring["rest"] =
          "0.37 + 0.2*" + parameter;  // on a lattice, angles are half a turn away from 0
      spring["damping"] = 0.3;
    } else if (places == Places::lattice) {
      spring["length"] = spring["damping"] = 0;
    }
  }
  return scene;
}

class ForceSensitivities : public DrivenScenes {};

TEST_P(ForceSensitivities, AreDifferencesOfScenes) {
  for (const Places places : {Places::anywhere, Places::lattice}) {
    Largest most;
    for_each_scene(2, 120, places, [&](const RandomDrivenScene& made, unsigned seed) {
      const std::vector<std::string>& parameters = made.free_parameters();
      check(following(loaded(made.scene(), seed), parameters.front(), places), parameters, most);
    });
    expect_small(most);
  }
}

INSTANTIATE_TEST_SUITE_P(Ties, ForceSensitivities, testing::Values(Ties::drivers, Ties::groups),
                         name_of_ties);

/// A crank and a rod in one line: as for points, no derivative is told there, also of what the
/// singular dyad does not load.
TEST(ForceSensitivities, AreNotToldAtASingularConfiguration) {
  const Json scene = Json::parse(R"({
    "parameters": {"phi": 0, "m": 3},
    "points": {"A": [0, 0], "B": [1, 0], "C": [3, 0], "D": [5, 0], "E": [7, 1], "F": [8, 1]},
    "links": {"ground": ["A", "D", "E"], "crank": ["A", "B"], "rod": ["B", "C"], "bar": ["C", "D"],
              "beam": ["E", "F"]},
    "drivers": {"A": {"position": "phi"}, "E": {"position": 0.0}},
    "masses": {"beam": {"mass": "m", "at": "F"}}, "gravity": [0, -10],
    "want": ["position", "sensitivity", "forces"]})");
  const Solved found = solved(scene);
  ASSERT_EQ(found.configurations().size(), 1U);
  for (const Forces& forces :
       mechanism::force_sensitivities(found.values, found.configurations()[0])) {
    EXPECT_TRUE(std::isnan(forces.efforts[mechanism::DriverIndex(1)]));
    EXPECT_EQ(std::ranges::count_if(forces.joints, &mechanism::JointForce::is_determined), 0);
    EXPECT_TRUE(std::isnan(forces.ground.moment));
  }
}

/// Three equal cranks carry a beam: the effort is determined beside forces that are not, and so is
/// its derivative by the mass, while one length alone violates the redundant constraint.
TEST(ForceSensitivities, BesideRedundantJointsAreThoseOfTheEffort) {
  const Json scene = Json::parse(R"({
    "parameters": {"phi": 0.5, "m": 2, "l": 3, "one": "l"},
    "links": {"ground": {"A": [0, 0], "B": [2, 0], "C": [4, 0]},
      "one": {"A": [0, 0], "D": [0, "one"]}, "two": {"B": [0, 0], "E": [0, "l"]},
      "three": {"C": [0, 0], "F": [0, "l"]}, "beam": {"D": [0, 0], "E": [2, 0], "F": [4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["ground.B", "two.B"]},
      "C": {"type": "revolute", "between": ["ground.C", "three.C"]},
      "D": {"type": "revolute", "between": ["one.D", "beam.D"]},
      "E": {"type": "revolute", "between": ["two.E", "beam.E"]},
      "F": {"type": "revolute", "between": ["three.F", "beam.F"]}},
    "drivers": {"A": {"position": "phi", "velocity": 1, "acceleration": 2}},
    "masses": {"beam": {"mass": "m", "at": [1, 0]}}, "gravity": [0, -10],
    "want": ["position", "velocity", "acceleration", "sensitivity", "forces"]})");
  const Solved found = solved(scene);
  int count = 0;
  for (const Configuration& configuration : found.configurations()) {
    if (!configuration.rates_known || !configuration.derivatives_known ||
        !configuration.is_consistent) {
      continue;
    }
    // By hand: effort = m l^2 2 - 10 m l sin(phi).
    const std::vector<Forces> all = mechanism::force_sensitivities(found.values, configuration);
    const auto effort_by = [&](std::size_t parameter) {
      return all[parameter].efforts[mechanism::DriverIndex(0)];
    };
    EXPECT_NEAR(effort_by(0), -10 * 2 * 3 * std::cos(0.5), 1e-9);
    EXPECT_NEAR(effort_by(1), 2 * 9 - 10 * 3 * std::sin(0.5), 1e-9);
    EXPECT_NEAR(effort_by(2), 2 * 2 * 3 * 2 - 10 * 2 * std::sin(0.5), 1e-9);
    EXPECT_TRUE(std::isnan(effort_by(3)));
    EXPECT_EQ(std::ranges::count_if(all[1].joints, &mechanism::JointForce::is_determined), 0);
    ++count;
  }
  EXPECT_GT(count, 0);
}

/// By hand: a crank of length l with a mass m at its end, turning at w, needs m g l cos(phi), and
/// its pin carries m (w^2 l - g) along it at phi = pi/2.
TEST(ForceSensitivities, AddUpToTheWorstCase) {
  const Json scene = Json::parse(R"({
    "parameters": {"phi": "pi/2", "l": {"value": 2, "tolerance": 0.1},
                   "m": {"value": 3, "tolerance": 0.2}, "w": 4},
    "links": {"ground": {"A": [0, 0]}, "crank": {"A": [0, 0], "B": ["l", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
    "drivers": {"A": {"position": "phi", "velocity": "w"}},
    "masses": {"crank": {"mass": "m", "at": "B"}}, "gravity": [0, -10],
    "want": ["position", "velocity", "acceleration", "sensitivity", "forces"]})");
  const Solved found = solved(scene);
  const std::vector<Forces> all =
      mechanism::force_sensitivities(found.values, found.configurations()[0]);
  const auto along_pin = [](const Forces& forces) { return forces.joints[0].on.back().second.y(); };
  // The force on the crank is m (g - w^2 l), upwards.
  EXPECT_NEAR(along_pin(all[1]), -3 * 16, 1e-12);
  EXPECT_NEAR(along_pin(all[2]), 10 - 32, 1e-12);
  EXPECT_NEAR(along_pin(all[3]), -3 * 2 * 4 * 2, 1e-12);
  EXPECT_NEAR(all[0].efforts[mechanism::DriverIndex(0)], -3 * 10 * 2, 1e-12);
  const mechanism::Spread& spread = found.values.spread();
  EXPECT_NEAR(along_pin(worst_case(all, spread)), 48 * 0.1 + 22 * 0.2, 1e-12);
  EXPECT_NEAR(along_pin(root_sum_square(all, spread)), std::hypot(48 * 0.1, 22 * 0.2), 1e-12);
}

/// Accelerations follow the crank's angle here, and no law reads a joint.
TEST(ForceSensitivities, OfAFourBarInMotionAreDifferences) {
  Largest most;
  check(example("four_bar_torque.json"), {"phi", "coupler_mass"}, most);
  expect_small(most);
  EXPECT_EQ(most.compared, 4);
}

/// The crane with its derivatives, as programs and people read it.
TEST(ForceSensitivities, AreReportedAsTheyAreComputed) {
  Json scene = example("crane.json");
  scene["want"] = {"position", "sensitivity", "forces"};
  const Solved found = solved(scene);
  const Configuration& raised = found.configurations()[1];
  const std::vector<Forces> all = mechanism::force_sensitivities(found.values, raised);
  const Forces worst = worst_case(all, found.values.spread());
  const mechanism::DriverIndex cylinder(0);
  const Json told = report_of(scene)["configurations"][1];
  EXPECT_EQ(told["drivers"]["cylinder"]["sensitivity"]["payload"]["effort"],
            all[1].efforts[cylinder]);
  EXPECT_EQ(told["drivers"]["cylinder"]["worst_case"]["effort"], worst.efforts[cylinder]);
  EXPECT_EQ(told["ground"]["sensitivity"]["stroke"]["moment"], all[0].ground.moment);
  const std::string csv = mechanism::csv_header(found.plan);
  EXPECT_NE(csv.find(",cylinder.worst_case_effort,"), std::string::npos);
  EXPECT_NE(csv.find(",ground.rss_moment,"), std::string::npos);
  // Nothing loads the cylinder across, and rounding is printed as zero.
  const std::string text = mechanism::report_text(found.report());
  EXPECT_NE(text.find("\n    cylinder.fx                      0\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("e-1"), std::string::npos) << text;
}

}  // namespace
}  // namespace assur::test::force_sensitivities_test
