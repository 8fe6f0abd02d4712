// Law: the answer for a mechanism that cannot be assembled says by how much it fails to close, even
// if lengths vanish or slides are parallel.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mechanism/lattice_scene.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::missed_closures_test {
namespace {

/// A platform on three legs from (0, 0), (6, 0) and (3, 8), the last of them too long.
Json platform(double first_leg) {
  Json scene;
  scene["links"]["ground"] = {{"A1", {0, 0}}, {"A2", {6, 0}}, {"A3", {3, 8}}};
  scene["links"]["platform"] = {{"B1", {0, 0}}, {"B2", {1, 0}}, {"B3", {0, 2}}};
  const auto leg = [&scene](const std::string& number, double length) {
    scene["links"]["leg" + number] = {{"A", {0, 0}}, {"B", {length, 0}}};
    scene["joints"]["A" + number] = {{"type", "revolute"},
                                     {"between", {"ground.A" + number, "leg" + number + ".A"}}};
    scene["joints"]["B" + number] = {{"type", "revolute"},
                                     {"between", {"leg" + number + ".B", "platform.B" + number}}};
  };
  leg("1", first_leg);
  leg("2", 5);
  leg("3", 30);
  return scene;
}

/// The number after `fail to close by` in the reason why a scene has no configurations.
double amount_in(const Solved& made) {
  const std::string reason = made.plan.obstacle(made.values);
  const std::string words = "fail to close by ";
  const std::size_t place = reason.find(words);
  return place == std::string::npos ? std::nan("") : std::stod(reason.substr(place + words.size()));
}

TEST(MissedClosures, AreToldOfALegWithoutLength) {
  const Solved none = solved(platform(0));
  ASSERT_EQ(none.solution.status, SolutionStatus::no_assembly);
  EXPECT_NEAR(amount_in(none), amount_in(solved(platform(1e-9))), 1e-6);
}

TEST(MissedClosures, AreToldOfEveryKindOnTheLattice) {
  int told = 0;
  for (const LatticeKind& kind : lattice_kinds()) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      Json scene = Json::parse(LatticeScene(kind, seed).text(1, 0));
      // One external joint is moved far enough for most groups to be out of reach.
      Json& feature = scene["links"]["ground"].begin().value();
      (feature.is_array() ? feature : feature["through"])[0] = 40;
      const Solved made = solved(scene);
      if (made.solution.status == SolutionStatus::no_assembly) {
        EXPECT_GT(amount_in(made), 0) << kind.spelling << " " << seed;
        ++told;
      }
    }
  }
  EXPECT_GT(told, 300);
}

}  // namespace
}  // namespace assur::test::missed_closures_test
