// Law: if points of a link coincide, regular configurations of its group have all rates, and first
// and second derivatives with respect to parameters that separate the points: those of rigid
// bodies.
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "mechanism/coinciding_points.hpp"
#include "mechanism/rigid_poses.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::zero_lengths {
namespace {

using namespace coinciding_points;

const std::vector<std::string> moved = {"s", "t", "u", "v", "r"};
using Rates = std::vector<double>;

/// The scene with second derivatives, and with parameters that move.
Json moving(Json scene, const Rates& rates) {
  for (std::size_t place = 0; place < moved.size(); ++place) {
    scene["parameters"][moved[place]] = {{"value", 0}, {"velocity", rates[place]}};
  }
  return with_unit_covariance(scene);
}

/// The least singular value of the constraints' Jacobian, relative to the largest.
Real firmness(const RigidScene& rigid, const RealVector& q) {
  const Eigen::JacobiSVD<RealMatrix> factors(rigid.jacobian(q));
  return factors.singularValues().tail<1>()(0) / factors.singularValues()(0);
}

struct Tally {
  int compared = 0, singular = 0;
  double velocity = 0, acceleration = 0, gradient = 0, hessian = 0;
};

/// A vector of one number for each moving coordinate of each link.
template <typename ValueOf>
RealVector of_links(const RigidScene& rigid, const Configuration& configuration,
                    const ValueOf& value_of) {
  RealVector result(rigid.size());
  for (const mechanism::LinkIndex link : configuration.links.keys()) {
    if (const Eigen::Index first = rigid.has(link) ? rigid.coordinate(link) : -1; first >= 0) {
      for (Eigen::Index row = 0; row < 3; ++row) {
        result(first + row) = value_of(configuration.links[link], row);
      }
    }
  }
  return result;
}

double apart(const RealVector& listed, const RealVector& truth) {
  return largest(0.0, static_cast<double>((listed - truth).cwiseAbs().maxCoeff() /
                                          (1 + truth.cwiseAbs().maxCoeff())));
}

void compare(const Solved& scene, const RigidScene& rigid, const Configuration& configuration,
             const Rates& rates, Tally& tally) {
  const RealVector listed = poses_of(rigid, configuration);
  const Real firm = firmness(rigid, listed);
  if (firm < 1e-3) {
    ++tally.singular;
    return;
  }
  EXPECT_EQ(configuration.regularity, Status::ok) << static_cast<double>(firm);
  ASSERT_TRUE(configuration.rates_known && configuration.derivatives_known);
  RealVector q = listed;
  (void)rigid.assemble(q, 4);
  const RealVector v = rigid.velocity(q);
  const RealVector a = rigid.acceleration(q, v);
  const Eigen::Map<const Eigen::VectorXd> along(rates.data(), std::ssize(rates));
  using mechanism::Frame;
  using Row = Eigen::Index;
  const auto of = [&](const auto& value_of) { return of_links(rigid, configuration, value_of); };
  const double velocity = apart(of([](const Frame& at, Row row) { return at.velocity(row); }), v);
  const double acceleration =
      apart(of([](const Frame& at, Row row) { return at.acceleration(row); }), a);
  const double gradient =
      apart(of([&](const Frame& at, Row row) { return at.follows.first.row(row).dot(along); }), v);
  const double hessian = apart(of([&](const Frame& at, Row row) {
                                 const auto& second =
                                     at.follows.second[static_cast<std::size_t>(row)];
                                 return along.dot(second * along);
                               }),
                               a);
  EXPECT_LT(velocity, 1e-9);
  EXPECT_LT(gradient, 1e-9);
  EXPECT_LT(acceleration, 1e-7);
  EXPECT_LT(hessian, 1e-7);
  for (const mechanism::SlideState& slide : configuration.slides) {
    const RigidScene::Jet truth =
        rigid.displacement(scene.plan.mechanism().joints()[slide.joint], q, v, a);
    const Real size = 1 + a.cwiseAbs().maxCoeff();
    EXPECT_LT(std::abs(slide.velocity - truth.c1), 1e-9L * size);
    EXPECT_LT(std::abs(slide.acceleration - 2 * truth.c2), 1e-7L * size);
    EXPECT_LT(std::abs(slide.follows.first.row(0).dot(along) - truth.c1), 1e-9L * size);
    EXPECT_LT(std::abs(along.dot(slide.follows.second[0] * along) - 2 * truth.c2), 1e-7L * size);
  }
  tally.velocity = largest(tally.velocity, velocity);
  tally.acceleration = largest(tally.acceleration, acceleration);
  tally.gradient = largest(tally.gradient, gradient);
  tally.hessian = largest(tally.hessian, hessian);
  ++tally.compared;
}

/// Moves each parameter by itself, and then all of them.
void check(const Json& scene, int listing, Tally& tally) {
  std::vector<Rates> motions;
  for (std::size_t place = 0; place < moved.size(); ++place) {
    motions.emplace_back(moved.size(), 0.0)[place] = 1;
  }
  motions.push_back({0.3, -0.7, 0.5, 1.1, -0.4});
  for (const Rates& rates : motions) {
    const Solved made = solved(scene_listed(moving(scene, rates), listing));
    const RigidScene rigid(made.plan.mechanism(), made.values);
    Rates sorted;
    for (const mechanism::ParameterIndex column : made.values.columns()) {
      const std::string& name = made.plan.mechanism().parameters()[column].name;
      sorted.push_back(
          rates[static_cast<std::size_t>(std::ranges::find(moved, name) - moved.begin())]);
    }
    for (const Configuration& configuration : made.configurations()) {
      compare(made, rigid, configuration, sorted, tally);
    }
  }
}

template <typename SceneOf>
void check_all(const SceneOf& scene_of, unsigned scenes, int least) {
  Tally tally;
  for (unsigned seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE(seed);
    check(scene_of(seed), static_cast<int>(seed) % listings, tally);
  }
  std::cout << tally.compared << " compared, " << tally.singular << " singular; velocities to "
            << tally.velocity << ", accelerations to " << tally.acceleration << ", gradients to "
            << tally.gradient << ", second derivatives to " << tally.hessian << '\n';
  EXPECT_GT(tally.compared, least);
}

TEST(ZeroLengths, OnBothLinksOfATetradHaveAllDerivatives) {
  check_all([](unsigned seed) { return tetrad(seed, false); }, 60, 300);
}

TEST(ZeroLengths, BesideASlideOfATetradHaveAllDerivatives) {
  check_all([](unsigned seed) { return tetrad(seed, true); }, 60, 200);
}

TEST(ZeroLengths, OfALinkOnThreeLegsHaveAllDerivatives) {
  for (const int slides : {0, 1, 2}) {
    SCOPED_TRACE(slides);
    check_all([slides](unsigned seed) { return triad(seed, slides); }, 40, 200);
  }
}

Json pin(const std::string& one, const std::string& other) {
  return {{"type", "revolute"}, {"between", {one, other}}};
}

/// The tetrad in which C coincides with B, and F with E.
Json small_tetrad(const Json& x, const Json& y) {
  SceneMaker scene;
  scene.point("ground", "B", 0, 0).point("ground", "E", 5, 1);
  scene.point("bcg", "B", 0, 0).point("bcg", "C", x, y).point("bcg", "G", 3, -1);
  scene.point("edf", "E", 0, 0).point("edf", "D", -1, 2).point("edf", "F", 0, 0);
  scene.bar("cd", {{"C", 0}, {"D", 3}}).bar("gf", {{"G", 0}, {"F", 3.5}});
  return scene.scene();
}

/// Derivatives are as good at small lengths, even if their squares vanish, as at zero.
TEST(ZeroLengths, AreTheLimitOfSmallLengths) {
  Tally tally;
  for (const double length : {0.0, 1e-300, 1e-160, 1e-100, 1e-15, 1e-12, 1e-8, 1e-4, 3e-3}) {
    SCOPED_TRACE(length);
    const auto text = [length](double part, const std::string& by) {
      std::array<char, 60> written{};
      (void)std::snprintf(written.data(), written.size(), "%.17g+%s", part * length, by.c_str());
      return Json(std::string(written.data()));
    };
    check(small_tetrad(text(0.6, "s"), text(-0.8, "t")), 0, tally);
  }
  EXPECT_GT(tally.compared, 9 * 6 * 3);
}

void check_driven(const Json& scene) {
  const Solved made = solved(scene);
  const RigidScene rigid(made.plan.mechanism(), made.values);
  ASSERT_EQ(made.configurations().size(), 4U);
  for (const Configuration& configuration : made.configurations()) {
    EXPECT_EQ(configuration.regularity, Status::ok);
    ASSERT_TRUE(configuration.rates_known);
    RealVector q = poses_of(rigid, configuration);
    ASSERT_TRUE(rigid.assemble(q));
    const RealVector v = rigid.velocity(q);
    const auto velocity = [](const mechanism::Frame& at, Eigen::Index row) {
      return at.velocity(row);
    };
    const auto acceleration = [](const mechanism::Frame& at, Eigen::Index row) {
      return at.acceleration(row);
    };
    EXPECT_LT(apart(of_links(rigid, configuration, velocity), v), 1e-10);
    EXPECT_LT(apart(of_links(rigid, configuration, acceleration), rigid.acceleration(q, v)), 1e-9);
  }
}

/// A driver carries a point of a link across another one, by a slide or on an arm.
TEST(ZeroLengths, ThatADriverSweepsHaveRates) {
  for (const double past : {0.0, 1e-200, 1e-16, -1e-12, 1e-9, -1e-6, 1e-4}) {
    SCOPED_TRACE(past);
    Json json = small_tetrad(0, 0);
    json["links"]["bcg"].erase("C");
    json["joints"]["C"]["between"] = {"arm.C", "cd.C"};
    json["outputs"]["C"] = "arm.C";
    Json slid = json;
    slid["links"]["bcg"]["P"] = {{"through", {-1, 0}}, {"along", {3, 4}}};
    slid["links"]["arm"] = {{"P", {{"through", {0, 0}}, {"along", {1, 0}}}}, {"C", {0.6, -0.8}}};
    slid["joints"]["P"] = {{"type", "prismatic"}, {"between", {"bcg.P", "arm.P"}}};
    slid["drivers"]["P"] = {{"position", past}, {"velocity", 0.7}, {"acceleration", 0.2}};
    check_driven(slid);
    Json turned = json;
    turned["links"]["bcg"]["P"] = {-2, 0};
    turned["links"]["arm"] = {{"P", {0, 0}}, {"C", {-2, 0}}};
    turned["joints"]["P"] = pin("bcg.P", "arm.P");
    turned["drivers"]["P"] = {
        {"position", std::acos(-1.0) + past}, {"velocity", 0.7}, {"acceleration", 0.2}};
    check_driven(turned);
  }
}

/// Whether the links of a scene stand and move as the first links of another one.
bool moves_as(const Configuration& configuration, const Configuration& alone) {
  double worst = 0;
  for (const mechanism::LinkIndex link : alone.links.keys()) {
    const mechanism::Frame& one = configuration.links[link];
    const mechanism::Frame& two = alone.links[link];
    worst = largest(worst, (one.velocity - two.velocity).norm());
    worst = largest(worst, (one.acceleration - two.acceleration).norm());
    worst = largest(worst, std::hypot(one.pose.x - two.pose.x, one.pose.y - two.pose.y));
    worst = largest(worst,
                    std::abs(angle_of(turned(one.pose.direction, reversed(two.pose.direction)))));
  }
  return worst < 1e-9;
}

/// Beside a parallelogram at its change point, which is listed once for each of its two motions.
TEST(ZeroLengths, HaveRatesBesideACrossing) {
  const Json rate = {{"value", 0}, {"velocity", 0.6}, {"acceleration", -0.3}};
  Json alone = small_tetrad("2*s", "s+s^2");
  alone["parameters"]["s"] = rate;
  Json both = alone;
  both["parameters"]["phi"] = 0;
  both["links"]["ground"]["K"] = {0, 0};
  both["links"]["ground"]["N"] = {4, 0};
  both["links"]["crank"] = {{"K", {0, 0}}, {"L", {1, 0}}};
  both["links"]["coupler"] = {{"L", {0, 0}}, {"M", {4, 0}}};
  both["links"]["rocker"] = {{"N", {0, 0}}, {"M", {1, 0}}};
  for (const auto& [name, one, other] :
       {std::array{"K", "ground", "crank"}, std::array{"L", "crank", "coupler"},
        std::array{"M", "coupler", "rocker"}, std::array{"N", "ground", "rocker"}}) {
    both["joints"][name] = pin(std::string(one) + "." + name, std::string(other) + "." + name);
  }
  both["drivers"]["K"] = {{"position", "phi"}, {"velocity", 2}, {"acceleration", 0}};
  const Solved truth = solved(alone);
  const Solved made = solved(both);
  ASSERT_EQ(truth.configurations().size(), 4U);
  ASSERT_EQ(made.configurations().size(), 4U);
  for (const Configuration& configuration : made.configurations()) {
    ASSERT_EQ(configuration.branches.size(), 2U);
    for (const Configuration& branch : configuration.branches) {
      EXPECT_TRUE(std::ranges::any_of(truth.configurations(), [&](const Configuration& other) {
        return moves_as(branch, other);
      }));
    }
  }
}

}  // namespace
}  // namespace assur::test::zero_lengths
