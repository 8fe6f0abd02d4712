// Law: reported forces keep every link in equilibrium, transmit nothing along slides, add up to the
// ground's resultant, and agree with the equations of motion.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/mechanism/force_columns.hpp>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "largest.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/equilibrium.hpp"
#include "mechanism/kind_scene.hpp"
#include "mechanism/loaded_scene.hpp"
#include "mechanism/scene_solutions.hpp"
#include "mechanism/turning_spring.hpp"

namespace assur::test::forces_test {
namespace {

struct Largest {
  int configurations = 0, undetermined = 0;
  double unbalanced = 0, along_lines = 0, ground = 0, motion = 0;
};

void check(const Solved& scene, Largest& most) {
  const mechanism::Mechanism& mechanism = scene.plan.mechanism();
  for (const Configuration& configuration : scene.configurations()) {
    if (configuration.regularity != Status::ok || !configuration.rates_known) {
      continue;
    }
    const mechanism::Forces forces = mechanism::forces_of(scene.values, configuration);
    const LinkSums sums(mechanism, scene.values, configuration, forces);
    if (!forces.reason.empty() || !std::isfinite(sums.largest())) {
      ++most.undetermined;
      continue;
    }
    ++most.configurations;
    const double unit = std::max(1.0, sums.largest());
    for (const mechanism::LinkIndex link : mechanism.links().keys()) {
      Eigen::Vector3d left = sums.on(link);
      if (link == mechanism.ground()) {
        left.head<2>() -= forces.ground.force;
        left(2) -= forces.ground.moment;
        most.ground = largest(most.ground, left.norm() / unit);
      } else {
        most.unbalanced = largest(most.unbalanced, left.norm() / unit);
      }
    }
    most.along_lines = largest(most.along_lines, sums.along_lines() / unit);
    const mechanism::Dynamics dynamics = mechanism::dynamics_of(scene.values, configuration);
    const auto count = std::ssize(dynamics.drivers);
    Eigen::VectorXd accelerations(count);
    Eigen::VectorXd efforts(count);
    for (Eigen::Index place = 0; place < count; ++place) {
      const auto driver = dynamics.drivers[static_cast<std::size_t>(place)];
      accelerations(place) = scene.values.motion(driver).acceleration;
      efforts(place) = forces.efforts[driver];
    }
    const Eigen::VectorXd asked =
        dynamics.mass_matrix * accelerations + dynamics.bias - dynamics.load;
    if (count > 0) {
      most.motion = largest(most.motion, (asked - efforts).cwiseAbs().maxCoeff() / unit);
    }
  }
}

void expect_small(const Largest& most) {
  std::cout << most.configurations << " configurations, " << most.undetermined
            << " not determined; unbalanced " << most.unbalanced << ", along lines "
            << most.along_lines << ", ground " << most.ground << ", equations of motion "
            << most.motion << "\n";
  EXPECT_GT(most.configurations, 0);
  EXPECT_LT(most.unbalanced, 1e-10);
  EXPECT_LT(most.along_lines, 1e-10);
  EXPECT_LT(most.ground, 1e-10);
  EXPECT_LT(most.motion, 1e-8);
}

class ForcesOfKinds : public testing::TestWithParam<std::size_t> {};

/// Every kind of a group, held by the ground.
TEST_P(ForcesOfKinds, KeepLinksInEquilibrium) {
  Largest most;
  const mechanism::GroupModels& group = mechanism::known_groups()[GetParam()];
  const std::vector<ModelLink> links(group.structure.link_count());
  unsigned seed = 4711;
  int kinds = 0;
  for (const mechanism::GroupModel& model : group.models) {
    for (const std::string& kind : model.rigid ? model.kinds : std::vector<std::string>()) {
      SCOPED_TRACE(kind);
      const KindBodies bodies(group.structure.joints, links, {}, kind.c_str(), ++seed);
      std::vector<std::size_t> link_order(links.size());
      std::vector<std::size_t> joint_order(group.structure.joints.size());
      std::iota(link_order.begin(), link_order.end(), 0U);
      std::iota(joint_order.begin(), joint_order.end(), 0U);
      check(solved(loaded(Json::parse(scene_text(bodies, link_order, joint_order)), seed)), most);
      ++kinds;
    }
  }
  std::cout << group.structure.name << ": " << kinds << " kinds, seeds from 4712: ";
  expect_small(most);
  EXPECT_EQ(most.undetermined, 0);
}

INSTANTIATE_TEST_SUITE_P(All, ForcesOfKinds,
                         testing::Range(std::size_t{0}, mechanism::known_groups().size()));

class ForcesOfScenes : public DrivenScenes {};

TEST_P(ForcesOfScenes, KeepLinksInEquilibrium) {
  for (const Places places : {Places::anywhere, Places::lattice}) {
    Largest most;
    for_each_scene(12, 300, places, [&](const RandomDrivenScene& made, unsigned seed) {
      check(solved(loaded(made.scene(), seed)), most);
    });
    expect_small(most);
    // On a lattice the ends of a spring may coincide, which leaves it no direction.
    EXPECT_TRUE(places == Places::lattice || most.undetermined == 0) << most.undetermined;
  }
}

/// The scene with parameters at rest, and with drivers that follow their laws where these read
/// joints.
Json at_rest(Json scene) {
  for (auto& [name, parameter] : scene["parameters"].items()) {
    if (parameter.is_object()) {
      parameter.erase("velocity");
      parameter.erase("acceleration");
    }
  }
  double rate = 0.7;
  for (auto& [name, driver] : scene["drivers"].items()) {
    driver.erase("velocity");
    driver.erase("acceleration");
    if (driver["position"].dump().find("joint(") == std::string::npos) {
      driver["velocity"] = rate = 1.3 - rate;
      driver["acceleration"] = rate - 1;
    }
  }
  scene["want"] = {"position", "velocity", "acceleration", "coefficients"};
  return scene;
}

/// Rates by the chain rule from the coefficients and the rates of the drivers.
template <int Coordinates>
std::array<Eigen::Matrix<double, Coordinates, 1>, 2> rates_by_chain_rule(
    const mechanism::Derivatives<Coordinates>& of, const Eigen::VectorXd& rate,
    const Eigen::VectorXd& second_rate) {
  Eigen::Matrix<double, Coordinates, 1> acceleration = of.first * second_rate;
  for (std::size_t row = 0; row < Coordinates; ++row) {
    acceleration(static_cast<Eigen::Index>(row)) += rate.dot(of.second[row] * rate);
  }
  return {of.first * rate, acceleration};
}

/// The group solver's velocities and accelerations follow from the coefficients of all bodies.
TEST_P(ForcesOfScenes, HaveCoefficientsThatGiveTheRates) {
  double worst = 0;
  int count = 0;
  for_each_scene(12, 300, Places::anywhere, [&](const RandomDrivenScene& made, unsigned) {
    const Solved scene = solved(at_rest(made.scene()));
    for (const Configuration& configuration : scene.configurations()) {
      if (configuration.regularity != Status::ok || !configuration.rates_known) {
        continue;
      }
      const mechanism::KinematicCoefficients all =
          mechanism::coefficients_of(scene.values, configuration);
      Eigen::VectorXd rate(std::ssize(all.drivers));
      Eigen::VectorXd second_rate(std::ssize(all.drivers));
      for (std::size_t place = 0; place < all.drivers.size(); ++place) {
        const auto row = static_cast<Eigen::Index>(place);
        rate(row) = scene.values.motion(all.drivers[place]).velocity;
        second_rate(row) = scene.values.motion(all.drivers[place]).acceleration;
      }
      double size = 1;
      for (const mechanism::Frame& link : configuration.links) {
        size = std::max({size, link.velocity.norm(), link.acceleration.norm()});
      }
      const auto compare = [&](const auto& told, const auto& velocity, const auto& acceleration) {
        const auto [first, second] = rates_by_chain_rule(told, rate, second_rate);
        worst = largest(worst, (first - velocity).norm() / size);
        worst = largest(worst, (second - acceleration).norm() / size);
      };
      for (const mechanism::LinkIndex link : configuration.links.keys()) {
        const mechanism::Frame& frame = configuration.links[link];
        compare(all.links[link], frame.velocity, frame.acceleration);
      }
      for (const mechanism::OutputIndex output : configuration.outputs.keys()) {
        const mechanism::Point& point = configuration.outputs[output];
        compare(all.outputs[output], point.velocity, point.acceleration);
      }
      for (const mechanism::SlideState& slide : configuration.slides) {
        using One = Eigen::Matrix<double, 1, 1>;
        const std::string& name = scene.plan.mechanism().joints()[slide.joint].name;
        const auto joint =
            std::ranges::find(all.joints, name, &mechanism::JointCoefficients::joint);
        compare(joint->coordinate, One(slide.velocity), One(slide.acceleration));
      }
      ++count;
    }
  });
  std::cout << count << " configurations, rates from coefficients " << worst << "\n";
  EXPECT_GT(count, 0);
  EXPECT_LT(worst, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Ties, ForcesOfScenes,
                         testing::Values(Ties::drivers, Ties::groups,
                                         Ties::drivers_in_larger_groups),
                         name_of_ties);

/// A crank of length a with a rod of length b that pushes a block along the x-axis, by hand: a
/// force F against the block needs the torque F a (sin phi + a sin phi cos phi / sqrt(b^2 - a^2
/// sin^2)).
TEST(Forces, OfASliderCrankAreThoseOnPaper) {
  const double a = 3;
  const double b = 5;
  const double phi = std::atan2(4.0, 3.0);
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [3, 0]}, "rod": {"B": [0, 0], "C": [5, 0]},
      "block": {"C": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "block.C"]},
      "S": {"type": "prismatic", "between": ["ground.way", "block.way"]}},
    "loads": {"gas": {"at": "block.C", "force": [-10, 0]}}, "want": ["position", "forces"]})");
  scene["drivers"]["A"] = {{"position", phi}};
  const Solved found = solved(scene);
  const double sine = a * std::sin(phi);
  for (const Configuration& configuration : found.configurations()) {
    const double sense = configuration.link("block").pose.x > 1 ? 1 : -1;
    const double root = sense * std::sqrt(b * b - sine * sine);
    const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
    const double torque = -10 * (sine + sine * a * std::cos(phi) / root);
    EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], torque, 1e-12);
    EXPECT_NEAR(forces.joints[3].on.back().second.y(), 10 * sine / root, 1e-12);
    EXPECT_NEAR(forces.joints[3].moment, 0, 1e-12);
    EXPECT_NEAR(forces.ground.force.x(), -10, 1e-12);
  }
}

