// Law: the solver emitted for a scene with redundant joints omits their constraints, says so, and
// finds the configurations in which they hold.
#include <gtest/gtest.h>

#include <assur/assemblies.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"

namespace assur::test::emit_redundant_test {
namespace {

/// A coupler on three parallel cranks of one length.
SceneMaker three_cranks() {
  SceneMaker scene;
  scene.bar("ground", {{"A", 0}, {"D", 4}, {"F", 2}})
      .bar("crank", {{"A", 0}, {"B", 1.5}})
      .bar("coupler", {{"B", 0}, {"C", 4}, {"G", 2}})
      .bar("rocker", {{"D", 0}, {"C", 1.5}})
      .bar("third", {{"F", 0}, {"G", 1.5}})
      .drive("A", 0.7, 2, 0.5);
  return scene;
}

TEST(EmitRedundant, SolversFindTheConfigurationsInWhichTheJointsHold) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  nlohmann::ordered_json scene = three_cranks().scene();
  scene["parameters"]["length"] = {{"value", 1.5}, {"variable", true}};
  scene["links"]["third"]["G"] = {"length", 0};
  scene["redundancy"]["tolerance"] = 1e-5;
  scene["outputs"] = {{"G", "third.G"}};
  scene["want"] = {"position"};
  const auto file = directory.write("cranks.json", scene.dump());
  const CommandResult emitted = run_assur("emit --scene " + file.string() + " --output " + root);
  EXPECT_EQ(emitted.status, 0);
  EXPECT_EQ(emitted.messages,
            "warning: " + file.string() +
                ": joints.C: constraints of the joint are redundant; the solver leaves them out, "
                "and excludes the configurations in which they do not hold\n");
  const std::string code = read_file(directory.path() / "assur/scenes/cranks.hpp");
  EXPECT_NE(code.find("/// Redundant constraints of C are left out."), std::string::npos);
  EXPECT_EQ(code.find("slides."), std::string::npos) << "the slot that stands for C is reported";
  EXPECT_EQ(code.find("settle"), std::string::npos) << "what may miss cannot be closed";
  const auto source = directory.write("driver.cpp", R"(#include <assur/scenes/cranks.hpp>
#include <cstdio>
int main() {
  using S = assur::scenes::Cranks;
  std::array<S::State<double>, S::max_configurations> states;
  S::Drivers<double> drivers;
  S::Parameters<double> parameters;
  auto branch = S::branch(drivers, parameters, 0);
  for (const double by : {0.0, 1e-6, -1e-6, 1e-3, -0.1}) {
    for (int step = 0; step < 5; ++step) {
      drivers.A.position = 0.4 + 0.2 * step;
      parameters.length = 1.5 + by;
      S::State<double> state;
      const S::Solution found = S::solve(drivers, parameters, states);
      const S::Track way = S::track(drivers, parameters, branch, state);
      const auto& output = states[0].outputs.G;
      std::printf("%d %d %d %.17g\n", found.count, found.left_out,
                  way.within_limits ? 1 : 0, output.position(0));
    }
  }
}
)");
  compile_program(source, root + "/driver", directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  for (const double by : {0.0, 1e-6, -1e-6, 1e-3, -0.1}) {
    for (int step = 0; step < 5; ++step) {
      SCOPED_TRACE(std::to_string(by) + " " + std::to_string(step));
      const double phi = 0.4 + 0.2 * step;
      int count = 0;
      int left_out = 0;
      int within = 0;
      double x = 0;
      printed >> count >> left_out >> within >> x;
      const bool holds = std::abs(by) < 1e-5;
      EXPECT_EQ(count, holds ? 1 : 0);
      EXPECT_GT(left_out, 0);
      EXPECT_EQ(within, holds ? 1 : 0);
      if (holds) {
        EXPECT_NEAR(x, 2 + 1.5 * std::cos(phi), 1e-15 + 4 * std::abs(by));
      }
    }
  }
}

/// Near a flat position the joint that is left out almost closes in the antiparallelogram, too.
TEST(LongEmitRedundant, SolversFindOneConfigurationBesideTheLine) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  nlohmann::ordered_json scene = three_cranks().scene();
  scene["outputs"] = {{"G", "third.G"}};
  const auto file = directory.write("cranks.json", scene.dump());
  ASSERT_EQ(run_assur("emit --scene " + file.string() + " --output " + root).status, 0);
  const auto source = directory.write("driver.cpp", R"(#include <assur/scenes/cranks.hpp>
#include <cstdio>
template <typename Scalar>
void print(double phi) {
  using S = assur::scenes::Cranks;
  std::array<S::State<Scalar>, S::max_configurations> states;
  S::Drivers<Scalar> drivers;
  drivers.A.position = static_cast<Scalar>(phi);
  const int count = S::solve(drivers, states).count;
  std::printf("%d %.17g\n", count, static_cast<double>(states[0].links.coupler.pose.direction.sin));
}
int main() {
  for (double beside = 1e-2; beside > 1e-11; beside /= 10) {
    for (const double phi : {beside, -beside, 3.141592653589793 - beside}) {
      print<double>(phi);
      print<float>(phi);
    }
  }
}
)");
  compile_program(source, root + "/driver", directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  for (double beside = 1e-2; beside > 1e-11; beside /= 10) {
    for (int place = 0; place < 6; ++place) {
      SCOPED_TRACE(std::to_string(std::log10(beside)) + " " + std::to_string(place));
      const bool is_float = place % 2 == 1;
      int count = 0;
      double sine = 0;
      printed >> count >> sine;
      EXPECT_EQ(count, 1);
      // Nearer than 2e-7 both configurations agree to the square root of rounding.
      const double off = beside > 2e-7 ? 4e-15 / beside : 1e-7;
      EXPECT_NEAR(sine, 0, is_float ? 2e-3 : off);
    }
  }
}

/// A solver's results for the cranks at an angle of the first.
struct Told {
  int status, count, families, regularity;
  double turning, turned, speeding_up;  ///< rocker's rate, coupler's sine, rocker's second rate
};

/// Compiles the solver of a scene of cranks, and asks it for each angle in double, then in float.
std::vector<Told> told_of(const nlohmann::ordered_json& scene, const std::vector<double>& angles) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  const auto file = directory.write("cranks.json", scene.dump());
  EXPECT_EQ(run_assur("emit --scene " + file.string() + " --output " + root).status, 0);
  std::string calls;
  for (const double angle : angles) {
    std::ostringstream digits;
    digits << std::hexfloat << angle;
    calls += "  print<double>(" + digits.str() + ");\n  print<float>(" + digits.str() + ");\n";
  }
  const auto source = directory.write("driver.cpp", R"(#define EIGEN_RUNTIME_NO_MALLOC
#include <assur/scenes/cranks.hpp>
#include <cstdio>
template <typename Scalar>
void print(double angle) {
  using S = assur::scenes::Cranks;
  static std::array<S::State<Scalar>, S::max_configurations> states;
  S::Drivers<Scalar> drivers;
  drivers.A.position = static_cast<Scalar>(angle);
  Eigen::internal::set_is_malloc_allowed(false);
  const S::Solution found = S::solve(drivers, states);
  Eigen::internal::set_is_malloc_allowed(true);
  const auto& links = states[0].links;
  std::printf("%d %d %d %d %.17g %.17g %.17g\n", static_cast<int>(found.status), found.count,
              found.families, found.count > 0 ? static_cast<int>(states[0].regularity) : -1,
              static_cast<double>(links.rocker.velocity(2)),
              static_cast<double>(links.coupler.pose.direction.sin),
              static_cast<double>(links.rocker.acceleration(2)));
}
int main() {
)" + calls + "}\n");
  compile_program(source, root + "/driver", directory);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::ifstream printed(directory.path() / "printed");
  std::vector<Told> all;
  std::string turning;
  std::string turned;
  std::string speeding_up;
  Told one{};
  while (printed >> one.status >> one.count >> one.families >> one.regularity >> turning >>
         turned >> speeding_up) {
    one.turning = std::strtod(turning.c_str(), nullptr);
    one.turned = std::strtod(turned.c_str(), nullptr);
    one.speeding_up = std::strtod(speeding_up.c_str(), nullptr);
    all.push_back(one);
  }
  EXPECT_EQ(all.size(), 2 * angles.size());
  return all;
}

/// Verdicts and rates are those of all constraints together, as `assur solve` closes them.
TEST(LongEmitRedundant, SolversTellWhatAllConstraintsTell) {
  // Two cranks in line with their pivots, and a third one that is not.
  nlohmann::ordered_json scene = three_cranks().scene();
  scene["links"]["ground"]["F"] = scene["links"]["coupler"]["G"] = {2, 1};
  const double in_line = std::atan2(1.0, 2.0);
  std::vector<double> angles;
  for (const double beside : {0.0, 1e-12, 1e-9, 1e-7, 1e-5, -1e-3}) {
    angles.push_back(in_line + beside);
  }
  int place = 0;
  for (const Told& told : told_of(scene, angles)) {
    const bool is_float = place++ % 2 == 1;
    SCOPED_TRACE(place);
    EXPECT_EQ(told.count, 1);
    EXPECT_TRUE(told.regularity == 0 || is_float);
    EXPECT_NEAR(told.turned, 0, is_float ? 1e-5 : 1e-13);
    EXPECT_NEAR(told.turning, 2, is_float ? 1e-3 : 1e-12);
    if (told.regularity == 0) {
      EXPECT_NEAR(told.speeding_up, 0.5, is_float ? 1e-2 : 1e-11);
    }
  }
  // With all three in line, configurations are near-singular, where the bound of accelerations does
  // not promise six digits; rates that are given are right.
  place = 0;
  angles = {1e-1, 2e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 0};
  for (const Told& told : told_of(three_cranks().scene(), angles)) {
    SCOPED_TRACE(place);
    const bool is_float = place % 2 == 1;
    const double beside = angles[static_cast<std::size_t>(place++ / 2)];
    EXPECT_EQ(told.count, 1);
    EXPECT_TRUE(std::isnan(told.turning) || std::abs(told.turning - 2) < 1e-2) << told.turning;
    if (!is_float) {
      EXPECT_EQ(told.regularity == 0, beside >= 2e-2);
      EXPECT_EQ(std::isnan(told.turning), beside < 1e-5);
    }
    if (told.regularity == 0) {
      EXPECT_NEAR(told.speeding_up, 0.5, is_float ? 5e-4 : 5e-7);
    }
  }
}

/// A crank's tip on another's pivot: it is not known whether the third crank blocks the family.
TEST(LongEmitRedundant, SolversSayWhereTheyDoNotKnowWhatIsLeft) {
  nlohmann::ordered_json scene = three_cranks().scene();
  scene["links"]["ground"]["F"] = scene["links"]["coupler"]["G"] = {1.5, 0};
  for (const Told& told : told_of(scene, {0})) {
    EXPECT_EQ(told.status, static_cast<int>(AssemblyStatus::unresolved));
    EXPECT_EQ(told.count, 0);
    EXPECT_EQ(told.families, 0);
  }
}

/// Two rails, and a platform that two bars keep parallel to the slide: nothing turns. The bars are
/// upright and inclined.
nlohmann::ordered_json translating_platform() {
  SceneMaker scene;
  scene.line("ground", "rail", {0.1, 0.2}, {1, 0}).line("slide", "rail", {0, 0}, {1, 0});
  scene.line("ground", "guide", {0.7, 1.5}, {1, 0}).line("platform", "guide", {0, 0}, {1, 0});
  scene.slide("S", "ground.rail", "slide.rail").slide("G", "ground.guide", "platform.guide");
  scene.point("slide", "P", 0.4, 0).point("platform", "Q", 0.3, 0);
  scene.point("slide", "E", 1.1, 0).point("platform", "F", 1.7, 0);
  scene.bar("upright", {{"P", 0}, {"Q", 1.3}});
  scene.bar("inclined", {{"E", 0}, {"F", std::hypot(0.7, 1.3)}});
  return scene.drive("S", 0.3, 1, 0).scene();
}

/// A bar whose ends slide along two perpendicular lines, and a crank at its middle.
nlohmann::ordered_json trammel() {
  SceneMaker scene;
  scene.line("ground", "gx", {0, 0}, {1, 0}).line("ground", "gy", {0, 0}, {0, 1});
  scene.line("bx", "g", {0, 0}, {1, 0}).line("by", "g", {0, 0}, {0, 1});
  scene.point("bx", "P", 0, 0).point("by", "Q", 0, 0);
  scene.bar("ground", {{"O", 0}}).bar("cr", {{"O", 0}, {"M", 1}});
  scene.bar("bar", {{"P", 0}, {"Q", 2}, {"M", 1}});
  scene.slide("sx", "ground.gx", "bx.g").slide("sy", "ground.gy", "by.g").drive("O", 0.3, 1, 0);
  nlohmann::ordered_json json = scene.scene();
  json["want"] = {"position"};
  return json;
}

/// Three parallel cranks, and a rod whose end nearly touches a slot that it cannot pass: two
/// configurations 4e-7 radians apart.
nlohmann::ordered_json cranks_and_a_slot() {
  SceneMaker scene = three_cranks();
  scene.line("ground", "slot", {3.9392310120487535, 0.6945927106677074},
             {-0.17364817766693033, 0.984807753012208});
  scene.bar("ground", {{"K", 0}}).bar("rod", {{"K", 0}, {"N", 4}});
  nlohmann::ordered_json json = scene.scene();
  json["joints"]["N"] = {{"type", "pin-in-slot"}, {"between", {"ground.slot", "rod.N"}}};
  return json;
}

/// Numbers of configurations of a solver, with its status, at positions of its driver.
std::vector<std::pair<int, int>> counts_of(const nlohmann::ordered_json& scene,
                                           const std::vector<double>& positions) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  const auto file = directory.write("counted.json", scene.dump());
  EXPECT_EQ(run_assur("emit --interface c --scene " + file.string() + " --output " + root).status,
            0);
  std::ostringstream given;
  given.precision(17);
  for (const double position : positions) {
    given << position << ", ";
  }
  // The C function has to return the same status.
  const auto source = directory.write("driver.cpp", R"(#include <assur/scenes/counted.hpp>
#include <assur/scenes/counted.cpp>
#include <cstdio>
int main() {
  using S = assur::scenes::Counted;
  static std::array<S::State<double>, S::max_configurations> states;
  const double positions[] = {)" + given.str() + R"(};
  for (const double position : positions) {
    S::Drivers<double> drivers;
    *drivers.positions()[0] = position;
    const auto found = S::solve(drivers, states);
    counted_drivers same;
    counted_defaults(&same);
    static_assert(sizeof(same) == sizeof(drivers), "drivers are plain numbers");
    std::memcpy(&same, &drivers, sizeof(same));
    static counted_solution in_c;
    const counted_status status = counted_solve(&same, &in_c);
    const bool agree = found.status == assur::AssemblyStatus::unresolved
                           ? status == counted_status_unresolved
                           : static_cast<int>(status) == static_cast<int>(found.status);
    std::printf("%d %d\n", static_cast<int>(found.status),
                agree && in_c.count == found.count ? found.count : -1);
  }
}
)");
  compile_program(source, root + "/driver", directory);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::ifstream printed(directory.path() / "printed");
  std::vector<std::pair<int, int>> counts(positions.size());
  for (auto& [status, count] : counts) {
    printed >> status >> count;
  }
  return counts;
}

