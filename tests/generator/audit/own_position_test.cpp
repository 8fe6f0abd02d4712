// Law: the derivatives that a program gives are judged by the derivatives of its own positions, in
// every language, and bounds on extrapolated differences hold.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>

#include "audit/extrapolated_derivative.hpp"
#include "run_program.hpp"
#include "whole_campaign.hpp"

namespace assur::test::own_position_test {
namespace {

using generator::audit::BoundedValue;
using generator::audit::SymmetricSamples;

/// A function with its first and second derivative.
struct Known {
  const char* name;
  std::function<double(double)> value;
  std::function<double(double)> first;
  std::function<double(double)> second;
};

const std::vector<Known>& known_functions() {
  static const std::vector<Known> list = {
      {"sine", [](double x) { return std::sin(3 * x); },
       [](double x) { return 3 * std::cos(3 * x); }, [](double x) { return -9 * std::sin(3 * x); }},
      {"root", [](double x) { return std::sqrt(2 + x); },
       [](double x) { return 0.5 / std::sqrt(2 + x); },
       [](double x) { return -0.25 / std::pow(2 + x, 1.5); }},
      {"arcsine", [](double x) { return std::asin(x / 2); },
       [](double x) { return 1 / std::sqrt(4 - x * x); },
       [](double x) { return x / std::pow(4 - x * x, 1.5); }},
      {"pole", [](double x) { return 1 / (2.2 - x); },
       [](double x) { return 1 / ((2.2 - x) * (2.2 - x)); },
       [](double x) { return 2 / std::pow(2.2 - x, 3); }},
      {"jump", [](double x) { return x < 1 ? x : x + 2 * std::numbers::pi; },
       [](double) { return 1.0; }, [](double) { return 0.0; }}};
  return list;
}

TEST(ExtrapolatedDerivative, IsWithinItsBound) {
  constexpr unsigned seed = 57;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> anywhere(-1.999, 1.999);
  double largest = 0;  // error as a part of the bound
  std::size_t sharp = 0;
  std::size_t all = 0;
  const auto judge = [&](const Known& known, double x, const BoundedValue& found, double exact) {
    if (std::isfinite(found.bound)) {
      EXPECT_LE(std::abs(found.value - exact), found.bound) << known.name << " at " << x;
      largest = std::max(largest, std::abs(found.value - exact) / found.bound);
    }
    ++all;
    sharp += found.bound < 1e-6 * (1 + std::abs(exact)) ? 1 : 0;
  };
  for (int count = 0; count < 2000; ++count) {
    const double x = anywhere(engine);
    for (const Known& known : known_functions()) {
      SymmetricSamples samples{known.value(x), 0.5, {}, {}, 0};
      for (double step = 0.5; samples.above.size() < 8; step /= 2) {
        samples.above.push_back(known.value(x + step));
        samples.below.push_back(known.value(x - step));
      }
      samples.error = 4 * 0x1p-53 * (1 + std::abs(samples.middle));
      judge(known, x, first_derivative(samples), known.first(x));
      judge(known, x, second_derivative(samples), known.second(x));
    }
  }
  std::cout << all << " derivatives, " << sharp << " to six digits, the largest error is "
            << largest << " of its bound, seed " << seed << '\n';
  EXPECT_GT(sharp, all * 8 / 10);
}

const std::string arm = "length a b\nangle q p\nmoving q p\n";
const char* const all_of_it =
    "printed run J FILE of x y by q p against own position\n"
    "  position f(a, b, q, p)\n  result J(a, b, q, p)\n"
    "printed run w FILE of rate(x), rate(y), rate2(x), D(x, b) against own position\n"
    "  position f(a, b, q, p)\n"
    "  result w(a, b, q, p, rate_q, rate_p, rate2_q, rate2_p)\n";

/// A planar arm of two links in a language: its position, Jacobian, velocity, acceleration.
struct Arm {
  const char* name;
  const char* file;
  std::string text;
  const char* way;  ///< how its positions are differentiated
};

void PrintTo(const Arm& tested, std::ostream* out) { *out << tested.name; }

std::string with(std::string text, const std::vector<std::pair<std::string, std::string>>& parts) {
  for (const auto& [from, to] : parts) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  }
  return text;
}

const std::string x_and_y = "a*cos(q) + b*cos(q + p), a*sin(q) + b*sin(q + p)";
const std::string row_x = "-a*sin(q) - b*sin(q + p), -b*sin(q + p)";
const std::string row_y = "a*cos(q) + b*cos(q + p), b*cos(q + p)";
const std::string derivatives =
    "-a*sin(q)*u - b*sin(q + p)*(u + t), a*cos(q)*u + b*cos(q + p)*(u + t), "
    "-a*sin(q)*c - a*cos(q)*u*u - b*sin(q + p)*(c + d) - b*cos(q + p)*(u + t)*(u + t), cos(q + p)";

std::vector<Arm> arms() {
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"XY", x_and_y}, {"ROWX", row_x}, {"ROWY", row_y}, {"DERIVATIVES", derivatives}};
  const std::string python =
      "def f(a, b, q, p): return [XY]\ndef J(a, b, q, p): return [[ROWX], [ROWY]]\n"
      "def w(a, b, q, p, u, t, c, d): return [DERIVATIVES]\n";
  const std::string cpp = VECTORS
      "using List = std::vector<double>;\n"
      "List f(double a, double b, double q, double p) { return {XY}; }\n"
      "Rows J(double a, double b, double q, double p) { return {{ROWX}, {ROWY}}; }\n"
      "List w(double a, double b, double q, double p, double u, double t, double c, double d) {\n"
      "  return {DERIVATIVES}; }\n";
  const std::string javascript =
      "const { sin, cos } = Math;\nfunction f(a, b, q, p) { return [XY]; }\n"
      "function J(a, b, q, p) { return [[ROWX], [ROWY]]; }\n"
      "function w(a, b, q, p, u, t, c, d) { return [DERIVATIVES]; }\n";
  const std::string octave =
      "1;\nfunction y = f(a, b, q, p), y = [XY].'; end\n"
      "function y = J(a, b, q, p), y = [ROWX; ROWY]; end\n"
      "function y = w(a, b, q, p, u, t, c, d), y = [DERIVATIVES].'; end\n";
  std::vector<Arm> list = {
      {"Python", "arm.py", "from math import sin, cos\n" + python,
       "by extrapolated differences, to "},
      {"Cpp", "arm.cpp", cpp, "by extrapolated differences, to "},
      {"Singles", "arm.cpp", with(cpp, {{"double", "float"}}), "in single precision, against"},
      {"PythonOfComplexNumbers", "arm.py",
       "import cmath\ndef real(x): return x if x.imag else x.real\ndef sin(x): return "
       "real(cmath.sin(x))\ndef cos(x): return real(cmath.cos(x))\n" +
           python,
       "by complex steps, to "},
      {"JavaScript", "arm.js", javascript, "by extrapolated differences, to "},
      {"PythonThatDropsImaginaryParts", "arm.py",
       "import cmath\ndef sin(x): return cmath.sin(x).real\ndef cos(x): return "
       "cmath.cos(x).real\n" +
           python,
       "extrapolated differences, to "},
      {"Octave", "arm.m", octave, "by complex steps, to "}};
  for (Arm& each : list) {
    each.text = with(each.text, parts);
  }
  std::erase_if(list, [](const Arm& each) {
    return installed({{each.name, each.file, "", "", 0, ""}}).empty();
  });
  return list;
}

