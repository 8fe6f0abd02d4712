// Law: an emitted solver moves the places that change with the rates of parameters as `assur solve`
// does: points and lines on the ground and on links, lengths of groups, laws that read joints.
#include <gtest/gtest.h>

#include "generator/solver_comparison.hpp"

namespace assur::test::emit_moving_places_test {
namespace {

using Json = nlohmann::ordered_json;

/// An example all of whose parameters move, each at rates of its own.
Json moving_example(const std::string& stem) {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / (stem + ".json"));
  double rate = 1;
  for (auto& [name, parameter] : scene["parameters"].items()) {
    if (!parameter.is_object()) {
      parameter = Json{{"value", parameter}};
    }
    parameter["velocity"] = 0.3 * rate;
    parameter["acceleration"] = 0.2 - 0.1 * rate;
    rate = rate > 2 ? rate - 2.3 : rate + 0.7;
  }
  return scene;
}

TEST(EmitMovingPlaces, AgreesWithSolveWhereAllParametersMove) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  const std::vector<std::pair<std::string, std::string>> examples = {
      {"four_bar_coupler_curve", "FourBarCouplerCurve"},
      {"slider_crank", "SliderCrank"},
      {"shaper_quick_return", "ShaperQuickReturn"},
      {"excavator_arm", "ExcavatorArm"},
      {"quintero_2011_rrp_rrr", "Quintero2011RrpRrr"},
      {"geared_five_bar", "GearedFiveBar"},
      {"rack_press", "RackPress"}};
  for (const auto& [stem, solver] : examples) {
    const auto file = directory.write(stem + ".json", moving_example(stem).dump());
    scenes.push_back({file, stem, solver, {}});
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 100);
  }
}

/// A length that moves and is a formula in another one that does, with a rate of its own.
Json formula_with_its_own_rate() {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / "slider_crank.json");
  scene["parameters"]["crank"] = {{"value", "0.3*rod + 2*swell"}, {"velocity", 3}};
  scene["parameters"]["rod"] = {{"value", 160}, {"velocity", "swell"}, {"acceleration", -2}};
  scene["parameters"]["swell"] = {{"value", 1.5}, {"velocity", 0.5}, {"acceleration", 0.25}};
  return scene;
}

TEST(EmitMovingPlaces, AgreesWithSolveWhereRatesStandInPlaceOfThoseThatFollow) {
  const TemporaryDirectory directory;
  const auto file = directory.write("swelling.json", formula_with_its_own_rate().dump());
  EXPECT_GT(compare_with_solve({{file, "swelling", "Swelling", {}}}).front(), 100);
}

}  // namespace
}  // namespace assur::test::emit_moving_places_test