/// Marghitu, Mechanisms and Robots Analysis with MATLAB (Springer 2009), section 4.5: a
/// slider-crank with AB = BC = 1 m at 45 degrees and 1 rad/s, links of 1 kg, g = 10 m/s^2, and 100
/// N against the slider. Equations 4.51 and 4.52 give the force of the crank on the rod, and the
/// crank alone gives the reaction at A and the moment.
TEST(Forces, OfASliderCrankAreThosePrintedByMarghitu) {
  const Json scene = Json::parse(R"({
    "parameters": {"phi": "45*deg"},
    "links": {"ground": {"A": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [1, 0]},
      "slider": {"C": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "slider.C"]},
      "S": {"type": "prismatic", "between": ["ground.way", "slider.way"]}},
    "drivers": {"A": {"position": "phi", "velocity": 1}},
    "gravity": [0, -10],
    "masses": {"crank": {"mass": 1, "at": [0.5, 0], "inertia": 0.0833417},
      "rod": {"mass": 1, "at": [0.5, 0], "inertia": 0.0833417}, "slider": {"mass": 1}},
    "loads": {"external": {"at": "slider.C", "force": [100, 0]}},
    "want": ["position", "velocity", "acceleration", "forces"]})");
  const Solved found = solved(scene);
  const double root = std::sqrt(2.0);
  int compared = 0;
  for (const Configuration& configuration : found.configurations()) {
    if (configuration.link("slider").pose.x < 1) {
      continue;  // the rod lies on the crank
    }
    const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
    const Eigen::Vector2d printed(-(400 + 7 * root) / 4, 5 * (84 + root) / 4);
    EXPECT_LT((forces.joints[1].on.back().second - printed).norm(), 1e-11);
    const Eigen::Vector2d at_A = printed + Eigen::Vector2d(-root / 4, 10 - root / 4);
    EXPECT_LT((forces.joints[0].on.back().second - at_A).norm(), 1e-11);
    const double moment = root / 2 * (printed.y() - printed.x()) + 10 * root / 4;
    EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], moment, 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 1);
}

