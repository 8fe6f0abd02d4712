// Law: beside singular positions of mechanisms with redundant constraints, an emitted solver lists
// as many configurations as the library, or says that it cannot decide, in every order of listing.
#include <gtest/gtest.h>

#include <assur/assemblies.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_redundant_lists_test {
namespace {

constexpr double pi = std::numbers::pi;

struct RedundantScene {
  const char* name;
  SceneMaker::Json (*make)();
  std::vector<double> singular;  ///< positions of the driver

  friend std::ostream& operator<<(std::ostream& out, const RedundantScene& scene) {
    return out << scene.name;
  }
};

SceneMaker::Json position_alone(const SceneMaker& scene) {
  SceneMaker::Json json = scene.scene();
  json["want"] = {"position"};
  json["report"] = {{"links", SceneMaker::Json::array()}};
  return json;
}

/// A four-bar that has its rocker twice.
template <int Crank, int Coupler, int Rocker, int Ground>
SceneMaker::Json doubled() {
  return position_alone(SceneMaker()
                            .parameter("phi", 0.3)
                            .bar("ground", {{"A", 0}, {"D", Ground}})
                            .bar("crank", {{"A", 0}, {"B", Crank}})
                            .bar("coupler", {{"B", 0}, {"C", Coupler}})
                            .bar("rocker", {{"D", 0}, {"C", Rocker}})
                            .bar("again", {{"D", 0}, {"C", Rocker}})
                            .drive("A", "phi", 0, 0));
}

/// A coupler on parallel cranks, in one line or on a triangle.
SceneMaker three_cranks(double aside) {
  SceneMaker scene;
  scene.parameter("phi", 0.3).bar("crank", {{"A", 0}, {"B", 1.5}});
  scene.bar("rocker", {{"D", 0}, {"C", 1.5}}).bar("third", {{"F", 0}, {"G", 1.5}});
  for (const auto& [link, names] : {std::pair("ground", "ADF"), std::pair("coupler", "BCG")}) {
    scene.point(link, std::string(1, names[0]), 0, 0);
    scene.point(link, std::string(1, names[1]), 4, 0);
    scene.point(link, std::string(1, names[2]), 2, aside);
  }
  return scene.drive("A", "phi", 0, 0);
}

/// A bar whose ends slide along two perpendicular lines, and a crank at its middle.
SceneMaker::Json trammel() {
  SceneMaker scene;
  scene.parameter("phi", 0.3);
  scene.line("ground", "gx", {0, 0}, {1, 0}).line("ground", "gy", {0, 0}, {0, 1});
  scene.line("bx", "g", {0, 0}, {1, 0}).line("by", "g", {0, 0}, {0, 1});
  scene.point("bx", "P", 0, 0).point("by", "Q", 0, 0);
  scene.bar("ground", {{"O", 0}}).bar("cr", {{"O", 0}, {"M", 1}});
  scene.bar("bar", {{"P", 0}, {"Q", 2}, {"M", 1}});
  scene.slide("sx", "ground.gx", "bx.g").slide("sy", "ground.gy", "by.g").drive("O", "phi", 0, 0);
  return position_alone(scene);
}

/// The same with its pins in slots.
SceneMaker::Json trammel_of_slots() {
  SceneMaker scene;
  scene.parameter("phi", 0.3);
  scene.line("ground", "gx", {0, 0}, {1, 0}).line("ground", "gy", {0, 0}, {0, 1});
  scene.bar("ground", {{"O", 0}}).bar("crank", {{"O", 0}, {"M", 0.7}});
  scene.bar("bar", {{"M", 0.7}}).point("bar", "P", 0, 0).point("bar", "Q", 1.4, 0);
  scene.slot("X", "ground.gx", "bar.P").slot("Y", "ground.gy", "bar.Q").drive("O", "phi", 0, 0);
  return position_alone(scene);
}

/// A slider-crank whose rod is as long as its crank, with its slide twice.
SceneMaker::Json equal_slider_crank() {
  SceneMaker scene;
  scene.parameter("phi", 0.3).bar("ground", {{"A", 0}}).bar("crank", {{"A", 0}, {"B", 1}});
  scene.bar("rod", {{"B", 0}, {"C", 1}}).point("ram", "C", 0, 0).drive("A", "phi", 0, 0);
  for (const auto& [name, x] : {std::pair("S1", 0.0), std::pair("S2", 2.0)}) {
    scene.line("ground", name, {x, 0}, {1, 0}).line("ram", name, {x / 2, 0}, {1, 0});
    scene.slide(name, "ground." + std::string(name), "ram." + std::string(name));
  }
  return position_alone(scene);
}

/// The status at a position of the driver, and the coordinates of all outputs in each
/// configuration.
struct Listed {
  int status = 0;
  std::vector<Eigen::VectorXd> places;
};

std::vector<Listed> listed_by_solver(const SceneMaker::Json& scene,
                                     const std::vector<double>& positions) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  const auto file = directory.write("listed.json", scene.dump());
  EXPECT_EQ(run_assur("emit --scene " + file.string() + " --output " + root).status, 0);
  std::ostringstream given;
  given.precision(17);
  for (const double position : positions) {
    given << position << ", ";
  }
  std::string printing;
  for (const auto& [name, feature] : scene["outputs"].items()) {
    const std::string output = "states[i].outputs." + name + ".position";
    printing += R"(      std::printf(" %.17g %.17g", )" + output + "(0), " + output + "(1));\n";
  }
  const auto source = directory.write("driver.cpp", R"(#include <assur/scenes/listed.hpp>
#include <cstdio>
int main() {
  using S = assur::scenes::Listed;
  static std::array<S::State<double>, S::max_configurations> states;
  const double positions[] = {)" + given.str() + R"(};
  for (const double position : positions) {
    S::Drivers<double> drivers;
    *drivers.positions()[0] = position;
    const auto found = S::solve(drivers, states);
    std::printf("%d %d", static_cast<int>(found.status), found.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
)" + printing + R"(    }
    std::puts("");
  }
}
)");
  compile_program(source, root + "/driver", directory);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::ifstream printed(directory.path() / "printed");
  std::vector<Listed> result(positions.size());
  for (Listed& at : result) {
    int count = 0;
    printed >> at.status >> count;
    for (int index = 0; index < count; ++index) {
      at.places.emplace_back(2 * static_cast<Eigen::Index>(scene["outputs"].size()));
      for (double& number : at.places.back()) {
        printed >> number;
      }
    }
  }
  EXPECT_TRUE(printed);
  return result;
}