TEST(EmitRedundant, NoConfigurationIsLostWhereNothingTurns) {
  for (const auto& [status, count] : counts_of(translating_platform(), {0.3, 0.7})) {
    EXPECT_EQ(status, static_cast<int>(AssemblyStatus::ok));
    EXPECT_EQ(count, 1);
  }
}

/// Where the trammel without its redundant constraint is singular, rounding may leave nothing.
TEST(LongEmitRedundant, NoConfigurationIsLostBesideSingularPositions) {
  constexpr double quarter = std::numbers::pi / 2;
  int resolved = 0;
  for (const auto& [status, count] :
       counts_of(trammel(), {0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 3e-6, 1e-5, 1e-3, 0.1, quarter,
                             quarter - 1e-6, quarter + 1e-3})) {
    const bool is_resolved = status == static_cast<int>(AssemblyStatus::ok);
    EXPECT_TRUE(is_resolved || status == static_cast<int>(AssemblyStatus::unresolved)) << status;
    EXPECT_EQ(count, is_resolved ? 1 : 0);
    resolved += is_resolved ? 1 : 0;
  }
  EXPECT_GE(resolved, 8);
}

/// A bar with a pin in each of two perpendicular slots, and a crank at its middle. At the quarter
/// turn all links have their origins within rounding of the ground's origin.
TEST(EmitRedundant, NoConfigurationIsLostWhereAllOriginsMeet) {
  SceneMaker scene;
  scene.line("ground", "gx", {0, 0}, {1, 0}).line("ground", "gy", {0, 0}, {0, 1});
  scene.bar("ground", {{"O", 0}}).bar("crank", {{"O", 0}, {"M", 0.7}});
  scene.bar("bar", {{"M", 0.7}}).point("bar", "P", 0, 0).point("bar", "Q", 1.4, 0);
  scene.slot("X", "ground.gx", "bar.P").slot("Y", "ground.gy", "bar.Q").drive("O", 0.3, 1, 0);
  nlohmann::ordered_json json = scene.scene();
  json["want"] = {"position"};
  constexpr double quarter = std::numbers::pi / 2;
  for (const auto& [status, count] :
       counts_of(json, {quarter, -quarter, quarter + 1e-9, quarter - 1e-6, 0.3})) {
    EXPECT_EQ(status, static_cast<int>(AssemblyStatus::ok));
    EXPECT_EQ(count, 1);
  }
}