/// A crank that pushes a block on a guide, with a spring, a load and masses, in units of length and
/// force, turned by an angle. With `exchanged`, all features of `between` are exchanged.
Json pushed_block(double length, double force, double angle, bool exchanged) {
  const auto place = [&](double x, double y) { return Json{length * x, length * y}; };
  const auto turned = [&](double size, double x, double y) {
    return Json{size * (std::cos(angle) * x - std::sin(angle) * y),
                size * (std::sin(angle) * x + std::cos(angle) * y)};
  };
  Json scene;
  scene["links"]["ground"] = {
      {"A", turned(length, 0.1, 0.2)},
      {"E", turned(length, 2, 3)},
      {"way", {{"through", turned(length, 1, -0.3)}, {"along", turned(1, 4, 1)}}}};
  scene["links"]["crank"] = {{"A", place(0, 0)}, {"B", place(1, 0)}};
  scene["links"]["rod"] = {{"B", place(0, 0)}, {"C", place(3, 0)}, {"P", place(1, 0.5)}};
  scene["links"]["block"] = {{"C", place(0.2, 0.1)},
                             {"way", {{"through", place(0.4, 0)}, {"along", {1, 0}}}}};
  const auto joint = [&](const char* type, const char* one, const char* other) {
    return Json{{"type", type}, {"between", exchanged ? Json{other, one} : Json{one, other}}};
  };
  scene["joints"] = {{"A", joint("revolute", "ground.A", "crank.A")},
                     {"B", joint("revolute", "crank.B", "rod.B")},
                     {"C", joint("revolute", "rod.C", "block.C")},
                     {"S", joint("prismatic", "ground.way", "block.way")}};
  const double sense = exchanged ? -1 : 1;
  scene["drivers"]["A"] = {
      {"position", sense * (0.7 + angle)}, {"velocity", sense * 2}, {"acceleration", sense * -3}};
  scene["gravity"] = turned(9.81 * length, 0, -1);
  const double mass = force / length;
  scene["masses"] = {
      {"crank", {{"mass", mass}, {"at", place(0.5, 0)}, {"inertia", 0.2 * mass * length * length}}},
      {"rod", {{"mass", 2 * mass}, {"at", "P"}, {"inertia", 0.7 * mass * length * length}}},
      {"block", {{"mass", 1.5 * mass}}}};
  scene["loads"] = {{"F", {{"at", "block.C"}, {"force", turned(force, -5, 1)}}},
                    {"M", {{"on", "rod"}, {"moment", 3 * force * length}}}};
  scene["springs"] = {{"K",
                       {{"between", {"ground.E", "rod.P"}},
                        {"stiffness", 4 * force / length},
                        {"length", 0.5 * length},
                        {"damping", 0.3 * force / length}}}};
  scene["want"] = {"position", "velocity", "acceleration", "forces"};
  return scene;
}

