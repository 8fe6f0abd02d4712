// Law: beside and at singular configurations, where constraints are redundant, and along branches,
// a force is told if and only if it is determined.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/mechanism/forces.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "largest.hpp"
#include "mechanism/scene_solutions.hpp"
#include "mechanism/turning_spring.hpp"

namespace assur::test::special_forces_test {
namespace {

/// A spring whose ends coincide has no direction: what it loads is not told, and all else is.
TEST(Forces, ThatASpringWithoutADirectionDoesNotLoadAreTold) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "E": [5, 0]}, "arm": {"A": [0, 0], "B": [1, 0]},
      "hand": {"B": [0, 0], "C": [1, 0]}, "other": {"E": [0, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "arm.A"]},
      "B": {"type": "revolute", "between": ["arm.B", "hand.B"]},
      "E": {"type": "revolute", "between": ["ground.E", "other.E"]}},
    "drivers": {"A": {"position": 0.3}, "B": {"position": "pi"}, "E": {"position": 0}},
    "gravity": [0, -10], "masses": {"hand": {"mass": 2}, "other": {"mass": 2, "at": [1, 0]}},
    "springs": {"K": {"between": ["ground.A", "hand.C"], "stiffness": 5, "length": 0.3}},
    "want": ["position", "forces", "dynamics"]})");
  const auto forces_in = [&] {
    const Solved found = solved(scene);
    return mechanism::forces_of(found.values, found.configurations()[0]);
  };
  const double weight_at_B = 20 * std::cos(0.3);
  const mechanism::Forces forces = forces_in();
  // The spring pulls at A, so that it turns the hand, but not hand and arm together.
  EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], weight_at_B, 1e-12);
  EXPECT_TRUE(std::isnan(forces.efforts[mechanism::DriverIndex(1)]));
  EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(2)], 20, 1e-12);
  EXPECT_TRUE(std::isnan(forces.joints[0].on.back().second.x()));
  EXPECT_NEAR(forces.ground.force.y(), -40, 1e-12);
  EXPECT_NEAR(forces.ground.moment, -weight_at_B - 120, 1e-12);
  EXPECT_EQ(forces.reason, "the ends of the spring K coincide, so that its force has no direction");
  const Solved found = solved(scene);
  const mechanism::Dynamics dynamics =
      mechanism::dynamics_of(found.values, found.configurations()[0]);
  EXPECT_TRUE(dynamics.mass_matrix.allFinite());
  EXPECT_EQ(dynamics.reason, forces.reason);
  // At rest a damper needs no direction, nor does a spring of the length 0.
  scene["springs"]["K"] = {{"between", {"ground.A", "hand.C"}}, {"stiffness", 5}, {"damping", 2}};
  EXPECT_NEAR(forces_in().efforts[mechanism::DriverIndex(1)], 0, 1e-12);
  EXPECT_EQ(forces_in().reason, "");
  scene["drivers"]["B"]["velocity"] = 1;
  EXPECT_TRUE(std::isnan(forces_in().efforts[mechanism::DriverIndex(1)]));
  EXPECT_NEAR(forces_in().ground.force.y(), -40, 1e-12);
}

