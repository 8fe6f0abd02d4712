// Law: no branch of a sweep begins, ends or is lost without an event that says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::lost_branches_test {
namespace {

/// Parallelograms in a row, which stand flat where the crank is at half a turn.
struct Row {
  const char* name;
  int stages;
  double crank, coupler;
  bool is_resolved = true;  ///< else some sweeps are too much for double precision

  friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.name; }
};

SceneMaker::Json scene_of(const Row& row) {
  SceneMaker scene;
  scene.parameter("phi", 0.0)
      .bar("ground", {{"A", 0.0}})
      .bar("crank", {{"A", 0.0}, {"C0", row.crank}});
  for (int stage = 0; stage < row.stages; ++stage) {
    const std::string here = std::to_string(stage);
    const std::string next = std::to_string(stage + 1);
    scene.bar("ground", {{"D" + here, (stage + 1) * row.coupler}})
        .bar("coupler" + here, {{"C" + here, 0.0}, {"C" + next, row.coupler}})
        .bar("rocker" + here, {{"D" + here, 0.0}, {"C" + next, row.crank}});
  }
  return scene.drive("A", "phi", 1, 0).scene();
}

/// The branches that an event names: those that end or go through it, and those that begin.
struct Named {
  std::set<int> ended, begun;
  bool is_crossing = false;
};

Named named_by(const std::string& event) {
  Named named;
  std::istringstream words(event);
  std::string word;
  words >> word;
  named.is_crossing = word == "crossing";
  bool begin = word == "birth" || word == "arrival";
  while (words >> word && word != "on") {
    if (word == "/") {
      begin = true;
    } else {
      (begin ? named.begun : named.ended).insert(std::stoi(word));
    }
  }
  return named;
}

/// Expects an event for each branch whose first row is behind the first step or whose last row is
/// before the last step, and some event if rows belong to no branch or if branches have no row at
/// the last step.
void expect_no_silence(const Row& row, SceneMaker::Json scene, double from, double to, int count) {
  const std::size_t branches = std::size_t{1} << row.stages;
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", count}};
  const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  std::map<int, std::set<int>> steps;  // of each branch
  std::set<int> ended;
  std::set<int> begun;
  bool is_any_row_of_none = false;
  int events = 0;
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (at.event.empty() && at.branch == 0) {
      is_any_row_of_none = true;
    } else if (at.event.empty()) {
      steps[at.branch].insert(at.step);
    } else {
      const Named named = named_by(at.event);
      ++events;
      EXPECT_LE(std::min(from, to), at.parameter);
      EXPECT_GE(std::max(from, to), at.parameter);
      ended.insert(named.ended.begin(), named.ended.end());
      begun.insert(named.begun.begin(), named.begun.end());
    }
  };
  mechanism::sweep(plan, {record, {}, {}});
  std::size_t at_end = 0;
  for (const auto& [branch, rows] : steps) {
    EXPECT_TRUE(*rows.begin() == 0 || begun.contains(branch)) << "branch " << branch << " begins";
    EXPECT_TRUE(*rows.rbegin() == count - 1 || ended.contains(branch))
        << "branch " << branch << " ends";
    at_end += *rows.rbegin() == count - 1 ? 1 : 0;
  }
  if (row.is_resolved) {
    EXPECT_EQ(events, 1);
    EXPECT_EQ(ended.size(), branches);
    EXPECT_TRUE(begun.empty());
  }
  EXPECT_TRUE(!is_any_row_of_none || events > 0) << "rows have no branch";
  EXPECT_TRUE(at_end == branches || events > 0) << "branches have no row at the last step";
}

class LostBranches : public testing::TestWithParam<Row> {};

/// All by `ctest -L long`; by default one in 23, and only one for the row of four.
TEST_P(LostBranches, AreTold) {
  const Row& row = GetParam();
  constexpr double flat = std::numbers::pi;
  int number = 0;
  for (const double width : {1.0, 1e-1, 1e-2, 1e-3, 1e-6}) {
    for (const int count : {2, 3, 20}) {
      for (int listing = 0; listing < listings; ++listing) {
        const int share = row.stages < 4 ? 23 : 45;
        if (number++ % share != 0 && !is_whole_campaign()) {
          continue;
        }
        SCOPED_TRACE(testing::Message() << width << " " << count << " listing " << listing);
        const SceneMaker::Json scene = scene_listed(scene_of(row), listing);
        expect_no_silence(row, scene, flat - width, flat, count);
        expect_no_silence(row, scene, flat, flat + width, count);
        expect_no_silence(row, scene, flat - width, flat + width, count);
        expect_no_silence(row, scene, flat - width / 1000, flat + width, count);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, LostBranches,
                         testing::Values(Row{"two", 2, 3, 4}, Row{"three", 3, 3, 4},
                                         Row{"four", 4, 1, 3}));
INSTANTIATE_TEST_SUITE_P(LongRows, LostBranches,
                         testing::Values(Row{"four fast", 4, 3, 4, false},
                                         Row{"four faster", 4, 2, 2.5, false},
                                         Row{"five", 5, 1, 3, false}));

}  // namespace
}  // namespace assur::test::lost_branches_test
