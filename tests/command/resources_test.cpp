// Law: a request that would take too much time or memory is refused quickly and in one line.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <limits>

#include "command/command.hpp"
#include "mechanism/many_dyads.hpp"

namespace assur::test::resources_test {
namespace {

using Json = nlohmann::ordered_json;

/// The processor time of child processes in seconds, which other programs do not lengthen.
double seconds_of_children() {
  rusage usage{};
  (void)getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
}

/// The message of a refused call, after the file's name. The limit of a minute is hundreds of times
/// the duration of a refusal, ten times with sanitizers, and far below that of the request.
std::string refusal_of(const std::string& scene, const std::string& call) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("scene.json", scene).string();
  const double before = seconds_of_children();
  const CommandResult result = run_assur(
      call + " " + file +
      (call.starts_with("emit") ? " --output " + (directory.path() / "out").string() : ""));
  EXPECT_LT(seconds_of_children() - before, 60);
  EXPECT_EQ(result.status, 2) << result.messages;
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  const std::string head = "error: " + file + ": ";
  EXPECT_EQ(result.messages.find(head), 0U) << result.messages;
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "out"));
  return result.messages.substr(std::min(head.size(), result.messages.size()));
}

int status_of(const std::string& scene) {
  const TemporaryDirectory directory;
  return run_assur("solve " + directory.write("scene.json", scene).string()).status;
}

double upright(int /*number*/) { return 1.4; }

TEST(Resources, OfALongListing) {
  const Json scene = many_dyads(29, upright);
  for (const std::string format : {"text", "json", "csv"}) {
    EXPECT_EQ(
        refusal_of(scene.dump(), "solve --format " + format),
        "there may be 536870912 configurations, and no more than 20000 can be listed; give "
        "joints limits, or ask for one configuration only: the nearest to a reference of more "
        "links, or one with a low number\n");
  }
  EXPECT_EQ(refusal_of(scene.dump(), "emit --scene"),
            "there may be 536870912 configurations, and an emitted solver lists 4096 at most; "
            "name fewer parts in the scene's 'report', or emit parts of the mechanism\n");
  const TemporaryDirectory directory;
  const std::string file = directory.write("scene.json", scene.dump()).string();
  const Json nearest = Json::parse(run_assur("solve --nearest --format json " + file).output);
  EXPECT_EQ(nearest["configurations"].size(), 1U);
  EXPECT_TRUE(nearest["nearest"]["configuration"].is_null());
  EXPECT_LT(nearest["nearest"]["distance"], nearest["nearest"]["runner_up"]);
}

Json swept(double from, double to) {
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/four_bar_coupler_curve.json"));
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", 11}};
  return scene;
}

TEST(Resources, OfASweep) {
  EXPECT_EQ(refusal_of(swept(0, 1e9).dump(), "solve --format csv"),
            "sweep: between two steps the mechanism moves too far to be followed; take more steps, "
            "or a shorter range\n");
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(refusal_of(swept(-largest, largest).dump(), "solve --format csv"),
            "sweep: the range from 'from' to 'to' is not finite\n");
  Json scene = many_dyads(11, upright);
  scene["parameters"]["phi"] = 0.3;
  scene["drivers"]["A"]["position"] = "phi";
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 1}, {"count", 11}};
  EXPECT_EQ(refusal_of(scene.dump(), "solve --format csv"),
            "sweep: more than 1000 configurations at one value cannot be followed; follow one "
            "of them alone, by its number or a reference\n");
  scene = many_dyads(20, upright);
  scene["links"]["rocker1"]["C"] = {99, 0};
  scene["parameters"]["phi"] = 0.3;
  scene["drivers"]["A"]["position"] = "phi";
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 1}, {"count", 3}};
  const TemporaryDirectory directory;
  const std::string file = directory.write("scene.json", scene.dump()).string();
  const CommandResult alone = run_assur("solve --branch 1 --format csv " + file);
  EXPECT_EQ(alone.status, 2);
  EXPECT_EQ(
      alone.messages,
      "error: " + file +
          ": sweep: there is no configuration 1 at any step, so there is no branch to follow\n");
}

/// Each group is a link between two slides that cross.
TEST(Resources, OfManyGroups) {
  Json scene;
  scene["want"] = {"position"};
  for (int number = 0; number < 65; ++number) {
    const std::string own = std::to_string(number);
    const auto line = [](int x, int y, int along) {
      return Json{{"through", {x, y}}, {"along", {1, along}}};
    };
    scene["links"]["ground"]["a" + own] = line(0, number, 0);
    scene["links"]["ground"]["b" + own] = line(0, number, 1);
    scene["links"]["link" + own] = {{"a", line(0, 0, 0)}, {"P", {1, 1}}};
    scene["joints"]["a" + own] = {{"type", "prismatic"},
                                  {"between", {"ground.a" + own, "link" + own + ".a"}}};
    scene["joints"]["b" + own] = {{"type", "pin-in-slot"},
                                  {"between", {"ground.b" + own, "link" + own + ".P"}}};
  }
  EXPECT_EQ(refusal_of(scene.dump(), "emit --scene"),
            "there are 65 groups, and an emitted solver has 64 at most; name fewer parts in the "
            "scene's 'report', or emit parts of the mechanism\n");
  EXPECT_EQ(status_of(scene.dump()), 0);
}

