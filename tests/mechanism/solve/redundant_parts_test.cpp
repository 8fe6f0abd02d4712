// Law: consistent redundant slides and slots are left out like pins, and the constraints left out
// of one part of a mechanism depend neither on other parts nor on names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "mechanism/scene_maker.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::redundant_parts {
namespace {

using Scene = nlohmann::ordered_json;

std::vector<std::string> names_of(const mechanism::Plan& plan) {
  std::vector<std::string> names;
  for (const mechanism::RedundantJoint& joint : plan.redundant()) {
    names.push_back(joint.name);
  }
  return names;
}

/// A slider with pins in slots along the x-axis; if `guided`, it is in a slide along it, too.
SceneMaker slider(const std::vector<Eigen::Vector2d>& pins, bool guided) {
  SceneMaker scene;
  scene.bar("ground", {{"A", 0}})
      .bar("crank", {{"A", 0}, {"B", 2}})
      .bar("rod", {{"B", 0}, {"C", 5}});
  scene.point("slider", "C", 0, 0).drive("A", 0.7, 1, 0.5);
  if (guided) {
    scene.line("ground", "guide", {3, 0}, {1, 0}).line("slider", "guide", {1, 0}, {1, 0});
    scene.slide("guide", "ground.guide", "slider.guide");
  }
  for (std::size_t place = 0; place < pins.size(); ++place) {
    const std::string name = "pin" + std::to_string(place);
    scene.point("slider", name, pins[place].x(), pins[place].y());
    scene.line("ground", name, {0.3, pins[place].y()}, {1, 0});
    scene.slot(name, "slider." + name, "ground." + name);
  }
  return scene;
}

void expect_slider(const Solved& found) {
  const double phi = 0.7;
  ASSERT_EQ(found.configurations().size(), 2U);
  for (const Configuration& configuration : found.configurations()) {
    const mechanism::Frame& at = configuration.link("slider");
    const double rod = at.pose.x - 2 * std::cos(phi);  // along the x-axis
    const double height = 2 * std::sin(phi);
    EXPECT_NEAR(std::abs(rod), std::sqrt(25 - height * height), 1e-13);
    EXPECT_NEAR(at.pose.y, 0, 1e-13);
    EXPECT_NEAR(at.pose.direction.cos, 1, 1e-13);
    EXPECT_NEAR(at.velocity(0), -height - height * 2 * std::cos(phi) / rod, 1e-12);
    EXPECT_NEAR(at.velocity(2), 0, 1e-12);
  }
}

TEST(RedundantParts, ASliderIsGuidedBySlotsThatHold) {
  for (const Eigen::Vector2d& pin : {Eigen::Vector2d(0.5, 1), {0, 1}, {0, -1}, {1, 0}, {0, 0}}) {
    SCOPED_TRACE(pin.transpose());
    const Solved found = solved(slider({pin}, true).scene());
    EXPECT_EQ(names_of(found.plan), std::vector<std::string>{"pin0"});
    expect_slider(found);
  }
  expect_slider(solved(slider({{0.5, 1}, {0.7, -1}}, true).scene()));
  const Solved pins = solved(slider({{0.5, 1}, {-0.6, 1}, {0.2, 0}}, false).scene());
  EXPECT_EQ(pins.plan.redundant().size(), 1U);
  expect_slider(pins);
}

TEST(RedundantParts, SlotsThatDoNotHoldAreRefused) {
  Scene scene = slider({{0.5, 1}}, true).scene();
  scene["links"]["slider"]["pin0"] = {3, 1.01};
  EXPECT_NE(
      message_of(scene).find("without constraints of guide the mechanism can be assembled, but "
                             "then these constraints are violated by 0.01 at least"),
      std::string::npos);
  // The pin is in the slot where the crank is at 0.7, and leaves it as soon as the crank goes on.
  scene["links"]["slider"]["pin0"] = {0, 1};
  const double x = 2 * std::cos(0.7) + std::sqrt(25 - std::pow(2 * std::sin(0.7), 2));
  scene["links"]["ground"]["pin0"] = {{"through", {x, 1}}, {"along", {1, 1}}};
  EXPECT_NE(message_of(scene).find(
                "these constraints hold in this position, but not after the drivers advance"),
            std::string::npos);
}

/// A mechanism of three slides: a wedge lifts a follower by half of its own motion.
TEST(RedundantParts, AWedgeLifts) {
  SceneMaker maker;
  maker.line("ground", "floor", {0, 0}, {1, 0}).line("ground", "wall", {1, 0}, {0, 1});
  maker.line("wedge", "floor", {0, 0}, {1, 0}).line("wedge", "slope", {0, 0.2}, {2, 1});
  maker.line("follower", "slope", {0, 0}, {2, 1}).line("follower", "wall", {0, 0}, {0, 1});
  maker.slide("floor", "ground.floor", "wedge.floor")
      .slide("slope", "wedge.slope", "follower.slope");
  maker.slide("wall", "ground.wall", "follower.wall").drive("floor", 0.7, 2, 0.5);
  const Solved found = solved(maker.scene());
  ASSERT_EQ(found.configurations().size(), 1U);
  EXPECT_EQ(found.plan.redundant().size(), 1U);
  const mechanism::Frame& at = found.configurations()[0].link("follower");
  EXPECT_NEAR(at.pose.x, 1, 1e-14);
  EXPECT_NEAR(at.pose.y, 0.2 + (1 - 0.7) / 2, 1e-14);
  EXPECT_NEAR(at.velocity(1), -1, 1e-13);
  EXPECT_NEAR(at.acceleration(1), -0.25, 1e-13);
  for (const mechanism::SlideState& slide : found.configurations()[0].slides) {
    const std::string& name = found.plan.mechanism().joints()[slide.joint].name;
    EXPECT_EQ(found.plan.is_stand_in(slide.joint), name == names_of(found.plan)[0]) << name;
  }
}

/// Three four-bars of Roberts on one point of a coupler, their last cranks on one pivot.
SceneMaker cognates() {
  const double size = std::hypot(2, 2.8);  // of the coupler's sides at that point
  SceneMaker scene;
  scene.point("ground", "A", 0, 0).point("ground", "D", 4, 0).point("ground", "Q", 2, 2.8);
  scene.bar("crank", {{"A", 0}, {"B", 2}}).bar("rocker", {{"D", 0}, {"C", 3}});
  scene.bar("coupler", {{"B", 0}, {"C", 4}}).point("coupler", "P", 2, 2.8);
  for (const auto& [number, foot, across, length] :
       {std::tuple{"1", "A", 1.4, 2.0}, {"2", "D", -1.4, 3.0}}) {
    const std::string side = std::string("side") + number;
    const std::string plate = std::string("plate") + number;
    const std::string last = std::string("last") + number;
    const std::string pin = std::string("G") + number;
    const std::string low = std::string("L") + number;
    const std::string high = std::string("H") + number;
    scene.point(side, low, 0, 0).point(side, pin, size, 0);
    scene.point(plate, pin, 0, 0).point(plate, "P", length, 0);
    scene.point(plate, high, length / 2, across * length / 2);
    scene.point(last, high, (length == 2 ? 3 : 2) * size / 4, 0).point(last, "Q", 0, 0);
    scene.json["joints"][low] = {{"type", "revolute"},
                                 {"between", {std::string("ground.") + foot, side + "." + low}}};
  }
  scene.drive("A", 0.7, 1, 0);
  return scene;
}

/// A trammel beside it, with its own crank.
void add_trammel(SceneMaker& scene) {
  scene.point("ground", "O", 20, 3).line("ground", "x", {20, 3}, {1, 0});
  scene.line("ground", "y", {20, 3}, {0, 1}).point("bar", "x", -1, 0).point("bar", "y", 1, 0);
  scene.point("bar", "M", 0, 0).point("radius", "O", 0, 0).point("radius", "M", 1, 0);
  scene.slot("x", "bar.x", "ground.x").slot("y", "bar.y", "ground.y").drive("O", 0.7, 1, 0);
}

/// The scene with other names of its links and joints, in another order.
Scene renamed(const Scene& scene, std::mt19937& random) {
  const auto names = [&](const Scene& of, const std::string& letter) {
    std::vector<std::string> own;
    std::vector<std::string> other;
    for (const auto& [name, item] : of.items()) {
      own.push_back(name);
      other.push_back(letter + std::to_string(10 + other.size()));
    }
    std::shuffle(other.begin(), other.end(), random);
    std::map<std::string, std::string> result;
    for (std::size_t place = 0; place < own.size(); ++place) {
      result[own[place]] = own[place] == "ground" ? own[place] : other[place];
    }
    return result;
  };
  const std::map<std::string, std::string> links = names(scene["links"], "link");
  const std::map<std::string, std::string> joints = names(scene["joints"], "joint");
  const auto feature_of = [&](const std::string& text) {
    const std::size_t dot = text.find('.');
    return links.at(text.substr(0, dot)) + text.substr(dot);
  };
  Scene result = scene;
  result["links"] = result["joints"] = result["drivers"] = Scene::object();
  for (const auto& [name, other] : links) {
    result["links"][other] = scene["links"][name];
  }
  for (const auto& [name, other] : joints) {
    result["joints"][other] = scene["joints"][name];
    for (Scene& feature : result["joints"][other]["between"]) {
      feature = feature_of(feature.get<std::string>());
    }
  }
  for (Scene& point : result["outputs"]) {
    point = feature_of(point.get<std::string>());
  }
  for (const auto& [name, driver] : scene["drivers"].items()) {
    result["drivers"][joints.at(name)] = driver;
  }
  return result;
}

/// Which constraint a search leaves out depends on the names of joints: here they are random.
TEST(RedundantParts, AreFoundUnderAnyName) {
  SceneMaker trammel = cognates();
  add_trammel(trammel);
  std::mt19937 random(7);
  for (int naming = 0; naming < 12; ++naming) {
    SCOPED_TRACE(naming);
    const Scene scene = renamed(trammel.scene(), random);
    const Solved found = solved(scene);
    EXPECT_FALSE(found.plan.redundant().empty());
    ASSERT_EQ(found.configurations().size(), 2U);
    for (const Configuration& configuration : found.configurations()) {
      EXPECT_EQ(configuration.regularity, Status::ok);
      const Eigen::Vector2d to_q = Eigen::Vector2d(2, 2.8) - configuration.output("H1").position;
      EXPECT_NEAR(to_q.norm(), 3 * std::hypot(2, 2.8) / 4, 1e-12);
      const Eigen::Vector2d low = configuration.output("x").position;
      const Eigen::Vector2d high = configuration.output("y").position;
      EXPECT_NEAR((low - Eigen::Vector2d(20 + 2 * std::cos(0.7), 3)).norm(), 0, 1e-12);
      EXPECT_NEAR((high - Eigen::Vector2d(20, 3 + 2 * std::sin(0.7))).norm(), 0, 1e-12);
    }
  }
}

/// Chebyshev's linkage and both its cognates on flat couplers: what is left out first decides
/// whether anything can be left out after it.
TEST(RedundantParts, OfFlatCognatesAreFoundUnderAnyName) {
  SceneMaker maker;
  maker.bar("ground", {{"O", 0}, {"P", 6}, {"Q", 3}}).bar("crank", {{"O", 0}, {"A", 2}});
  maker.bar("coupler", {{"A", 0}, {"B", 5}, {"C", 2.5}}).bar("rocker", {{"P", 0}, {"B", 5}});
  maker.bar("a", {{"O2", 0}, {"D", 2.5}}).bar("b", {{"D", 0}, {"C", 2}, {"E", 1}});
  maker.bar("c", {{"Q", 0}, {"E", 2.5}}).bar("d", {{"P2", 0}, {"F", 2.5}});
  maker.bar("e", {{"F", 0}, {"C", 5}, {"G", 2.5}}).bar("f", {{"Q2", 0}, {"G", 1}});
  maker.bar("ground", {{"O2", 0}, {"P2", 6}, {"Q2", 3}}).drive("O", 1, 1, 0.5);
  std::mt19937 random(7);
  for (int naming = 0; naming < 12; ++naming) {
    SCOPED_TRACE(naming);
    const Solved found = solved(renamed(maker.scene(), random));
    EXPECT_EQ(found.plan.redundant().size(), 2U);
    ASSERT_EQ(found.configurations().size(), 2U);
    for (const Configuration& configuration : found.configurations()) {
      EXPECT_EQ(configuration.regularity, Status::ok);
      const auto distance = [&](const std::string& one, const std::string& other) {
        return (configuration.output(one).position - configuration.output(other).position).norm();
      };
      EXPECT_NEAR(distance("A", "C"), 2.5, 1e-12);
      EXPECT_NEAR(distance("C", "D"), 2, 1e-12);
      EXPECT_NEAR(distance("C", "G"), 2.5, 1e-12);
      EXPECT_NEAR(distance("Q", "E"), 2.5, 1e-12);
      EXPECT_NEAR(distance("Q", "G"), 1, 1e-12);
    }
  }
}

/// Scott Russell's linkage on two blocks, driven at the low one, with a rod of this length.
SceneMaker scott_russell(double unit, double rod) {
  SceneMaker scene;
  scene.bar("ground", {{"A", 0}}).bar("crank", {{"A", 0}, {"B", 3 * unit}});
  scene.bar("rod", {{"C", 0}, {"B", 3 * unit}, {"D", rod}});
  scene.line("ground", "x", {0, 0}, {1, 0}).line("ground", "y", {0, 0}, {0, 1});
  scene.point("low", "C", 0, 0).line("low", "x", {0, 0}, {1, 0}).slide("x", "ground.x", "low.x");
  scene.point("high", "D", 0, 0).line("high", "y", {0, 0}, {0, 1});
  scene.slide("y", "ground.y", "high.y").drive("x", 3 * unit, unit, 0);
  return scene;
}

/// Scott Russell's linkage on two blocks, driven at a block, in units from 1e-9 to 1e9 of its size:
/// whether the left-out constraint holds is tested after a motion by a part of that size.
TEST(RedundantParts, HoldInAnyUnit) {
  for (const double unit : {1e-9, 1e-3, 1.0, 1e9}) {
    SCOPED_TRACE(unit);
    const Solved found = solved(scott_russell(unit, 6 * unit).scene());
    EXPECT_EQ(found.plan.redundant().size(), 1U);
    ASSERT_EQ(found.configurations().size(), 2U);
    for (const Configuration& configuration : found.configurations()) {
      EXPECT_EQ(configuration.regularity, Status::ok);
      const mechanism::Point& high = configuration.output("D");
      EXPECT_NEAR(std::abs(high.position.y()), std::sqrt(27) * unit, 1e-14 * unit);
      EXPECT_NEAR(high.velocity.y() * high.position.y(), -3 * unit * unit, 1e-13 * unit * unit);
    }
  }
}

/// Scott Russell's linkage driven at a block, and a bar that is pinned to the ground more than a
/// hundred times as far away as the block can go.
TEST(RedundantParts, HoldBesideALongLink) {
  for (const double far : {300.0, 3000.0, 30000.0}) {
    SCOPED_TRACE(far);
    SceneMaker maker = scott_russell(1, 6);
    maker.bar("ground", {{"Z", far}}).bar("bar", {{"Z", 0}}).drive("Z", 1, 0, 0);
    const Solved found = solved(maker.scene());
    EXPECT_EQ(found.plan.redundant().size(), 1U);
    ASSERT_EQ(found.configurations().size(), 2U);
    for (const Configuration& configuration : found.configurations()) {
      EXPECT_NEAR(std::abs(configuration.output("D").position.y()), std::sqrt(27), 1e-13);
    }
  }
}

/// Two parallelograms in a row, each with a third crank; two of their pins are in one place on the
/// lever between them. A slot from one of these to the other would have no direction, so none is
/// put there, though the names of these pins come first.
TEST(RedundantParts, LieTowardsOtherPlacesAlone) {
  SceneMaker maker;
  maker.bar("ground", {{"O", 0}, {"M", 2}, {"P", 4}, {"N", 6}, {"Q", 8}});
  maker.bar("crank", {{"O", 0}, {"C", 3}}).bar("x", {{"M", 0}, {"m", 3}});
  maker.bar("one", {{"C", 0}, {"m", 2}, {"B", 4}}).bar("other", {{"A", 0}, {"n", 2}, {"D", 4}});
  maker.parameter("rest", "3 - whole + 1").parameter("whole", 1);
  maker.bar("lever", {{"P", 0}, {"A", 3}, {"B", "rest"}}).bar("y", {{"N", 0}, {"n", 3}});
  maker.bar("rocker", {{"Q", 0}, {"D", 3}}).drive("O", 1, 1, 0.5);
  const Solved found = solved(maker.scene());
  EXPECT_EQ(names_of(found.plan), (std::vector<std::string>{"A", "B"}));
  ASSERT_EQ(found.configurations().size(), 1U);
  EXPECT_EQ(found.configurations()[0].regularity, Status::ok);
  for (const auto& [pin, place] : std::map<std::string, double>{{"m", 2}, {"n", 6}, {"D", 8}}) {
    const mechanism::Point& at = found.configurations()[0].output(pin);
    EXPECT_NEAR((at.position - Eigen::Vector2d(place + 3 * std::cos(1), 3 * std::sin(1))).norm(), 0,
                1e-13);
    EXPECT_NEAR((at.velocity - 3 * Eigen::Vector2d(-std::sin(1), std::cos(1))).norm(), 0, 1e-13);
  }
}

/// A linkage that locks, in any unit: its rod is too long by a hundredth.
TEST(RedundantParts, ThatDoNotHoldAreRefusedInAnyUnit) {
  for (const double unit : {1e-9, 1e-3, 1.0, 1e9}) {
    SCOPED_TRACE(unit);
    const std::string message = message_of(scott_russell(unit, 6.06 * unit).scene());
    EXPECT_NE(message.find("over-constrained by 1"), std::string::npos) << message;
  }
}

/// At 1e-7 rad from where the rod lies along the low guide, its dyad has two configurations that
/// rounding cannot separate. Whether a slot on the rod reaches the pin is in doubt there.
TEST(RedundantParts, BehindTwoConfigurationsThatAreOneAreInDoubt) {
  SceneMaker maker;
  maker.bar("ground", {{"A", 0}}).bar("crank", {{"A", 0}, {"B", 3}}).drive("A", 1e-7, 1, 0.5);
  maker.bar("rod", {{"B", 3}, {"D", 6}}).line("rod", "s", {0, 0}, {1, 0});
  maker.line("ground", "x", {0, 0}, {1, 0}).line("ground", "y", {0, 0}, {0, 1});
  maker.line("low", "x", {0, 0}, {1, 0}).slide("x", "ground.x", "low.x");
  maker.point("low", "C", 0, 0).point("high", "D", 0, 0).line("high", "y", {0, 0}, {0, 1});
  maker.slide("y", "ground.y", "high.y").slot("C", "low.C", "rod.s");
  const Solved found = solved(maker.scene());
  EXPECT_EQ(found.solution.status, mechanism::SolutionStatus::degenerate);
  EXPECT_EQ(found.solution.mobility, 0);
  EXPECT_NE(found.solution.reason.find("depends on the last digit: rounding cannot separate two "
                                       "configurations of the links that hold their group"),
            std::string::npos);
  maker.drive("A", 1e-3, 1, 0.5);
  EXPECT_EQ(solved(maker.scene()).configurations().size(), 2U);
}

}  // namespace
}  // namespace assur::test::redundant_parts
