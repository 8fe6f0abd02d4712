// Law: drivers, laws, limits and references that make no sense are refused in one line that names
// the place, the fault and the remedy.
#include <gtest/gtest.h>

#include "mechanism/bars.hpp"

namespace assur::test::driver_refusals_test {
namespace {

using Json = nlohmann::ordered_json;

/// A crank-rocker with an arm on its coupler and a hand on the arm, both turned by drivers.
Json robot() {
  Bars bars;
  bars.four_bar().point("coupler", "F", 1, 1).point("rocker", "F", 1, 1);
  bars.point("arm", "E", 0, 0).point("arm", "G", 1, 0).point("arm", "F", 1, 1);
  bars.point("hand", "G", 0, 0).point("hand", "T", 1, 0);
  bars.join("E", {"coupler.E", "arm.E"}).join("G", {"arm.G", "hand.G"});
  Json& scene = bars.json();
  scene["drivers"]["E"]["position"] = 0.3;
  scene["drivers"]["G"]["position"] = "0.4*joint(D)";
  scene["outputs"]["T"] = "hand.T";
  return scene;
}

std::string message_with_law(const std::string& joint, const std::string& law) {
  Json scene = robot();
  scene["drivers"][joint]["position"] = law;
  return message_of(scene);
}

/// The robot with a bar that turns the coupler's end into a pin of three links.
Json robot_with_pin_of_three() {
  Json scene = robot();
  scene["links"]["ground"]["M"] = {1, 3};
  scene["links"]["bar"] = {{"C", {0, 0}}, {"T", {2, 0}}};
  scene["links"]["other"] = {{"T", {0, 0}}, {"M", {2, 0}}};
  scene["joints"]["C"]["between"].push_back("bar.C");
  scene["joints"]["T"] = {{"type", "revolute"}, {"between", {"bar.T", "other.T"}}};
  scene["joints"]["M"] = {{"type", "revolute"}, {"between", {"ground.M", "other.M"}}};
  return scene;
}

TEST(Laws, ThatReadOneAnotherInACircleAreNamed) {
  ASSERT_EQ(message_of(robot()), "no error");
  Json scene = robot();
  scene["drivers"]["A"]["position"] = "joint(G)";
  scene["drivers"]["E"]["position"] = "2*joint(A)";
  scene["drivers"]["G"]["position"] = "joint(E)";
  EXPECT_EQ(message_of(scene),
            "scene: drivers.A.position: the laws of the joints A, G, E read one another in a "
            "circle; let one of them not read the others");
  EXPECT_EQ(message_with_law("E", "1 + joint(E)"),
            "scene: drivers.E.position: the law reads its own joint; let it read another one");
}

TEST(Laws, ThatReadWhatIsNoCoordinateAreNamed) {
  EXPECT_EQ(message_with_law("E", "joint(Q)"),
            "scene: drivers.E.position: no joint named 'Q' (choose from A, B, C, D, E, G)");
  EXPECT_EQ(message_with_law("E", "joint(2)"),
            "scene: drivers.E.position: expected the name of a joint at column 7 of 'joint(2)'");
  Json scene = robot_with_pin_of_three();
  ASSERT_EQ(message_of(scene), "no error");
  scene["drivers"]["E"]["position"] = "joint(C)";
  EXPECT_EQ(message_of(scene),
            "scene: drivers.E.position: the joint 'C' joins more than two links and has no "
            "coordinate; give each link a pin of its own");
}

TEST(Laws, ThatDoNotStandInAPositionAreNamed) {
  const std::string alone = ": joint(D) may stand only in the position of a driver or in a load";
  Json scene = robot();
  scene["drivers"]["E"]["velocity"] = "joint(D)";
  EXPECT_EQ(message_of(scene), "scene: drivers.E.velocity" + alone);
  scene = robot();
  scene["parameters"]["q"] = "joint(D)";
  EXPECT_EQ(message_of(scene), "scene: parameters.q" + alone);
  scene = robot();
  scene["links"]["arm"]["G"] = {"joint(D)", 0};
  EXPECT_EQ(message_of(scene), "scene: links.arm.G[0]" + alone);
  scene = robot();
  scene["joints"]["C"]["limits"] = {0, "joint(D)"};
  EXPECT_EQ(message_of(scene), "scene: joints.C.limits[1]" + alone);
  scene = robot();
  scene["reference"]["coupler"] = "joint(D)";
  EXPECT_EQ(message_of(scene), "scene: reference.coupler" + alone);
}

/// The arm and the hand, which only depend on these links, are not named.
TEST(Laws, ThatMakeAGroupOfTheirOwnAreNamed) {
  for (const char* read : {"B", "C", "D"}) {
    EXPECT_EQ(message_with_law("A", "joint(" + std::string(read) + ")"),
              "scene: drivers: the law of the joint A reads joints of the links crank, coupler, "
              "rocker, which this law moves: the links can only be solved together, as a group "
              "that is not supported; let a law read joints that are placed before the links "
              "that it moves");
  }
}

TEST(Laws, WithoutAValueAreNamed) {
  EXPECT_EQ(message_with_law("E", "asin(5 + joint(D))"),
            "drivers.E.position: the value is not a finite number");
}

TEST(Drivers, TooManyAreNamed) {
  Json scene = robot();
  scene["drivers"]["D"]["position"] = 1;
  EXPECT_EQ(
      message_of(scene),
      "scene: joints: over-constrained by 1: the joints B, C constrain the link coupler more than "
      "its freedoms allow; take a joint or a driver away; without constraints of B the mechanism "
      "can be assembled, but then these constraints are violated by 0.475 at least");
}

TEST(Joints, BetweenLinksThatDriversTieTogetherAreNamed) {
  Json scene = robot();
  scene["joints"]["F"] = {{"type", "revolute"}, {"between", {"coupler.F", "arm.F"}}};
  EXPECT_EQ(message_of(scene),
            "scene: joints: over-constrained by 2: the joint F joins links that drivers tie "
            "together; take a joint or a driver away; without constraints of F the mechanism can "
            "be assembled, but then these constraints are violated by 1.71 at least");
  scene = robot();
  scene["drivers"].erase("G");
  scene["joints"]["G"]["between"].push_back("coupler.F");
  EXPECT_EQ(
      message_of(scene),
      "scene: joints: over-constrained by 2: the joint G joins links that drivers tie "
      "together; take a joint or a driver away; without constraints of G the mechanism can be "
      "assembled, but then these constraints are violated by 1.49 at least");
}

TEST(Joints, WithBothEndsOnOneLinkAreNamed) {
  Json scene = robot();
  scene["joints"]["E"]["between"] = {"coupler.E", "coupler.C"};
  EXPECT_EQ(message_of(scene), "scene: joints.E.between: link 'coupler' occurs twice in one joint");
}

std::string message_with_limits(const Json& limits) {
  Json scene = robot();
  scene["joints"]["C"]["limits"] = limits;
  return message_of(scene);
}

TEST(Limits, ThatAreNoneAreNamed) {
  ASSERT_EQ(message_with_limits({-10, 10}), "no error");
  EXPECT_EQ(message_with_limits({2, 1}),
            "joints.C.limits: the lowest is above the highest; exchange the two");
  for (const Json& limits : {Json::array({1}), Json::array({1, 2, 3}), Json(1), Json("1, 2")}) {
    EXPECT_EQ(message_with_limits(limits),
              "scene: joints.C.limits: expected the limits [lowest, highest]");
  }
  EXPECT_EQ(message_with_limits({0, nullptr}),
            "scene: joints.C.limits[1]: expected a number or an expression, found null");
  EXPECT_EQ(message_with_limits({"0/0", 1}),
            "joints.C.limits[0]: the value is not a finite number");
  Json scene = robot_with_pin_of_three();
  scene["joints"]["C"]["limits"] = {0, 1};
  EXPECT_EQ(message_of(scene),
            "scene: joints.C.limits: the joint 'C' joins more than two links and has no "
            "coordinate; give each link a pin of its own");
}

TEST(References, ThatAreNoneAreNamed) {
  Json scene = robot();
  scene["reference"]["cupler"] = 0;
  EXPECT_EQ(message_of(scene),
            "scene: reference: no link named 'cupler' (did you mean 'coupler'?)");
  scene = robot();
  scene["reference"]["ground"] = 0;
  EXPECT_EQ(message_of(scene),
            "scene: reference.ground: the ground stands still in all configurations; name a moving "
            "link");
  const Solved without = solved(robot());
  try {
    (void)without.plan.nearest(without.values, without.solution);
    ADD_FAILURE() << "no error";
  } catch (const mechanism::MechanismError& error) {
    EXPECT_STREQ(error.what(),
                 "reference: the nearest configuration needs a reference; give the angles of some "
                 "links");
  }
}

}  // namespace
}  // namespace assur::test::driver_refusals_test
