// Law: redundant constraints are left out, and named, if they hold and continue to hold in motion;
// otherwise the mechanism is refused as over-constrained.
#include <gtest/gtest.h>

#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "mechanism/five_bars.hpp"
#include "mechanism/scene_maker.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test {
namespace {

constexpr const char* too_many =
    "scene: joints: over-constrained by 1: the joints B, C, D, F, G constrain the links coupler, "
    "rocker, third more than their freedoms allow; take a joint or a driver away";

std::string too_many_by(const std::string& gap) {
  return too_many + ("; without constraints of F the mechanism can be assembled, but then these "
                     "constraints are violated by " +
                     gap + " at least");
}

std::vector<std::string> names_of(const mechanism::Plan& plan) {
  std::vector<std::string> names;
  for (const mechanism::RedundantJoint& joint : plan.redundant()) {
    names.push_back(joint.name);
  }
  return names;
}

TEST(RedundantJoints, OfAParallelogramOfFiveBarsHold) {
  for (const double phi : {0.7, 2.0, 3.5, -1.1}) {
    Bars bars = five_bars(2, 1.5);
    bars.json()["parameters"]["phi"] = phi;
    const Solved found = solved(bars.json());
    ASSERT_EQ(found.configurations().size(), 1U) << phi;  // the antiparallelogram does not hold
    EXPECT_EQ(found.plan.redundant().size(), 1U);
    const mechanism::Point& point = found.configurations()[0].output("G");
    EXPECT_NEAR(point.position.x(), 2 + 1.5 * std::cos(phi), 1e-14);
    EXPECT_NEAR(point.position.y(), 1.5 * std::sin(phi), 1e-14);
    EXPECT_NEAR(point.velocity.x(), -3 * std::sin(phi), 1e-13);
    EXPECT_NEAR(point.acceleration.y(), -6 * std::sin(phi), 1e-13);
  }
}

/// The bars have one motion, and a sweep one branch, also where the bars are in line, and where
/// without the left-out constraint the rocker could turn back.
TEST(RedundantJoints, LeaveAFlatParallelogramOneMotion) {
  for (const double third : {1.0, 2.0}) {
    for (const double phi : {0.0, 0.5, 1.0, 1.5, 2.0}) {
      Bars bars = five_bars(2, 1.5);
      bars.json()["links"]["ground"]["F"] = {third, 0};
      bars.json()["links"]["coupler"]["G"] = {third, 0};
      bars.json()["parameters"]["phi"] = phi * std::numbers::pi;
      const Solved found = solved(bars.json());
      ASSERT_EQ(found.configurations().size(), 1U) << phi;
      EXPECT_TRUE(found.configurations()[0].branches.empty());
      EXPECT_NEAR(found.configurations()[0].link("rocker").velocity(2), 2, 1e-7) << phi;
      EXPECT_NEAR(found.configurations()[0].link("third").velocity(2), 2, 1e-7) << phi;
      EXPECT_NEAR(found.configurations()[0].link("coupler").velocity(2), 0, 1e-7) << phi;
      EXPECT_NEAR(found.configurations()[0].link("rocker").acceleration(2), 0, 1e-5) << phi;
    }
    Bars bars = five_bars(2, 1.5);
    bars.json()["links"]["ground"]["F"] = {third, 0};
    bars.json()["links"]["coupler"]["G"] = {third, 0};
    bars.json()["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", "2*pi"}, {"count", 9}};
    int rows = 0;
    const auto record = [&](const mechanism::SweepRecord& at) {
      EXPECT_EQ(at.event, "");
      EXPECT_EQ(at.branch, 1);
      if (at.event.empty()) {
        EXPECT_NEAR(at.state->link("rocker").velocity(2), 2, 1e-7) << at.step;
        ++rows;
      }
    };
    mechanism::sweep(mechanism::Plan(mechanism::parse_scene(bars.json().dump(), "scene")),
                     {record, {}, {}});
    EXPECT_EQ(rows, 9);
  }
}

