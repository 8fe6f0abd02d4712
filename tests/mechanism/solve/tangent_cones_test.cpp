// Law: the motions through a place where several loops lose rank at once are all those along which
// the mechanism can go on, and no others.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"

namespace assur::test::tangent_cones_test {
namespace {

Solved solved(const SceneMaker& maker) {
  return Solved(mechanism::parse_scene(maker.scene().dump(), "scene"));
}

/// Cranks of length 1 on a line, each coupled to the next by a bar of length 3, all stretched along
/// that line. Behind each bar, the crank turns as the one before, or -(3 + 1)/(3 - 1) times as
/// fast.
class RowOfParallelograms : public testing::TestWithParam<int> {};

TEST_P(RowOfParallelograms, ParallelOrCrossedEachByItself) {
  const int count = GetParam();
  SceneMaker maker;
  for (int crank = 0; crank <= count; ++crank) {
    const std::string name = std::to_string(crank);
    maker.point("ground", "A" + name, 3 * crank, 0);
    std::vector<std::pair<std::string, SceneMaker::Json>> points{{"A" + name, 0}, {"B" + name, 1}};
    if (crank > 0) {
      points.emplace_back("C" + name, 1);
      maker.bar("bar" + name, {{"B" + std::to_string(crank - 1), 0}, {"C" + name, 3}});
    }
    maker.bar("crank" + name, points);
  }
  maker.drive("A0", 0, 1, 0);
  const Solved row = solved(maker);
  ASSERT_EQ(row.configurations().size(), 1U);
  const std::vector<Configuration>& motions = row.configurations()[0].branches;
  std::set<std::vector<int>> factors;
  double worst = 0;
  for (const Configuration& motion : motions) {
    std::vector<int> of_motion;
    double before = 1;
    for (int crank = 1; crank <= count; ++crank) {
      const auto& link = motion.link("crank" + std::to_string(crank));
      const double factor = link.velocity(2) / before;
      of_motion.push_back(static_cast<int>(std::lround(factor)));
      EXPECT_TRUE(of_motion.back() == 1 || of_motion.back() == -2) << factor;
      worst = std::max({worst, std::abs(factor - of_motion.back()),
                        std::abs(link.acceleration(2)) / (link.velocity(2) * link.velocity(2))});
      before = link.velocity(2);
    }
    factors.insert(of_motion);
  }
  EXPECT_EQ(motions.size(), std::size_t{1} << count);
  EXPECT_EQ(factors.size(), motions.size());
  std::printf("%zu motions, rates off by %.1e\n", motions.size(), worst);
  EXPECT_LT(worst, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfUpToEight, RowOfParallelograms, testing::Range(1, 9));

/// A crank AB and a tetrad BCG, CD, GF, EDF, all stretched along a line, with joints at `x`.
SceneMaker flat_tetrad(const std::array<double, 7>& x, double phi) {
  const auto at = [&](char joint) { return x[std::string("ABCGDFE").find(joint)]; };
  SceneMaker maker;
  const auto add = [&](const std::string& link, const std::string& joints) {
    for (const char joint : joints) {
      maker.point(link, std::string(1, joint), at(joint) - at(joints[0]), 0);
    }
  };
  maker.point("ground", "A", at('A'), 0).point("ground", "E", at('E'), 0);
  add("crank", "AB");
  add("BCG", "BCG");
  add("CD", "CD");
  add("GF", "GF");
  add("EDF", "EDF");
  return maker.drive("A", phi, 1, 0.3);
}

std::vector<double> angles(const Configuration& configuration) {
  std::vector<double> result;
  for (const char* link : {"BCG", "CD", "GF", "EDF"}) {
    const auto& direction = configuration.link(link).pose.direction;
    result.push_back(std::atan2(direction.sin, direction.cos));
  }
  return result;
}

bool are_within(const std::vector<double>& angles, double bound) {
  return std::ranges::all_of(angles, [&](double angle) { return std::abs(angle) < bound; });
}

TEST(FlatTetrads, MoveToTheConfigurationsBesideThem) {
  constexpr unsigned seed = 5;
  constexpr double beside = 1e-4;
  constexpr double near = 0.05;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> lattice(-400, 400);
  std::array<int, 5> counts{};
  int compared = 0;
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::array<double, 7> x{};
    std::ranges::generate(x, [&] { return lattice(random) / 64.0; });
    const Solved flat = solved(flat_tetrad(x, 0));
    std::vector<Configuration> motions;
    for (const Configuration& one : flat.configurations()) {
      if (are_within(angles(one), 1e-4)) {
        motions = one.branches;
        if (one.rates_known) {
          motions.push_back(one);  // a crank of no length, which moves nothing
        }
      }
    }
    ASSERT_LE(motions.size(), 4U);
    ++counts[motions.size()];
    for (const double phi : {-beside, beside}) {
      SCOPED_TRACE(testing::Message() << "trial " << trial << " at " << phi);
      std::vector<std::vector<double>> there;
      const Solved bent = solved(flat_tetrad(x, phi));
      for (const Configuration& one : bent.configurations()) {
        if (const auto of_one = angles(one); are_within(of_one, near)) {
          there.push_back(of_one);
        }
      }
      EXPECT_EQ(there.size(), motions.size());
      // phi = t + 0.15 t^2.
      const double t = (std::sqrt(1 + 0.6 * phi) - 1) / 0.3;
      for (const Configuration& motion : motions) {
        std::vector<double> expected;
        double fastest = 1;
        for (const char* link : {"BCG", "CD", "GF", "EDF"}) {
          const auto& state = motion.link(link);
          expected.push_back(state.velocity(2) * t + state.acceleration(2) * t * t / 2);
          fastest = std::max(fastest, std::abs(state.velocity(2)));
        }
        if (fastest * beside > near / 2) {
          continue;
        }
        double nearest = 1;
        for (const std::vector<double>& one : there) {
          double apart = 0;
          for (std::size_t link = 0; link < one.size(); ++link) {
            apart = std::max(apart, std::abs(one[link] - expected[link]));
          }
          nearest = std::min(nearest, apart);
        }
        ++compared;
        worst = std::max(worst, nearest / std::pow(fastest * beside, 3));
      }
    }
  }
  std::printf("seed %u: %d, %d, %d tetrads with 0, 2, 4 motions; %d compared, off by %.1f cubes\n",
              seed, counts[0], counts[2], counts[4], compared, worst);
  EXPECT_GT(counts[2], 5);
  EXPECT_GT(counts[4], 5);
  EXPECT_GT(compared, 100);
  EXPECT_LT(worst, 1e3);
}

}  // namespace
}  // namespace assur::test::tangent_cones_test