/// With a moving driver nothing is known of the rates of a flat parallelogram, nor of its forces.
/// The rates and forces of a crank and a dyad beside it are those without the parallelogram.
TEST(Forces, OfGroupsBesideASingularOneAreTold) {
  const Json both = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0], "E": [9, 0], "L": [12, 1]},
      "one": {"A": [0, 0], "B": [2, 0]}, "bar": {"B": [0, 0], "C": [4, 0]},
      "two": {"D": [0, 0], "C": [2, 0]}, "arm": {"E": [0, 0], "G": [1, 0]},
      "p": {"G": [0, 0], "K": [2, 0]}, "q": {"K": [0, 0], "L": [2, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["one.B", "bar.B"]},
      "C": {"type": "revolute", "between": ["bar.C", "two.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "two.D"]},
      "E": {"type": "revolute", "between": ["ground.E", "arm.E"]},
      "G": {"type": "revolute", "between": ["arm.G", "p.G"]},
      "K": {"type": "revolute", "between": ["p.K", "q.K"]},
      "L": {"type": "revolute", "between": ["ground.L", "q.L"]}},
    "drivers": {"A": {"position": 0, "velocity": 1}, "E": {"position": 1, "velocity": 2}},
    "masses": {"bar": {"mass": 2, "at": [1, 0.5], "inertia": 0.3},
      "p": {"mass": 1, "at": [1, 0], "inertia": 0.1}},
    "want": ["position", "velocity", "acceleration", "forces"]})");
  Json alone = both;
  for (const char* link : {"one", "bar", "two"}) {
    alone["links"].erase(link);
  }
  for (const char* joint : {"A", "B", "C", "D"}) {
    alone["joints"].erase(joint);
  }
  alone["drivers"].erase("A");
  alone["masses"].erase("bar");
  const auto forces_by_joint = [](const Solved& of, const Configuration& configuration) {
    std::map<std::string, Eigen::Vector2d> result;
    for (const mechanism::JointForce& force :
         mechanism::forces_of(of.values, configuration).joints) {
      result[force.joint] = force.on.back().second;
    }
    return result;
  };
  const Solved of_both = solved(both);
  const Solved of_alone = solved(alone);
  ASSERT_EQ(of_alone.configurations().size(), 2U);
  std::size_t compared = 0;
  for (const Configuration& configuration : of_both.configurations()) {
    EXPECT_FALSE(configuration.link("bar").velocity.allFinite());
    EXPECT_FALSE(configuration.link("bar").acceleration.allFinite());
    const auto same = std::ranges::find_if(of_alone.configurations(), [&](const auto& one) {
      return std::abs(one.link("p").pose.direction.sin -
                      configuration.link("p").pose.direction.sin) < 1e-12;
    });
    ASSERT_NE(same, of_alone.configurations().end());
    EXPECT_LT((configuration.link("q").acceleration - same->link("q").acceleration).norm(), 1e-12);
    const auto told = forces_by_joint(of_both, configuration);
    for (const auto& [joint, force] : forces_by_joint(of_alone, *same)) {
      EXPECT_LT((told.at(joint) - force).norm(), 1e-11) << joint;
      ++compared;
    }
    for (const char* joint : {"A", "B", "C", "D"}) {
      EXPECT_FALSE(told.at(joint).allFinite()) << joint;
    }
  }
  EXPECT_EQ(compared, 4 * of_both.configurations().size());
}

/// Beside the flat position of three parallel cranks the rates of the beam are not known, but those
/// of the driven crank are, which alone has a mass; at rest all are zero.
TEST(Forces, OfADrivenLinkAreToldBesideAChangePoint) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "B": [2, 0], "C": [3, 0]},
      "one": {"A": [0, 0], "D": [1, 0]}, "two": {"B": [0, 0], "E": [1, 0]},
      "three": {"C": [0, 0], "F": [1, 0]}, "beam": {"D": [0, 0], "E": [2, 0], "F": [3, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["ground.B", "two.B"]},
      "C": {"type": "revolute", "between": ["ground.C", "three.C"]},
      "D": {"type": "revolute", "between": ["one.D", "beam.D"]},
      "E": {"type": "revolute", "between": ["two.E", "beam.E"]},
      "F": {"type": "revolute", "between": ["three.F", "beam.F"]}},
    "drivers": {"A": {"position": 0, "velocity": 1}}, "gravity": [0, -9.81],
    "masses": {"one": {"mass": 2, "at": [0.3, 0]}},
    "want": ["position", "velocity", "acceleration", "forces"]})");
  for (const double velocity : {1.0, 0.0}) {
    for (const double phi : {1e-4, 1e-5, 1e-6, 0.0, -1e-5}) {
      SCOPED_TRACE(testing::Message() << velocity << " at " << phi);
      scene["drivers"]["A"]["position"] = phi;
      scene["drivers"]["A"]["velocity"] = velocity;
      const Solved found = solved(scene);
      ASSERT_FALSE(found.configurations().empty());
      for (const Configuration& configuration : found.configurations()) {
        const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
        EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], 0.6 * 9.81 * std::cos(phi), 1e-9);
        EXPECT_NEAR(forces.ground.force.x(), 0.6 * velocity * std::cos(phi), 1e-9);
        EXPECT_TRUE(velocity > 0 || configuration.link("beam").acceleration.isZero(0));
      }
    }
  }
}