CommandResult judged(const Arm& tested, const std::string& text) {
  const TemporaryDirectory directory;
  directory.write(tested.file, text);
  const bool octave = std::string(tested.file).ends_with(".m");
  const std::string statements = with(
      all_of_it,
      {{"FILE", tested.file}, {"  position", octave ? "  before arm\n  position" : "  position"}});
  const fs::path file = directory.write("own.audit", arm + statements);
  return run_assur("audit --run " + file.string());
}

class OwnPositions : public testing::TestWithParam<Arm> {};

TEST_P(OwnPositions, JudgeTheDerivatives) {
  const Arm& tested = GetParam();
  const CommandResult right = judged(tested, tested.text);
  EXPECT_EQ(right.status, 0) << right.output << right.messages;
  EXPECT_NE(right.output.find(tested.way), std::string::npos) << right.output;

  // One slip in each of the three.
  const CommandResult wrong = judged(
      tested, with(tested.text,
                   {{"- b*sin(q + p), -b*sin(q + p)", "- b*sin(q + p), -sin(q + p)"},
                    {"-a*sin(q)*u - b*sin(q + p)*(u + t)", "a*sin(q)*u + b*sin(q + p)*(u + t)"},
                    {"*(u + t)*(u + t), cos(q + p)", "*(u + t)*(u + t)/2, cos(q + p)"}}));
  EXPECT_EQ(wrong.status, 1) << wrong.output << wrong.messages;
  EXPECT_NE(wrong.output.find("in all: 5 of 8 agree"), std::string::npos) << wrong.output;
  EXPECT_NE(wrong.output.find("the factor b is missing"), std::string::npos) << wrong.output;
  EXPECT_NE(wrong.output.find("rate(x): differs by sign"), std::string::npos) << wrong.output;
  EXPECT_NE(wrong.output.find("rate2(x): differs"), std::string::npos) << wrong.output;
}