/// Three equal cranks, and a cylinder from the ground or from a crank to their coupler. If a
/// crank's two redundant constraints were left out, cranks and coupler alone would be a group that
/// moves.
TEST(RedundantJoints, OfParallelCranksOnACylinderHold) {
  for (const std::string base : {"ground", "crank"}) {
    Bars bars = five_bars(2, 1.5);
    const Json axis = {{"through", {0, 0}}, {"along", {1, 0}}};
    bars.json()["links"]["tube"]["axis"] = axis;
    bars.json()["links"]["rod"]["axis"] = axis;
    bars.point("tube", "Q", 0, 0).point("rod", "P", 0, 0).point("coupler", "P", 1.5, 0.2);
    bars.point(base, "Q", 0.3, 0.4);
    bars.join("Q", {base + ".Q", "tube.Q"}).join("P", {"rod.P", "coupler.P"});
    bars.json()["joints"]["S"] = {{"type", "prismatic"}, {"between", {"tube.axis", "rod.axis"}}};
    bars.json()["drivers"] = {{"S", {{"position", 1.6}, {"velocity", 0.2}}}};
    bars.json()["outputs"] = {{"P", "coupler.P"}, {"Q", base + ".Q"}};
    const Solved found = solved(bars.json());
    EXPECT_EQ(found.plan.redundant().size(), 1U);
    ASSERT_EQ(found.configurations().size(), 2U) << base;
    for (const Configuration& configuration : found.configurations()) {
      const mechanism::Point& end = configuration.output("P");
      const mechanism::Point& foot = configuration.output("Q");
      const Eigen::Vector2d along = end.position - foot.position;
      EXPECT_NEAR(along.norm(), 1.6, 1e-13);
      EXPECT_NEAR(along.dot(end.velocity - foot.velocity) / 1.6, 0.2, 1e-13);
      EXPECT_NEAR(configuration.link("coupler").pose.direction.cos, 1, 1e-13);
      EXPECT_NEAR(std::hypot(end.position.x() - 1.5, end.position.y() - 0.2), 1.5, 1e-13);
    }
  }
}

/// One of several equal cranks is driven; pins on the ground are at rest, one at its origin.
TEST(RedundantJoints, OfManyParallelCranksHold) {
  for (const int cranks : {3, 4, 5}) {
    for (const int driven : {0, 1, 2}) {
      SCOPED_TRACE(std::to_string(cranks) + " cranks, driven is " + std::to_string(driven));
      Json scene;
      scene["links"]["coupler"] = Json::object();
      for (int crank = 0; crank < cranks; ++crank) {
        const std::string number = std::to_string(crank);
        const std::string name = "crank" + number;
        const int row = crank / 3;
        const Json place = {crank % 3, 0.25 * row};
        scene["links"]["ground"]["A" + number] = place;
        scene["links"]["coupler"]["B" + number] = place;
        scene["links"][name] = {{"A", {0, 0}}, {"B", {1, 0}}};
        scene["joints"]["A" + number] = {{"type", "revolute"},
                                         {"between", {"ground.A" + number, name + ".A"}}};
        scene["joints"]["B" + number] = {{"type", "revolute"},
                                         {"between", {name + ".B", "coupler.B" + number}}};
      }
      scene["drivers"]["A" + std::to_string(driven)] = {{"position", 1.0}, {"velocity", 2}};
      const Solved found = solved(scene);
      EXPECT_EQ(found.plan.redundant().size(), static_cast<std::size_t>(cranks - 2));
      ASSERT_EQ(found.configurations().size(), 1U);
      const mechanism::Frame& coupler = found.configurations()[0].link("coupler");
      EXPECT_NEAR(coupler.pose.x, std::cos(1.0), 1e-13);
      EXPECT_NEAR(coupler.velocity(0), -2 * std::sin(1.0), 1e-12);
      EXPECT_NEAR(coupler.velocity(2), 0, 1e-12);
    }
  }
}