TEST(LongEmitRedundant, ConfigurationsOfAnotherGroupThatNearlyMeetAreBothListed) {
  for (const auto& [status, count] : counts_of(cranks_and_a_slot(), {std::numbers::pi / 2, 1})) {
    EXPECT_EQ(status, static_cast<int>(AssemblyStatus::ok));
    EXPECT_EQ(count, 2);
  }
}

/// A door on three hinges, one of them driven; a flap on two hinges, moved by a cylinder; a ram in
/// two guides in one line; and three cranks, whose groups have two configurations each.
std::vector<nlohmann::ordered_json> scenes_with_redundant_joints() {
  SceneMaker door;
  SceneMaker flap;
  for (const std::string hinge : {"H1", "H2"}) {
    for (SceneMaker* scene : {&door, &flap}) {
      scene->point("ground", hinge, 1, 2).point("door", hinge, 0.5, 0).point("door", "P", 1.5, 0.2);
    }
  }
  door.point("ground", "H3", 1, 2).point("door", "H3", 0.5, 0).drive("H3", 0.4, 1, 0.5);
  flap.point("ground", "Q", 0, 0).point("tube", "Q", 0, 0).point("rod", "P", 0, 0);
  flap.line("tube", "axis", {0, 0}, {1, 0}).line("rod", "axis", {0, 0}, {1, 0});
  flap.slide("S", "tube.axis", "rod.axis").drive("S", 2.2, 1, 0.5);
  SceneMaker ram;
  ram.bar("ground", {{"A", 0}}).bar("crank", {{"A", 0}, {"B", 1}}).bar("rod", {{"B", 0}, {"C", 3}});
  ram.point("ram", "C", 0, 0).drive("A", 0.6, 1, 0.5);
  for (const auto& [name, x] : {std::pair("S1", 0.0), std::pair("S2", 2.0)}) {
    ram.line("ground", name, {x, 0.3}, {1, 0}).line("ram", name, {x / 2, 0}, {1, 0});
    ram.slide(name, "ground." + std::string(name), "ram." + std::string(name));
  }
  return {door.scene(), flap.scene(), ram.scene(), three_cranks().scene()};
}

TEST(LongEmitRedundant, SolversAgreeWithSolve) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  for (const nlohmann::ordered_json& scene : scenes_with_redundant_joints()) {
    const std::string stem = "redundant" + std::to_string(scenes.size());
    scenes.push_back({directory.write(stem + ".json", scene.dump()), stem, struct_of(stem), {}});
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 0);
  }
}

}  // namespace
}  // namespace assur::test::emit_redundant_test
