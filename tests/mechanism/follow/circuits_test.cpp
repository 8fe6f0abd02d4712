// Law: branches of a sweep are on one circuit if the mechanism can move from one to the other
// without disassembly: for four-bars by Grashof's rule, for six-bars by signs of discriminants.
#include <gtest/gtest.h>

#include <array>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>

#include "mechanism/scene_maker.hpp"

namespace assur::test::circuits_test {
namespace {

using Json = SceneMaker::Json;
constexpr double turn = 2 * std::numbers::pi;

/// A row of a sweep: its step, its branch, and the places of outputs by their names.
struct Row {
  int step, branch;
  std::map<std::string, Eigen::Vector2d> at;
};

struct Swept {
  mechanism::Circuits circuits;
  std::vector<Row> rows;
  std::vector<std::string> events;

  [[nodiscard]] std::set<int> numbers() const {
    return {circuits.of_branch.begin(), circuits.of_branch.end()};
  }
  /// The kinds of its events.
  [[nodiscard]] std::set<std::string> kinds() const {
    std::set<std::string> kinds;
    for (const std::string& event : events) {
      kinds.insert(event.substr(0, event.find(' ')));
    }
    return kinds;
  }
};

Swept swept(const Json& json) {
  const mechanism::Scene scene = mechanism::parse_scene(json.dump(), "scene");
  const mechanism::Plan plan(scene);
  Swept kept;
  const auto record = [&](const mechanism::SweepRecord& row) {
    if (!row.event.empty()) {
      kept.events.push_back(row.event);
      return;
    }
    kept.rows.push_back({row.step, row.branch, {}});
    for (const mechanism::OutputIndex output : plan.mechanism().outputs().keys()) {
      kept.rows.back().at[plan.mechanism().outputs()[output].name] =
          row.state->outputs[output].position;
    }
  };
  mechanism::sweep(plan, {record, {}, {}, [&](const mechanism::Circuits& circuits) {
                            kept.circuits = circuits;
                          }});
  return kept;
}

/// A four-bar by its lengths: crank, coupler, rocker, ground.
SceneMaker four_bar(const std::array<double, 4>& bars) {
  SceneMaker maker;
  maker.parameter("phi", 0.3)
      .bar("ground", {{"A", 0.0}, {"D", bars[3]}})
      .bar("crank", {{"A", 0.0}, {"B", bars[0]}})
      .bar("coupler", {{"B", 0.0}, {"C", bars[1]}})
      .bar("rocker", {{"D", 0.0}, {"C", bars[2]}})
      .drive("A", "phi", 1, 0);
  maker.json["want"] = {"position"};
  return maker;
}

/// By Grashof's rule: two where the shortest and the longest bar together are shorter than the
/// other two; one where they are longer, or where they are as long and the two meet in a change
/// point.
int circuits_by_grashof(std::array<double, 4> bars) {
  std::sort(bars.begin(), bars.end());
  return bars[0] + bars[3] < bars[1] + bars[2] ? 2 : 1;
}

bool is_assembled(const std::array<double, 4>& bars) {
  const double sum = std::accumulate(bars.begin(), bars.end(), 0.0);
  return 2 * *std::max_element(bars.begin(), bars.end()) < sum;
}

struct Bars {
  const char* name;
  bool are_whole;  ///< lengths from 1 to 6, so that many are in special position
  unsigned seed;