TEST(RedundantJoints, ThatDoNotHoldAreRefused) {
  Bars bars = five_bars(2, 1.500001);
  EXPECT_EQ(message_of(bars.json()), too_many_by("1e-06"));
  bars.json()["redundancy"]["tolerance"] = 1e-5;
  EXPECT_EQ(solved(bars.json()).configurations().size(), 1U);
  bars.json()["redundancy"]["tolerance"] = 1e-9;
  EXPECT_EQ(message_of(bars.json()), too_many_by("1e-06"));
}

/// The gap is the excess length of the third crank, in the scene's unit: only this crank does not
/// fit.
TEST(RedundantJoints, TellByHowMuchTheyDoNotHold) {
  EXPECT_EQ(message_of(five_bars(2, 1.6).json()), too_many_by("0.1"));
  EXPECT_EQ(message_of(five_bars(2, 16).json()), too_many_by("14.5"));
}

/// The least error of the rocker's length where the crank's tip and a third crank of the given
/// length hold the coupler, and with it C: two circles, then a distance.
double length_that_misses(double third, double phi) {
  const Eigen::Vector2d tip(1.5 * std::cos(phi), 1.5 * std::sin(phi));
  const Eigen::Vector2d from_f = tip - Eigen::Vector2d(2, 0);
  const double base = std::atan2(-from_f.y(), -from_f.x());
  const double half = std::acos((from_f.squaredNorm() + 4 - third * third) / (4 * from_f.norm()));
  double least = std::numeric_limits<double>::infinity();
  for (const double angle : {base + half, base - half}) {
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const double length = (tip + 4 * along - Eigen::Vector2d(4, 0)).norm();
    least = std::fmin(least, std::abs(length - 1.5));
  }
  return least;
}

/// The plan leaves out a constraint of C, and not one of the crank whose length is changed.
TEST(RedundantJoints, TellItAtOtherValuesThanTheScenesOwn) {
  for (const double phi : {0.7, 1.4, 2.3}) {
    Bars bars = five_bars(2, 1.5);
    bars.json()["parameters"]["phi"] = phi;
    bars.json()["parameters"]["third"] = 1.5;
    bars.json()["links"]["third"]["G"] = {"third", 0};
    const Solved found = solved(bars.json());
    ASSERT_EQ(names_of(found.plan), std::vector<std::string>{"C"});
    for (const double more : {1e-6, -1e-3, 4e-3}) {
      SCOPED_TRACE(more);
      try {
        (void)found.plan.solve(found.plan.values({{"third", 1.5 + more}}));
        FAIL() << "is solved";
      } catch (const mechanism::OverConstrained& refusal) {
        const double missed = length_that_misses(1.5 + more, phi);
        EXPECT_GT(missed, std::abs(more) / 2);
        EXPECT_NEAR(refusal.gap, missed, 1e-12 + 1e-9 * missed);
      }
    }
  }
}

/// The third crank has another pivot, and fits only where the first one stands upright: the
/// mechanism is locked there.
TEST(RedundantJoints, ThatHoldAtOneInstantAreRefused) {
  Bars bars = five_bars(1, std::hypot(1.0, 1.5));
  bars.json()["parameters"]["phi"] = "pi/2";
  EXPECT_EQ(message_of(bars.json()),
            std::string(too_many) +
                "; without constraints of C the mechanism can be assembled, and these constraints "
                "hold in this position, but not after the drivers advance");
}

