// Law: on and beside change points, a mechanism with redundant constraints has the motions and the
// configurations that all constraints leave, whatever its links are called.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mechanism/redundant_cranks.hpp"
#include "mechanism/scene_maker.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Two parallelograms in a row, with a bar from the first crank to the last; `order` has the
/// numbers in the names of the links.
SceneMaker double_parallelogram(const std::array<int, 6>& order) {
  const auto named = [&order](std::size_t part) { return "link" + std::to_string(order[part]); };
  SceneMaker maker;
  maker.parameter("phi", 0.7).bar("ground", {{"A", 0}, {"D", 3}, {"G", 7}});
  maker.bar(named(0), {{"A", 0}, {"B", 2}}).bar(named(1), {{"D", 0}, {"C", 2}});
  maker.bar(named(2), {{"G", 0}, {"F", 2}}).bar(named(3), {{"B", 0}, {"C", 3}});
  maker.bar(named(4), {{"C", 0}, {"F", 4}}).bar(named(5), {{"B", 0}, {"F", 7}});
  return maker.drive("A", "phi", 1, 0);
}

/// Cranks turn as the first one does, and bars do not turn; rates that are not known are skipped.
void expect_parallel(const Configuration& motion, const std::array<int, 6>& order,
                     const std::string& where) {
  for (std::size_t part = 0; part < order.size(); ++part) {
    const double turning = motion.link("link" + std::to_string(order[part])).velocity(2);
    if (std::isfinite(turning)) {
      EXPECT_NEAR(turning, part < 3 ? 1 : 0, 0.02) << where << ", part " << part;
    }
  }
}

TEST(RedundantBranches, OfADoubleParallelogramAreParallel) {
  std::array<int, 6> order = {0, 1, 2, 3, 4, 5};
  int number = 0;
  do {
    if (number++ % 41 != 0) {
      continue;
    }
    const Plan plan(mechanism::parse_scene(double_parallelogram(order).scene().dump(), "scene"));
    for (const double flat : {0.0, pi}) {
      for (const double beside : {0.0, 1e-12, 1e-9, 1e-8, 2e-8, 3e-7, 1e-5, 1e-3}) {
        const std::string where = std::to_string(number) + ", " + std::to_string(flat) + " + " +
                                  std::to_string(beside * 1e9) + "e-9";
        const Solution found = plan.solve(plan.values({{"phi", flat + beside}}));
        ASSERT_FALSE(found.configurations.empty()) << where;
        for (const Configuration& one : found.configurations) {
          if (one.rates_known) {
            expect_parallel(one, order, where);
          }
          for (const Configuration& branch : one.branches) {
            expect_parallel(branch, order, where);
          }
        }
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(RedundantBranches, SweepsHaveOneRowAStep) {
  RedundantCranks cranks(2);
  cranks.add("A", {0, 0}).add("B", {1, 0}).add("C", {3, 0}).add("D", {7, 0}).drive("A");
  for (const double from : {pi - 3.7e-6, pi - 1e-3}) {
    cranks.json()["sweep"] = {
        {"parameter", "phi"}, {"from", from}, {"to", pi + 1e-5}, {"count", 21}};
    cranks.json()["parameters"]["phi"] = 0.7;
    const SweepKept run = run_sweep(mechanism::parse_scene(cranks.json().dump(), "scene"));
    EXPECT_EQ(run.rows.size(), 21U) << from - pi;
    EXPECT_TRUE(run.events.empty()) << from - pi;
  }
}

}  // namespace
}  // namespace assur::test