/// Eleven dyads carry two equal bars whose ends are at one point, so that the bars turn freely in
/// every configuration. Then fourteen dyads, 16384 configurations, have second derivatives with
/// respect to 100 parameters, which would take 0.9 GB.
TEST(LongResources, OfManyFamiliesAndNumbers) {
  const std::string mend =
      "; give joints limits, or ask for one configuration only: the nearest to a reference of more "
      "links, or one with a low number\n";
  Json scene = many_dyads(11, upright);
  scene["links"]["bar11"]["Q"] = scene["links"]["bar11"]["P"];
  const auto join = [&scene](const std::string& name, const std::string& one,
                             const std::string& other) {
    scene["joints"][name] = {{"type", "revolute"}, {"between", {one, other}}};
  };
  scene["links"]["one"] = scene["links"]["other"] = {{"E", {0, 0}}, {"F", {1, 0}}};
  join("E1", "bar11.P", "one.E");
  join("E2", "bar11.Q", "other.E");
  join("F", "one.F", "other.F");
  EXPECT_EQ(refusal_of(scene.dump(), "solve"),
            "there may be 4096 configurations, and more than 1000 families" + mend);
  scene = many_dyads(14, upright);
  std::string sum = "0";
  for (int number = 0; number < 100; ++number) {
    const std::string name = "p" + std::to_string(number);
    scene["parameters"][name] = 1;
    sum += "+0*" + name;
  }
  scene["links"]["ground"]["A"] = {sum, 0};
  scene["outputs"]["P"] = "bar14.P";
  scene["want"] = {"sensitivity"};
  scene["covariance"] = {{"parameters", {"p0"}}, {"matrix", Json::parse("[[1]]")}};
  EXPECT_EQ(refusal_of(scene.dump(), "solve"),
            "there may be 16384 configurations, and no more than 109 can be listed" + mend);
}

/// The four-bar with more parameters, each a formula of the one before.
std::string chain_of_parameters(int count, bool with_sensitivities) {
  nlohmann::json scene =
      nlohmann::json::parse(read_file(ASSUR_EXAMPLES "/four_bar_coupler_curve.json"));
  std::string last = "1";
  for (int number = 0; number < count; ++number) {
    const std::string name = "p" + std::to_string(number);
    scene["parameters"][name] = last + "+0.001";
    last = name;
  }
  if (!with_sensitivities) {
    scene["want"] = {"position"};
  }
  return scene.dump();
}

TEST(Resources, OfManyParameters) {
  EXPECT_EQ(refusal_of(chain_of_parameters(20001, true), "solve"),
            "an object has more than 20000 keys; divide the scene\n");
  EXPECT_NE(refusal_of(chain_of_parameters(2000, true), "solve")
                .find("leave 'sensitivity' out of 'want'\n"),
            std::string::npos);
  EXPECT_EQ(status_of(chain_of_parameters(15000, false)), 0);
}

/// A chain of cranks, in which the law of each one reads the two joints before it.
std::string chain_of_laws(int count) {
  nlohmann::json scene;
  scene["links"]["ground"] = {{"P", {0, 0}}};
  std::string last = "ground";
  for (int number = 0; number < count; ++number) {
    const std::string own = std::to_string(number);
    scene["links"]["link" + own] = {{"A", {0, 0}}, {"P", {1, 0}}};
    scene["joints"]["j" + own] = {{"type", "revolute"},
                                  {"between", {last + ".P", "link" + own + ".A"}}};
    scene["drivers"]["j" + own]["position"] = number < 2 ? "0.01"
                                                         : "joint(j" + std::to_string(number - 1) +
                                                               ") - joint(j" +
                                                               std::to_string(number - 2) + ")";
    last = "link" + own;
  }
  scene["want"] = {"position"};
  return scene.dump();
}

TEST(Resources, OfManyLaws) {
  EXPECT_EQ(refusal_of(chain_of_laws(2000), "solve"),
            "links: a mechanism has at most 1000 links; remove some\n");
  EXPECT_EQ(status_of(chain_of_laws(600)), 0);
}

}  // namespace
}  // namespace assur::test::resources_test