/// Where the coupler cannot reach the second crank, nothing is known of the third.
TEST(RedundantJoints, SayWhereNothingCanBeAssembledWithoutThem) {
  Bars bars = five_bars(2, 1.5);
  bars.json()["links"]["ground"]["D"] = {40, 0};
  bars.json()["links"]["ground"]["F"] = {20, 0};
  EXPECT_EQ(
      message_of(bars.json()),
      std::string(too_many) +
          "; without constraints of C the mechanism cannot be assembled either: group 1 (dyad "
          "RRR: coupler, third): the joints B, F, G fail to close by 15.4 at least");
}

/// The cranks hold one another; a dyad of length 3 on their coupler does not reach over 23.93.
TEST(RedundantJoints, AreNotBlamedForWhatCannotReach) {
  Bars bars = five_bars(2, 1.5);
  bars.point("ground", "H", 30, 0).point("coupler", "K", 5, 1);
  bars.point("arm", "K", 0, 0).point("arm", "M", 1, 0);
  bars.point("lever", "H", 0, 0).point("lever", "M", 2, 0);
  bars.join("K", {"coupler.K", "arm.K"}).join("M", {"arm.M", "lever.M"});
  bars.join("H", {"ground.H", "lever.H"});
  EXPECT_NE(message_of(bars.json())
                .find("the mechanism cannot be assembled either: group 3 (dyad RRR: arm, lever): "
                      "the joints H, K, M fail to close by 20.9 at least"),
            std::string::npos);
}

/// A joint that a law reads, or that has limits, is kept; constraints of another are left out.
TEST(RedundantJoints, AreNoneThatLawsReadOrThatHaveLimits) {
  Bars bars = five_bars(2, 1.5);
  bars.point("ground", "H", 9, 0).point("hand", "H", 0, 0).join("H", {"ground.H", "hand.H"});
  bars.json()["drivers"]["H"]["position"] = "2*joint(C)";
  bars.json()["joints"]["B"]["limits"] = {-10, 10};
  const Solved found = solved(bars.json());
  ASSERT_EQ(found.configurations().size(), 1U);
  ASSERT_EQ(found.plan.redundant().size(), 1U);
  EXPECT_NE(found.plan.redundant()[0].name, "B");
  EXPECT_NE(found.plan.redundant()[0].name, "C");
}

/// If no configuration is within the limits of joints, the reason names the limits, and not the
/// redundant constraints.
TEST(RedundantJoints, BeyondLimitsHold) {
  Bars bars = five_bars(2, 1.5);
  bars.json()["joints"]["D"]["limits"] = {1, 2};
  const Solved found = solved(bars.json());
  EXPECT_EQ(found.solution.left_out, 1U);
  EXPECT_EQ(found.solution.reason,
            "the one configuration is beyond the limits of joints: D by 17.2 deg at least");
  EXPECT_EQ(found.plan.solve(found.plan.values({{"phi", 1.5}})).configurations.size(), 1U);
}

/// A ram in two guides in one line: the guide that is not reported is left out, in any listing.
TEST(RedundantJoints, AreThoseThatAreNotReported) {
  for (const std::string reported : {"first guide", "second guide"}) {
    Bars bars;
    const Json along = {1, 0};
    for (const auto& [name, x] : {std::pair("first guide", 0.0), std::pair("second guide", 2.0)}) {
      bars.json()["links"]["ground"][name] = {{"through", {x, 0.3}}, {"along", along}};
      bars.json()["links"]["ram"][name] = {{"through", {x / 2, 0}}, {"along", along}};
      bars.json()["joints"][name] = {
          {"type", "prismatic"},
          {"between", {std::string("ground.") + name, std::string("ram.") + name}}};
    }
    bars.point("rod", "B", 0, 0).point("rod", "C", 3, 0).point("ram", "C", 0, 0);
    bars.join("B", {"crank.B", "rod.B"}).join("C", {"rod.C", "ram.C"});
    bars.json()["report"] = {{"joints", {reported}}, {"links", {"rod"}}};
    const Solved found = solved(bars.json());
    ASSERT_EQ(found.configurations().size(), 2U);
    EXPECT_NE(names_of(found.plan), std::vector<std::string>{reported});
    const mechanism::Configuration& one = found.configurations()[0];
    ASSERT_EQ(one.slides.size(), 1U);
    EXPECT_TRUE(found.plan.request().reported.has(one.slides[0].joint)) << reported;
    const double shift = reported == "first guide" ? 0 : 1 - 2;
    EXPECT_NEAR(one.slides[0].displacement, one.link("ram").pose.x + shift, 1e-14);
  }
}