/// Three equal cranks carry a coupler: the third one shares a load that the equations do not
/// divide.
TEST(Forces, ThatRedundantJointsShareAreNotTold) {
  const Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "B": [2, 0], "C": [4, 0]},
      "one": {"A": [0, 0], "D": [0, 3]}, "two": {"B": [0, 0], "E": [0, 3]},
      "three": {"C": [0, 0], "F": [0, 3]}, "beam": {"D": [0, 0], "E": [2, 0], "F": [4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["ground.B", "two.B"]},
      "C": {"type": "revolute", "between": ["ground.C", "three.C"]},
      "D": {"type": "revolute", "between": ["one.D", "beam.D"]},
      "E": {"type": "revolute", "between": ["two.E", "beam.E"]},
      "F": {"type": "revolute", "between": ["three.F", "beam.F"]}},
    "drivers": {"A": {"position": 0.5, "velocity": 1, "acceleration": 2}},
    "masses": {"beam": {"mass": 2, "at": [1, 0]}}, "gravity": [0, -9.81],
    "want": ["position", "velocity", "acceleration", "forces", "dynamics"]})");
  const Solved found = solved(scene);
  ASSERT_FALSE(found.configurations().empty());
  for (const Configuration& configuration : found.configurations()) {
    if (!configuration.rates_known || !configuration.is_consistent) {
      continue;
    }
    const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
    EXPECT_FALSE(forces.reason.empty());
    // The torque is that of a mass on a crank of length 3: m l^2 alpha + m g dy/dphi.
    const double height = -3 * std::sin(0.5);
    EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], 2 * 9 * 2 + 2 * 9.81 * height, 1e-11);
    EXPECT_EQ(std::ranges::count_if(forces.joints, &mechanism::JointForce::is_determined), 0);
  }
}

/// The effort of three cranks whose lengths hold to 12 to 14 digits, and of cranks far from the
/// origin, whose places are rounded as much.
TEST(Forces, ThatRedundantJointsDoNotShareAreToldWhereLengthsAreRounded) {
  for (const double digits : {1e-14, 1e-13, 1e-12}) {
    for (const double away : {0.0, 1e5}) {
      const auto rounded = [&](double number) { return std::round(number / digits) * digits; };
      Json scene = Json::parse(R"({
        "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
          "B": {"type": "revolute", "between": ["ground.B", "two.B"]},
          "C": {"type": "revolute", "between": ["ground.C", "three.C"]},
          "D": {"type": "revolute", "between": ["one.D", "beam.D"]},
          "E": {"type": "revolute", "between": ["two.E", "beam.E"]},
          "F": {"type": "revolute", "between": ["three.F", "beam.F"]}},
        "drivers": {"A": {"position": 0.7}}, "masses": {"beam": {"mass": 2, "at": [1, 0]}},
        "gravity": [0, -9.81], "want": ["position", "forces"]})");
      const double length = std::sqrt(2.3);
      const double aside = std::sqrt(0.7);
      const auto place = [&](double x, double y) { return Json({rounded(x), rounded(y)}); };
      scene["links"]["ground"] = {{"A", place(away, away)},
                                  {"B", place(away + 2 * aside, away)},
                                  {"C", place(away + aside, away + aside)}};
      scene["links"]["beam"] = {
          {"D", {0, 0}}, {"E", place(2 * aside, 0)}, {"F", place(aside, aside)}};
      for (const auto& [link, ends] :
           {std::pair("one", "AD"), std::pair("two", "BE"), std::pair("three", "CF")}) {
        scene["links"][link] = {{std::string(1, ends[0]), {0, 0}},
                                {std::string(1, ends[1]), place(length, 0)}};
      }
      if (away > 0) {
        scene["redundancy"] = {{"tolerance", 1e-6}};  // places far away are rounded by more
      }
      const Solved found = solved(scene);
      ASSERT_FALSE(found.configurations().empty()) << digits << " " << away;
      for (const Configuration& configuration : found.configurations()) {
        const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
        EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], 2 * 9.81 * length * std::cos(0.7),
                    1e-4);
      }
    }
  }
}

