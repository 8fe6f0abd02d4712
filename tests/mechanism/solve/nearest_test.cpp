// Law: the search for the nearest configuration alone finds the nearest one of the list, with the
// same runner-up, and also succeeds where there are too many configurations for a list.
#include <gtest/gtest.h>

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <random>

#include "mechanism/many_dyads.hpp"

namespace assur::test::nearest_test {
namespace {

using Json = nlohmann::ordered_json;
using mechanism::Nearest;
using mechanism::Plan;
using mechanism::Solution;

Plan plan_of(const Json& scene) { return Plan(mechanism::parse_scene(scene.dump(), "scene")); }

/// The search alone and the list answer the same; both keep any limits.
void expect_same(const Plan& plan) {
  const mechanism::Values values = plan.values();
  const Solution all = plan.solve(values);
  const std::optional<Nearest> listed = plan.nearest(values, all);
  Solution alone;
  const std::optional<Nearest> sought = plan.solve_nearest(values, alone);
  ASSERT_EQ(listed.has_value(), sought.has_value());
  if (!listed) {
    EXPECT_EQ(alone.configurations.size(), 0U);
    EXPECT_EQ(alone.status, all.status);
    return;
  }
  ASSERT_EQ(alone.configurations.size(), 1U);
  EXPECT_NEAR(sought->distance, listed->distance, 1e-12);
  ASSERT_EQ(sought->runner_up.has_value(), listed->runner_up.has_value());
  if (listed->runner_up) {
    EXPECT_NEAR(*sought->runner_up, *listed->runner_up, 1e-12);
  }
  const auto& expected = all.configurations[listed->configuration];
  for (const mechanism::LinkIndex link : plan.mechanism().links().keys()) {
    EXPECT_EQ(alone.configurations[0].links[link].pose.x, expected.links[link].pose.x);
    EXPECT_EQ(alone.configurations[0].links[link].pose.direction.cos,
              expected.links[link].pose.direction.cos);
  }
}

TEST(Nearest, IsThatOfTheList) {
  std::mt19937 random(20260);
  std::uniform_real_distribution<double> angle(-3, 3);
  std::size_t limited = 0;
  for (int scene = 0; scene < 60; ++scene) {
    Json json = many_dyads(6, [&](int) { return angle(random); });
    for (int number = 1; number <= 6; ++number) {
      if (scene % 2 == 1 && angle(random) > 2.2) {
        json["joints"]["G" + std::to_string(number)]["limits"] = {0, 3.1};
        ++limited;
      }
      if (scene % 3 == 1 && angle(random) > 0) {
        json["reference"].erase("bar" + std::to_string(number));
      }
    }
    if (scene % 3 == 2) {
      json["reference"]["rocker3"] = angle(random);
    }
    if (scene % 3 == 1) {  // links without a reference leave several equally near
      json["reference"]["bar6"] = angle(random);
      const Plan plan = plan_of(json);
      const mechanism::Values values = plan.values();
      Solution alone;
      const auto sought = plan.solve_nearest(values, alone);
      const auto listed = plan.nearest(values, plan.solve(values));
      ASSERT_EQ(sought.has_value(), listed.has_value());
      EXPECT_NEAR(sought ? sought->distance : 0, listed ? listed->distance : 0, 1e-12);
      continue;
    }
    expect_same(plan_of(json));
  }
  EXPECT_GT(limited, 10U);
}

/// The nearest of 2^29 has each bar up or down as its reference says.
TEST(Nearest, IsFoundAmongMoreThanCanBeListed) {
  const auto stands_up = [](int number) { return number % 3 != 1; };
  const Plan plan =
      plan_of(many_dyads(29, [&](int number) { return stands_up(number) ? 1.4 : -1.3; }));
  EXPECT_EQ(plan.most_configurations(), std::ldexp(1.0, 29));
  Solution alone;
  const std::optional<Nearest> nearest = plan.solve_nearest(plan.values(), alone);
  ASSERT_TRUE(nearest && nearest->runner_up);
  EXPECT_LT(nearest->distance, 1);
  EXPECT_GT(*nearest->runner_up, 2);
  for (int number = 1; number <= 29; ++number) {
    EXPECT_EQ(alone.configurations[0].link("bar" + std::to_string(number)).pose.direction.sin > 0,
              stands_up(number));
  }
}

/// The limits of all but three dyads leave eight configurations, which are found without the
/// others.
TEST(Limits, LeaveAListWhereThereAreTooMany) {
  Json scene = many_dyads(29, [](int) { return 1.4; });
  for (int number = 4; number <= 29; ++number) {
    scene["joints"]["G" + std::to_string(number)]["limits"] = {0, 3.1};
  }
  const Plan plan = plan_of(scene);
  const Solution solution = plan.solve(plan.values());
  EXPECT_EQ(solution.configurations.size(), 8U);
  EXPECT_FALSE(solution.left_out.has_value());
}

std::string refusal_of(const Json& scene, bool nearest) {
  const Plan plan = plan_of(scene);
  try {
    Solution solution;
    if (nearest) {
      (void)plan.solve_nearest(plan.values(), solution);
    } else {
      plan.solve(plan.values(), solution);
    }
  } catch (const mechanism::MechanismError& error) {
    return error.what();
  }
  return "solved";
}

TEST(TooMany, AreRefusedWithAMend) {
  Json scene = many_dyads(29, [](int) { return 1.4; });
  const std::string mend =
      "; give joints limits, or ask for one configuration only: the nearest to a reference of more "
      "links, or one with a low number";
  EXPECT_EQ(refusal_of(scene, false),
            "there may be 536870912 configurations, and no more than 20000 can be listed" + mend);
  scene["reference"] = {{"bar29", 1.4}};
  EXPECT_EQ(refusal_of(scene, true),
            "there may be 536870912 configurations, and to find them, more than 300000 groups "
            "would have to be solved" +
                mend);
  EXPECT_EQ(refusal_of(many_dyads(10, [](int) { return 1.4; }), false), "solved");
}

}  // namespace
}  // namespace assur::test::nearest_test
