// Law: rates beyond the range of the scalar are unknown, and the configuration is not regular, in
// emitted solvers of either precision, in C and in batches as in `assur solve`.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"

namespace assur::test::emit_rates_that_overflow_test {
namespace {

SceneMaker::Json four_bar() {
  return SceneMaker()
      .bar("ground", {{"A", 0}, {"D", 4}})
      .bar("crank", {{"A", 0}, {"B", 1}})
      .bar("coupler", {{"B", 0}, {"C", 3}})
      .bar("rocker", {{"D", 0}, {"C", 3}})
      .drive("A", 1, 1, 0)
      .scene();
}

/// A crank whose length grows at a rate of its own.
SceneMaker::Json growing_crank() {
  return SceneMaker()
      .parameter("r", {{"value", 2}, {"velocity", 1e308}})
      .bar("ground", {{"A", 0}})
      .bar("crank", {{"A", 0}, {"B", "r"}})
      .drive("A", 1, 1, 0)
      .scene();
}

constexpr std::array<double, 7> speeds = {1, 1e10, 1e150, 1e154, 1e155, 1e160, 1e308};

/// Whether all rates of a configuration are regular, in the lines of the program below: a letter
/// for the source, the regularity, the number of infinite rates, and of NaN.
constexpr const char* program_text = R"(
#include <cmath>
#include <cstdio>
#include <vector>

int infinite = 0, unknown = 0;
template <typename Rates>
void count(const Rates& rates) {
  for (int row = 0; row < rates.rows(); ++row) {
    infinite += std::isinf(rates(row)) ? 1 : 0;
    unknown += std::isnan(rates(row)) ? 1 : 0;
  }
}
void tell(char who, bool regular) {
  std::printf("%c %d %d %d\n", who, regular ? 1 : 0, infinite, unknown);
  infinite = unknown = 0;
}
template <typename S, typename Scalar>
void print(char who, Scalar speed) {
  std::array<typename S::template State<Scalar>, S::max_configurations> states;
  typename S::template Drivers<Scalar> drivers;
  drivers.A.velocity = speed;
  (void)S::solve(drivers, states);
  count(states[0].outputs.B.velocity);
  count(states[0].outputs.B.acceleration);
  tell(who, states[0].regularity == assur::Status::ok);
}
int main() {
  using S = assur::scenes::FourBar;
  const std::vector<double> speeds = {SPEEDS};
  const std::size_t count = speeds.size();
  for (const double speed : speeds) {
    print<S>('d', speed);
  }
  for (const double speed : speeds) {
    four_bar_drivers drivers;
    four_bar_defaults(&drivers);
    drivers.A.velocity = speed;
    static four_bar_solution solution;
    (void)four_bar_solve(&drivers, &solution);
    for (const double rate : solution.states[0].outputs.B.acceleration) {
      infinite += std::isinf(rate) ? 1 : 0;
      unknown += std::isnan(rate) ? 1 : 0;
    }
    tell('c', solution.states[0].regularity == four_bar_status_ok);
  }
  std::vector<double> given;
  for (const double position : {1., 0.}) {
    given.insert(given.end(), count, position);
    if (position == 1) {
      given.insert(given.end(), speeds.begin(), speeds.end());
    }
  }
  constexpr std::size_t columns = assur::support::column_count<S::State<double>>;
  std::vector<assur::AssemblyStatus> status(count);
  std::vector<int> counts(count), families(count), mobility(count);
  std::vector<assur::Status> regularity(2 * count);
  std::vector<double> states(2 * columns * count);
  S::BatchSolutions batch;
  batch.status = status.data();
  batch.count = counts.data();
  batch.families = families.data();
  batch.mobility = mobility.data();
  batch.regularity = regularity.data();
  batch.states = states.data();
  batch.stride = count;
  S::solve_batch<2>(count, {given.data(), count}, batch);
  for (std::size_t instance = 0; instance < count; ++instance) {
    for (std::size_t column = 0; column < columns; ++column) {
      infinite += std::isinf(states[column * count + instance]) ? 1 : 0;
      unknown += std::isnan(states[column * count + instance]) ? 1 : 0;
    }
    tell('b', regularity[instance] == assur::Status::ok);
  }
  for (const float speed : {1.F, 1e10F, 1e25F}) {
    print<S>('f', speed);
  }
  print<assur::scenes::Growing>('g', 1e10);
}
)";

TEST(EmitRatesThatOverflow, AreUnknownAndNotRegular) {
  const TemporaryDirectory directory;
  const auto file = directory.write("four_bar.json", four_bar().dump());
  emit_solver({file, "", "", {}}, directory, "--interface c");
  emit_solver({directory.write("growing.json", growing_crank().dump()), "", "", {}}, directory);
  std::ostringstream list;
  for (const double speed : speeds) {
    list << speed << ", ";
  }
  std::string text = program_text;
  text.replace(text.find("SPEEDS"), 6, list.str());
  const auto source = directory.write("driver.cpp",
                                      "#include <assur/scenes/four_bar.cpp>\n"
                                      "#include <assur/scenes/growing.hpp>\n" +
                                          text);
  const std::string program = (directory.path() / "driver").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt").c_str()), 0);
  std::istringstream printed(read_file(program + ".txt"));
  const auto expect_next = [&](char who, bool regular) {
    char teller = 0;
    int is_regular = 0;
    int infinite = 0;
    int unknown = 0;
    printed >> teller >> is_regular >> infinite >> unknown;
    EXPECT_EQ(teller, who);
    EXPECT_EQ(is_regular, regular ? 1 : 0) << who;
    EXPECT_EQ(infinite, 0) << who;
    EXPECT_EQ(unknown == 0, regular) << who;
  };
  for (const char who : {'d', 'c', 'b'}) {
    for (const double speed : speeds) {
      auto scene = four_bar();
      scene["drivers"]["A"]["velocity"] = speed;
      const CommandResult solved =
          run_assur("solve --format json " + directory.write("at.json", scene.dump()).string());
      const auto answer = nlohmann::json::parse(solved.output);
      const bool regular = answer["configurations"][0]["regularity"] == "regular";
      EXPECT_EQ(regular, speed < 1e155) << speed;
      expect_next(who, regular);
    }
  }
  expect_next('f', true);
  expect_next('f', true);
  expect_next('f', false);
  expect_next('g', false);
}

}  // namespace
}  // namespace assur::test::emit_rates_that_overflow_test