/// A redundant pin is replaced by a slot with a name such as `C of box`. A slide to which the scene
/// gives that very name is still reported.
TEST(RedundantJoints, HideNoSlideOfTheScene) {
  Bars bars = five_bars(2, 1.5);
  const Json axis = {{"through", {0, 0}}, {"along", {1, 0}}};
  bars.json()["links"]["ground"]["axis"] = axis;
  bars.json()["links"]["box"]["axis"] = axis;
  bars.json()["joints"]["C of box"] = {{"type", "prismatic"},
                                       {"between", {"ground.axis", "box.axis"}}};
  bars.json()["drivers"]["C of box"]["position"] = 0.5;
  const Solved found = solved(bars.json());
  ASSERT_EQ(names_of(found.plan), std::vector<std::string>{"C"});
  int described = 0;
  for (const mechanism::SlideState& slide : found.configurations()[0].slides) {
    described += found.plan.is_stand_in(slide.joint) ? 0 : 1;
  }
  EXPECT_EQ(described, 1);
}

/// Equal cranks carry a coupler, on which a door slides in two guides, moved by a rod. There are
/// redundant constraints of two sorts, each of which would also be left out by itself.
TEST(RedundantJoints, OfGuidesOnParallelCranksHold) {
  for (const int cranks : {3, 4}) {
    Json scene;
    for (int crank = 0; crank < cranks; ++crank) {
      const std::string number = std::to_string(crank);
      scene["links"]["ground"]["A" + number] = {2 * crank, 0};
      scene["links"]["coupler"]["B" + number] = {2 * crank, 2};
      scene["links"]["crank" + number] = {{"A", {0, 0}}, {"B", {0, 2}}};
      scene["joints"]["A" + number] = {{"type", "revolute"},
                                       {"between", {"ground.A" + number, "crank" + number + ".A"}}};
      scene["joints"]["B" + number] = {
          {"type", "revolute"}, {"between", {"crank" + number + ".B", "coupler.B" + number}}};
    }
    for (const std::string guide : {"G", "H"}) {
      const Json line = {{"through", {1, guide == "G" ? 1 : 3}}, {"along", {1, 0}}};
      scene["links"]["coupler"][guide] = line;
      scene["links"]["door"][guide] = line;
      scene["joints"][guide] = {{"type", "prismatic"},
                                {"between", {"coupler." + guide, "door." + guide}}};
    }
    scene["links"]["door"]["P"] = {2, 2};
    scene["links"]["rod"] = {{"P", {2, 2}}, {"Q", {5, 3}}};
    scene["links"]["ground"]["Q"] = {5, 3};
    scene["joints"]["P"] = {{"type", "revolute"}, {"between", {"door.P", "rod.P"}}};
    scene["joints"]["Q"] = {{"type", "revolute"}, {"between", {"rod.Q", "ground.Q"}}};
    scene["drivers"]["A0"] = {{"position", 0.2}, {"velocity", 1}};
    scene["outputs"]["P"] = "door.P";
    const Solved found = solved(scene);
    EXPECT_EQ(found.plan.redundant().size(), static_cast<std::size_t>(cranks - 1));
    ASSERT_EQ(found.configurations().size(), 2U);
    for (const Configuration& configuration : found.configurations()) {
      const mechanism::Point& pin = configuration.output("P");
      EXPECT_NEAR(pin.position.y(), 2 * std::cos(0.2), 1e-13);  // 2 in the coupler's frame
      EXPECT_NEAR(std::hypot(pin.position.x() - 5, pin.position.y() - 3), std::sqrt(10), 1e-13);
      EXPECT_NEAR(pin.velocity.y(), -2 * std::sin(0.2), 1e-13);
      EXPECT_NEAR(configuration.link("coupler").velocity(2), 0, 1e-13);
    }
  }
}