INSTANTIATE_TEST_SUITE_P(Languages, OwnPositions, testing::ValuesIn(share_of(arms(), 3)),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// The findings on a slider whose position has no value at some points.
struct Fault {
  const char* name;
  const char* declarations;
  const char* frame;
  const char* rows;
  int status;
  const char* answer;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class OwnPositionOfASlider : public testing::TestWithParam<Fault> {};

TEST_P(OwnPositionOfASlider, IsAnswered) {
  const Fault& fault = GetParam();
  const TemporaryDirectory directory;
  directory.write("s.py",
                  "from math import *\ndef x(r, l, th): return r*cos(th) + sqrt(l*l - "
                  "r*r*sin(th)**2)\ndef v(r, l, th, w): return -r*sin(th)*w - "
                  "r*r*sin(th)*cos(th)*w/sqrt(l*l - r*r*sin(th)**2)\ndef bad(w): return w/0\n");
  const fs::path file =
      directory.write("s.audit", std::string(fault.declarations) + "printed run v s.py " +
                                     fault.frame + "\n" + fault.rows + "\n");
  const CommandResult result = run_assur("audit --run " + file.string());
  EXPECT_EQ(result.status, fault.status) << result.output << result.messages;
  const std::string& said = fault.status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(fault.answer), std::string::npos) << said;
}

#define SLIDER "length r l\nangle th\nmoving th\n"
#define CLOSED                                                                                    \
  "length r l s\nangle th ph\nunknown ph s\nmoving th\nloop f g = polar(r, th) + polar(l, ph) - " \
  "point(s, 0)\n"
#define OWN "of rate(x) against own position"
#define SPEED "  result v(r, l, th, rate_th)"
#define PLACE "  position x(r, l, th)\n"
INSTANTIATE_TEST_SUITE_P(
    Answers, OwnPositionOfASlider,
    testing::Values(
        Fault{"WhereItHasAValue", SLIDER, OWN, PLACE SPEED, 0,
              "where it has a value (elsewhere it ended with ValueError: "},
        Fault{"AtAssembledPoints", CLOSED, OWN, PLACE SPEED, 0, "agrees, computed at 40 assembled"},
        Fault{"Fails", SLIDER, OWN, PLACE "  result bad(rate_th)", 1, "rate(x): fails"},
        Fault{"PositionFails", SLIDER, OWN, "  position x(r, l, th)/0\n" SPEED, 1,
              "because     its position has no value at nearly all points: it ended with "},
        Fault{"NothingMoves", "length r l\nangle th w\n", OWN, PLACE "  result v(r, l, th, w)", 2,
              "s.audit:4:12: nothing moves, so the position has no rate"},
        Fault{"Unknown", CLOSED, OWN, "  position r*cos(th) + l*cos(ph)\n" SPEED, 2,
              "an own position is a function of parameters, and 'ph' is an unknown"},
        Fault{"ByAnUnknown", CLOSED, "of x by ph against own position", PLACE SPEED, 2,
              "s.audit:6:28: 'ph' is an unknown"},
        Fault{"NoDerivative", SLIDER, "of x against own position", PLACE SPEED, 2,
              "expected rate(NAME), rate2(NAME) or D(NAME, PARAMETER)"},
        Fault{"NoPosition", SLIDER, OWN, SPEED, 2, "'position EXPRESSION'"},
        Fault{"NotAgainst", SLIDER, "of rate(th)", PLACE SPEED, 2, "'against own position'"},
        Fault{"AgainstAnother", SLIDER, "of rate(x) against other position", PLACE SPEED, 2,
              "'against own position'"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace assur::test::own_position_test
