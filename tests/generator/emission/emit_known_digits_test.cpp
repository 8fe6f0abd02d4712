// Law: rates and sensitivities of an emitted solver have at least two correct digits, even near a
// change point, and six where the configuration is `ok`; those with fewer than two, or that do not
// exist, are NaN. A group much smaller than its surroundings is `ok` where `assur solve` calls it
// regular.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"

namespace assur::test::emit_known_digits_test {
namespace {

constexpr double rate = 1, second_rate = 0.5;

SceneMaker::Json four_bar(double crank, double coupler, double rocker, double ground) {
  return SceneMaker()
      .parameter("coupler", {{"value", coupler}, {"tolerance", 0.01}})
      .bar("ground", {{"A", 0}, {"D", ground}})
      .bar("crank", {{"A", 0}, {"B", crank}})
      .bar("coupler", {{"B", 0}, {"C", "coupler"}})
      .bar("rocker", {{"D", 0}, {"C", rocker}})
      .drive("A", 0, rate, second_rate)
      .scene();
}

/// What is read of a configuration: the rocker's motion, and the sensitivity of C.y to the coupler.
struct Reading {
  int near_singular;
  double sin, omega, alpha, sensitivity;
};

/// A scene, and where its driver stands.
struct Posed {
  SceneMaker::Json scene;
  std::vector<double> positions;
};

/// Prints the configurations of a solver at each position of its driver.
constexpr const char* printing = R"(
template <typename S>
void print(const std::vector<double>& positions) {
  std::array<typename S::template State<double>, S::max_configurations> states;
  typename S::template Drivers<double> drivers;
  for (const double position : positions) {
    drivers.A.position = position;
    const int count = S::solve(drivers, states).count;
    std::printf("%d\n", count);
    for (int i = 0; i < count; ++i) {
      const auto& s = states[static_cast<std::size_t>(i)];
      const auto& rocker = s.links.rocker;
      std::printf("%d %.17g %.17g %.17g %.17g\n", s.regularity == assur::Status::ok ? 0 : 1,
                  rocker.pose.direction.sin, rocker.velocity(2), rocker.acceleration(2),
                  s.outputs.C.sensitivity(1, 0));
    }
  }
}
)";

/// The configurations of each scene's emitted solver, all in one program: [scene][position].
std::vector<std::vector<std::vector<Reading>>> emitted(const std::vector<Posed>& scenes) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string includes = "#include <cstdio>\n#include <vector>\n";
  std::ostringstream calls;
  calls.precision(17);
  for (std::size_t index = 0; index < scenes.size(); ++index) {
    const std::string number = std::to_string(index);
    const auto file = directory.write("linkage" + number + ".json", scenes[index].scene.dump());
    emit_solver({file, "", "", {}}, directory);
    includes += "#include <assur/scenes/linkage" + number + ".hpp>\n";
    calls << "  print<assur::scenes::Linkage" << number << ">({";
    for (const double position : scenes[index].positions) {
      calls << position << ", ";
    }
    calls << "});\n";
  }
  const auto source =
      directory.write("driver.cpp", includes + printing + "int main() {\n" + calls.str() + "}\n");
  compile_program(source, root + "/driver", directory);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  const auto number = [&printed] {
    std::string text;
    printed >> text;
    return std::strtod(text.c_str(), nullptr);
  };
  std::vector<std::vector<std::vector<Reading>>> readings;
  for (const Posed& posed : scenes) {
    for (auto& of_position : readings.emplace_back(posed.positions.size())) {
      std::size_t count = 0;
      printed >> count;
      of_position.resize(count);
      for (Reading& reading : of_position) {
        printed >> reading.near_singular;
        reading.sin = number();
        reading.omega = number();
        reading.alpha = number();
        reading.sensitivity = number();
      }
    }
  }
  return readings;
}

/// The exact reading on a branch on which tan(rocker / 2) is `times` tan(crank / 2).
Reading exact(double times, double position) {
  const double t = std::tan(position / 2);
  const double reduced = 1 + times * times * t * t;
  const double slope = times * (1 + t * t) / reduced;
  const double bend = times * t * (1 - times * times) * (1 + t * t) / (reduced * reduced);
  return {0, std::sin(2 * std::atan(times * t)), slope * rate,
          bend * rate * rate + slope * second_rate, -1 / std::tan(position)};
}

