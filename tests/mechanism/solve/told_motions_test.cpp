// Law: which motions go through a singular configuration does not depend on how the mechanism is
// turned, and no motion is reported that only rounding makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"

namespace assur::test::told_motions_test {
namespace {

// Two stages of scissors with bars of 10, the lower bar driven from a ground that is turned by psi.
// Where it lies along the ground, the upper stage is flat on the lower: its bars turn as the driven
// one does, or the other way.
SceneMaker flat_scissors(double phi, double psi) {
  SceneMaker maker;
  return maker.parameter("phi", phi)
      .parameter("psi", psi)
      .line("ground", "way", {0, 0}, {std::cos(psi), std::sin(psi)})
      .line("foot", "way", {0, 0}, {1, 0})
      .point("foot", "S", 0, 0)
      .slide("way", "ground.way", "foot.way")
      .point("ground", "L0", 0, 0)
      .drive("L0", "phi + psi", 2, 1)
      .bar("rising1", {{"L0", 0}, {"M1", 5}, {"R1", 10}})
      .bar("falling1", {{"S", 0}, {"M1", 5}, {"L1", 10}})
      .bar("rising2", {{"L1", 0}, {"M2", 5}, {"R2", 10}})
      .bar("falling2", {{"R1", 0}, {"M2", 5}, {"L2", 10}});
}

TEST(ToldMotions, OfFlatScissorsDoNotDependOnHowTheyAreTurned) {
  for (const double phi : {0.0, std::acos(-1.0)}) {
    for (int turn = 0; turn < 24; ++turn) {
      SCOPED_TRACE(testing::Message() << phi << " turned " << turn);
      const Solved solved(
          mechanism::parse_scene(flat_scissors(phi, 0.27 * turn).scene().dump(), "scene"));
      ASSERT_EQ(solved.configurations().size(), 1U);
      std::vector<double> rates;
      for (const Configuration& motion : solved.configurations()[0].branches) {
        const Eigen::Vector3d& velocity = motion.link("rising2").velocity;
        rates.push_back(velocity(2));
        EXPECT_NEAR(velocity(2), -motion.link("falling2").velocity(2), 1e-6);
        EXPECT_NEAR(motion.link("rising2").acceleration(2), velocity(2) / 2, 1e-5);
      }
      std::ranges::sort(rates);
      ASSERT_EQ(rates.size(), 2U);
      EXPECT_NEAR(rates[0], -2, 1e-6);
      EXPECT_NEAR(rates[1], 2, 1e-6);
    }
  }
}

// A block on the x-axis whose pin is in the slot of a bar about (3, 3 sin phi), which slopes by
// phi: at 3 + 3 cos phi. Where the slot lies along the axis, the block is anywhere.
TEST(ToldMotions, OfABlockInASlotNearlyAlongItsSlideAreOne) {
  for (int place = 0; place < 40; ++place) {
    const double phi = 1e-12 * std::pow(10, 0.15 * place);
    SCOPED_TRACE(phi);
    SceneMaker maker;
    maker.parameter("phi", {{"value", phi}, {"velocity", 2}})
        .line("ground", "way", {0, 0}, {1, 0})
        .point("ground", "E", 3, "3*sin(phi)")
        .point("bar", "E", 0, 0)
        .line("bar", "slot", {0, 0}, {1, 0})
        .drive("E", "-phi", -2, 0)
        .line("block", "way", {0, 0}, {1, 0})
        .point("block", "C", 0, 0)
        .slide("way", "ground.way", "block.way")
        .slot("C in the slot", "bar.slot", "block.C");
    const Solved solved(mechanism::parse_scene(maker.scene().dump(), "scene"));
    ASSERT_EQ(solved.configurations().size(), 1U);
    const Configuration& block = solved.configurations()[0];
    EXPECT_NEAR(block.link("block").pose.x, 6, 1e-3);
    EXPECT_TRUE(block.branches.empty());
    if (block.rates_known) {  // two digits of those with which the bar moves
      EXPECT_NEAR(block.link("block").velocity(0), -6 * std::sin(phi), 6e-2);
    }
  }
}

}  // namespace
}  // namespace assur::test::told_motions_test
