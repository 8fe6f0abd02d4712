// Law: the forces of an emitted solver are the same in batches and in C, are NaN if they are not
// determined, and cost nothing if they are not requested.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "generator/mixed_scene.hpp"
#include "generator/solver_comparison.hpp"
#include "mechanism/turning_spring.hpp"

namespace assur::test::emit_forces_forms_test {
namespace {

using Json = nlohmann::ordered_json;

/// Compiles and runs a program that includes the solver of a scene, and gives what it prints.
std::string run_program(const std::string& name, const Json& scene, const std::string& text,
                        const std::string& options = "") {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  emit_solver({directory.write(name + ".json", scene.dump()), name, "", {}}, directory, options);
  const auto source = directory.write("driver.cpp", text);
  compile_program(source, root + "/driver", directory);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  return read_file(directory.path() / "printed");
}

/// `track` counts the turns of a spring and of an angle that a load reads, as a sweep does, in C++
/// and in C.
TEST(EmitForces, OfASpringCountItsTurnsAlongABranch) {
  const Json scene = turning_spring();
  const std::string printed =
      run_program("turning", scene,
                  R"cpp(#include <cstdio>
#include <assur/scenes/turning.cpp>
                        using S = assur::scenes::Turning;
                        int main() {
                          for (int k = 0; k < 2; ++k) {
                            S::Drivers<double> drivers;
                            S::Branch branch = S::branch(drivers, k);
                            S::State<double> state;
                            turning_drivers in_c;
                            turning_defaults(&in_c);
                            turning_branch branch_in_c;
                            turning_state state_in_c;
                            turning_way way;
                            (void)turning_begin(&in_c, k, &branch_in_c);
                            for (int row = 0; row <= 720; ++row) {
                              in_c.A.position = drivers.A.position = 0.3 + 4 * 3.14159265358979323846 * row / 720;
                              if (!assur::is_solvable(S::track(drivers, branch, state).status) ||
                                  turning_track(&in_c, &branch_in_c, &state_in_c, &way) >
                                      turning_status_near_singular) {
                                return 1;
                              }
                              std::printf("%.17g %.17g ", state.efforts.A, state_in_c.efforts.A);
                            }
                          }
                        }
                  )cpp",
                  "--interface c");
  std::istringstream numbers(printed);
  double worst = 0;
  for (const std::size_t branch : {1U, 2U}) {
    for (const double effort : efforts_along(scene, branch)) {
      double in_cpp = 0;
      double in_c = 0;
      ASSERT_TRUE(numbers >> in_cpp >> in_c);
      EXPECT_EQ(in_cpp, in_c);
      worst = std::max(worst, std::abs(in_cpp - effort));
    }
  }
  EXPECT_LT(worst, 1e-10);
}

/// Batches give the same numbers bit by bit, forces among them; springs at pins have no packs, so
/// that here a scene without one is solved.
TEST(EmitForces, AreTheSameInBatches) {
  Json json = mixed_scene();
  json["springs"].erase("T");
  json["loads"].erase("M");
  EXPECT_EQ(
      run_program("packed", json, R"cpp(#include <cstdio>
#include <vector>
#include <assur/scenes/packed.hpp>
                                        using S = assur::scenes::Packed;
                                        constexpr std::size_t count = 50, columns = assur::support::column_count<S::State<double>>;
                                        constexpr std::size_t most = static_cast<std::size_t>(S::max_configurations);
                                        int main() {
                                          std::vector<double> given(3 * count), states(most * columns * count);
                                          std::vector<assur::AssemblyStatus> status(count);
                                          std::vector<assur::Status> regularity(most * count);
                                          std::vector<int> found(count), families(count), mobility(count);
                                          for (std::size_t i = 0; i < count; ++i) {
                                            given[i] = 0.12 * static_cast<double>(i);
                                            given[count + i] = 3;
                                            given[2 * count + i] = -1;
                                          }
                                          S::BatchSolutions result;
                                          result.status = status.data();
                                          result.count = found.data();
                                          result.families = families.data();
                                          result.mobility = mobility.data();
                                          result.regularity = regularity.data();
                                          result.states = states.data();
                                          result.stride = count;
                                          (void)S::solve_batch(count, {given.data(), count}, result);
                                          int compared = 0, differ = 0;
                                          for (std::size_t i = 0; i < count; ++i) {
                                            S::Drivers<double> drivers;
                                            drivers.A = {given[i], 3, -1};
                                            std::array<S::State<double>, most> lone;
                                            const int n = S::solve(drivers, lone).count;
                                            differ += n != found[i];
                                            for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
                                              assur::support::for_each_column(
                                                  lone[k], [&](double& number, std::size_t column) {
                                                    differ += number != result.column(k, column)[i];
                                                    compared += 1;
                                                  });
                                            }
                                          }
                                          std::printf("%d %s\n", differ, compared > 1000 ? "of many" : "of few");
                                        }
      )cpp"),
      "0 of many\n");
}