  friend std::ostream& operator<<(std::ostream& out, const Bars& bars) { return out << bars.name; }
};

class FourBars : public testing::TestWithParam<Bars> {};

/// All four inversions, from two first values: one at which bars are in line, and any other.
TEST_P(FourBars, HaveTheCircuitsOfGrashof) {
  std::mt19937 random(GetParam().seed);
  std::uniform_int_distribution<int> whole(1, 6);
  std::uniform_real_distribution<double> real(1, 6);
  int count = 0;
  int free_at_a_step = 0;
  std::map<int, int> of_circuits;
  for (int number = 0; number < 40; ++number) {
    std::array<double, 4> bars{};
    for (double& bar : bars) {
      bar = GetParam().are_whole ? whole(random) : real(random);
    }
    if (!is_assembled(bars)) {
      continue;
    }
    for (int inversion = 0; inversion < 4; ++inversion) {
      std::rotate(bars.begin(), bars.begin() + 1, bars.end());
      for (const double from : {0.0, 1.25}) {
        SCOPED_TRACE(testing::Message() << bars[0] << ' ' << bars[1] << ' ' << bars[2] << ' '
                                        << bars[3] << " from " << from);
        const Swept found = swept(four_bar(bars).sweep("phi", from, from + turn, 13).scene());
        // Where B lies on D, coupler and rocker turn freely, and no branch is told to go on.
        if (found.kinds().contains("degenerate")) {
          ++free_at_a_step;
          continue;
        }
        const int expected = circuits_by_grashof(bars);
        EXPECT_EQ(found.numbers().size(), static_cast<std::size_t>(expected));
        ++of_circuits[expected];
        ++count;
      }
    }
  }
  std::cout << "seed " << GetParam().seed << ": " << count << " sweeps, " << of_circuits[2]
            << " with two circuits, " << free_at_a_step << " with links that turn freely\n";
  EXPECT_GT(of_circuits[1], 20);
  EXPECT_GT(of_circuits[2], 20);
  EXPECT_LT(free_at_a_step, count / 4);
}

INSTANTIATE_TEST_SUITE_P(Circuits, FourBars,
                         testing::Values(Bars{"OfWholeLengths", true, 20261128},
                                         Bars{"OfAnyLengths", false, 59}),
                         [](const auto& at) { return at.param.name; });

/// A dyad's two configurations by the side of its inner pin: +1 left of the line from one outer pin
/// to the other.
std::optional<Eigen::Vector2d> inner_pin(const Eigen::Vector2d& from, double first,
                                         const Eigen::Vector2d& to, double second, int side) {
  const Eigen::Vector2d along = to - from;
  const double distance = along.norm();
  const double part = (first * first - second * second + distance * distance) / (2 * distance);
  const double square = first * first - part * part;
  if (!(square >= 0)) {
    return std::nullopt;
  }
  const Eigen::Vector2d unit = along / distance;
  return from + part * unit + side * std::sqrt(square) * Eigen::Vector2d(-unit.y(), unit.x());
}

int side_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& at) {
  const Eigen::Vector2d along = to - from;
  return along.x() * (at.y() - from.y()) - along.y() * (at.x() - from.x()) > 0 ? 1 : -1;
}

/// A six-bar of Watt: a four-bar whose rocker has a third pin E, and a dyad E F G to the ground.
struct SixBar {
  std::array<double, 4> bars{};
  Eigen::Vector2d on_rocker{0, 0}, ground{0, 0};
  double third = 0, fourth = 0;

  [[nodiscard]] Json scene() const {
    SceneMaker maker = four_bar(bars);
    maker.point("rocker", "E", on_rocker.x(), on_rocker.y())
        .point("ground", "G", ground.x(), ground.y())
        .bar("third", {{"E", 0.0}, {"F", third}})
        .bar("fourth", {{"G", 0.0}, {"F", fourth}})
        .sweep("phi", 0, turn, 49);
    return maker.scene();
  }
};

/// Fine steps of the crank, and at each the sides of both dyads that can be assembled: bit 0 of a
/// state for the first, bit 1 for the second.
class Continuation {
 public:
  static constexpr int steps = 48 * 40;
  static constexpr int states = 4;

  explicit Continuation(const SixBar& bar) : bar_(bar), group_(steps * states) {
    std::iota(group_.begin(), group_.end(), 0);
    for (int step = 0; step < steps; ++step) {
      for (int state = 0; state < states; ++state) {
        if (!is_there(step, state)) {
          continue;
        }
        for (const int side : {1, -1}) {
          const int beside = (step + side + steps) % steps;
          if (is_there(beside, state)) {
            join(place(step, state), place(beside, state));
            continue;
          }
          // The dyad that cannot be assembled beside this step is stretched out between the two.
          const bool is_first = !inner_of_first(beside, state);
          join(place(step, state), place(step, state ^ (is_first ? 1 : 2)));
        }
      }
    }
  }

  [[nodiscard]] int group_of(int step, int state) { return root(place(step, state)); }
  [[nodiscard]] bool is_there(int step, int state) const { return pins(step, state).has_value(); }