/// The scene with its parts in the opposite order.
Json listed_backward(Json scene) {
  for (const char* part : {"links", "joints", "masses", "loads"}) {
    std::vector<std::string> names;
    for (const auto& [name, entry] : scene[part].items()) {
      names.insert(names.begin(), name);
    }
    Json backward = Json::object();
    for (const std::string& name : names) {
      backward[name] = scene[part][name];
    }
    scene[part] = backward;
  }
  return scene;
}

/// Forces of the same block in other units, turned, in another order, or with exchanged features
/// are the same.
TEST(Forces, DoNotDependOnHowTheSceneIsDescribed) {
  struct Described {
    double length, force, angle;
    bool exchanged;
  };
  const Solved plain = solved(pushed_block(1, 1, 0, false));
  ASSERT_EQ(plain.configurations().size(), 2U);
  double worst = 0;
  for (const Described& way :
       {Described{1, 1, 0, true}, Described{1000, 1, 0, false}, Described{1, 1e-3, 0, false},
        Described{1, 1, 2.1, false}, Described{0.01, 7, -0.8, true}}) {
    const Json scene = pushed_block(way.length, way.force, way.angle, way.exchanged);
    const Solved other = solved(way.exchanged ? listed_backward(scene) : scene);
    ASSERT_EQ(other.configurations().size(), 2U);
    const Eigen::Rotation2Dd turn(way.angle);
    for (const Configuration& one : plain.configurations()) {
      double nearest = std::numeric_limits<double>::infinity();
      const mechanism::Forces expected = mechanism::forces_of(plain.values, one);
      for (const Configuration& here : other.configurations()) {
        const mechanism::Forces told = mechanism::forces_of(other.values, here);
        const double sense = way.exchanged ? -1 : 1;
        const double couple = way.force * way.length;
        const mechanism::DriverIndex driver(0);
        double away = std::abs(told.efforts[driver] / couple - sense * expected.efforts[driver]);
        for (const mechanism::JointForce& joint : expected.joints) {
          const auto same =
              std::ranges::find(told.joints, joint.joint, &mechanism::JointForce::joint);
          away = largest(
              away, (same->on.back().second / way.force - sense * (turn * joint.on.back().second))
                        .norm());
        }
        away = largest(away, (told.ground.force / way.force - turn * expected.ground.force).norm());
        away = largest(away, std::abs(told.ground.moment / couple - expected.ground.moment));
        nearest = std::min(nearest, away);
      }
      worst = largest(worst, nearest);
    }
  }
  std::cout << "by descriptions " << worst << "\n";
  EXPECT_LT(worst, 1e-11);
}

