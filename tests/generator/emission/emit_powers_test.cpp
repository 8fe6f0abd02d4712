// Law: a power of parameters has, in `assur solve` and in emitted solvers of variable parameters,
// its exact value and its exact derivatives; only derivatives that do not exist are unknown.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "generator/solver_comparison.hpp"

namespace assur::test::emit_powers_test {
namespace {

const double none = std::numeric_limits<double>::quiet_NaN();

/// x^n with its derivatives; with `x` and `n` moving at the rates 3 and 0, x^n moves at `by_x` 3.
struct Power {
  double x, n;
  double value, by_x, by_n;
};

const std::vector<Power>& powers() {
  static const std::vector<Power> all = {{-2, 2, 4, -4, none},
                                         {-2, 3, -8, 12, none},
                                         {-2, 1, -2, 1, none},
                                         {-2, 0, 1, 0, none},
                                         {-2, -1, -0.5, -0.25, none},
                                         {0, 2, 0, 0, 0},
                                         {0, 1, 0, 1, 0},
                                         {0, 0, 1, 0, none},
                                         {2, 3, 8, 12, 8 * std::log(2.0)},
                                         {4, 0.5, 2, 0.25, 2 * std::log(4.0)}};
  return all;
}

std::string scene(double x, double n, double tolerance_of_n = 0) {
  const auto text = [](double number) { return nlohmann::json(number).dump(); };
  return R"({"parameters": {"x": {"value": )" + text(x) + R"(, "velocity": 3, "tolerance": 0.5},
      "n": {"value": )" +
         text(n) + R"(, "tolerance": )" + text(tolerance_of_n) + R"(}},
    "links": {"ground": {"A": [0, 0]}, "c": {"A": [0, 0], "B": ["x^n", 1]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "c.A"]}},
    "drivers": {"A": {"position": 0}}, "outputs": {"B": "c.B"},
    "report": {"links": []}, "want": ["position", "velocity", "sensitivity"]})";
}

void expect(double found, double truth, const std::string& what) {
  if (std::isnan(truth)) {
    EXPECT_TRUE(std::isnan(found)) << what << ": " << found;
  } else {
    EXPECT_DOUBLE_EQ(found, truth) << what;
  }
}

/// The results for B.x: its position, its derivatives with respect to x and n, its velocity, its
/// worst case, and whether it is regular.
void expect_all(const std::array<double, 6>& told, const Power& exact, const std::string& what,
                double tolerance_of_n = 0) {
  expect(told[0], exact.value, what + ", value");
  expect(told[1], exact.by_x, what + ", by x");
  expect(told[2], exact.by_n, what + ", by n");
  expect(told[3], 3 * exact.by_x, what + ", velocity");
  const double by_n = tolerance_of_n == 0 ? 0 : tolerance_of_n * std::abs(exact.by_n);
  expect(told[4], 0.5 * std::abs(exact.by_x) + by_n, what + ", worst case");
  EXPECT_EQ(told[5], 1) << what;
}