/// 1 for a number that is known, which must then have two digits; 0 for NaN.
int counted(double value, double truth) {
  if (std::isnan(value)) {
    return 0;
  }
  EXPECT_NEAR(value, truth, 5e-3 * std::abs(truth));
  return 1;
}

TEST(EmitKnownDigits, AreAllThatIsGivenBesideTheChangePointOfAParallelogram) {
  const std::vector<double> positions = {
      0,   std::numbers::pi, 1e-16, 1e-12, 1e-9, 1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3,
      1e-2};
  int nothing = 0;
  int rates_alone = 0;
  int all = 0;
  const std::vector<std::pair<double, double>> lengths = {{2, 3}, {0.7, 1.1}, {2, 3.7}};
  std::vector<Posed> scenes;
  for (const auto& [crank, ground] : lengths) {
    scenes.push_back({four_bar(crank, ground, crank, ground), positions});
  }
  const auto all_found = emitted(scenes);
  for (std::size_t index = 0; index < scenes.size(); ++index) {
    const auto& [crank, ground] = lengths[index];
    const auto& found = all_found[index];
    for (std::size_t place = 0; place < positions.size(); ++place) {
      const double position = positions[place];
      SCOPED_TRACE(testing::Message() << crank << ", " << ground << " at " << position);
      const Reading parallel = exact(1, position);
      const Reading crossed = exact(-(ground + crank) / (ground - crank), position);
      ASSERT_FALSE(found[place].empty());
      const bool at_change_point = found[place].size() == 1;
      for (const Reading& reading : found[place]) {
        const bool is_parallel =
            std::abs(reading.sin - parallel.sin) < std::abs(reading.sin - crossed.sin);
        const Reading& truth = is_parallel ? parallel : crossed;
        const int rates = counted(reading.omega, truth.omega);
        const int second_rates = counted(reading.alpha, truth.alpha);
        EXPECT_EQ(std::isnan(reading.sensitivity), rates == 0);
        if (is_parallel && rates == 1) {
          counted(reading.sensitivity, truth.sensitivity);
        }
        EXPECT_LE(second_rates, at_change_point ? 0 : rates);
        EXPECT_LE(rates, at_change_point ? 0 : 1);
        if (reading.near_singular == 0) {
          EXPECT_NEAR(reading.omega, truth.omega, 5e-7 * std::abs(truth.omega));
          EXPECT_NEAR(reading.alpha, truth.alpha, 5e-7 * std::abs(truth.alpha));
        }
        ++(rates == 0 ? nothing : second_rates == 0 ? rates_alone : all);
      }
    }
  }
  std::printf("%d without rates, %d with first rates alone, %d with all\n", nothing, rates_alone,
              all);
  EXPECT_GE(nothing, 12);
  EXPECT_GE(rates_alone, 6);
  EXPECT_GE(all, 12);
}

TEST(EmitKnownDigits, AreKeptBySmallRodsOnALongCrankAsSolveSays) {
  std::vector<Posed> scenes;
  for (const double rod : {1e-5, 1e-6, 1e-7}) {
    scenes.push_back({four_bar(1, rod, rod, 1), {rod}});
    scenes.back().scene["drivers"]["A"]["position"] = rod;
  }
  const auto all_found = emitted(scenes);
  for (std::size_t rod = 0; rod < scenes.size(); ++rod) {
    SCOPED_TRACE(scenes[rod].positions.front());
    const auto& found = all_found[rod].front();
    const TemporaryDirectory directory;
    const CommandResult solved =
        run_assur("solve " + directory.write("rods.json", scenes[rod].scene.dump()).string() +
                  " --format json");
    ASSERT_EQ(solved.status, 0) << solved.messages;
    const auto report = SceneMaker::Json::parse(solved.output);
    ASSERT_EQ(report["configurations"].size(), 2U);
    ASSERT_EQ(found.size(), 2U);
    for (std::size_t index = 0; index < 2; ++index) {
      const auto& configuration = report["configurations"][index];
      EXPECT_EQ(configuration["regularity"], "regular");
      EXPECT_EQ(found[index].near_singular, 0);
      const double omega = configuration["links"]["rocker"]["velocity"][2];
      const double alpha = configuration["links"]["rocker"]["acceleration"][2];
      EXPECT_NEAR(found[index].omega, omega, 1e-6 * std::abs(omega));
      EXPECT_NEAR(found[index].alpha, alpha, 1e-6 * std::abs(alpha));
    }
  }
}

}  // namespace
}  // namespace assur::test::emit_known_digits_test