/// A four-bar that turns freely: with the accelerations that its equations of motion give, its
/// energy changes by what the integrator, of the fourth order, leaves out.
TEST(Forces, OfEquationsOfMotionKeepTheEnergy) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "crank": {"A": [0, 0], "B": [1, 0]},
      "coupler": {"B": [0, 0], "C": [3.5, 0], "G": [1.5, 0.4]},
      "rocker": {"D": [0, 0], "C": [3, 0], "H": [1.5, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
      "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "outputs": {"G": "coupler.G", "H": "rocker.H"}, "gravity": [0, -9.81],
    "masses": {"crank": {"mass": 0, "inertia": 3},
      "coupler": {"mass": 1.2, "at": "G", "inertia": 0.8},
      "rocker": {"mass": 0.9, "at": "H", "inertia": 0.6}},
    "want": ["position", "velocity", "acceleration", "dynamics"]})");
  struct Motion {
    double acceleration, energy;
  };
  const auto motion_at = [&](double angle, double rate) {
    scene["drivers"]["A"] = {{"position", angle}, {"velocity", rate}};
    const Solved found = solved(scene);
    for (const Configuration& at : found.configurations()) {
      const auto& coupler = at.link("coupler").pose;
      // The rocker's end lies on the left of the way from B to D.
      if (coupler.direction.sin * (4 - coupler.x) + coupler.direction.cos * coupler.y < 0) {
        continue;
      }
      const mechanism::Dynamics of = mechanism::dynamics_of(found.values, at);
      const auto energy = [](double mass, double inertia, const mechanism::Point& centre,
                             double turning) {
        return mass * (centre.velocity.squaredNorm() / 2 + 9.81 * centre.position.y()) +
               inertia * turning * turning / 2;
      };
      return Motion{(of.load(0) - of.bias(0)) / of.mass_matrix(0, 0),
                    1.5 * rate * rate +
                        energy(1.2, 0.8, at.output("G"), at.link("coupler").velocity(2)) +
                        energy(0.9, 0.6, at.output("H"), at.link("rocker").velocity(2))};
    }
    ADD_FAILURE() << angle;
    return Motion{0, 0};
  };
  std::vector<double> drifts;
  for (const int steps : {20, 40, 80}) {
    const double h = 1.0 / steps;
    double angle = 0.5;
    double rate = 5;
    const double start = motion_at(angle, rate).energy;
    for (int step = 0; step < steps; ++step) {
      const double a1 = motion_at(angle, rate).acceleration;
      const double v2 = rate + h / 2 * a1;
      const double a2 = motion_at(angle + h / 2 * rate, v2).acceleration;
      const double v3 = rate + h / 2 * a2;
      const double a3 = motion_at(angle + h / 2 * v2, v3).acceleration;
      const double v4 = rate + h * a3;
      const double a4 = motion_at(angle + h * v3, v4).acceleration;
      angle += h / 6 * (rate + 2 * v2 + 2 * v3 + v4);
      rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    drifts.push_back(std::abs(motion_at(angle, rate).energy - start));
  }
  std::cout << "energy drifts by " << drifts[0] << ", " << drifts[1] << ", " << drifts[2] << "\n";
  EXPECT_GT(drifts[2], 0);
  EXPECT_GT(drifts[0], 12 * drifts[1]);
  EXPECT_GT(drifts[1], 12 * drifts[2]);
}

