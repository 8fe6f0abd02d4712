// Law: laws with abs, min and max have the values and the derivatives of the branch that is chosen;
// at a corner the derivatives are those of one side, and the corner is named.
#include <gtest/gtest.h>

#include <assur/mechanism/scene_file.hpp>
#include <cmath>

#include "mechanism/solved.hpp"

namespace assur::test::corners_test {
namespace {

mechanism::Scene crank_with(const std::string& law, double t) {
  return mechanism::parse_scene(
      R"({"points": {"A": [0, 0], "B": [1, 0]}, "links": {"crank": ["A", "B"], "ground": ["A"]},
          "parameters": {"t": {"value": )" +
          std::to_string(t) + R"(, "velocity": 2}, "min": 3, "u": "t/10 + 0.2"},
          "drivers": {"A": {"position": ")" +
          law + R"("}}, "outputs": ["B"]})",
      "scene");
}

struct Case {
  const char* law;
  double t;
  double angle, rate;
  bool is_corner;
};

class Corners : public testing::TestWithParam<Case> {};

TEST_P(Corners, AreOneSidedAndTold) {
  const Case& at = GetParam();
  const mechanism::Plan plan(crank_with(at.law, at.t));
  const Values values = plan.values();
  const Solution solution = plan.solve(values);
  ASSERT_EQ(solution.configurations.size(), 1U);
  const mechanism::Frame& crank = solution.configurations[0].link("crank");
  EXPECT_NEAR(angle_of(crank.pose.direction), at.angle, 1e-15);
  EXPECT_NEAR(crank.velocity.z(), at.rate, 1e-15);
  EXPECT_EQ(values.corners(), at.is_corner ? std::vector<std::string>{"drivers.A.position"}
                                           : std::vector<std::string>{});
}

// The parameter t moves with velocity 2; min without brackets is a parameter.
constexpr std::array<Case, 12> cases = {{{"abs(t)", 0.5, 0.5, 2, false},
                                         {"abs(t)", -0.5, 0.5, -2, false},
                                         {"abs(t)", 0, 0, 2, true},
                                         {"abs(4*t - 1)", 0.25, 0, 8, true},
                                         {"max(t, 0.25)", 0.5, 0.5, 2, false},
                                         {"max(t, 0.25)", 0.125, 0.25, 0, false},
                                         {"max(t, 0.25)", 0.25, 0.25, 2, true},
                                         {"max(0.25, t)", 0.25, 0.25, 0, true},
                                         {"min(t, 0.25)", 0.25, 0.25, 2, true},
                                         {"min(0.25, t)", 0.5, 0.25, 0, false},
                                         {"min*t + max(0, t)^abs(-2)", 0.5, 1.75, 8, false},
                                         {"abs(u - 0.25)", 0.5, 0, 0.2, true}}};

/// 3*0.3 is not 0.9 in double precision: rounding chooses the side, and the corner is told.
TEST(Corner, AreToldToWithinRounding) {
  const mechanism::Plan plan(crank_with("abs(3*t - 0.9)", 0.3));
  const Values values = plan.values();
  EXPECT_EQ(values.corners(), std::vector<std::string>{"drivers.A.position"});
  const Solution solution = plan.solve(values);
  EXPECT_NEAR(std::abs(solution.configurations[0].link("crank").velocity.z()), 6, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Laws, Corners, testing::ValuesIn(cases));

}  // namespace
}  // namespace assur::test::corners_test
