// Law: positions, rates, sensitivities and verdicts of every rigid kind in special position are the
// same in any unit of length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "mechanism/lattice_scene.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::units_test {
namespace {

/// A group in units of 2^exponent, its first joint on the ground driven along x by a parameter.
Json in_unit(const LatticeScene& group, int exponent) {
  Json scene = Json::parse(group.text(1, 0));
  scene["want"] = {"position", "velocity", "acceleration", "sensitivity"};
  scene["parameters"]["w"] = {{"value", 1}, {"velocity", 1}, {"acceleration", 2}};
  const auto scaled = [&](Json& coordinate, const std::string& offset) {
    const std::string number =
        coordinate.is_string() ? coordinate.get<std::string>() : coordinate.dump();
    coordinate = "((" + number + ")" + offset + ")*2^(" + std::to_string(exponent) + ")";
  };
  for (const auto& [name, link] : scene["links"].items()) {
    std::string offset = name == "ground" ? " + w - 1" : "";
    for (Json& feature : link) {
      Json& place = feature.is_array() ? feature : feature["through"];
      scaled(place[0], offset);
      scaled(place[1], "");
      offset.clear();
    }
  }
  return scene;
}

/// The largest difference of two motions of a link; the lengths of `other` are in the given unit.
double difference(const mechanism::Frame& one, const mechanism::Frame& other, double unit) {
  const Eigen::Vector3d scale(unit, unit, 1);
  double result = std::max({std::abs(one.pose.x - other.pose.x / unit),
                            std::abs(one.pose.y - other.pose.y / unit),
                            std::abs(one.pose.direction.cos - other.pose.direction.cos),
                            std::abs(one.pose.direction.sin - other.pose.direction.sin)});
  const auto compare = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d gap = a - b.cwiseQuotient(scale);
    result = std::max(result, gap.cwiseAbs().maxCoeff() / std::max(1.0, a.cwiseAbs().maxCoeff()));
  };
  compare(one.velocity, other.velocity);
  compare(one.acceleration, other.acceleration);
  compare(one.follows.first.col(0), other.follows.first.col(0));
  return result;
}

class Units : public testing::TestWithParam<int> {};

TEST_P(Units, ChangeNoAnswer) {
  const int exponent = GetParam();
  double worst = 0;
  int compared = 0;
  for (const LatticeKind& kind : lattice_kinds()) {
    for (unsigned seed = 1; seed <= 2; ++seed) {
      const LatticeScene group(kind, seed);
      const Solved here = solved(in_unit(group, 0));
      const Solved there = solved(in_unit(group, exponent));
      ASSERT_EQ(here.solution.status, there.solution.status) << group.name();
      ASSERT_EQ(here.configurations().size(), there.configurations().size()) << group.name();
      for (std::size_t index = 0; index < here.configurations().size(); ++index) {
        const Configuration& one = here.configurations()[index];
        const Configuration& other = there.configurations()[index];
        EXPECT_EQ(one.regularity, other.regularity) << group.name() << " " << index;
        EXPECT_EQ(one.derivatives_known, other.derivatives_known) << group.name() << " " << index;
        EXPECT_EQ(one.rates_known, other.rates_known) << group.name() << " " << index;
        EXPECT_EQ(one.branches.size(), other.branches.size()) << group.name() << " " << index;
        if (one.regularity != Status::ok) {
          continue;
        }
        for (const mechanism::LinkIndex link : one.links.keys()) {
          worst = largest(
              worst, difference(one.links[link], other.links[link], std::ldexp(1.0, exponent)));
        }
        ++compared;
      }
    }
  }
  std::cout << compared << " configurations, largest difference " << worst << "\n";
  EXPECT_LE(worst, 1e-9);
  EXPECT_GT(compared, 300);
}

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, Units, testing::Values(-300, 300));

}  // namespace
}  // namespace assur::test::units_test