 private:
  static int place(int step, int state) { return step % steps * states + state; }
  [[nodiscard]] Eigen::Vector2d driven(int step) const {
    const double phi = turn * step / steps;
    return bar_.bars[0] * Eigen::Vector2d(std::cos(phi), std::sin(phi));
  }
  [[nodiscard]] std::optional<Eigen::Vector2d> inner_of_first(int step, int state) const {
    return inner_pin(driven(step), bar_.bars[1], {bar_.bars[3], 0}, bar_.bars[2],
                     (state & 1) != 0 ? 1 : -1);
  }
  [[nodiscard]] std::optional<Eigen::Vector2d> pins(int step, int state) const {
    const std::optional<Eigen::Vector2d> c = inner_of_first(step, state);
    if (!c) {
      return std::nullopt;
    }
    const Eigen::Vector2d d(bar_.bars[3], 0);
    const Eigen::Vector2d unit = (*c - d) / bar_.bars[2];
    const Eigen::Vector2d e =
        d + bar_.on_rocker.x() * unit + bar_.on_rocker.y() * Eigen::Vector2d(-unit.y(), unit.x());
    return inner_pin(e, bar_.third, bar_.ground, bar_.fourth, (state & 2) != 0 ? 1 : -1);
  }
  int root(int at) {
    return group_[static_cast<std::size_t>(at)] == at
               ? at
               : group_[static_cast<std::size_t>(at)] = root(group_[static_cast<std::size_t>(at)]);
  }
  void join(int one, int other) { group_[static_cast<std::size_t>(root(one))] = root(other); }

  const SixBar& bar_;
  std::vector<int> group_;
};

/// Every row of a sweep lies on the circuit that tiny steps of explicit dyads reach from it.
TEST(Circuits, OfSixBarsAreThoseOfTinySteps) {
  constexpr unsigned seed = 1986;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> length(1, 5);
  std::map<std::size_t, int> of_circuits;
  for (int number = 0; number < 40; ++number) {
    SixBar bar;
    for (double& one : bar.bars) {
      one = length(random);
    }
    bar.on_rocker = {length(random) - 2, length(random) - 2};
    bar.ground = {length(random) + 2, length(random) - 3};
    bar.third = length(random);
    bar.fourth = length(random);
    if (!is_assembled(bar.bars)) {
      continue;
    }
    SCOPED_TRACE(bar.scene().dump());
    const Swept found = swept(bar.scene());
    Continuation oracle(bar);
    std::map<int, int> group_of_circuit;
    std::set<int> groups;
    for (const Row& row : found.rows) {
      const Eigen::Vector2d d(bar.bars[3], 0);
      const int state = (side_of(row.at.at("B"), d, row.at.at("C")) > 0 ? 1 : 0) +
                        (side_of(row.at.at("E"), bar.ground, row.at.at("F")) > 0 ? 2 : 0);
      const int step = row.step * Continuation::steps / 48;
      ASSERT_TRUE(oracle.is_there(step % Continuation::steps, state));
      const int group = oracle.group_of(step, state);
      const int circuit = found.circuits.of(row.branch);
      EXPECT_EQ(group_of_circuit.try_emplace(circuit, group).first->second, group)
          << "step " << row.step << ", branch " << row.branch;
      groups.insert(group);
    }
    EXPECT_EQ(groups.size(), group_of_circuit.size());
    ++of_circuits[groups.size()];
  }
  std::cout << "seed " << seed << ": six-bars by their number of circuits:";
  for (const auto& [circuits, count] : of_circuits) {
    std::cout << ' ' << count << " with " << circuits;
  }
  std::cout << '\n';
  EXPECT_GE(of_circuits.size(), 3U);
}

constexpr std::array<double, 4> crank_rocker = {1, 4, 3, 4.5};
constexpr std::array<double, 4> triple_rocker = {3, 2, 2.5, 4};

struct Range {
  const char* name;
  const char* position;  ///< of the crank, a formula in phi
  double from, to;
  bool is_closed;

