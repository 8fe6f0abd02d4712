// Law: a sweep joins its branches through a change point and reports a `crossing`, however short it
// is, with a step on the point or beside it, and in every order of listing.
#include <gtest/gtest.h>

#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <set>

#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::change_points_test {
namespace {

using Real = long double;
using Complex = std::complex<Real>;

struct Stage {
  double coupler, rocker, ground;
};
/// Four-bars in a row, each driven by the rocker before it, all flat at one angle of the crank.
struct Row {
  const char* name;
  double crank;
  std::vector<Stage> stages;
  bool half_turn;      ///< flat at half a turn of the crank, or else at zero
  bool parallelogram;  ///< or a kite, whose coupler may lie on its crank
  /// Nearer than this to the change point, rounding leaves no digits of the last stage: each branch
  /// has a row, but which row belongs to which branch is not known.
  double lost = 0;

  friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.name; }
  [[nodiscard]] Real flat() const { return half_turn ? std::numbers::pi_v<Real> : 0; }
  [[nodiscard]] unsigned modes() const { return 1U << stages.size(); }
};

SceneMaker::Json scene_of(const Row& row) {
  SceneMaker scene;
  scene.parameter("phi", 0.0)
      .bar("ground", {{"A", 0.0}})
      .bar("crank", {{"A", 0.0}, {"C0", row.crank}});
  double place = 0;
  for (std::size_t index = 0; index < row.stages.size(); ++index) {
    const Stage& stage = row.stages[index];
    const std::string here = std::to_string(index);
    const std::string next = "C" + std::to_string(index + 1);
    scene.bar("ground", {{"D" + here, place += stage.ground}});
    scene.bar("coupler" + here, {{"C" + here, 0.0}, {next, stage.coupler}});
    scene.bar("rocker" + here, {{"D" + here, 0.0}, {next, stage.rocker}});
  }
  return scene.drive("A", "phi", 1, 0).scene();
}

/// The pins between couplers and rockers. In each stage the pin is where a parallelogram (or a
/// folded kite) has it, or is mirrored in the line through the two other pins.
std::vector<Complex> pins(const Row& row, Real phi, unsigned mode) {
  const Real move = phi - row.flat();
  Complex b = Complex(std::cos(move), std::sin(move)) * (row.half_turn ? -1.0L : 1.0L) *
              static_cast<Real>(row.crank);
  Complex base = 0;
  std::vector<Complex> result;
  for (std::size_t index = 0; index < row.stages.size(); ++index) {
    const Complex d = base + static_cast<Real>(row.stages[index].ground);
    const Complex plain = row.parallelogram ? d + b - base : base;
    const Complex along = (d - b) / std::abs(d - b);
    const bool mirrored = (mode >> index & 1U) != 0;
    result.push_back(mirrored ? b + along * std::conj((plain - b) / along) : plain);
    b = result.back();
    base = d;
  }
  return result;
}

/// Whether a configuration is in a mode, within the accuracy: each stage loses as many digits again
/// as the previous one, and configurations that meet to within rounding are the same.
bool is_in_mode(const Row& row, unsigned mode, const mechanism::SweepRecord& at) {
  const Real away = std::abs(static_cast<Real>(at.parameter) - row.flat());
  if (away > 0 && away < row.lost) {
    return true;
  }
  const bool merged = at.state->regularity != Status::ok && !at.state->derivatives_known;
  const std::vector<Complex> truth = pins(row, at.parameter, mode);
  const auto rate = [&](std::size_t index, Real middle, Real half) {
    return (pins(row, middle + half, mode)[index] - pins(row, middle - half, mode)[index]) /
           (2 * half);
  };
  for (std::size_t index = 0; index < row.stages.size(); ++index) {
    Real tolerance =
        std::min(3e-2L * away + 1e-7L, 1e-13L / std::pow(std::max(away, 1e-12L), Real(index + 1)));
    if (index > 0) {
      tolerance = std::max(tolerance, std::min(5 * away + 1e-7L, 1e-4L));
    }
    if (merged) {
      tolerance = std::max(tolerance, row.stages.size() > 2 ? 1.5e-6L : 1e-6L);
    }
    const mechanism::Point& pin = at.state->output("C" + std::to_string(index + 1));
    if (!(std::abs(Complex(pin.position.x(), pin.position.y()) - truth[index]) <= tolerance)) {
      return false;
    }
    const Complex velocity(pin.velocity.x(), pin.velocity.y());
    if (at.state->rates_known && away > 1e-6L &&
        !(std::abs(velocity - rate(index, at.parameter, 1e-7L)) < 0.3L)) {
      return false;
    }
    if (at.state->rates_known && away < 1e-8L &&
        !(std::abs(velocity - rate(index, row.flat(), 1e-6L)) < 0.3L)) {
      return false;
    }
  }
  return true;
}