/// Beer, Johnston and Mazurek, Vector Mechanics for Engineers, Statics, 12th edition, problems
/// 10.21(a) and 10.22(a): an engine with AB = 50 mm and BC = 200 mm. With the crank at 30 degrees a
/// force of 4 kN on the piston is held by a couple of 121.8 N m; at 60 degrees a couple of 100 N m
/// holds 2.05 kN.
TEST(Forces, OfAnEngineAreThosePrintedByBeerAndJohnston) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [0.05, 0]}, "rod": {"B": [0, 0], "C": [0.2, 0]},
      "piston": {"C": [0, 0], "way": {"through": [0, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "piston.C"]},
      "S": {"type": "prismatic", "between": ["ground.way", "piston.way"]}},
    "want": ["position", "forces"]})");
  const auto effort = [&](const char* joint, double position, const char* loads) {
    scene["drivers"] = {{joint, {{"position", position}}}};
    scene["loads"] = Json::parse(loads);
    const Solved found = solved(scene);
    std::vector<double> efforts;
    for (const Configuration& configuration : found.configurations()) {
      if (configuration.link("piston").pose.x > 0.1) {
        efforts.push_back(std::abs(
            mechanism::forces_of(found.values, configuration).efforts[mechanism::DriverIndex(0)]));
      }
    }
    return efforts;
  };
  const double degree = std::numbers::pi / 180;
  const std::vector<double> couple =
      effort("A", 30 * degree, R"({"gas": {"at": "piston.C", "force": [-4000, 0]}})");
  ASSERT_EQ(couple.size(), 1U);
  EXPECT_NEAR(couple[0], 121.8, 0.05);
  const double stroke = 0.05 / 2 + std::sqrt(0.04 - 0.0025 * 0.75);
  const std::vector<double> force =
      effort("S", stroke, R"({"couple": {"on": "crank", "moment": 100}})");
  ASSERT_EQ(force.size(), 2U);  // the crank above and below the line
  EXPECT_NEAR(force[0], 2050, 5);
  EXPECT_NEAR(force[1], 2050, 5);
}

/// Beer and Johnston, Vector Mechanics for Engineers, Statics, problem 6.133(a): the Whitworth
/// mechanism with the crank AB, 0.1 m, in line with the slotted member CD, which B divides at 0.5 m
/// from C. The solution finds that the slot pushes the block with 1680 N against 1200 N across CD
/// at 0.7 m from C, so that the couple at A is 1680 N times 0.1 m.
TEST(Forces, OfAWhitworthMechanismAreThosePrintedByBeerAndJohnston) {
  const Solved found = solved(Json::parse(R"({
    "links": {"ground": {"A": [0, 0.4], "C": [0, 0]}, "crank": {"A": [0, 0], "B": [0.1, 0]},
      "member": {"C": [0, 0], "D": [0.7, 0], "slot": {"through": [0, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "pin-in-slot", "between": ["member.slot", "crank.B"]},
      "C": {"type": "revolute", "between": ["ground.C", "member.C"]}},
    "drivers": {"A": {"position": "90*deg"}},
    "loads": {"P": {"at": "member.D", "force": [0, 1200], "frame": "member"}},
    "want": ["position", "forces"]})"));
  ASSERT_FALSE(found.configurations().empty());
  for (const Configuration& configuration : found.configurations()) {
    const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
    const auto block = std::ranges::find(forces.joints, "B", &mechanism::JointForce::joint);
    EXPECT_NEAR(block->on[1].second.norm(), 1680, 1e-9);
    EXPECT_NEAR(std::abs(forces.efforts[mechanism::DriverIndex(0)]), 168, 1e-10);
  }
}

/// Three equal cranks, of which the joints of one are left out: all have coefficients by the angle
/// of the first, and the order of `between` tells on which link a force acts.
TEST(Forces, OfRedundantJointsFollowTheOrderOfBetween) {
  int turned = 0;
  for (const bool is_turned : {false, true}) {
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
      "drivers": {"A": {"position": 0.5}}, "want": ["position", "forces", "coefficients"]})");
    for (auto& joint : scene["joints"]) {
      if (is_turned && joint["between"][0] != "ground.A") {
        std::swap(joint["between"][0], joint["between"][1]);
      }
    }
    const Solved found = solved(scene);
    ASSERT_EQ(found.plan.redundant().size(), 1U);
    const double sense = is_turned ? -1 : 1;
    for (const Configuration& configuration : found.configurations()) {
      if (!configuration.is_consistent) {
        continue;
      }
      const mechanism::KinematicCoefficients all =
          mechanism::coefficients_of(found.values, configuration);
      const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
      for (const char* name : {"B", "C", "D", "E", "F"}) {
        const auto of = std::ranges::find(all.joints, name, &mechanism::JointCoefficients::joint);
        ASSERT_NE(of, all.joints.end()) << name;
        const bool is_crank = std::string(name) == "B" || std::string(name) == "C";
        EXPECT_NEAR(of->coordinate.first(0, 0), is_crank ? sense : -sense, 1e-13) << name;
        EXPECT_NEAR(of->coordinate.second[0](0, 0), 0, 1e-12) << name;
        const auto& force = *std::ranges::find(forces.joints, name, &mechanism::JointForce::joint);
        for (std::size_t place = 0; place < 2; ++place) {
          const std::string end = scene["joints"][name]["between"][place];
          EXPECT_EQ(found.plan.mechanism().links()[force.on[place].first].name,
                    end.substr(0, end.find('.')))
              << name;
          ++turned;
        }
      }
    }
  }
  EXPECT_GE(turned, 20);
}