/// A rocker that is doubled on the same two pins shares the force of the beam with its twin; the
/// forces on the beam and on the ground, and the derivatives of these, are those of one rocker with
/// the weight of both.
TEST(Forces, OnALinkThatTwoOthersCarryTogetherAreTold) {
  Json scene = Json::parse(R"({
    "points": {"A": [0, 0], "B": [1, 2], "C": [5, 3], "D": [4, 0]},
    "parameters": {"phi": {"drawn": "A"}, "w": 2},
    "links": {"ground": ["A", "D"], "crank": ["A", "B"], "beam": ["B", "C"], "one": ["D", "C"]},
    "drivers": {"A": {"position": "phi", "velocity": 3}},
    "masses": {"beam": {"mass": "w", "at": [1, 0.3], "inertia": 0.1},
      "one": {"mass": 1, "at": [1, 0]}},
    "gravity": [0, -9.81],
    "want": ["position", "velocity", "acceleration", "forces", "sensitivity"]})");
  const Solved alone = solved(scene);
  scene["links"]["two"] = {"D", "C"};
  const Solved shared = solved(scene);
  const auto on = [](const Solved& of, const mechanism::Forces& forces, const std::string& joint,
                     const std::string& link) {
    for (const auto& [own, force] :
         std::ranges::find(forces.joints, joint, &mechanism::JointForce::joint)->on) {
      if (of.plan.mechanism().links()[own].name == link) {
        return force;
      }
    }
    throw std::logic_error("no such link at the joint");
  };
  ASSERT_EQ(alone.configurations().size(), 2U);
  ASSERT_EQ(shared.configurations().size(), 2U);
  for (std::size_t place = 0; place < 2; ++place) {
    std::vector<mechanism::Forces> with_one =
        mechanism::force_sensitivities(alone.values, alone.configurations()[place]);
    std::vector<mechanism::Forces> with_two =
        mechanism::force_sensitivities(shared.values, shared.configurations()[place]);
    with_one.push_back(mechanism::forces_of(alone.values, alone.configurations()[place]));
    with_two.push_back(mechanism::forces_of(shared.values, shared.configurations()[place]));
    EXPECT_EQ(with_one.back().reason, "");
    EXPECT_NE(with_two.back().reason, "");
    for (std::size_t of = 0; of < with_one.size(); ++of) {
      for (const auto& [joint, link] :
           {std::pair("B", "beam"), std::pair("C", "beam"), std::pair("D", "ground")}) {
        EXPECT_LT(
            (on(shared, with_two[of], joint, link) - on(alone, with_one[of], joint, link)).norm(),
            1e-11)
            << joint << " of " << of;
      }
      EXPECT_TRUE(on(shared, with_two[of], "C", "one").array().isNaN().all());
      EXPECT_TRUE(on(shared, with_two[of], "D", "two").array().isNaN().all());
    }
  }
}