/// Two rows of equal bars, one on the other's coupler, with pins of both in one place: a slot from
/// one of these pins to the other would have no direction.
TEST(RedundantJoints, OfPinsInOnePlaceHold) {
  Json scene;
  scene["links"]["ground"]["W"] = {7, 9};
  scene["links"]["rod"] = {{"W", {7, 9}}, {"T", {0, 9}}};
  scene["links"]["top"]["T"] = {0, 9};
  scene["joints"]["T"] = {{"type", "revolute"}, {"between", {"rod.T", "top.T"}}};
  scene["joints"]["W"] = {{"type", "revolute"}, {"between", {"rod.W", "ground.W"}}};
  for (const int bar : {0, 1, 2}) {
    const std::string number = std::to_string(bar);
    const double x = bar * (bar + 1);
    scene["links"]["ground"]["A" + number] = {x, bar % 2};
    scene["links"]["coupler"]["B" + number] = {x + 4, 3 + bar % 2};
    scene["links"]["coupler"]["C" + number] = {x + 4, 3 + bar % 2};
    scene["links"]["top"]["D" + number] = {x + 7, 7 + bar % 2};
    scene["links"]["lower" + number] = {{"A", {0, 0}}, {"B", {4, 3}}};
    scene["links"]["upper" + number] = {{"C", {0, 0}}, {"D", {3, 4}}};
    for (const auto& [joint, low, high] : {std::tuple{"A", "ground", "lower"},
                                           {"B", "lower", "coupler"},
                                           {"C", "coupler", "upper"},
                                           {"D", "upper", "top"}}) {
      const auto feature = [&number, &joint = joint](const std::string& link) {
        return link +
               (link == "lower" || link == "upper" ? number + "." + joint : "." + (joint + number));
      };
      scene["joints"][joint + number] = {{"type", "revolute"},
                                         {"between", {feature(low), feature(high)}}};
    }
  }
  scene["drivers"]["A1"] = {{"position", 0.05}, {"velocity", 1}};
  const Solved found = solved(scene);
  EXPECT_EQ(found.plan.redundant().size(), 2U);
  ASSERT_FALSE(found.configurations().empty());
  for (const Configuration& configuration : found.configurations()) {
    EXPECT_NEAR(configuration.link("coupler").velocity(2), 0, 1e-12);
    EXPECT_NEAR(configuration.link("top").velocity(2), 0, 1e-12);
    EXPECT_LT(configuration.residual, 1e-12);
  }
}

TEST(RedundantJoints, OfADoorOnThreeHingesHold) {
  Bars bars;
  for (const char* hinge : {"H1", "H2"}) {
    bars.point("ground", hinge, 0, 0).point("crank", hinge, 0, 0);
    bars.join(hinge, {std::string("ground.") + hinge, std::string("crank.") + hinge});
  }
  bars.json()["outputs"]["B"] = "crank.B";
  const Solved found = solved(bars.json());
  EXPECT_EQ(found.configurations().size(), 1U);
  EXPECT_EQ(names_of(found.plan), (std::vector<std::string>{"H1", "H2"}));
  bars.json()["links"]["crank"]["H2"] = {0, 1e-3};
  EXPECT_NE(message_of(bars.json()).find("over-constrained by 4"), std::string::npos);
}

