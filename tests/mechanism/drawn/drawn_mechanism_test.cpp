// Law: a drawing built in C++ has the solutions of the same drawing in a scene file; parts that do
// not fit are refused by name.
#include <gtest/gtest.h>

#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <functional>

#include "mechanism/same_solution.hpp"

namespace assur::test::drawn_mechanism_test {
namespace {

using mechanism::DrawnJoint;
using mechanism::DrawnMechanism;
using mechanism::JointType;
using mechanism::Mechanism;
using mechanism::Request;

constexpr const char* scene_text = R"({
  "points": {"A": [0, 0], "B": [20, "h"], "C": [3, -64], "D": [80, 0], "P": [-14, -162],
             "S": [40, 90]},
  "parameters": {"h": 35, "AB": {"drawn": ["A", "B"], "value": 42}, "phi": {"drawn": "A"}},
  "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "P"],
            "rocker": ["D", "C"], "slider": ["S"], "bar": ["P", "S"]},
  "joints": {"guide": {"type": "prismatic", "links": ["ground", "slider"], "at": "S",
                       "direction": [1, "h"], "limits": [-400, 400]}},
  "drivers": {"A": {"position": "phi + 1", "velocity": 10}},
  "outputs": ["P", "S"]})";

struct Built {
  Mechanism mechanism;
  Request request;
};

Built built() {
  Built result;
  Mechanism& made = result.mechanism;
  made.add_parameter("h", 35);
  made.declare_parameter("AB");
  made.set_parameter("AB", 42);
  made.declare_parameter("phi");
  DrawnMechanism drawn(made);
  drawn.add_point("A", 0, 0);
  drawn.add_point("B", 20, "h");
  drawn.add_point("C", 3, -64);
  drawn.add_point("D", 80, 0);
  drawn.add_point("P", -14, -162);
  drawn.add_point("S", 40, 90);
  drawn.add_link("ground", {"A", "D"});
  drawn.add_link("crank", {"A", "B"});
  drawn.add_link("coupler", {"B", "C", "P"});
  drawn.add_link("rocker", {"D", "C"});
  drawn.add_link("slider", {"S"});
  drawn.add_link("bar", {"P", "S"});
  drawn.set_length("AB", {{"A", "B"}});
  drawn.set_coordinate("phi", "A");
  DrawnJoint guide;
  guide.name = "guide";
  guide.type = JointType::prismatic;
  guide.links = {"ground", "slider"};
  guide.at = "S";
  guide.direction = {1, "h"};
  guide.limits = {-400, 400};
  drawn.add_joint(guide);
  drawn.place();
  drawn.add_driver("A", "phi + 1", 10);
  drawn.add_output("P", "P");
  drawn.add_output("S", "S");
  drawn.refer(result.request);
  return result;
}

TEST(DrawnMechanism, IsThatOfASceneFile) {
  const mechanism::Scene scene = mechanism::parse_scene(scene_text, "scene");
  const mechanism::Plan read(scene);
  const Built made = built();
  const mechanism::Plan plan(made.mechanism, made.request);
  const Solution one = plan.solve(plan.values());
  EXPECT_GT(one.configurations.size(), 1U);
  expect_same_solution(one, read.solve(read.values()));
  const auto nearest = plan.nearest(plan.values(), one);
  const auto nearest_read = read.nearest(read.values(), one);
  ASSERT_TRUE(nearest && nearest_read);
  EXPECT_EQ(nearest->configuration, nearest_read->configuration);
  EXPECT_TRUE(same_bits(nearest->distance, nearest_read->distance));
}

/// A number of the reference that belongs to links which are not reported keeps none of them.
TEST(DrawnMechanism, ReferenceKeepsNoLink) {
  Built made = built();
  made.request.reported.links = std::vector{index_of(made.mechanism.links(), std::string("crank"))};
  made.request.reported.joints.emplace();
  Mechanism without_outputs = made.mechanism;
  const mechanism::Plan plan(without_outputs, made.request);
  EXPECT_TRUE(index_of(plan.mechanism().links(), std::string("slider")).exists());  // an output
  EXPECT_EQ(plan.request().reference.size(), plan.mechanism().links().size() - 1);
}

struct Refusal {
  const char* name;
  std::function<void(DrawnMechanism&)> add;
  const char* message;
};

class DrawnRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(DrawnRefusal, NamesThePart) {
  Mechanism made;
  made.declare_parameter("x");
  DrawnMechanism drawn(made);
  drawn.add_point("A", 0, 0);
  drawn.add_point("B", 1, 1);
  drawn.add_link("ground", {"A"});
  drawn.add_link("crank", {"A", "B"});
  try {
    GetParam().add(drawn);
    FAIL() << "nothing is refused";
  } catch (const mechanism::MechanismError& error) {
    EXPECT_EQ(std::string(error.what()).find(GetParam().message), 0U) << error.what();
  }
}

const std::vector<Refusal> refusals = {
    {"PointTwice", [](DrawnMechanism& drawn) { drawn.add_point("A", 1, 2); },
     "points: the name 'A' is taken; choose another one"},
    {"LinkTwice", [](DrawnMechanism& drawn) { drawn.add_link("crank", {"A"}); },
     "links: the name 'crank' is taken; choose another one"},
    {"LengthWithoutParameter",
     [](DrawnMechanism& drawn) {
       drawn.set_length("y", {{"A", "B"}});
     },
     "parameters.y.drawn: no parameter named 'y'"},
    {"ParameterWithoutValue", [](DrawnMechanism& drawn) { drawn.place(); },
     "parameters.x: the parameter has no value; give it one"},
    {"OutputOfNoLink",
     [](DrawnMechanism& drawn) {
       drawn.add_point("C", 5, 5);
       drawn.set_length("x", {{"A", "B"}});
       drawn.place();
       drawn.add_output("C", "C");
     },
     "outputs.C: no link lists the point 'C'"},
};

INSTANTIATE_TEST_SUITE_P(Refusals, DrawnRefusal, testing::ValuesIn(refusals),
                         [](const auto& refusal) { return std::string(refusal.param.name); });

}  // namespace
}  // namespace assur::test::drawn_mechanism_test
