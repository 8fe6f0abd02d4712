// Law: oddities in a scene are reported without stopping the answer: links that turn freely, sweeps
// that move nothing, configurations beyond limits; circuits are reported on request.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "command/command.hpp"

namespace assur::test::told_oddities_test {
namespace {

using Json = nlohmann::json;

Json four_bar() {
  return Json::parse(R"({"points": {"A": [0, 0], "B": [20, 34.6], "C": [3.1, -63.9], "D": [80, 0],
        "P": [-13.8, -162.5], "Q": [10, 10]},
      "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "P"],
                "rocker": ["D", "C"]},
      "parameters": {"phi": {"drawn": "A"}},
      "drivers": {"A": {"position": "phi", "velocity": 10}}, "outputs": ["P"],
      "sweep": {"parameter": "phi", "from": 0, "to": "2*pi", "count": 9}})");
}

CommandResult solved(const Json& scene, const std::string& options) {
  const TemporaryDirectory directory;
  return run_assur("solve " + directory.write("scene.json", scene.dump()).string() + options);
}

Json answer(const Json& scene, const std::string& options = "") {
  return Json::parse(solved(scene, " --format json" + options).output);
}

/// Those of all configurations, in whatever order: another link makes another order.
std::multiset<std::string> outputs_of(const Json& solution) {
  std::multiset<std::string> outputs;
  for (const Json& one : solution["configurations"]) {
    outputs.insert(one["outputs"].dump());
  }
  return outputs;
}

struct Idle {
  const char* name;
  const char* pin;      ///< from which the idle link is drawn to Q
  const char* carrier;  ///< the link that it follows
};

class IdleLinks : public testing::TestWithParam<Idle> {};

/// On the ground, on a moving link, on a pin of two links: all else is as without it, and it keeps
/// the drawn angle to the link that carries it, in every configuration and at every angle.
TEST_P(IdleLinks, AreLeftAtRestAsTheyAreDrawn) {
  Json scene = four_bar();
  const Json without = answer(scene);
  scene["links"]["washer"] = {GetParam().pin, "Q"};
  const CommandResult told = solved(scene, "");
  EXPECT_EQ(told.status, 0);
  EXPECT_NE(told.messages.find("warning: "), std::string::npos);
  EXPECT_NE(told.messages.find("the link 'washer' turns freely on its one pin"), std::string::npos)
      << told.messages;
  const Json with = answer(scene);
  EXPECT_EQ(with["idle"], Json::array({"washer"}));
  const Json& points = scene["points"];
  const auto& [pin, to] = std::pair(points[GetParam().pin], points["Q"]);
  const double drawn = std::atan2(to[1].get<double>() - pin[1].get<double>(),
                                  to[0].get<double>() - pin[0].get<double>());
  const auto angle = [](const Json& configuration, const std::string& link) {
    return link == "ground" ? 0.0 : configuration["links"][link]["theta"].get<double>();
  };
  const auto drawn_one = with["drawn"]["configuration"].get<std::size_t>() - 1;
  const double to_carrier = drawn - angle(with["configurations"][drawn_one], GetParam().carrier);
  for (const char* phi : {"phi=1.0467", "phi=2.5", "phi=-1"}) {
    const Json here = answer(scene, std::string(" --set ") + phi);
    const Json plain = answer(four_bar(), std::string(" --set ") + phi);
    ASSERT_EQ(here["configurations"].size(), plain["configurations"].size());
    for (const Json& one : here["configurations"]) {
      const double off = angle(one, "washer") - angle(one, GetParam().carrier) - to_carrier;
      EXPECT_NEAR(std::sin(off / 2), 0, 1e-12);
    }
    EXPECT_EQ(outputs_of(here), outputs_of(plain));
  }
  EXPECT_EQ(with["configurations"].size(), without["configurations"].size());
}

INSTANTIATE_TEST_SUITE_P(Told, IdleLinks,
                         testing::Values(Idle{"OnTheGround", "D", "ground"},
                                         Idle{"OnAMovingLink", "P", "coupler"},
                                         Idle{"OnAPinOfTwoLinks", "C", "coupler"}),
                         [](const auto& at) { return at.param.name; });

Json with_washer(const Json& joint) {
  Json scene = Json::parse(R"({"links": {"ground": {"A": [0, 0], "W": [1, 2]},
      "crank": {"A": [0, 0], "B": [1, 0]}, "washer": {"W": [0, 0], "E": [1, 0]}},
      "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
      "drivers": {"A": {"position": 0.5}}, "outputs": {"E": "washer.E"}})");
  scene["joints"]["W"] = joint;
  return scene;
}

TEST(IdleLinksOfObjects, StandAtAngleZero) {
  const Json scene = with_washer({{"type", "revolute"}, {"between", {"ground.W", "washer.W"}}});
  EXPECT_EQ(answer(scene)["configurations"][0]["outputs"]["E"]["position"], Json({2.0, 2.0}));
  const TemporaryDirectory directory;
  const std::string file = directory.write("scene.json", scene.dump()).string();
  for (const std::string& call :
       {"draw " + file + " --output " + (directory.path() / "picture.svg").string(),
        "emit --scene " + file + " --output " + (directory.path() / "emitted").string()}) {
    const CommandResult result = run_assur(call);
    EXPECT_EQ(result.status, 0) << result.messages;
    EXPECT_NE(result.messages.find("'washer' turns freely"), std::string::npos) << call;
  }
}