TEST(EmitPowers, AreThoseOfSolveAndExact) {
  const TemporaryDirectory directory;
  const auto known = [](const nlohmann::json& number) {
    return number.is_null() ? none : number.get<double>();
  };
  std::string includes = program_head;
  std::string calls;
  const auto emit = [&](const std::string& name, const std::string& variable, double tolerance) {
    const std::string text = scene(powers().front().x, powers().front().n, tolerance);
    emit_solver({directory.write(name + ".json", text), "", "", {}}, directory,
                "--variable " + variable);
    includes += "#include <assur/scenes/" + name + ".hpp>\n";
  };
  const auto print = [&](const std::string& name, const std::string& values) {
    calls += "  {\n    using S = assur::scenes::" + struct_of(name) +
             ";\n    S::Parameters<double> p;\n" + values + "    print<S>(p);\n  }\n";
  };
  for (const Power& power : powers()) {
    const auto file = directory.write("solved.json", scene(power.x, power.n));
    const CommandResult result = run_assur("solve --format json " + file.string());
    ASSERT_EQ(result.status, 0) << result.messages;
    const auto configuration = nlohmann::json::parse(result.output)["configurations"][0];
    const auto& B = configuration["outputs"]["B"];
    expect_all({known(B["position"][0]), known(B["sensitivity"]["x"][0]),
                known(B["sensitivity"]["n"][0]), known(B["velocity"][0]), known(B["worst_case"][0]),
                configuration["regularity"] == "regular" ? 1. : 0.},
               power, "solve");
  }
  constexpr double tolerance = 0.25;  // of n, where it is no variable
  emit("both", "x,n", 0);
  emit("of_x", "x", tolerance);
  emit("of_n", "n", 0);
  std::vector<std::pair<Power, double>> expected;
  for (const Power& power : powers()) {
    const auto set = [](const std::string& name, double value) {
      return "    p." + name + " = " + nlohmann::json(value).dump() + ";\n";
    };
    print("both", set("x", power.x) + set("n", power.n));
    expected.emplace_back(power, 0);
    if (power.n == powers().front().n) {
      print("of_x", set("x", power.x));
      expected.emplace_back(power, tolerance);
    }
    if (power.x == powers().front().x) {
      print("of_n", set("n", power.n));
      expected.emplace_back(power, 0);
    }
  }
  const std::string printing = R"(
template <typename S>
void print(const typename S::template Parameters<double>& parameters) {
  std::array<typename S::template State<double>, S::max_configurations> states;
  (void)S::solve(typename S::template Drivers<double>(), parameters, states);
  const auto& B = states[0].outputs.B;
  std::printf("%.17g %.17g %.17g %.17g %.17g %d\n", B.position(0),
              sensitivity<S>(B.sensitivity, "x", 0), sensitivity<S>(B.sensitivity, "n", 0),
              B.velocity(0), B.worst_case(0),
              states[0].regularity == assur::Status::ok ? 1 : 0);
}
)";
  const auto source =
      directory.write("powers.cpp", includes + printing + "int main() {\n" + calls + "}\n");
  const std::string program = (directory.path() / "powers").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt").c_str()), 0);
  std::istringstream printed(read_file(program + ".txt"));
  for (const auto& [power, tolerance_of_n] : expected) {
    std::array<double, 6> told{};
    for (double& number : told) {
      std::string text;
      printed >> text;
      number = std::strtod(text.c_str(), nullptr);
    }
    expect_all(told, power, "emitted, x = " + std::to_string(power.x), tolerance_of_n);
  }
}

TEST(EmitPowers, ThatThereAreNotAreRefused) {
  const TemporaryDirectory directory;
  for (const auto& [x, n] : {std::pair(-8., 1. / 3), std::pair(0., -1.)}) {
    const CommandResult result =
        run_assur("solve " + directory.write("power.json", scene(x, n)).string());
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.messages.find("the value is not a finite number"), std::string::npos);
  }
  emit_solver({directory.write("refused.json", scene(2, 3)), "", "", {}}, directory,
              "--variable x,n");
  const auto source = directory.write("refused.cpp", R"(#include <assur/scenes/refused.hpp>
using S = assur::scenes::Refused;
bool is_refused(double x, double n) {
  S::Parameters<double> parameters;
  parameters.x = x;
  parameters.n = n;
  std::array<S::State<double>, S::max_configurations> states;
  const S::Solution found = S::solve(S::Drivers<double>(), parameters, states);
  return found.status == assur::AssemblyStatus::not_finite && found.count == 0;
}
int main() {
  return is_refused(-8, 1. / 3) && is_refused(0, -1) && !is_refused(-8, 3) ? 0 : 1;
}
)");
  const std::string program = (directory.path() / "refused").string();
  compile_program(source, program, directory);
  EXPECT_EQ(std::system(program.c_str()), 0);
}

}  // namespace
}  // namespace assur::test::emit_powers_test