/// A wedge lifts a follower by half of its own motion; one of its three slides is half left out.
TEST(Forces, OfAWedgeHaveCoefficientsAtAllSlides) {
  const Json scene = Json::parse(R"({
    "links": {"ground": {"floor": {"through": [0, 0], "along": [1, 0]},
        "wall": {"through": [1, 0], "along": [0, 1]}},
      "wedge": {"floor": {"through": [0, 0], "along": [1, 0]},
        "slope": {"through": [0, 0.2], "along": [2, 1]}},
      "follower": {"slope": {"through": [0, 0], "along": [2, 1]},
        "wall": {"through": [0, 0], "along": [0, 1]}}},
    "joints": {"floor": {"type": "prismatic", "between": ["ground.floor", "wedge.floor"]},
      "slope": {"type": "prismatic", "between": ["wedge.slope", "follower.slope"]},
      "wall": {"type": "prismatic", "between": ["ground.wall", "follower.wall"]}},
    "drivers": {"floor": {"position": 0.7}}, "gravity": [0, -10], "masses": {"follower": {"mass": 3}},
    "want": ["position", "forces", "coefficients"]})");
  const Solved found = solved(scene);
  ASSERT_EQ(found.configurations().size(), 1U);
  ASSERT_EQ(found.plan.redundant().size(), 1U);
  const Configuration& configuration = found.configurations()[0];
  const mechanism::KinematicCoefficients all =
      mechanism::coefficients_of(found.values, configuration);
  const std::vector<std::pair<std::string, double>> expected = {
      {"floor", 1}, {"slope", -std::sqrt(1.25)}, {"wall", -0.5}};
  ASSERT_EQ(all.joints.size(), expected.size());
  for (const auto& [name, slope] : expected) {
    const auto of = std::ranges::find(all.joints, name, &mechanism::JointCoefficients::joint);
    ASSERT_NE(of, all.joints.end()) << name;
    EXPECT_NEAR(of->coordinate.first(0, 0), slope, 1e-14) << name;
    EXPECT_NEAR(of->coordinate.second[0](0, 0), 0, 1e-13) << name;
  }
  const mechanism::Forces forces = mechanism::forces_of(found.values, configuration);
  EXPECT_NEAR(forces.efforts[mechanism::DriverIndex(0)], -15, 1e-12);
}

/// A link that turns freely is held at rest, and is no coordinate.
TEST(Forces, DoNotCountIdleLinksAsDrivers) {
  Json scene = example("crane.json");
  scene["links"]["washer"] = {"P", "Q"};
  scene["points"]["Q"] = {9, 9};
  scene["want"] = {"position", "forces", "dynamics", "coefficients"};
  const Solved found = solved(scene);
  const mechanism::Mechanism& mechanism = found.plan.mechanism();
  EXPECT_EQ(mechanism.drivers().size(), 2U);
  EXPECT_EQ(mechanism::described_drivers(mechanism).size(), 1U);
  const Configuration& configuration = found.configurations()[0];
  EXPECT_EQ(mechanism::dynamics_of(found.values, configuration).mass_matrix.rows(), 1);
  const mechanism::KinematicCoefficients all =
      mechanism::coefficients_of(found.values, configuration);
  EXPECT_EQ(all.drivers.size(), 1U);
  for (const mechanism::ForceColumn& column : mechanism::force_columns(found.plan)) {
    EXPECT_TRUE(column.part != "effort" || column.of == "cylinder") << column.of;
  }
}

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