/// The same program in C reads the same numbers.
TEST(EmitForces, AreToldInC) {
  const std::string printed =
      run_program("mixed", mixed_scene(),
                  R"cpp(#include <cstdio>
#include <cmath>
#include <assur/scenes/mixed.cpp>
                        int main() {
                          mixed_drivers drivers;
                          mixed_defaults(&drivers);
                          static mixed_solution told;
                          (void)mixed_solve(&drivers, &told);
                          using S = assur::scenes::Mixed;
                          std::array<S::State<double>, S::max_configurations> states;
                          const S::Solution found = S::solve(S::Drivers<double>{}, states);
                          double apart = found.count == told.count && found.count > 0 ? 0 : 1;
                          for (int i = 0; i < found.count; ++i) {
                            const auto& s = states[static_cast<std::size_t>(i)];
                            const mixed_state& c = told.states[i];
                            apart += std::abs(s.efforts.A - c.efforts.A) +
                                     std::abs(s.forces.C.strut(1) - c.forces.C.strut[1]) +
                                     std::abs(s.forces.B(0) - c.forces.B[0]) +
                                     std::abs(s.forces.S.force(1) - c.forces.S.force[1]) +
                                     std::abs(s.forces.S.moment - c.forces.S.moment) +
                                     std::abs(s.ground.moment - c.ground.moment);
                          }
                          std::printf("%g\n", apart);
                        }
                  )cpp",
                  "--interface c");
  EXPECT_EQ(printed, "0\n");
}

/// With masses, stiffnesses and lengths as arguments, the solver of one scene has the results of
/// another scene's solver.
TEST(EmitForces, FollowVariableParameters) {
  Json json = mixed_scene();
  json["parameters"] = {
      {"load", 2}, {"k", 3}, {"rod", 3}, {"sag", {{"value", 0.2}, {"velocity", 1}}}};
  json["links"]["rod"]["C"] = {"rod", 0};
  json["springs"]["K"]["stiffness"] = "k";
  Json other = json;
  other["parameters"]["load"] = 2.5;
  other["parameters"]["k"] = 1;
  other["parameters"]["rod"] = 3.1;
  const auto printing = [](const std::string& solver, const std::string& given) {
    return "#include <cstdio>\n#include <assur/scenes/" + solver +
           ".hpp>\nint main() {\n  using S = assur::scenes::" + struct_of(solver) +
           R"(;
  std::array<S::State<double>, S::max_configurations> states;
  const auto found = S::solve(S::Drivers<double>{})" +
           given + R"(, states);
  for (int i = 0; i < found.count; ++i) {
    const auto& s = states[static_cast<std::size_t>(i)];
    std::printf("%.9g %.9g %.9g %.9g\n", s.efforts.A, s.forces.S.moment, s.forces.C.rod(0),
                s.ground.moment);
  }
}
)";
  };
  const std::string told =
      run_program("variable", json, printing("variable", ", S::Parameters<double>{2.5, 1, 3.1}"),
                  "--variable load,k,rod");
  EXPECT_EQ(told, run_program("fixed", other, printing("fixed", "")));
  EXPECT_GT(std::count(told.begin(), told.end(), '\n'), 0);
}

/// A stretched dyad can be prestressed: its forces are NaN although it is not loaded, and the
/// effort of a driver that does not carry it is reported.
TEST(EmitForces, AreNotToldAtADeadCentre) {
  const Json json = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0], "E": [9, 0]}, "crank": {"A": [0, 0], "B": [1, 0]},
      "rod": {"B": [0, 0], "C": [2, 0]}, "rocker": {"D": [0, 0], "C": [1, 0]},
      "arm": {"E": [0, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "rocker.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]},
      "E": {"type": "revolute", "between": ["ground.E", "arm.E"]}},
    "drivers": {"A": {"position": 0}, "E": {"position": 1}},
    "loads": {"M": {"on": "arm", "moment": 3}}, "want": ["position", "forces"]})");
  EXPECT_EQ(run_program("stretched", json, R"cpp(#include <cmath>
#include <cstdio>
#include <assur/scenes/stretched.hpp>
                                                 int main() {
                                                   using S = assur::scenes::Stretched;
                                                   std::array<S::State<double>, S::max_configurations> states;
                                                   const S::Solution found = S::solve(S::Drivers<double>{}, states);
                                                   for (int i = 0; i < found.count; ++i) {
                                                     const auto& s = states[static_cast<std::size_t>(i)];
                                                     std::printf("%d %g %g\n",
                                                                 std::isnan(s.forces.C(0)) &&
                                                                     std::isnan(s.forces.B(1)),
                                                                 s.efforts.E, s.ground.moment);
                                                   }
                                                 }
            )cpp"),
            "1 -3 3\n");
}

/// Masses, loads and springs change nothing where no forces are wanted.
TEST(EmitForces, CostNothingWhereTheyAreNotWanted) {
  const TemporaryDirectory directory;
  Json json = mixed_scene();
  json["want"] = {"position", "velocity"};
  Json bare = json;
  for (const char* part : {"gravity", "masses", "loads", "springs"}) {
    bare.erase(part);
  }
  const std::string text = [&] {
    emit_solver({directory.write("scene.json", bare.dump()), "scene", "", {}}, directory);
    return read_file(directory.path() / "assur/scenes/scene.hpp");
  }();
  emit_solver({directory.write("scene.json", json.dump()), "scene", "", {}}, directory);
  EXPECT_EQ(read_file(directory.path() / "assur/scenes/scene.hpp"), text);
  EXPECT_EQ(text.find("orces"), std::string::npos);
}

}  // namespace
}  // namespace assur::test::emit_forces_forms_test
