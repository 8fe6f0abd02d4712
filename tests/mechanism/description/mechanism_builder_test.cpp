// Law: a mechanism that is built in C++ has the solutions of the same mechanism in a scene file,
// and a part that does not fit is refused by name where it is added.
#include <gtest/gtest.h>

#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "mechanism/same_solution.hpp"

namespace assur::test::mechanism_builder_test {
namespace {

using mechanism::JointType;
using mechanism::Mechanism;

/// The mechanism of examples/four_bar_coupler_curve.json.
Mechanism four_bar() {
  Mechanism made("Hoeken's crank-rocker");
  made.add_parameter("ground", 80);
  made.add_parameter("crank", 40);
  made.set_tolerance("crank", 0.02);
  for (const char* bar : {"coupler", "rocker"}) {
    made.add_parameter(bar, 100.0);
    made.set_tolerance(bar, 0.05);
  }
  made.add_parameter("reach", 200);
  made.set_tolerance("reach", "reach/2000");
  made.add_parameter("phi", "60*deg");
  for (const char* link : {"ground", "crank", "coupler", "rocker"}) {
    made.add_link(link);
  }
  made.add_point("ground.A", 0, 0);
  made.add_point("ground.D", "ground", 0);
  made.add_point("crank.A", 0, 0);
  made.add_point("crank.B", "crank", 0);
  made.add_point("coupler.B", 0, 0);
  made.add_point("coupler.C", "coupler", 0);
  made.add_point("coupler.P", "reach", 0);
  made.add_point("rocker.D", 0, 0);
  made.add_point("rocker.C", "rocker", 0);
  made.add_joint("A", JointType::revolute, {"ground.A", "crank.A"});
  made.add_joint("B", JointType::revolute, {"crank.B", "coupler.B"});
  made.add_joint("C", JointType::revolute, {"coupler.C", "rocker.C"});
  made.add_joint("D", JointType::revolute, {"ground.D", "rocker.D"});
  made.add_driver("A", "phi", 10);
  made.add_output("P", "coupler.P");
  made.add_output("C", "coupler.C");
  return made;
}

Scene scene_of_file(const std::vector<std::string>& settings = {}) {
  return mechanism::read_scene(ASSUR_EXAMPLES "/four_bar_coupler_curve.json", settings);
}

TEST(MechanismBuilder, GivesTheSolutionOfTheSceneFile) {
  const Plan built(four_bar());
  const Solved read(scene_of_file());
  const Values values = built.values();
  EXPECT_EQ(read.configurations().size(), 2U);
  expect_same_solution(built.solve(values), read.solution);
  EXPECT_TRUE(same_matrix(values.spread().tolerances, read.values.spread().tolerances));
}

TEST(MechanismBuilder, ReplacedValuesAreSettings) {
  const Plan built(four_bar());
  const Values values = built.values({{"phi", 1.0}, {"reach", 150.0}});
  const Solved read(scene_of_file({"phi=1", "reach=150"}));
  expect_same_solution(built.solve(values), read.solution);
  expect_same_solution(read.plan.solve(read.plan.values({{"reach", 150.0}, {"phi", 1.0}})),
                       read.solution);
}

/// A plan needs its mechanism no longer, and a solution its plan: both may be destroyed.
TEST(MechanismBuilder, SolutionsOutliveTheirPlan) {
  Solution solution;
  {
    const Plan plan(four_bar());
    solution = plan.solve(plan.values());
  }
  EXPECT_EQ(solution.configurations.at(0).output("P").position.size(), 2);
}

TEST(MechanismBuilder, PartsOfAConfigurationGoByName) {
  const Solved read(scene_of_file());
  const Configuration& configuration = read.configurations().at(0);
  const mechanism::OutputIndex P(0);
  const mechanism::LinkIndex crank(1);
  EXPECT_EQ(&configuration.output("P"), &configuration.outputs[P]);
  EXPECT_EQ(&configuration.link("crank"), &configuration.links[crank]);
  EXPECT_EQ(configuration.link("crank").velocity(2), 10);
}

std::string message_of(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const mechanism::MechanismError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MechanismBuilder, UnknownPartsOfAConfigurationAreNamed) {
  const Solved read(scene_of_file());
  const Configuration& configuration = read.configurations().at(0);
  EXPECT_EQ(message_of([&] { (void)configuration.output("Q"); }),
            "no output named 'Q' (choose from P, C)");
  EXPECT_EQ(message_of([&] { (void)configuration.link("crnk"); }),
            "no link named 'crnk' (did you mean 'crank'?)");
  EXPECT_EQ(message_of([&] {
              (void)read.plan.values({{"pho", 1.0}});
            }),
            "no parameter named 'pho' (did you mean 'phi'?)");
}

struct Fault {
  const char* name;
  std::function<void(Mechanism&)> add;
  std::string message;
};

class BuilderFault : public testing::TestWithParam<Fault> {};

TEST_P(BuilderFault, NamesThePart) {
  Mechanism made = four_bar();
  EXPECT_EQ(message_of([&] { GetParam().add(made); }), GetParam().message);
}

using Names = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(
    MechanismBuilder, BuilderFault,
    testing::Values(
        Fault{"UnknownLink",
              [](Mechanism& made) {
                made.add_joint("E", JointType::revolute, {"ground.A", "crnk.A"});
              },
              "joints.E.between[1]: no link named 'crnk' (did you mean 'crank'?)"},
        Fault{"UnknownLinkOfAPoint", [](Mechanism& made) { made.add_point("couple.Q", 0, 0); },
              "links.couple.Q: no link named 'couple' (did you mean 'coupler'?)"},
        Fault{"UnknownFeature",
              [](Mechanism& made) {
                made.add_joint("E", JointType::revolute, {"ground.A", "crank.Q"});
              },
              "joints.E.between[1]: link 'crank' has no feature 'Q' (choose from A, B)"},
        Fault{"NoDot",
              [](Mechanism& made) {
                made.add_joint("E", JointType::revolute, {"ground.A", "crank"});
              },
              "joints.E.between[1]: expected 'link.feature', found 'crank'"},
        Fault{"LineAtARevoluteJoint",
              [](Mechanism& made) {
                made.add_line("coupler.axis", 0, 0, 1, 0);
                made.add_joint("E", JointType::revolute, {"ground.A", "coupler.axis"});
              },
              "joints.E.between: a revolute joint joins points, and 'coupler.axis' is a line"},
        Fault{"PointAtAPrismaticJoint",
              [](Mechanism& made) {
                made.add_joint("E", JointType::prismatic, {"ground.A", "coupler.B"});
              },
              "joints.E.between: a prismatic joint joins two lines, and 'ground.A' is a point"},
        Fault{"PinInNoSlot",
              [](Mechanism& made) {
                made.add_joint("E", JointType::pin_in_slot, {"ground.A", "coupler.B"});
              },
              "joints.E.between: a pin-in-slot joint joins a point and a line; found two points"},
        Fault{"OneFeature",
              [](Mechanism& made) { made.add_joint("E", JointType::revolute, {"ground.A"}); },
              "joints.E.between: expected two or more features [\"link.feature\", ...]"},
        Fault{"TwiceTheSameLink",
              [](Mechanism& made) {
                made.add_joint("E", JointType::revolute, {"crank.A", "crank.B"});
              },
              "joints.E.between: link 'crank' occurs twice in one joint"},
        Fault{"LinkTwice", [](Mechanism& made) { made.add_link("crank"); },
              "links: the name 'crank' is taken; choose another one"},
        Fault{"LinkWithADot", [](Mechanism& made) { made.add_link("a.b"); },
              "links: 'a.b' has a dot, which stands between the names of a link and its feature; "
              "write "
              "another letter"},
        Fault{"FeatureTwice", [](Mechanism& made) { made.add_point("crank.A", 1, 2); },
              "links.crank.A: the name 'A' is taken; choose another one"},
        Fault{"JointTwice",
              [](Mechanism& made) {
                made.add_joint("A", JointType::revolute, {"ground.A", "coupler.B"});
              },
              "joints: the name 'A' is taken; choose another one"},
        Fault{"OutputTwice", [](Mechanism& made) { made.add_output("P", "coupler.B"); },
              "outputs: the name 'P' is taken; choose another one"},
        Fault{"OutputOfALine",
              [](Mechanism& made) {
                made.add_line("coupler.axis", 0, 0, 1, 0);
                made.add_output("Q", "coupler.axis");
              },
              "outputs.Q: an output is a point, and this feature is a line"},
        Fault{"LineWithoutADirection",
              [](Mechanism& made) { made.add_line("coupler.axis", 0, 0, 0, "2 - 2"); },
              "links.coupler.axis.along: [0, 0] has no direction; at least one of the numbers must "
              "not be zero"},
        Fault{"ParameterTwice", [](Mechanism& made) { made.add_parameter("phi", 1); },
              "parameters: the name 'phi' is taken; choose another one"},
        Fault{"ParameterOfAFunctionsName", [](Mechanism& made) { made.add_parameter("sin", 1); },
              "parameters: 'sin' is the name of a function or constant; choose another one"},
        Fault{"DriverOfAnUnknownJoint", [](Mechanism& made) { made.add_driver("crank", "phi"); },
              "drivers: no joint named 'crank' (choose from A, B, C, D)"},
        Fault{"DriverTwice", [](Mechanism& made) { made.add_driver("A", "phi"); },
              "drivers.A: the joint has a driver already; give it only one"},
        Fault{"UnknownParameter", [](Mechanism& made) { made.add_point("crank.Q", "2*crnk", 0); },
              "links.crank.Q[0]: no parameter named 'crnk' (did you mean 'crank'?)"},
        Fault{"NoExpression", [](Mechanism& made) { made.add_point("crank.Q", 0, "2*"); },
              "links.crank.Q[1]: the expression ends where a number, a name or '(' is expected at "
              "column 3 of '2*'"}),
    [](const auto& fault) { return std::string(fault.param.name); });

/// A refused addition leaves the mechanism as it was.
TEST(MechanismBuilder, AFaultLeavesNothingBehind) {
  Mechanism made = four_bar();
  EXPECT_NE(message_of([&] { made.add_point("coupler.Q", "no_such", 0); }), "no error");
  EXPECT_NE(message_of([&] { made.add_line("coupler.R", 0, 0, 1, "no_such"); }), "no error");
  EXPECT_NE(message_of([&] { made.add_line("coupler.S", 0, 0, 0, 0); }), "no error");
  EXPECT_NE(message_of([&] { made.add_parameter("fresh", "no_such"); }), "no error");
  EXPECT_NE(message_of([&] { made.add_driver("B", 0, "no_such"); }), "no error");
  EXPECT_NE(message_of([&] { made.set_limits("C", 4, "no_such"); }), "no error");
  const Plan plan(made);
  expect_same_solution(plan.solve(plan.values()), Solved(scene_of_file()).solution);
}

TEST(MechanismBuilder, AParameterWithoutAValueIsNamed) {
  Mechanism made = four_bar();
  made.declare_parameter("later");
  EXPECT_EQ(message_of([&] { (void)Plan(made); }),
            "parameters.later: the parameter has no value; give it one");
}

mechanism::Mechanism turning_bar() {
  mechanism::Mechanism bar("a bar");
  bar.add_parameter("phi", 0.5);
  bar.add_parameter("a", 2);
  bar.add_link("ground");
  bar.add_point("ground.A", 0, 0);
  bar.add_link("bar");
  bar.add_point("bar.A", 0, 0);
  bar.add_point("bar.P", "a", 0);
  bar.add_joint("A", mechanism::JointType::revolute, {"ground.A", "bar.A"});
  bar.add_driver("A", "phi", 1);
  bar.add_output("P", "bar.P");
  return bar;
}

// Seven positions, some of them out of reach, are solved into one solution that is reused.
TEST(Solution, IsTheSameInTheMemoryOfAnother) {
  Mechanism linkage = four_bar();
  linkage.set_parameter("coupler", 30);
  const mechanism::Plan plan(linkage);
  mechanism::Solution reused;
  std::vector<std::size_t> counts;
  for (int step = 0; step < 7; ++step) {
    const mechanism::Values values = plan.values({{"phi", 0.9 * step}});
    plan.solve(values, reused);
    expect_same_solution(plan.solve(values), reused);
    counts.push_back(reused.configurations.size());
  }
  EXPECT_NE(std::count(counts.begin(), counts.end(), 0U), 0);
  EXPECT_NE(std::count(counts.begin(), counts.end(), 2U), 0);
}

TEST(MisusedLibrary, IsRefusedInALine) {
  using mechanism::MechanismError;
  mechanism::Mechanism bar = turning_bar();
  const mechanism::Plan plan(bar);
  const mechanism::Plan other(bar);
  EXPECT_THROW((void)plan.solve(other.values()), MechanismError);
  EXPECT_THROW((void)plan.values({{"phi", std::numeric_limits<double>::infinity()}}),
               MechanismError);
  EXPECT_THROW((void)mechanism::Configuration().link("bar"), MechanismError);
  mechanism::Values values = plan.values();
  EXPECT_THROW(values.set(mechanism::ParameterIndex(), 1), MechanismError);
  const mechanism::ParameterIndex phi = bar.parameter_named("phi");
  EXPECT_THROW(values.set(phi, std::nan("")), MechanismError);
  values.set(phi, 1);
  EXPECT_EQ(plan.solve(values).configurations.size(), 1U);
  EXPECT_THROW(bar.add_output("P", "bar.P"), MechanismError);
  mechanism::Request request;
  request.sweep = mechanism::Sweep{phi, {}, {}, 3};
  EXPECT_THROW(mechanism::Plan(bar, request), MechanismError);
  request.sweep = mechanism::Sweep{phi, bar.add_number(0, "from"), bar.add_number(1, "to"), 0};
  EXPECT_THROW(mechanism::Plan(bar, request), MechanismError);
}

TEST(MisusedLibrary, ANumberThatNoConfigurationHasIsRefused) {
  mechanism::Mechanism bar = turning_bar();
  mechanism::Request request;
  request.sweep = mechanism::Sweep{bar.parameter_named("phi"), bar.add_number(0, "from"),
                                   bar.add_number(1, "to"), 3};
  const mechanism::Plan plan(bar, request);
  mechanism::Solution solution;
  EXPECT_EQ(message_of([&] { (void)plan.solve_one(plan.values(), 0, solution); }),
            "there is no configuration 0; they are numbered from 1");
  EXPECT_EQ(
      message_of([&] { (void)mechanism::sweep_branch(plan, 0, {}); }),
      "reference: the nearest configuration needs a reference; give the angles of some links");
  EXPECT_EQ(message_of([&] { (void)mechanism::sweep_branch(plan, 1, {}); }), "no error");
}

/// A table of the request has the wrong size, or the mechanism does not have its index.
TEST(MisusedLibrary, ARequestThatDoesNotFitIsRefusedInALine) {
  mechanism::Mechanism bar = turning_bar();
  const auto refusal = [&bar](const auto& ask) {
    mechanism::Request request;
    ask(request);
    return message_of([&] { (void)mechanism::Plan(bar, request); });
  };
  const mechanism::ParameterIndex phi = bar.parameter_named("phi");
  const mechanism::NumberIndex variance = bar.add_number(1, "variance");
  const std::string each =
      "covariance.matrix: expected a row and a column for each of the parameters";
  EXPECT_EQ(refusal([&](auto& request) {
              request.covariance = mechanism::Covariance{{phi}, {}};
            }),
            each);
  EXPECT_EQ(refusal([&](auto& request) {
              request.covariance = mechanism::Covariance{{phi}, {{variance, variance}}};
            }),
            each);
  EXPECT_EQ(refusal([&](auto& request) {
              request.covariance = mechanism::Covariance{{phi}, {{mechanism::NumberIndex()}}};
            }),
            "covariance.matrix: the mechanism has no number of this index");
  EXPECT_EQ(refusal([&](auto& request) {
              request.redundancy_tolerance = mechanism::NumberIndex(bar.numbers().size());
            }),
            "redundancy.tolerance: the mechanism has no number of this index");
  EXPECT_EQ(refusal([&](auto& request) { request.variable = {mechanism::ParameterIndex(9)}; }),
            "variable: the mechanism has no parameter of this index");
  EXPECT_EQ(refusal([&](auto& request) {
              request.covariance = mechanism::Covariance{{phi}, {{variance}}};
            }),
            "no error");
}

TEST(MisusedLibrary, AFormulaThatIsReplacedOrNotUsedDoesNotCount) {
  mechanism::Mechanism bar = turning_bar();
  bar.set_parameter("a", "1/0");
  EXPECT_THROW((void)mechanism::Plan(bar).values(), mechanism::MechanismError);
  bar.set_parameter("a", 3);
  bar.add_point("bar.unused", "1/0", 0);
  const mechanism::Plan plan(bar);
  EXPECT_NEAR(plan.solve(plan.values()).configurations[0].output("P").position.norm(), 3, 1e-15);
}

TEST(MisusedLibrary, ValuesThatWereRefusedAreNotSolved) {
  mechanism::Mechanism bar = turning_bar();
  bar.set_parameter("a", "sqrt(phi)");
  const mechanism::Plan plan(bar);
  mechanism::Values values = plan.values();
  const mechanism::ParameterIndex phi = bar.parameter_named("phi");
  EXPECT_THROW(values.set(phi, -1), mechanism::MechanismError);
  EXPECT_THROW((void)plan.solve(values), mechanism::MechanismError);
  values.set(phi, 4);
  EXPECT_EQ(plan.solve(values).configurations[0].output("P").position,
            plan.solve(plan.values({{"phi", 4.0}})).configurations[0].output("P").position);
}

}  // namespace
}  // namespace assur::test::mechanism_builder_test
