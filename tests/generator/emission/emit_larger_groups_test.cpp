// Law: a solver emitted for a mechanism with a group of more than four links has the configurations
// and motions of `assur solve`, follows branches, and allocates nothing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "generator/solver_comparison.hpp"

namespace assur::test::emit_larger_groups_test {
namespace {

using Json = nlohmann::ordered_json;

/// Three ternary links, each pinned to the crank or the ground, and three bars between them: 14
/// complex configurations.
Json three_pairs() {
  return Json::parse(R"({
    "points": {"A": [-2, 0], "B": [-1, 1], "D": [4, 0.5], "F": [7, 0], "P": [0, 3], "Q": [-0.5, 5],
               "R": [3.2, 2.9], "S": [4.6, 3.1], "T": [6, 5.5], "U": [7.4, 3.3]},
    "links": {"ground": ["A", "D", "F"], "crank": ["A", "B"], "one": ["B", "P", "Q"],
              "two": ["D", "R", "S"], "three": ["F", "T", "U"], "bar_a": ["P", "R"],
              "bar_b": ["Q", "T"], "bar_c": ["S", "U"]},
    "parameters": {"a": {"drawn": ["P", "R"], "tolerance": 0.01},
                   "b": {"drawn": ["D", "S"], "tolerance": 0.02}},
    "drivers": {"A": {"position": 0.785, "velocity": 1, "acceleration": 0.5}}, "outputs": ["S", "T"]})");
}

/// The same with a further dyad on one of its links.
Json with_a_dyad() {
  Json scene = three_pairs();
  scene["points"]["V"] = {9, 5};
  scene["points"]["W"] = {10, 1};
  scene["links"]["ground"] = {"A", "D", "F", "W"};
  scene["links"]["rod"] = {"U", "V"};
  scene["links"]["rocker"] = {"V", "W"};
  scene["links"]["three"] = {"F", "T", "U"};
  scene["outputs"] = {"V"};
  return scene;
}

/// A bar slides in place of one of the pins.
Json with_a_slide() {
  Json scene = three_pairs();
  scene["links"]["bar_c"] = {"U"};
  scene["joints"]["guide"] = {
      {"type", "prismatic"}, {"links", {"two", "bar_c"}}, {"at", "S"}, {"along", {"S", "U"}}};
  scene["parameters"].erase("b");
  return scene;
}

/// Slides in place of three more, in three directions: no elimination leaves one unknown.
Json with_three_slides() {
  Json scene = three_pairs();
  scene["parameters"].erase("b");
  scene["parameters"].erase("a");
  for (const auto& [bar, end, other, link] : {std::array{"bar_a", "R", "P", "two"},
                                              {"bar_b", "Q", "T", "one"},
                                              {"bar_c", "U", "S", "three"}}) {
    scene["links"][bar] = {other};
    scene["joints"][std::string("guide_") + bar] = {
        {"type", "prismatic"}, {"links", {link, bar}}, {"at", end}, {"along", {end, other}}};
  }
  return scene;
}

EmittedScene written(const TemporaryDirectory& directory, const std::string& name,
                     const Json& scene) {
  return {directory.write(name + ".json", scene.dump()), name, struct_of(name), {}};
}

TEST(EmitLargerGroups, AgreeWithSolve) {
  const TemporaryDirectory directory;
  const std::vector<int> compared =
      compare_with_solve({written(directory, "three_pairs", three_pairs()),
                          written(directory, "with_a_dyad", with_a_dyad()),
                          written(directory, "with_a_slide", with_a_slide()),
                          written(directory, "with_three_slides", with_three_slides())});
  for (const int numbers : compared) {
    std::cout << numbers << " numbers\n";
    EXPECT_GT(numbers, 100);
  }
}

/// Replaces `operator new` and `malloc` by functions that count.
constexpr const char* counting_head = R"(#include <cstdio>
#include <cstdlib>
#include <new>
static long allocations = 0;
extern "C" void* __real_malloc(std::size_t size);
extern "C" void* __wrap_malloc(std::size_t size) { ++allocations; return __real_malloc(size); }
void* operator new(std::size_t size) { ++allocations; return std::malloc(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#include <assur/scenes/three_pairs.hpp>
#include <assur/scenes/with_three_slides.hpp>
template <typename Solver>
auto& states_of() {
  static std::array<typename Solver::template State<double>, Solver::max_configurations> states;
  return states;
}
)";

TEST(EmitLargerGroups, FollowBranchesAndAllocateNothing) {
  const TemporaryDirectory directory;
  emit_solver(written(directory, "three_pairs", three_pairs()), directory);
  emit_solver(written(directory, "with_three_slides", with_three_slides()), directory);
  const auto source = directory.write("follow.cpp", std::string(counting_head) + R"(int main() {
  using Slides = assur::scenes::WithThreeSlides;
  const bool all = Slides::solve(Slides::Drivers<double>(), states_of<Slides>()).complete;
  using Solver = assur::scenes::ThreePairs;
  auto& states = states_of<Solver>();
  Solver::Drivers<double> drivers;
  auto found = Solver::solve(drivers, states);
  int followed = 0;
  double farthest = 0;
  for (int k = 0; k < found.count; ++k) {
    drivers = {};
    Solver::Branch branch = Solver::branch(drivers, k);
    Solver::State<double> state;
    for (int step = 0; step < 20; ++step) {
      drivers.A.position -= 0.02;
      const Solver::Track track = Solver::track(drivers, branch, state);
      if (!assur::is_solvable(track.status)) break;
      ++followed;
      found = Solver::solve(drivers, states);
      double nearest = 1;
      for (int other = 0; other < found.count; ++other) {
        const auto& at = states[static_cast<std::size_t>(other)].outputs.S.position;
        const double away = (at - state.outputs.S.position).norm();
        nearest = away < nearest ? away : nearest;
      }
      farthest = nearest > farthest ? nearest : farthest;
    }
  }
  std::printf("%d %g %ld %d\n", followed, farthest, allocations, all && found.complete ? 1 : 0);
}
)");
  const SolverCompiler compiler = quick_compiler();
  compile(
      compiler.command,
      "-O0 " + compiler.objects + "-Wl,--wrap=malloc -o " + directory.path().string() + "/follow",
      source, directory);
  ASSERT_EQ(std::system(
                (directory.path().string() + "/follow > " + directory.path().string() + "/printed")
                    .c_str()),
            0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  int followed = 0;
  double farthest = 1;
  long allocations = 1;
  int complete = 0;
  printed >> followed >> farthest >> allocations >> complete;
  std::cout << followed << " places followed, at most " << farthest << " from one that is listed\n";
  EXPECT_GE(followed, 20);
  EXPECT_LT(farthest, 1e-9);
  // std::printf allocates its buffer once, after the count is passed to it.
  EXPECT_EQ(allocations, 0);
  EXPECT_EQ(complete, 1);
}

}  // namespace
}  // namespace assur::test::emit_larger_groups_test
