// Law: the motions through a point where several loops lose rank at once are exactly those along
// which the mechanism can move.
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

/// A crank and dyads between its pins, those of links before, and the ground, all on a line, with
/// lengths of a lattice. Some are singular throughout, as where a pin is on the crank's pivot.
SceneMaker flat_chain(std::mt19937& random, double phi, std::vector<std::string>& links) {
  struct Pin {
    std::string link, name;
    int at;
  };
  const auto any = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  SceneMaker maker;
  links = {"crank"};
  std::vector<Pin> pins{{"crank", "P", any(1, 3)}};
  maker.point("ground", "A", 0, 0).bar("crank", {{"A", 0}, {"P", pins[0].at}});
  const int dyads = any(1, 4);
  for (int dyad = 0; dyad < dyads; ++dyad) {
    const std::string number = std::to_string(dyad);
    const Pin one = pins[static_cast<std::size_t>(any(0, static_cast<int>(pins.size()) - 1))];
    Pin other{"ground", "D" + number, any(-6, 6)};
    if (any(0, 9) < 3) {
      other = pins[static_cast<std::size_t>(any(0, static_cast<int>(pins.size()) - 1))];
    }
    const int middle = any(-6, 6);
    if (one.at == other.at || middle == one.at || middle == other.at) {
      continue;
    }
    if (other.link == "ground") {
      maker.point("ground", other.name, other.at, 0);
    }
    for (const auto& [link, end] : {std::pair{"U" + number, one}, {"V" + number, other}}) {
      const std::string tip = "T" + link;
      const int place = any(-6, 6);
      maker.bar(link, {{end.name, 0}, {"M" + number, middle - end.at}, {tip, place - end.at}});
      pins.push_back({link, tip, place});
      links.push_back(link);
    }
    pins.push_back({"U" + number, "M" + number, middle});
  }
  return maker.drive("A", phi, 1, 0.3);
}

TEST(FlatChains, MoveToTheConfigurationsBesideThem) {
  constexpr unsigned seed = 1;
  constexpr double beside = 1e-4;
  constexpr double near = 0.005;
  std::mt19937 random(seed);
  int motions_in_all = 0;
  int untold = 0;
  int compared = 0;
  double worst = 0;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    std::vector<std::string> links;
    const std::mt19937 same = random;
    const Solved flat = solved(flat_chain(random, 0, links));
    const auto angles_of = [&](const Configuration& one) {
      std::vector<double> result;
      for (const std::string& link : links) {
        const auto& direction = one.link(link).pose.direction;
        result.push_back(std::atan2(direction.sin, direction.cos));
      }
      return result;
    };
    std::vector<Configuration> motions;
    for (const Configuration& one : flat.configurations()) {
      if (are_within(angles_of(one), 1e-4)) {
        motions = one.branches;
        if (one.rates_known) {
          motions.push_back(one);
        }
      }
    }
    std::mt19937 again = same;
    std::vector<std::vector<double>> there;
    const Solved bent = solved(flat_chain(again, beside, links));
    for (const Configuration& one : bent.configurations()) {
      if (const auto of_one = angles_of(one); are_within(of_one, near)) {
        there.push_back(of_one);
      }
    }
    motions_in_all += static_cast<int>(motions.size());
    if (motions.empty()) {
      untold += there.empty() ? 0 : 1;
      continue;
    }
    std::size_t within = 0;
    const double t = (std::sqrt(1 + 0.6 * beside) - 1) / 0.3;
    for (const Configuration& motion : motions) {
      double fastest = 1;
      bool is_known_twice = true;
      std::vector<double> expected;
      for (const std::string& link : links) {
        const auto& state = motion.link(link);
        // Where a tangent is multiple, accelerations may be unknown.
        const double second = std::isnan(state.acceleration(2)) ? 0 : state.acceleration(2);
        is_known_twice = is_known_twice && !std::isnan(state.acceleration(2));
        expected.push_back(state.velocity(2) * t + second * t * t / 2);
        fastest = std::max(fastest, std::abs(state.velocity(2)));
      }
      if (!are_within(expected, near)) {
        continue;
      }
      ++within;
      double nearest = 1;
      for (const std::vector<double>& one : there) {
        double apart = 0;
        for (std::size_t link = 0; link < one.size(); ++link) {
          apart = std::max(apart, std::abs(one[link] - expected[link]));
        }
        nearest = std::min(nearest, apart);
      }
      ++compared;
      worst = std::max(worst, nearest / std::pow(fastest * beside, is_known_twice ? 3 : 2));
    }
    EXPECT_EQ(there.size(), within);
  }
  std::printf(
      "seed %u: %d motions, %d chains whose motions are not told; %d compared, off by %.1f "
      "cubes\n",
      seed, motions_in_all, untold, compared, worst);
  EXPECT_GT(compared, 100);
  EXPECT_LE(untold, 2);
  EXPECT_LT(worst, 1e4);
}

}  // namespace
}  // namespace assur::test::tangent_cones_test