void expect_crossing(const Row& row, SceneMaker::Json scene, double from, double to, int count) {
  scene["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", count}};
  const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
  std::map<int, std::set<unsigned>> modes;     // of each branch: those that all its rows are in
  std::map<int, std::multiset<int>> branches;  // of each step
  int crossings = 0;
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (!at.event.empty()) {
      EXPECT_EQ(at.event.rfind("crossing", 0), 0U) << at.event;
      EXPECT_EQ(std::count(at.event.begin(), at.event.end(), ' '), row.modes());
      EXPECT_LT(std::abs(at.parameter - row.flat()), 5e-12L);
      EXPECT_LT(at.state->residual, 5e-11);
      ++crossings;
      return;
    }
    branches[at.step].insert(at.branch);
    std::set<unsigned>& possible = modes[at.branch];
    for (unsigned mode = 0; mode < row.modes() && branches.size() == 1; ++mode) {
      possible.insert(mode);
    }
    std::erase_if(possible, [&](unsigned mode) { return !is_in_mode(row, mode, at); });
  };
  mechanism::sweep(plan, {record, {}, {}});
  EXPECT_EQ(crossings, 1);
  std::multiset<int> all;
  for (unsigned number = 1; number <= row.modes(); ++number) {
    all.insert(static_cast<int>(number));
  }
  for (const auto& [step, numbers] : branches) {
    EXPECT_EQ(numbers, all) << "step " << step;
  }
  std::set<unsigned> taken;
  for (const auto& [branch, possible] : modes) {
    EXPECT_FALSE(possible.empty()) << "branch " << branch << " changes its mode";
    if (possible.size() == 1) {
      EXPECT_TRUE(taken.insert(*possible.begin()).second) << "branch " << branch;
    }
  }
}

class ChangePoints : public testing::TestWithParam<Row> {};

/// By default one sweep in 17, and one in 51 for rows with many branches; all by `ctest -L long`.
TEST_P(ChangePoints, AreCrossingsInSweepsOfAnyWidth) {
  const Row& row = GetParam();
  const bool all = is_whole_campaign();
  const int share = row.stages.size() > 3 ? 51 : 17;
  int number = 0;
  const auto flat = static_cast<double>(row.flat());
  for (double width = 1; width > 5e-10; width /= 10) {
    for (const double before : {1.0, 0.63}) {
      for (const int count : {2, 3, 4}) {
        for (int listing = 0; listing < listings; ++listing) {
          if (number++ % share != 0 && !all) {
            continue;
          }
          SCOPED_TRACE(testing::Message()
                       << width << " " << before << " " << count << " listing " << listing);
          expect_crossing(row, scene_listed(scene_of(row), listing), flat - before * width,
                          flat + width, count);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , ChangePoints,
    testing::Values(
        Row{"parallelogram", 2, {{4, 2, 4}}, false, true},
        Row{"antiparallel", 2, {{4, 2, 4}}, true, true},
        Row{"lengths that are not dyadic", 1.3, {{0.79, 1.3, 0.79}}, true, true},
        Row{"rhombus", 3, {{3, 3, 3}}, true, true}, Row{"kite", 4, {{4, 2, 2}}, false, false},
        Row{"kite unfolded", 0.6, {{0.6, 1.25, 1.25}}, true, false},
        Row{"two in a row", 6, {{11, 6, 11}, {9, 6, 9}}, true, true},
        Row{"three in a row", 6, {{11, 6, 11}, {9, 6, 9}, {7, 6, 7}}, true, true},
        Row{"three fast", 2, {{3, 2, 3}, {3, 2, 3}, {3, 2, 3}}, false, true, 2e-6},
        Row{"four", 1, {{3, 1, 3}, {3, 1, 3}, {3, 1, 3}, {3, 1, 3}}, true, true, 2e-6},
        Row{"four rocking", 3, {{1, 3, 1}, {1, 3, 1}, {1, 3, 1}, {1, 3, 1}}, false, true, 2e-6}));

/// Peaucellier's cell with arms of 5 and a rhombus of 3. A length moves its pin B through the
/// middle between P and Q, where C meets B. There the configurations with C = B and with C opposite
/// B cross, for each of the two places of P and Q. No driver moves with the length.
TEST(ChangePointsOfALength, AreCrossingsInSweepsOfAnyWidth) {
  SceneMaker cell;
  cell.parameter("p", 0.0)
      .point("ground", "O", 0, 0)
      .point("ground", "B", "4 + p", 0)
      .bar("upper_arm", {{"O", 0}, {"P", 5}})
      .bar("lower_arm", {{"O", 0}, {"Q", 5}})
      .bar("BP", {{"B", 0}, {"P", 3}})
      .bar("BQ", {{"B", 0}, {"Q", 3}})
      .bar("CP", {{"C", 0}, {"P", 3}})
      .bar("CQ", {{"C", 0}, {"Q", 3}});
  for (const double width : share_of(std::vector<double>{1e-1, 1e-4, 1e-6, 1e-8}, 3)) {
    for (const int count : {3, 4}) {
      for (int listing = 0; listing < (is_whole_campaign() ? 2 : 1); ++listing) {
        SCOPED_TRACE(testing::Message() << width << " " << count << " listing " << listing);
        SceneMaker::Json scene = scene_listed(cell.scene(), listing);
        scene["sweep"] = {{"parameter", "p"}, {"from", -width}, {"to", width}, {"count", count}};
        const mechanism::Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
        int crossings = 0;
        std::map<int, int> rows;
        const auto record = [&](const mechanism::SweepRecord& at) {
          if (at.event.empty()) {
            ++rows[at.branch];
            return;
          }
          EXPECT_EQ(at.event.rfind("crossing", 0), 0U) << at.event;
          EXPECT_EQ(std::count(at.event.begin(), at.event.end(), ' '), 2);
          EXPECT_LT(std::abs(at.parameter), 1e-11);
          EXPECT_LT(at.state->residual, 5e-11);
          ++crossings;
        };
        mechanism::sweep(plan, {record, {}, {}});
        EXPECT_EQ(crossings, 2);
        EXPECT_EQ(rows, (std::map<int, int>{{1, count}, {2, count}, {3, count}, {4, count}}));
      }
    }
  }
}

}  // namespace
}  // namespace assur::test::change_points_test