/// A limit, a mass or a slide means that somebody wants the link to move.
TEST(IdleLinksOfObjects, ThatSomethingActsOnAreRefused) {
  const Json pin = {{"type", "revolute"}, {"between", {"ground.W", "washer.W"}}};
  Json limited = pin;
  limited["limits"] = {0, 1};
  Json heavy = with_washer(pin);
  heavy["masses"]["washer"] = {{"mass", 2}};
  for (const Json& scene : {with_washer(limited), heavy}) {
    const CommandResult result = solved(scene, "");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.messages.find("under-constrained by 1: the link washer"), std::string::npos)
        << result.messages;
  }
}

/// The nearest of two configurations beyond limits has the least excess of a search by hand.
TEST(BeyondLimits, TheNearestConfigurationIsTold) {
  Json scene = four_bar();
  const Json all = answer(scene)["configurations"];
  std::vector<double> angles;
  for (const Json& one : all) {
    angles.push_back(one["links"]["rocker"]["theta"].get<double>());
  }
  ASSERT_EQ(angles.size(), 2U);
  for (const double lowest : {angles[0] + 0.1, angles[1] + 0.2}) {
    const double highest = lowest + 0.05;
    double least = 10;
    std::size_t nearest = 0;
    for (std::size_t one = 0; one < 2; ++one) {
      const double turn = 2 * std::numbers::pi;
      const double below = std::remainder(lowest - angles[one], turn);
      const double above = std::remainder(angles[one] - highest, turn);
      const double excess =
          std::min(below < 0 ? below + turn : below, above < 0 ? above + turn : above);
      if (excess < least) {
        least = excess;
        nearest = one;
      }
    }
    scene["joints"] = {{"D",
                        {{"type", "revolute"},
                         {"at", "D"},
                         {"links", {"ground", "rocker"}},
                         {"limits", {lowest, highest}}}}};
    const Json told = answer(scene);
    EXPECT_EQ(told["status"], "no-assembly");
    EXPECT_EQ(told["nearest_to_limits"]["links"], all[nearest]["links"]);
    EXPECT_EQ(told["nearest_to_limits"]["excess"].size(), 1U);
    EXPECT_NEAR(told["nearest_to_limits"]["excess"]["D"].get<double>(), least, 1e-12);
    EXPECT_NE(solved(scene, "").output.find("\nnearest to the limits: D by "), std::string::npos);
  }
  scene["joints"]["D"]["limits"] = {angles[0] - 0.1, angles[0] + 0.1};
  EXPECT_FALSE(answer(scene).contains("nearest_to_limits"));
}

TEST(IdleSweep, IsToldInOneLine) {
  Json scene = four_bar();
  scene["parameters"]["other"] = 1;
  scene["parameters"]["from_other"] = "2*other";
  scene["sweep"]["parameter"] = "other";
  const TemporaryDirectory directory;
  const std::string page = (directory.path() / "page.html").string();
  const auto drawn = [&] {
    return run_assur("draw " + directory.write("scene.json", scene.dump()).string() + " --output " +
                     page);
  };
  const CommandResult still = drawn();
  EXPECT_EQ(still.status, 0);
  EXPECT_NE(still.messages.find("no link and no driver reads the parameter 'other'"),
            std::string::npos)
      << still.messages;
  EXPECT_EQ(std::count(still.messages.begin(), still.messages.end(), '\n'), 1);
  scene["drivers"]["A"]["position"] = "phi + from_other";
  EXPECT_EQ(drawn().messages, "");
}

TEST(CircuitOptions, TellTheBranchAndTheCircuitOfConfigurations) {
  const Json told = answer(four_bar(), " --circuits")["configurations"];
  for (const Json& one : told) {
    EXPECT_TRUE(one["branch"].is_number_integer());
    EXPECT_EQ(one["circuit"], one["branch"]);  // a crank-rocker has a circuit for each branch
  }
  EXPECT_FALSE(answer(four_bar())["configurations"][0].contains("circuit"));
  EXPECT_NE(solved(four_bar(), " --circuits").output.find(", branch 1, circuit 1\n"),
            std::string::npos);
  const Json elsewhere = answer(four_bar(), " --circuits --set phi=7")["configurations"];
  EXPECT_TRUE(elsewhere[0].at("branch").is_null());
  const std::string rows = solved(four_bar(), " --format csv").output;
  EXPECT_NE(rows.substr(0, rows.find('\n')).find(",circuit,event"), std::string::npos);
}

TEST(CircuitOptions, AreRefusedWhereThereIsNoSweep) {
  Json scene = four_bar();
  for (const auto& [options, message] : std::map<std::string, std::string>{
           {" --unwrapped",
            "--unwrapped: only the rows of a sweep have angles that continue; use "
            "--format csv\n"}}) {
    EXPECT_EQ(solved(scene, options).status, 2);
    EXPECT_NE(solved(scene, options).messages.find(message), std::string::npos);
  }
  scene.erase("sweep");
  for (const auto& [options, message] : std::map<std::string, std::string>{
           {" --circuits", "--circuits: the scene has no sweep; add one\n"},
           {" --unwrapped --format csv",
            "--unwrapped: only the rows of a sweep have angles that continue; add a sweep to the "
            "scene\n"}}) {
    const CommandResult result = solved(scene, options);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.output, "");
    EXPECT_NE(result.messages.find(message), std::string::npos) << result.messages;
  }
}

}  // namespace
}  // namespace assur::test::told_oddities_test