/// At a change point, and at the dead centre of a driven slide, nothing is known of the rates, and
/// so of the inertia: where no force balances it, forces grow without bound nearby, and none is
/// told of the links in line.
TEST(Forces, ThatUnknownInertiaMayCauseAreNotTold) {
  Json parallelogram = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "crank": {"A": [0, 0], "B": [2, 0]},
      "coupler": {"B": [0, 0], "C": [4, 0]}, "rocker": {"D": [0, 0], "C": [2, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
      "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": 0, "velocity": 1}},
    "gravity": [0, -9.81], "masses": {"rocker": {"mass": 2, "at": [1, 0]}},
    "want": ["position", "velocity", "acceleration", "forces"]})");
  const Json slider = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "rail": {"through": [0, 0], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [3, 0]},
      "piston": {"C": [0, 0], "shoe": {"through": [0, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "piston.C"]},
      "S": {"type": "prismatic", "between": ["ground.rail", "piston.shoe"]}},
    "drivers": {"S": {"position": 4, "velocity": 1}},
    "gravity": [0, -9.81], "masses": {"crank": {"mass": 1, "at": [0.5, 0.2]}},
    "want": ["position", "velocity", "acceleration", "forces"]})");
  for (const double phi : {0.0, 1e-8, 1e-7}) {
    parallelogram["drivers"]["A"]["position"] = phi;
    for (const Json& scene : {parallelogram, slider}) {
      const Solved found = solved(scene);
      ASSERT_FALSE(found.configurations().empty());
      for (const Configuration& configuration : found.configurations()) {
        const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
        EXPECT_TRUE(std::isnan(forces.efforts[mechanism::DriverIndex(0)]));
        EXPECT_EQ(std::ranges::count_if(forces.joints, &mechanism::JointForce::is_determined), 0);
        EXPECT_FALSE(forces.reason.empty());
      }
    }
  }
}

/// Along a branch the turns of a spring at a pin count: the work of the driver is the energy that
/// spring and torque take up.
TEST(Forces, OfASpringCountItsTurnsAlongABranch) {
  const Json scene = turning_spring();
  const double turn = 2 * std::numbers::pi;
  for (const std::size_t branch : {1U, 2U}) {
    const std::vector<double> efforts = efforts_along(scene, branch);
    ASSERT_EQ(efforts.size(), 721U);
    const double work = (std::accumulate(efforts.begin(), efforts.end(), 0.0) -
                         (efforts.front() + efforts.back()) / 2) *
                        (2 * turn / 720);
    Json first = scene;
    first.erase("sweep");
    const Solved begin = solved(first);
    const auto& rocker = begin.configurations()[branch - 1].link("rocker").pose.direction;
    const double angle = angle_of(rocker);
    const auto energy = [&](double turned) {
      const double deflection = std::remainder(angle - 0.2, turn) + turned;
      return deflection * deflection + 1.5 * (angle + turned) * (angle + turned);
    };
    EXPECT_NEAR(work, energy(2 * turn) - energy(0), 1e-3 * energy(2 * turn));
    for (std::size_t row = 1; row < efforts.size(); ++row) {
      EXPECT_LT(std::abs(efforts[row] - efforts[row - 1]), 2);  // a turn lost would make it 31
    }
  }
}

/// The turns also count where the spring's rest angle follows the swept parameter, and beyond the
/// limits of joints, where there are no rows.
TEST(Forces, OfASpringCountTurnsThatNoRowShows) {
  Json scene = turning_spring();
  scene["springs"]["S"]["rest"] = "phi";
  for (const std::size_t branch : {1U, 2U}) {
    const std::vector<double> efforts = efforts_along(scene, branch);
    for (std::size_t row = 1; row < efforts.size(); ++row) {
      EXPECT_LT(std::abs(efforts[row] - efforts[row - 1]), 2);
    }
  }
  struct Row {
    double parameter, angle, effort;
  };
  const auto rows_of = [](const Json& json) {
    const mechanism::Plan plan(mechanism::parse_scene(json.dump(), "scene.json"));
    mechanism::Values values = plan.values();
    std::vector<Row> rows;
    (void)mechanism::sweep(
        plan, {[&](const mechanism::SweepRecord& record) {
                 if (record.event.empty()) {
                   values.set(plan.request().sweep->parameter, record.parameter);
                   rows.push_back(
                       {record.parameter, angle_of(record.state->link("rocker").pose.direction),
                        mechanism::forces_of(values, *record.state).efforts.items().front()});
                 }
               },
               nullptr, nullptr});
    return rows;
  };
  scene = turning_spring();
  scene["sweep"]["count"] = 145;
  const std::vector<Row> all = rows_of(scene);
  scene["joints"]["D"]["limits"] = {-3, 0};
  const std::vector<Row> some = rows_of(scene);
  EXPECT_EQ(all.size(), 290U);
  EXPECT_GT(some.size(), 100U);
  EXPECT_LT(some.size(), 200U);
  for (const Row& row : some) {
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Row& other) {
      return other.parameter == row.parameter && std::abs(other.angle - row.angle) < 1e-9 &&
             std::abs(other.effort - row.effort) < 1e-9;
    })) << row.parameter;
  }
}

