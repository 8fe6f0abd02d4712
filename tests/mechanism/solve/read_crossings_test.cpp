// Law: a law that reads a joint at a change point gives its driver the rates of every motion
// through that point.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanism/bars.hpp"

namespace assur::test::read_crossings_test {
namespace {

constexpr double length = 1.5, base = 4, speed = 2, speeding_up = 0.5;

/// A parallelogram, and a hand on the ground that `hand` drives, with a dyad that it moves.
Bars parallelogram_with_hand(double phi, const Json& hand) {
  Bars bars;
  bars.json()["parameters"]["phi"] = phi;
  bars.json()["links"]["crank"]["B"] = {length, 0};
  bars.json()["drivers"]["A"] = {
      {"position", "phi"}, {"velocity", speed}, {"acceleration", speeding_up}};
  bars.point("ground", "D", base, 0).point("coupler", "B", 0, 0).point("coupler", "C", base, 0);
  bars.point("rocker", "D", 0, 0).point("rocker", "C", length, 0);
  bars.join("B", {"crank.B", "coupler.B"}).join("C", {"coupler.C", "rocker.C"});
  bars.join("D", {"ground.D", "rocker.D"});
  bars.point("ground", "H", 9, 0).point("hand", "H", 0, 0).point("hand", "T", 1, 0);
  bars.point("ground", "K", 12, 1).point("lever", "K", 0, 0).point("lever", "M", 2.5, 0);
  bars.point("arm", "T", 0, 0).point("arm", "M", 3, 0);
  bars.join("H", {"ground.H", "hand.H"}).join("T", {"hand.T", "arm.T"});
  bars.join("M", {"arm.M", "lever.M"}).join("K", {"ground.K", "lever.K"});
  bars.json()["drivers"]["H"] = hand;
  return bars;
}

/// A law of the rocker's angle, with its first and second derivative.
struct Law {
  std::string text;
  double (*at)(double);
  double (*slope)(double);
  double (*bend)(double);
};

const std::vector<Law> laws = {
    {"2*joint(D) + 1", [](double x) { return 2 * x + 1; }, [](double) { return 2.0; },
     [](double) { return 0.0; }},
    {"sin(joint(D))", [](double x) { return std::sin(x); }, [](double x) { return std::cos(x); },
     [](double x) { return -std::sin(x); }},
    {"2^(0.3*joint(D))", [](double x) { return std::exp2(0.3 * x); },
     [](double x) { return 0.3 * std::numbers::ln2 * std::exp2(0.3 * x); },
     [](double x) { return std::pow(0.3 * std::numbers::ln2, 2) * std::exp2(0.3 * x); }},
    {"1/(9 + joint(D)^2)", [](double x) { return 1 / (9 + x * x); },
     [](double x) { return -2 * x / std::pow(9 + x * x, 2); },
     [](double x) { return (6 * x * x - 18) / std::pow(9 + x * x, 3); }},
    {"atan2(joint(D), 7) + atan(joint(D)) - sqrt(20 + joint(D))",
     [](double x) { return std::atan2(x, 7) + std::atan(x) - std::sqrt(20 + x); },
     [](double x) { return 7 / (49 + x * x) + 1 / (1 + x * x) - 0.5 / std::sqrt(20 + x); },
     [](double x) {
       return -14 * x / std::pow(49 + x * x, 2) - 2 * x / std::pow(1 + x * x, 2) +
              0.25 / std::pow(20 + x, 1.5);
     }},
};

/// The rocker turns as the crank does, or in the antiparallelogram faster by a factor that follows
/// from the closed form tan(rocker / 2) = m tan(crank / 2). The hand's dyad moves as if a driver
/// turned the hand at the same rates.
TEST(ReadCrossings, HaveTheRatesOfEachMotion) {
  for (const double phi : {0.0, std::numbers::pi}) {
    const double sense = phi == 0 ? 1 : -1;
    const double faster = (length + sense * base) / (length - sense * base);
    for (const Law& law : laws) {
      SCOPED_TRACE(law.text + " at " + std::to_string(phi));
      const Solved found = solved(parallelogram_with_hand(phi, {{"position", law.text}}).json());
      ASSERT_EQ(found.configurations().size(), 2U);  // of the hand's dyad
      for (const Configuration& configuration : found.configurations()) {
        ASSERT_EQ(configuration.branches.size(), 2U);
        for (const double times : {1.0, faster}) {
          const double omega = speed * times;
          const double alpha = speeding_up * times;
          const auto one =
              std::ranges::find_if(configuration.branches, [&](const Configuration& branch) {
                return std::abs(branch.link("rocker").velocity(2) - omega) < 1e-6;
              });
          ASSERT_NE(one, configuration.branches.end()) << omega;
          EXPECT_NEAR(one->link("rocker").acceleration(2), alpha, 1e-8);
          const double hand_omega = law.slope(phi) * omega;
          const double hand_alpha = law.bend(phi) * omega * omega + law.slope(phi) * alpha;
          EXPECT_NEAR(one->link("hand").velocity(2), hand_omega, 1e-8);
          EXPECT_NEAR(one->link("hand").acceleration(2), hand_alpha, 1e-7);
          const Solved driven = solved(parallelogram_with_hand(phi, {{"position", law.at(phi)},
                                                                     {"velocity", hand_omega},
                                                                     {"acceleration", hand_alpha}})
                                           .json());
          bool is_met = false;
          for (const Configuration& other : driven.configurations()) {
            const double away =
                other.link("arm").pose.direction.sin - configuration.link("arm").pose.direction.sin;
            if (std::abs(away) < 1e-6) {
              is_met = true;
              ASSERT_EQ(other.branches.size(), 2U);
              for (const std::string link : {"arm", "lever"}) {
                EXPECT_NEAR(one->link(link).velocity(2), other.branches[0].link(link).velocity(2),
                            1e-6);
                EXPECT_NEAR(one->link(link).acceleration(2),
                            other.branches[0].link(link).acceleration(2), 1e-5);
              }
            }
          }
          EXPECT_TRUE(is_met);
        }
      }
    }
  }
}

/// Rates that the driver states are its own on every motion.
TEST(ReadCrossings, KeepRatesThatAreStated) {
  const Solved found = solved(
      parallelogram_with_hand(0, {{"position", "joint(D)"}, {"velocity", 3}, {"acceleration", 4}})
          .json());
  for (const Configuration& configuration : found.configurations()) {
    ASSERT_EQ(configuration.branches.size(), 2U);
    for (const Configuration& branch : configuration.branches) {
      EXPECT_NEAR(branch.link("hand").velocity(2), 3, 1e-12);
      EXPECT_NEAR(branch.link("hand").acceleration(2), 4, 1e-12);
    }
  }
}

}  // namespace
}  // namespace assur::test::read_crossings_test