/// Of two guides on one line the one that a load reads is kept, so that the other cannot be driven.
TEST(Forces, TellWhichJointsLoadsKeepFromBeingLeftOut) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"rail": {"through": [0, 0], "along": [1, 0]},
        "guide": {"through": [6, 0], "along": [1, 0]}},
      "piston": {"C": [0, 0], "shoe": {"through": [0.5, 0], "along": [1, 0]},
        "stem": {"through": [2, 0], "along": [1, 0]}}},
    "joints": {"S": {"type": "prismatic", "between": ["ground.rail", "piston.shoe"]},
      "T": {"type": "prismatic", "between": ["ground.guide", "piston.stem"]}},
    "drivers": {"S": {"position": 0.4}}, "want": ["position", "forces"]})");
  const auto pushed_by = [&](const char* formula) {
    scene["loads"]["P"] = {{"at", "piston.C"}, {"force", {formula, 0}}};
    return scene;
  };
  const Solved found = solved(pushed_by("-5*joint(S)"));
  EXPECT_NEAR(mechanism::forces_of(found.values, found.configurations()[0])
                  .efforts[mechanism::DriverIndex(0)],
              2, 1e-12);
  EXPECT_NE(message_of(pushed_by("-5*joint(T)"))
                .find("T cannot be left out, because laws or loads read the coordinate"),
            std::string::npos);
}

TEST(Forces, RefuseLoadsThatDoNotFit) {
  const Json scene = example("slider_crank.json");
  const auto message = [&](const char* key, const char* text) {
    Json changed = scene;
    changed[key] = Json::parse(text);
    return message_of(changed);
  };
  EXPECT_NE(message("masses", R"({"crnk": {"mass": 1}})").find("masses: no link named 'crnk'"),
            std::string::npos);
  EXPECT_NE(message("masses", R"({"crank": {"mass": -1}})").find("masses.crank.mass"),
            std::string::npos);
  Json press = example("rack_press.json");
  press["masses"] = Json::parse(R"({"ram": {"mass": 1, "at": "axis"}})");
  EXPECT_NE(message_of(press).find("is a line"), std::string::npos);
  EXPECT_NE(message("loads", R"({"F": {"at": "B", "force": [1, 0]}})").find("loads.F.at"),
            std::string::npos);
  Json negative = scene;  // a formula is negative at its values
  negative["masses"] = Json::parse(R"({"crank": {"mass": "crank - 1e6"}})");
  const Solved found = solved(negative);
  EXPECT_THROW((void)mechanism::forces_of(found.values, found.configurations()[0]),
               mechanism::MechanismError);
  EXPECT_NE(message("masses", R"({"crank": {"mass": 1, "inertia": -1}})")
                .find("masses.crank.inertia: the number is negative"),
            std::string::npos);
  EXPECT_NE(message("loads", R"({"F": {"on": "crnk", "moment": 1}})")
                .find("loads.F.on: no link named 'crnk' (did you mean 'crank'?)"),
            std::string::npos);
  // A load at a pin acts on one of its links.
  Json crane = example("crane.json");
  crane["loads"]["hook"]["at"] = "P";
  EXPECT_NE(message_of(crane).find("loads.hook.at: expected 'link.feature', found 'P'"),
            std::string::npos);
  crane["loads"]["hook"]["at"] = "A";
  EXPECT_NE(message_of(crane).find("found 'A' (did you mean '"), std::string::npos)
      << message_of(crane);
  EXPECT_NE(message("springs", R"({"K": {"between": ["rod.B", "rod.C"]}})")
                .find("both ends are on the same link"),
            std::string::npos);
  EXPECT_NE(message("want", R"(["force"])").find("no such result 'force'"), std::string::npos);
}

}  // namespace
}  // namespace assur::test::forces_test