/// Where a parallelogram lies in one line, nothing balances a load across it: beside this place the
/// forces along the line grow without bound, and turn the crank in either sense as the branch is.
/// What a dyad on its coupler bears does not depend on it.
TEST(Forces, ThatDependOnTheWayToAChangePointAreNotTold) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0], "N": [6, 4]},
      "one": {"A": [0, 0], "B": [2, 0]}, "bar": {"B": [0, 0], "C": [4, 0], "M": [2, 1]},
      "two": {"D": [0, 0], "C": [2, 0]}, "r": {"M": [0, 0], "O": [3, 0]},
      "s": {"N": [0, 0], "O": [4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["one.B", "bar.B"]},
      "C": {"type": "revolute", "between": ["bar.C", "two.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "two.D"]},
      "M": {"type": "revolute", "between": ["bar.M", "r.M"]},
      "N": {"type": "revolute", "between": ["ground.N", "s.N"]},
      "O": {"type": "revolute", "between": ["r.O", "s.O"]}},
    "drivers": {"A": {"position": 0}}, "gravity": [0, -9.81],
    "masses": {"bar": {"mass": 2, "at": [1, 0.5]}, "two": {"mass": 1.5, "at": [0.7, 0.1]},
      "r": {"mass": 1, "at": [1, 0]}},
    "want": ["position", "forces"]})");
  const auto forces_at = [&](double phi) {
    scene["drivers"]["A"]["position"] = phi;
    const Solved found = solved(scene);
    std::vector<mechanism::Forces> all;
    for (const Configuration& configuration : found.configurations()) {
      all.push_back(mechanism::forces_of(found.values, configuration));
    }
    return all;
  };
  const auto force_in = [](const mechanism::Forces& forces, const char* joint) {
    return std::ranges::find(forces.joints, joint, &mechanism::JointForce::joint)->on[1].second;
  };
  const std::vector<mechanism::Forces> beside = forces_at(1e-4);
  const std::vector<mechanism::Forces> there = forces_at(0);
  ASSERT_EQ(beside.size(), 4U);
  ASSERT_EQ(there.size(), 2U);
  double least = beside[0].efforts[mechanism::DriverIndex(0)];
  double most = least;
  for (const mechanism::Forces& forces : beside) {
    least = std::min(least, forces.efforts[mechanism::DriverIndex(0)]);
    most = std::max(most, forces.efforts[mechanism::DriverIndex(0)]);
  }
  EXPECT_GT(most - least, 50);
  for (const mechanism::Forces& forces : there) {
    EXPECT_TRUE(std::isnan(forces.efforts[mechanism::DriverIndex(0)]));
    EXPECT_FALSE(force_in(forces, "B").allFinite());
    double nearest = 1;
    for (const mechanism::Forces& other : beside) {
      nearest = std::min(nearest, (force_in(forces, "M") - force_in(other, "M")).norm());
    }
    EXPECT_LT(nearest, 1e-2);
    EXPECT_TRUE(force_in(forces, "N").allFinite());
  }
  // Where the dyad is stretched, too, all is still at rest: the ground carries the weight.
  scene["links"]["ground"]["N"] = {11, 1};
  const std::vector<mechanism::Forces> stretched = forces_at(0);
  EXPECT_FALSE(stretched.empty());
  for (const mechanism::Forces& forces : stretched) {
    EXPECT_FALSE(force_in(forces, "N").allFinite());
    EXPECT_NEAR(forces.ground.force.y(), -4.5 * 9.81, 1e-12);
  }
}

}  // namespace
}  // namespace assur::test::special_forces_test
