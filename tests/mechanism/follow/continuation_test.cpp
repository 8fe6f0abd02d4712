// Law: from set to set of values, a continuation goes to the configuration of the same branch: in a
// four-bar the one with the same sign of its triangle, whichever parameters change.
#include <gtest/gtest.h>

#include <assur/mechanism/continuation.hpp>
#include <cmath>
#include <cstdio>
#include <random>

#include "mechanism/solved.hpp"

namespace assur::test::continuation_test {
namespace {

using mechanism::Continuation;
using mechanism::ParameterIndex;

constexpr unsigned seed = 20261128;

mechanism::Scene four_bar() {
  return mechanism::parse_scene(R"({
    "parameters": {"a": 2, "b": 4, "c": 3.5, "phi": 0.3},
    "links": {"ground": {"A": [0, 0], "D": [5, 0]}, "crank": {"A": [0, 0], "B": ["a", 0]},
              "coupler": {"B": [0, 0], "C": ["b", 0]}, "rocker": {"D": [0, 0], "C": ["c", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
               "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
               "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
               "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": "phi"}}, "outputs": {"C": "coupler.C"}, "want": ["position"]})",
                                "scene");
}

/// The sign of the triangle B C D.
bool is_left(const Configuration& configuration) {
  const auto& B = configuration.link("coupler").pose;
  const Eigen::Vector2d& C = configuration.output("C").position;
  return (C.x() - B.x) * (0 - C.y()) - (C.y() - B.y) * (5 - C.x()) > 0;
}

struct Walk {
  mechanism::Scene scene = four_bar();
  std::vector<ParameterIndex> parameters;
  Continuation branches;
  mechanism::Values values;

  Walk() : parameters(named()), branches(made()), values(branches.plan().values()) {}

  std::vector<ParameterIndex> named() const {
    std::vector<ParameterIndex> result;
    for (const char* name : {"a", "b", "c", "phi"}) {
      result.push_back(scene.mechanism.parameter_named(name));
    }
    return result;
  }
  Continuation made() const { return {scene.mechanism, scene.request, parameters}; }

  const Solution& at(const std::vector<double>& numbers) {
    std::vector<std::pair<ParameterIndex, double>> changed;
    for (std::size_t one = 0; one < parameters.size(); ++one) {
      changed.emplace_back(parameters[one], numbers[one]);
    }
    values.set(changed);
    return branches.solve(values);
  }
};

TEST(Continuation, KeepsTheSignOfATriangle) {
  Walk walk;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-1, 1);
  double phi = 0.3;
  std::vector<bool> signs;
  int compared = 0;
  for (int step = 0; step < 300; ++step) {
    phi += 0.5 * part(random);  // a crank-rocker for all of these lengths, so it may turn anywhere
    const Solution& solution =
        walk.at({1.6 + 0.4 * part(random), 4 + 0.3 * part(random), 3.5 + 0.3 * part(random), phi});
    ASSERT_EQ(solution.configurations.size(), 2U);
    if (step == 0) {
      signs = {is_left(solution.configurations[0]), is_left(solution.configurations[1])};
      ASSERT_NE(signs[0], signs[1]);
      EXPECT_TRUE(walk.branches.go_to());
      continue;
    }
    const Continuation::Next next = walk.branches.next();
    ASSERT_EQ(next.size(), 2U);
    std::vector<bool> found(2);
    for (std::size_t place = 0; place < 2; ++place) {
      ASSERT_TRUE(next[place]) << "step " << step;
      EXPECT_EQ(is_left(solution.configurations[*next[place]]), signs[place]) << "step " << step;
      found[*next[place]] = signs[place];
      ++compared;
    }
    signs = found;
    EXPECT_TRUE(walk.branches.go_to());
  }
  std::printf("%d configurations continued, seed %u\n", compared, seed);
}

TEST(Continuation, StaysWhereItIsBeforeWhatCannotBeReached) {
  Walk walk;
  const Solution* solution = &walk.at({4, 4, 3.5, 1});
  const bool begun = is_left(solution->configurations[0]);
  walk.branches.go_to();
  EXPECT_TRUE(walk.at({4, 4, 3.5, 3}).configurations.empty());  // beyond a dead centre
  EXPECT_EQ(walk.branches.next(), Continuation::Next(2));
  // Assembled again on the other side of it, which no branch reaches.
  EXPECT_EQ(walk.at({4, 4, 3.5, 2 * 3.141592653589793 - 1}).configurations.size(), 2U);
  EXPECT_EQ(walk.branches.next(), Continuation::Next(2));
  EXPECT_THROW(walk.at({4, 4, 3.5, std::nan("")}), mechanism::MechanismError);
  solution = &walk.at({4, 4, 3.5, 1.1});
  const Continuation::Next next = walk.branches.next();
  ASSERT_TRUE(next[0]);
  EXPECT_EQ(is_left(solution->configurations[*next[0]]), begun);
}

}  // namespace
}  // namespace assur::test::continuation_test
