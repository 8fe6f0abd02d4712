// Law: values with a replaced parameter are bitwise equal to those evaluated afresh with it; long
// chains of parameters need no deep stack, and cycles are refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

#include "mechanism/same_solution.hpp"
#include "scenes_of.hpp"

namespace assur::test::values_test {
namespace {

namespace fs = std::filesystem;
using mechanism::Mechanism;
using mechanism::ParameterIndex;

void expect_same(const Plan& plan, const Values& set, const Values& fresh) {
  expect_same_values(set, fresh, plan.mechanism());
  expect_same_solution(plan.solve(set), plan.solve(fresh));
}

/// Moves every parameter and moves it back, one after the other, in one set of values.
void check_settings(const Plan& plan) {
  const Values original = plan.values();
  Values values = plan.values();
  std::vector<std::pair<std::string, double>> replaced;
  for (const ParameterIndex parameter : plan.mechanism().parameters().keys()) {
    const std::string& name = plan.mechanism().parameters()[parameter].name;
    SCOPED_TRACE(name);
    const double value = original.parameter(parameter);
    const double moved = value + 1e-3 * (value == 0 ? 1 : std::abs(value));
    values.set(parameter, moved);
    replaced.emplace_back(name, moved);
    expect_same(plan, values, plan.values(replaced));
    values.set(parameter, value);
    replaced.back().second = value;
    expect_same(plan, values, plan.values(replaced));
  }
}

/// Moves neighbouring pairs of parameters together, then all of them, then none.
void check_settings_together(const Plan& plan) {
  const Values original = plan.values();
  Values values = plan.values();
  std::vector<std::pair<ParameterIndex, double>> all;
  std::vector<std::pair<std::string, double>> replaced;
  for (const ParameterIndex parameter : plan.mechanism().parameters().keys()) {
    const double value = original.parameter(parameter);
    all.emplace_back(parameter, value + 1e-3 * (value == 0 ? 1 : std::abs(value)));
    replaced.emplace_back(plan.mechanism().parameters()[parameter].name, all.back().second);
    if (all.size() > 1) {
      values.set({all[all.size() - 2], all.back()});
      expect_same(plan, values, plan.values(replaced));
    }
  }
  Values at_once = plan.values();
  at_once.set(all);
  expect_same(plan, at_once, plan.values(replaced));
  at_once.set(std::vector<std::pair<ParameterIndex, double>>());
  expect_same(plan, at_once, plan.values(replaced));
  EXPECT_THROW(at_once.set({all.front(), {ParameterIndex(), 1.0}}), mechanism::MechanismError);
  EXPECT_FALSE(at_once.usable());
  at_once.set(all);
  expect_same(plan, at_once, plan.values(replaced));
}

class ExampleValues : public testing::TestWithParam<std::string> {};

TEST_P(ExampleValues, SetAreThoseEvaluatedAfresh) {
  check_settings(Plan(mechanism::read_scene(fs::path(ASSUR_EXAMPLES) / (GetParam() + ".json"))));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExampleValues, testing::ValuesIn(scenes_of(ASSUR_EXAMPLES)),
                         [](const auto& name) { return name.param; });

/// The crank's length, the driver, a tolerance and the covariance follow from others by formulas,
/// through up to three steps; two formulas are chains that part and meet again.
const char* const tied = R"({
  "parameters": {
    "unit": 20, "ground": "4*unit", "crank": {"value": "ground/2", "tolerance": "unit/1000"},
    "coupler": "crank + 3*unit", "rocker": "sqrt(coupler*(crank + ground)) - unit/2",
    "reach": {"value": "coupler + rocker", "tolerance": "crank*0.001"}, "turn": 1, "phi": "turn + 0.05"},
  "links": {
    "ground": {"A": [0, 0], "D": ["ground", 0]},
    "crank": {"A": [0, 0], "B": ["crank", 0]},
    "coupler": {"B": [0, 0], "C": ["coupler", 0], "P": ["reach", "unit"]},
    "rocker": {"D": [0, 0], "C": ["rocker", 0]}},
  "joints": {
    "A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
    "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
    "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
    "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
  "drivers": {"A": {"position": "phi", "velocity": "unit/2", "acceleration": "turn"}},
  "outputs": {"P": "coupler.P"},
  "covariance": {"parameters": ["unit", "turn"], "matrix": [["unit*0.01", 0], [0, "turn*0.01"]]},
  "sweep": {"parameter": "phi", "from": "turn/2", "to": "turn + 2", "count": 11}
})";

TEST(Values, SetAreThoseEvaluatedAfreshThroughFormulas) {
  check_settings(Plan(mechanism::parse_scene(tied, "tied")));
}

TEST(Values, SetTogetherAreThoseEvaluatedAfresh) {
  check_settings_together(Plan(mechanism::parse_scene(tied, "tied")));
  check_settings_together(
      Plan(mechanism::read_scene(fs::path(ASSUR_EXAMPLES) / "excavator_arm.json")));
}

/// A value that replaces a formula does not follow the parameters that the formula names.
TEST(Values, OfAReplacedParameterStayWhereTheyAre) {
  const Plan plan(mechanism::parse_scene(tied, "tied"));
  const ParameterIndex unit = plan.mechanism().parameter_named("unit", "");
  const ParameterIndex coupler = plan.mechanism().parameter_named("coupler", "");
  Values values = plan.values({{"coupler", 101.0}});
  values.set(unit, 20.5);
  EXPECT_EQ(values.parameter(coupler), 101);
  expect_same(plan, values, plan.values({{"coupler", 101.0}, {"unit", 20.5}}));
}

constexpr int links_of_chain = 20000;

/// A crank whose length is the last of many parameters, each of which depends on the one before,
/// declared from the last to the first or from the first to the last.
Mechanism chain(bool backwards, const mechanism::Mechanism::Given& first) {
  Mechanism made;
  const auto name = [](int place) { return "p" + std::to_string(place); };
  for (int place = 0; place < links_of_chain; ++place) {
    made.declare_parameter(name(backwards ? links_of_chain - 1 - place : place));
  }
  made.set_parameter(name(0), first);
  for (int place = 1; place < links_of_chain; ++place) {
    made.set_parameter(name(place), name(place - 1) + " + 1");
  }
  made.add_link("ground");
  made.add_link("crank");
  made.add_point("ground.A", 0, 0);
  made.add_point("crank.A", 0, 0);
  made.add_point("crank.P", name(links_of_chain - 1), 0);
  made.add_joint("A", mechanism::JointType::revolute, {"ground.A", "crank.A"});
  made.add_driver("A", 0);
  made.add_output("P", "crank.P");
  return made;
}

mechanism::Request positions() {
  mechanism::Request request;
  request.want = {true, false, false, false};
  return request;
}

TEST(Values, OfALongChainOfParametersAreEvaluated) {
  for (const bool backwards : {false, true}) {
    const Plan plan(chain(backwards, 1), positions());
    Values values = plan.values();
    const auto length = [&] {
      return plan.solve(values).configurations.at(0).output("P").position.x();
    };
    EXPECT_EQ(length(), links_of_chain);
    values.set(plan.mechanism().parameter_named("p0", ""), 5);
    EXPECT_EQ(length(), links_of_chain + 4);
    values.set(plan.mechanism().parameter_named("p10000", ""), 0);
    EXPECT_EQ(length(), links_of_chain - 1 - 10000);
  }
}

TEST(Values, OfACycleAreRefusedByName) {
  const Mechanism made = chain(false, "p" + std::to_string(links_of_chain - 1));
  try {
    const Plan plan(made, positions());
    FAIL() << "a cycle was planned";
  } catch (const mechanism::MechanismError& error) {
    EXPECT_EQ(std::string(error.what()),
              "parameters.p0: the parameter depends on itself through 'p" +
                  std::to_string(links_of_chain - 1) + "'; give one of them a number");
  }
}

TEST(Values, OfAShortCycleAreRefusedByName) {
  Mechanism made;
  made.declare_parameter("a");
  made.declare_parameter("b");
  made.set_parameter("a", "2*b");
  made.set_parameter("b", "a + 1");
  made.add_link("ground");
  try {
    const Plan plan(made);
    FAIL() << "a cycle was planned";
  } catch (const mechanism::MechanismError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "parameters.a: the parameter depends on itself through 'b'; give one of them a number");
  }
}

}  // namespace
}  // namespace assur::test::values_test
