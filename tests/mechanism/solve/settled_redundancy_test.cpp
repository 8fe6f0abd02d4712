// Law: where a mechanism is regular, but becomes singular when its redundant constraints are left
// out, configurations, verdicts and rates are those of the mechanism with all its constraints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanism/five_bars.hpp"

namespace assur::test {
namespace {

/// Where a crank is perpendicular to the coupler, a slot along the coupler alone would let the
/// crank's tip slide.
TEST(SettledRedundancy, OfCranksSquareToTheCouplerAreRegular) {
  for (const double phi : {0.5, -0.5}) {
    for (const double beside : {0.0, 1e-9, 1e-6}) {
      Bars bars = five_bars(2, 1.5);
      bars.json()["parameters"]["phi"] = phi * std::numbers::pi + beside;
      const Solved found = solved(bars.json());
      ASSERT_EQ(found.configurations().size(), 1U) << phi;
      EXPECT_EQ(found.configurations()[0].regularity, Status::ok) << phi;
      EXPECT_NEAR(found.configurations()[0].link("rocker").velocity(2), 2, 1e-14) << phi;
    }
  }
}

/// Beside their flat position the cranks have one configuration. Without one constraint there would
/// also be an antiparallelogram, in which the pins miss only by the square of the angle.
TEST(SettledRedundancy, OfAnAlmostFlatParallelogramHoldOnce) {
  for (const double third : {1.0, 1.3, 2.0}) {
    for (const double unit : {1.0, 0x1p-60, 0x1p60}) {
      for (double beside = 1e-2; beside > 1e-13; beside /= unit == 1 ? 7 : 1000) {
        for (const double phi : {beside, -beside, std::numbers::pi - beside}) {
          SCOPED_TRACE(std::to_string(third) + " " + std::to_string(std::log10(beside)));
          Bars bars = five_bars(2, 1.5);
          bars.json()["links"]["ground"]["F"] = {third, 0};
          bars.json()["links"]["coupler"]["G"] = {third, 0};
          for (const auto& [link, points] : bars.json()["links"].items()) {
            for (const auto& [name, place] : points.items()) {
              place[0] = place[0].get<double>() * unit;
            }
          }
          bars.json()["parameters"]["phi"] = phi;
          const Solved found = solved(bars.json());
          ASSERT_EQ(found.configurations().size(), 1U);
          const Configuration& only = found.configurations()[0];
          // Rounding moves the coupler by eps over the angle, and by no more than the root of eps.
          const double moved = std::min(4e-15 / beside, 1e-7);
          EXPECT_NEAR(only.link("coupler").pose.direction.sin, 0, moved);
          EXPECT_TRUE(only.branches.empty());
          if (only.rates_known) {
            EXPECT_NEAR(only.link("rocker").velocity(2), 2,
                        only.regularity == Status::ok ? 1e-6 : 1e-2);
          }
          if (only.regularity == Status::ok) {
            EXPECT_NEAR(only.link("rocker").acceleration(2), 0, 4 * 5e-7);  // of omega^2
          }
          EXPECT_TRUE(only.regularity == Status::ok || beside < 1e-2);
          EXPECT_TRUE(only.rates_known || beside < 1e-5);
        }
      }
    }
  }
}

/// Two cranks are in line with their pivots; the third one, beside that line, holds them. All is
/// known as elsewhere, except derivatives by a parameter that the cranks could not follow.
TEST(SettledRedundancy, OfCranksOfWhichTwoAreInLineAreRegular) {
  for (const double beside : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
    for (const std::string of_third : {"long", "1.5"}) {
      for (const double sense : {1.0, -1.0}) {
        SCOPED_TRACE(beside);
        Bars bars = five_bars(2, 1.5);
        bars.json()["links"]["ground"]["F"] = bars.json()["links"]["coupler"]["G"] = {2, 1};
        const double phi = std::atan2(1.0, 2.0) + sense * beside;
        bars.json()["parameters"] = {{"phi", phi}, {"long", 1.5}};
        bars.json()["links"]["crank"]["B"] = bars.json()["links"]["rocker"]["C"] = {"long", 0};
        bars.json()["links"]["third"]["G"] = {of_third, 0};
        bars.json()["drivers"]["A"]["acceleration"] = 3;
        bars.json()["want"] = {"position", "velocity", "acceleration", "sensitivity"};
        bars.json()["covariance"] = {{"parameters", {"phi"}}, {"matrix", Json::array({{1}})}};
        const Solved found = solved(bars.json());
        ASSERT_EQ(found.configurations().size(), 1U);
        const Configuration& only = found.configurations()[0];
        EXPECT_EQ(only.regularity, Status::ok);
        EXPECT_NEAR(only.link("coupler").pose.direction.sin, 0, 1e-14);
        for (const std::string crank : {"rocker", "third"}) {
          EXPECT_NEAR(only.link(crank).velocity(2), 2, 1e-13);
          EXPECT_NEAR(only.link(crank).acceleration(2), 3, 1e-12);
          if (only.derivatives_known) {
            EXPECT_NEAR(only.link(crank).follows.first(2, 0), 1, 1e-13);
          }
        }
        if (beside < 1e-9) {
          EXPECT_EQ(only.derivatives_known, of_third == "long");
        }
        if (only.derivatives_known && of_third == "long") {
          const auto of_long = only.output("G").follows.first.col(1);
          EXPECT_NEAR(of_long.x(), std::cos(phi), 1e-12);
          EXPECT_NEAR(of_long.y(), std::sin(phi), 1e-12);
          const Eigen::MatrixXd& second = only.output("G").follows.second[0];
          EXPECT_NEAR(second(0, 0), -1.5 * std::cos(phi), 1e-9);
          EXPECT_NEAR(second(0, 1), -std::sin(phi), 1e-9);
          EXPECT_NEAR(second(1, 1), 0, 1e-9);
        }
      }
    }
  }
}

}  // namespace
}  // namespace assur::test