  friend std::ostream& operator<<(std::ostream& out, const Range& range) {
    return out << range.name;
  }
};

class Ranges : public testing::TestWithParam<Range> {};

/// Over a closed range each branch of a crank-rocker goes on as itself, and otherwise as none.
TEST_P(Ranges, JoinTheirEndsWhereTheMechanismIsTheSame) {
  const Range& range = GetParam();
  Json scene = four_bar(crank_rocker).sweep("phi", range.from, range.to, 25).scene();
  scene["drivers"]["A"] = {{"position", range.position}};
  const Swept found = swept(scene);
  ASSERT_EQ(found.circuits.of_branch, (std::vector<int>{1, 2}));
  EXPECT_EQ(found.circuits.next,
            range.is_closed ? (std::vector<int>{1, 2}) : (std::vector<int>{0, 0}));
}

INSTANTIATE_TEST_SUITE_P(Circuits, Ranges,
                         testing::Values(Range{"OneTurn", "phi", 0, turn, true},
                                         Range{"Backwards", "phi", 1, 1 - turn, true},
                                         Range{"ThreeTurns", "3*phi", -1, turn - 1, true},
                                         Range{"HalfATurn", "phi", 0, turn / 2, false},
                                         Range{"ALittleLess", "phi", 0, 6.28, false},
                                         Range{"TypedWithSevenDigits", "phi", 0, 6.283185, true},
                                         Range{"ToAndFro", "1 + sin(phi)", 0, turn, true}),
                         [](const auto& at) { return at.param.name; });

/// The range begins amid its reach: two branches fold, two are born, and those of either pair are
/// joined with the others only because 0 and a whole turn are one.
TEST(Circuits, OfATripleRockerJoinAtFoldsAndOverTheTurn) {
  const Swept found = swept(four_bar(triple_rocker).sweep("phi", 0, turn, 25).scene());
  EXPECT_EQ(found.kinds(), (std::set<std::string>{"birth", "fold"}));
  EXPECT_EQ(found.circuits.of_branch.size(), 4U);
  EXPECT_EQ(found.numbers(), std::set<int>{1});
  const Swept half = swept(four_bar(triple_rocker).sweep("phi", 0, turn / 2, 25).scene());
  EXPECT_EQ(half.circuits.of_branch, (std::vector<int>{1, 1}));
}

/// Gears make the second crank turn half as fast. After one turn the mechanism is another; after
/// two it is the same, and each branch goes on as itself.
TEST(Circuits, OfGearsNeedTheTurnsOfTheSlowest) {
  SceneMaker maker;
  maker.parameter("phi", 0.3)
      .bar("ground", {{"A", 0.0}, {"D", 4.0}})
      .bar("crank", {{"A", 0.0}, {"B", 1.0}})
      .bar("other", {{"D", 0.0}, {"C", 1.0}})
      .bar("left", {{"B", 0.0}, {"P", 4.0}})
      .bar("right", {{"C", 0.0}, {"P", 3.5}})
      .drive("A", "phi", 1, 0);
  for (const int turns : {1, 2}) {
    Json scene = maker.sweep("phi", 0, turns * turn, 49).scene();
    scene["drivers"]["D"] = {{"position", "0.5*joint(A)"}};
    EXPECT_EQ(swept(scene).circuits.next,
              turns == 2 ? (std::vector<int>{1, 2}) : (std::vector<int>{0, 0}))
        << turns;
  }
}

/// A coupler point that a parameter moves along its link changes the mechanism, though no pose.
TEST(Circuits, OfAChangedLinkAreNotClosed) {
  SceneMaker maker = four_bar(crank_rocker);
  maker.parameter("along", 0.5).point("coupler", "P", "along", 1);
  EXPECT_EQ(swept(maker.sweep("along", 0, 1, 9).scene()).circuits.next, (std::vector<int>{0, 0}));
}

/// `swept_places` finds at a step what the rows of that step say, and between two the same
/// branches.
TEST(Circuits, OfTheConfigurationsAtTheOwnValue) {
  int between = 0;
  for (const std::array<double, 4>& bars : {crank_rocker, triple_rocker}) {
    for (const double own : {0.0, turn / 24, 0.3, turn / 4 + 0.1, turn, 7.0}) {
      Json scene = four_bar(bars).sweep("phi", 0, turn, 25).scene();
      scene["parameters"]["phi"] = own;
      const mechanism::Scene read = mechanism::parse_scene(scene.dump(), "scene");
      const mechanism::Plan plan(read);
      const mechanism::SweptPlaces places = swept_places(read.mechanism, read.request);
      const Swept found = swept(scene);
      EXPECT_EQ(places.circuits.of_branch, found.circuits.of_branch);
      if (own > turn) {
        EXPECT_TRUE(places.branches.empty());
        continue;
      }
      const mechanism::Solution solution = plan.solve(plan.values());
      ASSERT_EQ(places.branches.size(), solution.configurations.size());
      // On each of its branches C moves less from step to step than to another branch.
      const auto step = static_cast<int>(std::lround(own / turn * 24));
      for (std::size_t one = 0; one < places.branches.size(); ++one) {
        const Eigen::Vector2d at = solution.configurations[one].output("C").position;
        const Row* nearest = nullptr;
        for (const Row& row : found.rows) {
          if (row.step == step && (nearest == nullptr || (row.at.at("C") - at).norm() <
                                                             (nearest->at.at("C") - at).norm())) {
            nearest = &row;
          }
        }
        ASSERT_NE(nearest, nullptr);
        EXPECT_EQ(places.branches[one], nearest->branch) << own;
        between += std::abs(own - step * turn / 24) > 1e-9 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(between, 6);
}

std::vector<std::map<std::string, std::string>> table_of(const Json& json,
                                                         mechanism::SweepRows::Angles angles) {
  const mechanism::Scene scene = mechanism::parse_scene(json.dump(), "scene");
  const mechanism::Plan plan(scene);
  mechanism::SweepRows rows(plan, angles);
  std::string text = csv_header(plan);
  mechanism::Circuits circuits;
  mechanism::sweep(plan, {[&](const mechanism::SweepRecord& row) { rows.add(row, text); },
                          {},
                          {},
                          [&](const mechanism::Circuits& found) { circuits = found; }});
  std::vector<std::map<std::string, std::string>> table;
  std::vector<std::string> head;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!head.empty()) {
      mechanism::SweepRows::set_circuit(circuits, line);
    }
    std::istringstream cells(line + ",");
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell);
    }
    if (head.empty()) {
      head = row;
      continue;
    }
    EXPECT_EQ(row.size(), head.size());
    table.emplace_back();
    for (std::size_t column = 0; column < row.size(); ++column) {
      table.back()[head[column]] = row[column];
    }
  }
  return table;
}