/// Constraints are chosen to be left out where the plan is made. Where the rest is nearly singular,
/// others are left out: the answer is that of a plan that is made there.
TEST(RedundantJoints, AreLeftOutAnewWhereTheRestHardlyDeterminesTheLinks) {
  SceneMaker maker;
  maker.line("ground", "gx", {0, 0}, {1, 0}).line("ground", "gy", {0, 0}, {0, 1});
  maker.line("bx", "g", {0, 0}, {1, 0}).line("by", "g", {0, 0}, {0, 1});
  maker.point("bx", "P", 0, 0).point("by", "Q", 0, 0).bar("ground", {{"O", 0}});
  maker.bar("cr", {{"O", 0}, {"M", 1}}).bar("bar", {{"P", 0}, {"Q", 2}, {"M", 1}});
  maker.slide("sx", "ground.gx", "bx.g").slide("sy", "ground.gy", "by.g").drive("O", "t", 1, 0);
  Json trammel = maker.parameter("t", 0.3).scene();
  const Solved made = solved(trammel);
  for (const double quarter : {0., 1., 2., -1.}) {
    for (double beside = 1e-12; beside < 0.1; beside *= 3) {
      for (const double t :
           {quarter * std::numbers::pi / 2 + beside, quarter * std::numbers::pi / 2 - beside}) {
        mechanism::Values values = made.plan.values();
        values.set(mechanism::ParameterIndex(0), t);
        const Solution found = made.plan.solve(values);
        ASSERT_EQ(found.configurations.size(), 1U) << found.reason << " at " << t;
        EXPECT_EQ(found.configurations[0].regularity, Status::ok);
        EXPECT_NEAR(found.configurations[0].link("bar").pose.direction.cos, -std::cos(t), 1e-12);
      }
    }
  }
  trammel["sweep"] = {{"parameter", "t"}, {"from", -1e-5}, {"to", 1e-5}, {"count", 21}};
  const SweepKept kept = run_sweep(mechanism::parse_scene(trammel.dump(), "scene", {}));
  EXPECT_EQ(kept.rows.size(), 21U);
  EXPECT_TRUE(kept.events.empty());
}

/// Beside the place where a crank is in line with another one, groups are regular and rounding
/// leaves them further apart than all constraints together.
TEST(RedundantJoints, OfCranksHoldWhereverThePlanIsMade) {
  const std::vector<std::vector<std::array<int, 2>>> lattice = {{{1, 2}, {2, 1}, {0, 1}},
                                                                {{2, 0}, {0, 2}, {1, 0}},
                                                                {{0, 0}, {3, 0}, {1, 0}},
                                                                {{3, 0}, {2, 1}, {1, 0}},
                                                                {{3, 2}, {0, 2}, {0, 1}}};
  for (const std::vector<std::array<int, 2>>& pivots : lattice) {
    SceneMaker maker;
    for (std::size_t crank = 0; crank < pivots.size(); ++crank) {
      const std::string number = std::to_string(crank);
      maker.point("ground", "A" + number, pivots[crank][0], pivots[crank][1]);
      maker.point("coupler", "B" + number, pivots[crank][0], pivots[crank][1]);
      maker.bar("crank" + number, {{"A" + number, 0}, {"B" + number, 2}});
    }
    Json json = maker.parameter("phi", 0.3).drive("A1", "phi", 0, 0).scene();
    json["want"] = {"position"};
    const Solved elsewhere = solved(json);
    for (const double quarter : {0., 1., 2.}) {
      for (double beside = 1e-12; beside < 0.01; beside *= 7) {
        for (const double phi :
             {quarter * std::numbers::pi / 2 + beside, quarter * std::numbers::pi / 2 - beside}) {
          SCOPED_TRACE(phi);
          json["parameters"]["phi"] = phi;
          mechanism::Values values = elsewhere.plan.values();
          values.set(mechanism::ParameterIndex(0), phi);
          EXPECT_EQ(elsewhere.plan.solve(values).configurations.size(),
                    solved(json).configurations().size());
        }
      }
    }
  }
}

}  // namespace
}  // namespace assur::test
