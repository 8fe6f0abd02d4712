// Law: a sweep reports as it goes and keeps nothing of what it reported; a value that cannot be
// used, however late, is refused before anything is reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "command/process.hpp"
#include "mechanism/solved.hpp"

namespace assur::test::sweep_stream_test {
namespace {

using Json = nlohmann::ordered_json;

Json four_bar(int count) {
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/four_bar_coupler_curve.json"));
  scene["sweep"]["count"] = count;
  scene["want"] = {"position"};
  return scene;
}

TEST(SweepStream, RecordsArriveWhileTheSweepRuns) {
  constexpr int count = 100;
  const Plan plan(mechanism::parse_scene(four_bar(count).dump(), "scene"));
  std::vector<int> solved_before_row;
  int solved = 0;
  int done = 0;
  const auto record = [&](const mechanism::SweepRecord& row) {
    EXPECT_EQ(done, row.step);  // all steps before it, and no later one
    solved_before_row.push_back(solved);
  };
  mechanism::sweep(plan, {record, [&](double, const Solution&) { ++solved; },
                          [&](int steps) {
                            EXPECT_EQ(steps, done + 1);
                            done = steps;
                          }});
  EXPECT_EQ(done, count);
  ASSERT_EQ(solved_before_row.size(), 2U * count);
  for (std::size_t row = 0; row < solved_before_row.size(); ++row) {
    EXPECT_EQ(solved_before_row[row], static_cast<int>(row / 2) + 1);
  }
}

TEST(SweepStream, AnObserverMayStopASweepByThrowing) {
  const Plan plan(mechanism::parse_scene(four_bar(1000).dump(), "scene"));
  int rows = 0;
  const auto record = [&](const mechanism::SweepRecord&) {
    if (++rows == 5) {
      throw std::runtime_error("enough");
    }
  };
  EXPECT_THROW(mechanism::sweep(plan, {record, [](double, const Solution&) {}, [](int) {}}),
               std::runtime_error);
  EXPECT_EQ(rows, 5);
}

TEST(SweepStream, MemoryDoesNotGrowWithTheCount) {
  // A command that is built with AddressSanitizer keeps what is freed, unless it is told not to.
  ::setenv("ASAN_OPTIONS", "quarantine_size_mb=0", 1);
  const TemporaryDirectory directory;
  const auto peak = [&](int count) {
    const auto file = directory.write("scene.json", four_bar(count).dump());
    const ProcessResult result =
        run_process({"solve", file.string(), "--format", "csv"}, opened("/dev/null"));
    EXPECT_EQ(result.status, 0) << result.messages;
    return result.peak_kilobytes;
  };
  const long few = peak(2000);
  const long many = peak(200000);
  std::cout << "2000 steps: " << few << " kB, 200000 steps: " << many << " kB\n";
  EXPECT_GT(few, 0);
  EXPECT_LT(many, few + 8L * 1024);
}

TEST(SweepStream, AValueThatIsNotFiniteLateLeavesNoOutput) {
  const TemporaryDirectory directory;
  Json scene = four_bar(1000);
  scene["drivers"]["A"]["position"] = "sqrt(5 - phi)";
  const auto file = directory.write("scene.json", scene.dump());
  const CommandResult result = run_assur("solve " + file.string() + " --format csv");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  EXPECT_EQ(result.messages,
            "error: " + file.string() + ": drivers.A.position: the value is not a finite number\n");
}

TEST(SweepStream, AValueThatIsNotFiniteLateIsNotReportedBefore) {
  Json scene = four_bar(1000);
  scene["drivers"]["A"]["position"] = "sqrt(5 - phi)";
  const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  int calls = 0;
  EXPECT_THROW(
      mechanism::sweep(plan, {[&](const mechanism::SweepRecord&) { ++calls; },
                              [&](double, const Solution&) { ++calls; }, [&](int) { ++calls; }}),
      mechanism::MechanismError);
  EXPECT_EQ(calls, 0);
}

TEST(SweepStream, WhereAFormulaHasNoValueBetweenTwoStepsNoBranchGoesThrough) {
  Json scene = four_bar(3);
  scene["sweep"]["from"] = 0;
  scene["sweep"]["to"] = 1;
  scene["drivers"]["A"]["position"] = "phi + sqrt((phi - 0.25)^2 - 0.01)";
  const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  std::set<int> steps;
  std::vector<std::string> events;
  mechanism::sweep(plan, {.record =
                              [&](const mechanism::SweepRecord& record) {
                                steps.insert(record.step);
                                if (!record.event.empty()) {
                                  events.push_back(record.event);
                                }
                              },
                          .solved = {},
                          .progress = {}});
  EXPECT_EQ(steps.size(), 3U);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].substr(0, 10), "unresolved");
}

TEST(SweepStream, OtherParametersMayHaveOtherValues) {
  Json scene = four_bar(5);
  const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  scene["parameters"]["phi"] = 0.25;
  Json longer = scene;
  longer["parameters"]["more"] = 0.125;
  scene["parameters"]["more"] = 0.0;
  for (Json* each : {&scene, &longer}) {
    (*each)["drivers"]["A"]["position"] = "phi + more";
  }
  const auto rows = [](const Plan& swept, const Values& values) {
    std::string text;
    mechanism::SweepRows table(swept);
    mechanism::sweep(
        swept, values,
        {.record = [&](const mechanism::SweepRecord& record) { table.add(record, text); },
         .solved = {},
         .progress = {}});
    return text;
  };
  const Plan one(mechanism::parse_scene(scene.dump(), "scene"));
  const Plan other(mechanism::parse_scene(longer.dump(), "scene"));
  EXPECT_EQ(rows(one, one.values({{"more", 0.125}})), rows(other, other.values()));
}

TEST(SweepStream, WithoutASweepInTheRequestIsRefused) {
  Json scene = four_bar(3);
  scene.erase("sweep");
  const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  EXPECT_THROW(mechanism::sweep(plan, {}), mechanism::MechanismError);
}

}  // namespace
}  // namespace assur::test::sweep_stream_test