/// Unwrapped angles go on by less than half a turn a row, and differ from the others by whole
/// turns; the crank's are those of its law, over three turns.
TEST(Circuits, RowsHaveAnglesThatGoOn) {
  using Angles = mechanism::SweepRows::Angles;
  const Json scene = four_bar(crank_rocker).sweep("phi", 1, 1 + 3 * turn, 100).scene();
  const auto principal = table_of(scene, Angles::principal);
  const auto unwrapped = table_of(scene, Angles::unwrapped);
  ASSERT_EQ(principal.size(), unwrapped.size());
  ASSERT_EQ(principal.size(), 200U);
  std::map<std::string, double> last;
  double largest = 0;
  for (std::size_t row = 0; row < principal.size(); ++row) {
    for (const auto& [name, cell] : principal[row]) {
      if (!name.ends_with(".theta")) {
        EXPECT_EQ(unwrapped[row].at(name), cell) << name;
        continue;
      }
      const double angle = std::stod(unwrapped[row].at(name));
      const double turns = (angle - std::stod(cell)) / turn;
      EXPECT_NEAR(turns, std::round(turns), 1e-14) << name;
      const auto [before, is_first] = last.try_emplace(principal[row].at("branch") + name, angle);
      EXPECT_LT(std::abs(angle - before->second), turn / 2);
      before->second = angle;
      if (name == "crank.theta") {
        largest = std::max(largest, std::abs(angle - std::stod(principal[row].at("phi"))));
      }
    }
    EXPECT_EQ(unwrapped[row].at("circuit"), unwrapped[row].at("branch"));
  }
  EXPECT_LT(largest, 1e-13);
}

}  // namespace
}  // namespace assur::test::circuits_test
