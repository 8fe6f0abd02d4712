// Law: reported forces keep every link in equilibrium, transmit nothing along slides, add up to the
// ground's resultant, and agree with the equations of motion.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
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