std::vector<Eigen::VectorXd> listed_by_library(const mechanism::Solution& solution) {
  std::vector<Eigen::VectorXd> result;
  for (const mechanism::Configuration& configuration : solution.configurations) {
    result.emplace_back(2 * static_cast<Eigen::Index>(configuration.outputs.size()));
    Eigen::Index row = 0;
    for (const mechanism::Point& output : configuration.outputs) {
      result.back().segment<2>(row) = output.position;
      row += 2;
    }
  }
  return result;
}

/// Whether each of some configurations is among others. Where two are nearer than the square root
/// of the lengths' rounding, their closures differ by less than it, and they count as one.
bool are_among(const std::vector<Eigen::VectorXd>& some,
               const std::vector<Eigen::VectorXd>& others) {
  constexpr double one = 1e-6;
  return std::ranges::all_of(some, [&](const Eigen::VectorXd& place) {
    return std::ranges::any_of(
        others, [&](const Eigen::VectorXd& other) { return (place - other).norm() < one; });
  });
}

class EmitRedundantLists : public testing::TestWithParam<RedundantScene> {};

/// One listing by default, at 40 positions; 3 listings, at 840, by `ctest -L long`. The positions
/// are 1e-12 to 1e-2 beside a singular one, and every tenth is anywhere.
TEST_P(EmitRedundantLists, AreThoseOfTheLibraryBesideSingularPositions) {
  const RedundantScene& scene = GetParam();
  constexpr unsigned seed = 20261129;
  const int orders = is_whole_campaign() ? listings : 1;
  const int count = is_whole_campaign() ? 840 : 40;
  int compared = 0;
  int undecided = 0;
  int incomplete = 0;
  for (int listing = 0; listing < orders; ++listing) {
    std::mt19937 random(seed + static_cast<unsigned>(listing));
    std::uniform_real_distribution<double> exponent(-12, -2);
    std::uniform_real_distribution<double> anywhere(-pi, pi);
    std::vector<double> positions = scene.singular;
    while (static_cast<int>(positions.size()) < count) {
      const std::size_t number = positions.size();
      const double near = scene.singular[number % scene.singular.size()];
      const double beside = std::pow(10, exponent(random));
      positions.push_back(number % 10 == 9 ? anywhere(random)
                                           : near + (number % 4 < 2 ? beside : -beside));
    }
    const SceneMaker::Json json = scene_listed(scene.make(), listing);
    const mechanism::Plan plan(mechanism::parse_scene(json.dump(), "scene"));
    const std::vector<Listed> found = listed_by_solver(json, positions);
    for (std::size_t place = 0; place < positions.size(); ++place) {
      SCOPED_TRACE(testing::Message() << "listing " << listing << " at " << positions[place]);
      const mechanism::Solution known = plan.solve(plan.values({{"phi", positions[place]}}));
      const std::vector<Eigen::VectorXd> places = listed_by_library(known);
      ++compared;
      if (found[place].status == static_cast<int>(AssemblyStatus::unresolved)) {
        ++undecided;
        continue;
      }
      const bool are_all = are_among(places, found[place].places);
      const bool are_known = are_among(found[place].places, places);
      if (!(are_all && are_known) && !known.incomplete.empty()) {
        ++incomplete;
        continue;
      }
      EXPECT_TRUE(are_all) << "a configuration is lost: " << found[place].places.size() << " of "
                           << places.size();
      EXPECT_TRUE(are_known) << "a configuration is invented: " << found[place].places.size()
                             << " for " << places.size();
    }
  }
  std::cout << compared << " positions, seed " << seed << ": " << undecided
            << " not decided by the solver, " << incomplete
            << " with other configurations where the library cannot decide\n";
  EXPECT_LT(5 * (undecided + incomplete), compared);
}

INSTANTIATE_TEST_SUITE_P(
    , EmitRedundantLists,
    testing::Values(
        RedundantScene{"parallelogram", doubled<2, 4, 2, 4>, {0, pi}},
        RedundantScene{"rhombus", doubled<2, 2, 2, 2>, {0, pi}},
        RedundantScene{"kite", doubled<4, 2, 2, 4>, {0}},
        RedundantScene{"cranks", [] { return position_alone(three_cranks(0)); }, {0, pi}},
        RedundantScene{"triangle", [] { return position_alone(three_cranks(1)); }, {0, pi}},
        RedundantScene{"trammel", trammel, {0, pi / 2, -pi / 2}},
        RedundantScene{"trammel of slots", trammel_of_slots, {0, pi / 2, -pi / 2}},
        RedundantScene{"slider-crank", equal_slider_crank, {pi / 2, -pi / 2}}));

}  // namespace
}  // namespace assur::test::emit_redundant_lists_test
