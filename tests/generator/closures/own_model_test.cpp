// Law: the functions emitted for closures that a user types are the closures' derivatives.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "command/command.hpp"
#include "whole_campaign.hpp"

namespace assur::test::own_model_test {
namespace {

namespace fs = std::filesystem;

const fs::path own_model = fs::path(ASSUR_EXAMPLES) / "audit" / "own_model";
const fs::path every_function = fs::path(ASSUR_CLOSURES) / "every_function.audit";

/// Compiles a program against headers emitted below a directory, and gives what it prints.
std::string output_of(const TemporaryDirectory& directory, const std::string& program) {
  const std::string root = directory.path().string();
  const fs::path source = directory.write("driver.cpp", program);
  const std::string compile =
      std::string(ASSUR_COMPILER) +
      " -std=c++17 -O0 -fno-exceptions -Wall -Wextra -Wconversion -Wshadow"
      " -Werror -I" +
      root + " -I" ASSUR_RUNTIME " -isystem " ASSUR_TESTS " -isystem " ASSUR_EIGEN " " +
      source.string() + " -o " + root + "/driver 2> " + root + "/errors";
  EXPECT_EQ(std::system(compile.c_str()), 0)
      << read_file(directory.path() / "errors").substr(0, 4000);
  EXPECT_EQ(std::system((root + "/driver > " + root + "/output").c_str()), 0);
  return read_file(directory.path() / "output");
}

void emit(const fs::path& file, const TemporaryDirectory& directory) {
  const CommandResult result =
      run_assur("emit --closures " + file.string() + " --output " + directory.path().string());
  ASSERT_EQ(result.status, 0) << result.messages;
  EXPECT_EQ(result.output, "");
  std::istringstream lines(
      read_file(directory.path() / "assur/closures" / (file.stem().string() + ".hpp")));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

/// The residuals as a person writes them from the files.
const std::string typed_residuals = R"(
#include <assur/closures/every_function.hpp>
#include <assur/closures/gear_five_bar.hpp>
#include <assur/closures/zhauyt_2017.hpp>
#include "generator/closures_driver.hpp"

using closures_driver::Values;
using namespace std;

assur::Vector<double, 3> every_function(const Values& d, const Values& u, const Values& q) {
  const double a = d[0], b = d[1], beta = d[2], c = u[0], phi = u[1], x = q[0], psi = q[1],
               theta = q[2];
  const double alpha = acos((a * a - b * b) / (2 * a * c));
  const double rhs = d[3] * d[4] + d[5] * d[5] * d[6] - d[7];
  return {a * cos(2 * phi - psi) + sqrt(1 + c * c) * x - b * sin(phi - psi + beta - alpha) +
              tan(theta) / (a - b) + rhs,
          x * x * cos(psi + alpha) - pow(a * a + x * x, 1.5) - 1 / sqrt(1 + c * c) -
              1 / sqrt(x + a),
          -sin(theta) * x - a / pow(x + b * cos(psi), 2) + sin(atan2(x, c) + psi) +
              cos(asin(x / (10 * a)) - theta) + 0.75 * sin(atan(b / c) - 2 * psi)};
}

assur::Vector<double, 4> gear_five_bar(const Values& d, const Values& u, const Values& q) {
  const double l1 = d[0], l2 = d[1], l3 = d[2], l4 = d[3], e = d[8], phi1 = u[0];
  const double s = q[0], phi2 = q[1], phi3 = q[2], phi5 = q[3], phi4 = d[9] - 2 * phi1;
  const double xB = l1 * cos(phi1) + l2 * cos(phi2), yB = l1 * sin(phi1) + l2 * sin(phi2);
  return {xB - l3 * cos(phi3) - l4 * cos(phi4) - d[4], yB - l3 * sin(phi3) - l4 * sin(phi4) - d[5],
          xB - d[6] - s * cos(phi5) + e * sin(phi5), yB - d[7] - s * sin(phi5) - e * cos(phi5)};
}

assur::Vector<double, 4> zhauyt(const Values& d, const Values& u, const Values& q) {
  const auto a = [&d](int index) {
    return d[static_cast<std::size_t>(index <= 4 ? index - 1 : index <= 6 ? index - 1
                                      : index == 13 ? 6 : index)];
  };
  const double alpha = acos((a(5) * a(5) + a(6) * a(6) - a(13) * a(13)) / (2 * a(5) * a(6)));
  const double x = a(1) + a(3) * cos(u[0]) + a(4) * cos(q[0]);
  const double y = a(2) + a(3) * sin(u[0]) + a(4) * sin(q[0]);
  return {a(9) + a(7) * cos(q[2]) - a(5) * cos(q[1]) - x,
          a(10) + a(7) * sin(q[2]) - a(5) * sin(q[1]) - y,
          a(11) + a(8) * cos(q[3]) - a(6) * cos(q[1] - alpha) - x,
          a(12) + a(8) * sin(q[3]) - a(6) * sin(q[1] - alpha) - y};
}

int main() {
  using namespace assur::closures;
  closures_driver::report<EveryFunction>("every_function", {2, 1, 0, 0.3, 0.7, 1.1, 0.4, 0.9},
                                         {1.2, 0}, {1.5, 0, 0}, 0.6, every_function);
  closures_driver::report<GearFiveBar>("gear_five_bar", {1, 2, 2, 0.7, 2, 0.5, 1, -1, 0.3, 0},
                                       {0}, {1.4, 0, 0, 0}, 3, gear_five_bar);
  closures_driver::report<Zhauyt2017>("zhauyt_2017",
                                      {0.1, 0.2, 0.5, 2, 1.1, 1.3, 1, 1.5, 1.6, 2, 1, 3, 0.4, 1, 0},
                                      {0}, {0, 0, 0, 0}, 3, zhauyt);
}
)";

TEST(OwnModel, EmittedFunctionsAreTheResidualsDerivatives) {
  const TemporaryDirectory directory;
  for (const fs::path& file : {every_function, own_model / "gear_five_bar.audit",
                               fs::path(ASSUR_EXAMPLES) / "audit" / "zhauyt_2017.audit"}) {
    emit(file, directory);
  }
  const std::string output = output_of(directory, typed_residuals);
  std::printf("largest errors, relative where numbers exceed one (seed 20)\n%s", output.c_str());
  // residual, jacobian, dimension, input Jacobian, velocity, acceleration, jerk, curvature rhs
  constexpr std::array<double, 8> bounds = {1e-12, 1e-10, 1e-10, 1e-10, 1e-10, 1e-10, 1e-8, 1e-10};
  std::istringstream lines(output);
  int models = 0;
  for (std::string name; lines >> name; ++models) {
    for (std::size_t index = 0; index < bounds.size(); ++index) {
      std::string error;
      lines >> error;
      EXPECT_LE(std::strtod(error.c_str(), nullptr), bounds[index]) << name << " " << index;
      EXPECT_EQ(error.find("nan"), std::string::npos) << name << " " << index;
    }
  }
  EXPECT_EQ(models, 3);
}

/// An assembled geared five-bar, its neighbours by Newton, and a dead centre.
const std::string solving = R"(
#include <assur/closures/gear_five_bar.hpp>
#include <assur/tracking.hpp>
#include "generator/closures_driver.hpp"

using Model = assur::closures::GearFiveBar;
using Real = long double;
using D = Model::Dimensions<Real>;
using U = Model::Inputs<Real>;
using Q = Model::Configuration<Real>;

template <typename Variables>
Variables moved(Variables variables, int index, Real step) {
  constexpr int count = static_cast<int>(std::tuple_size_v<decltype(variables.members())>);
  assur::advance(variables, assur::Vector<Real, count>(step * assur::Vector<Real, count>::Unit(index)));
  return variables;
}

double rounded(Real length) { return double(length); }
assur::Direction<double> rounded(const assur::Direction<Real>& direction) {
  return {double(direction.cos), double(direction.sin)};
}
template <typename Variables, typename From>
Variables rounded(const From& from) {
  Variables variables;
  assur::for_each_pair(variables, from, [](auto& to, const auto& exact) { to = rounded(exact); });
  return variables;
}

Q solved(const D& d, const U& u, Q q) {
  if (assur::refine<Model, Real>(d, u, q) != assur::Status::ok) {
    std::printf("unsolved\n");
  }
  return q;
}

/// The way from one configuration to another.
assur::Vector<double, 4> between(const Q& from, const Q& to) {
  const auto turn = [](const auto& a, const auto& b) {
    return double(assur::angle_of(assur::turned(b, assur::reversed(a))));
  };
  return {double(to.s - from.s), turn(from.phi2, to.phi2), turn(from.phi3, to.phi3),
          turn(from.phi5, to.phi5)};
}

int main() {
  D d{1, 2, 1.8L, 0.7L, 0, 0, 0, 0, 0.3L, assur::direction_of<Real>(0.4L)};
  U u{assur::direction_of<Real>(0.9L)};
  Q q{1.4L, assur::direction_of<Real>(0.3L), assur::direction_of<Real>(1.7L),
      assur::direction_of<Real>(0.8L)};
  assur::Vector<Real, 4> f;
  Model::residual(d, u, q, f);
  d.x_D += f(0);
  d.y_D += f(1);
  d.x_E += f(2);
  d.y_E += f(3);

  assur::Sensitivities<Model, Real> s;
  assur::Motion<Model, Real> m;
  const assur::Vector<Real, 1> rate(0.7L), second(-0.4L);
  std::printf("%s\n", assur::to_string(assur::sensitivities<Model, Real>(d, u, q, s)));
  std::printf("%s\n", assur::to_string(assur::motion<Model, Real>(d, u, q, rate, second, m)));
  double error = 0;
  constexpr Real h = 1e-4L;
  // Central differences, once extrapolated.
  const auto slope = [&](auto at) {
    const auto central = [&](Real step) {
      return (between(at(-step), at(step)) / double(2 * step)).eval();
    };
    return ((4 * central(h) - central(2 * h)) / 3).eval();
  };
  for (int index = 0; index < Model::dimension_count; ++index) {
    const auto found = slope([&](Real step) { return solved(moved(d, index, step), u, q); });
    error = std::max(error, closures_driver::difference(s.to_dimensions.col(index), found));
  }
  const auto found = slope([&](Real step) { return solved(d, moved(u, 0, step), q); });
  error = std::max(error, closures_driver::difference(s.to_inputs.col(0), found));
  std::printf("%.3g\n", error);
  const auto at = [&](Real t) {
    return solved(d, moved(u, 0, t * (rate(0) + t * second(0) / 2)), q);
  };
  std::printf("%.3g\n", closures_driver::difference(m.velocity, slope(at)));
  const auto curve = [&](Real t) {
    return ((between(q, at(t)) + between(q, at(-t))) / double(t * t)).eval();
  };
  const auto bent = ((4 * curve(1e-3L) - curve(2e-3L)) / 3).eval();
  std::printf("%.3g\n", closures_driver::difference(m.acceleration, bent));

  Q far = q;  // a poor guess
  assur::advance(far, assur::Vector<Real, 4>(0.2L, -0.3L, 0.2L, 0.1L));
  std::printf("%s\n", assur::to_string(assur::refine<Model, Real>(d, u, far)));
  std::printf("%.3g\n", double(between(q, far).cwiseAbs().maxCoeff()));

  const auto d_rounded = rounded<Model::Dimensions<double>>(d);
  const auto q_rounded = rounded<Model::Configuration<double>>(q);
  const auto path = [&](double time) {
    const assur::Vector<double, 1> steady(1.0);
    return assur::InputMotion<Model>{{assur::direction_of(0.9 + time)}, steady, 0 * steady};
  };
  const auto start = assur::branch_point<Model>(d_rounded, path(0), q_rounded);
  const auto way = assur::track<Model>(d_rounded, path, 0, 0.3, start);
  std::printf("%s\n", assur::to_string(way.status));
  const Q there = solved(d, moved(u, 0, Real(0.3)), q);
  std::printf("%.3g\n", std::abs(way.point.q.s - double(there.s)) +
                            std::abs(way.point.q.phi3.sin - double(there.phi3.sin)));
  Q dead = q;
  dead.phi3 = dead.phi2;  // AB and CB on one line
  std::printf("%s\n", assur::to_string(assur::regularity<Model, Real>(d, u, dead).status));
  d.l1 = std::numeric_limits<Real>::quiet_NaN();
  std::printf("%s\n", assur::to_string(assur::sensitivities<Model, Real>(d, u, q, s)));
}
)";

TEST(LongOwnModel, TheRuntimeSolvesAsItDoesModels) {
  const TemporaryDirectory directory;
  emit(own_model / "gear_five_bar.audit", directory);
  const std::string output = output_of(directory, solving);
  std::printf("%s", output.c_str());
  std::istringstream lines(output);
  const auto expect_word = [&](const std::string& expected) {
    std::string line;
    std::getline(lines >> std::ws, line);
    EXPECT_EQ(line, expected);
  };
  const auto expect_small = [&](double bound) {
    double error = 1;
    lines >> error;
    EXPECT_LE(error, bound);
  };
  expect_word("ok");
  expect_word("ok");
  expect_small(1e-10);  // sensitivities
  expect_small(1e-10);  // velocity
  expect_small(1e-8);   // acceleration: second differences in steps of 1e-3
  expect_word("ok");
  expect_small(1e-12);  // refined from a poor guess
  expect_word("ok");
  expect_small(1e-13);  // tracked
  expect_word("singular");
  expect_word("not finite");
}

/// Closures without moving parameters, with these alone, and with more closures than unknowns.
const std::string shapes = R"(
#include <assur/closures/all_held.hpp>
#include <assur/closures/all_moving.hpp>
#include <assur/closures/too_many.hpp>
#include <assur/kinematics.hpp>
#include <cstdio>

using namespace assur;

template <typename Model>
void solve(const typename Model::template Dimensions<double>& d,
           const typename Model::template Inputs<double>& u) {
  typename Model::template Configuration<double> q;
  q.q = direction_of(1.0);
  Sensitivities<Model, double> s;
  Motion<Model, double> m;
  Vector<double, Model::input_count> rates;
  rates.setZero();
  std::printf("%s ", to_string(refine<Model, double>(d, u, q)));
  std::printf("%s ", to_string(sensitivities<Model, double>(d, u, q, s)));
  std::printf("%s ", to_string(sensitivities_and_motion<Model, double>(d, u, q, rates, rates, s, m)));
  std::printf("%.12f\n", q.q.cos);
}

int main() {
  solve<closures::AllHeld>({2, 1}, {});
  solve<closures::AllMoving>({}, {2, 1});
  Matrix<double, 2, 1> J;
  closures::TooMany::jacobian<double>({}, {3}, {direction_of(1.5707963267948966)}, J);
  std::printf("%d %.3f %.3f\n", closures::TooMany::rigid, J(0), J(1));
}
)";

TEST(OwnModel, AnyNumbersOfParametersAndClosuresWork) {
  const TemporaryDirectory directory;
  const std::string head = "length a b\nangle q\nunknown q\n";
  const std::string closure = "closure f = a*cos(q) - b\n";
  const std::string second = "closure g = a*sin(q) - b\n";
  emit(directory.write("all_held.audit", head + closure), directory);
  emit(directory.write("all_moving.audit", head + "moving a b\n" + closure), directory);
  emit(directory.write("too_many.audit", head + "moving a\n" + closure + second), directory);
  EXPECT_EQ(output_of(directory, shapes),
            "ok ok ok 0.500000000000\nok ok ok 0.500000000000\n0 -3.000 0.000\n");
}

TEST(OwnModel, ARootThatTwoFunctionsShareNamesBoth) {
  const TemporaryDirectory directory;
  emit(directory.write("shared.audit",
                       "length a x y\nunknown x y\nclosure f = sqrt(x^2 + a^2) - y\n"
                       "closure g = a*cos(atan2(a, x)) - x\n"),
       directory);
  const std::string header = read_file(directory.path() / "assur/closures/shared.hpp");
  for (const char* part : {"sqrt(a^2 + x^2) has no value or no derivatives, and", "atan2(a, x)"}) {
    EXPECT_NE(header.find(part), std::string::npos) << header;
  }
}

TEST(OwnModel, CheckTellsWhatDiffers) {
  const TemporaryDirectory directory;
  emit(every_function, directory);
  const std::string arguments = "emit --check --closures " + every_function.string() +
                                " --output " + directory.path().string();
  const int runs = is_whole_campaign() ? 10 : 3;
  for (int run = 0; run < runs; ++run) {  // GiNaC's order of terms differs from run to run
    EXPECT_EQ(run_assur(arguments).status, 0);
  }
  directory.write("assur/closures/every_function.hpp", "");
  const CommandResult result = run_assur(arguments);
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.messages,
            "assur/closures/every_function.hpp differs from what would be written\n");
}

TEST(OwnModel, ThePlantedSignIsFoundAndItsCorrectionAgrees) {
  const std::string audit = read_file(own_model / "gear_five_bar.audit");
  std::string code = read_file(own_model / "gear_five_bar.cpp");
  const TemporaryDirectory directory;
  const fs::path file = directory.write("gear_five_bar.audit", audit);
  const fs::path source = directory.write("gear_five_bar.cpp", code);

  const CommandResult found = run_assur("audit " + file.string());
  EXPECT_EQ(found.status, 1) << found.messages;
  EXPECT_NE(found.output.find("15 of 16 agree\n    . . . .\n    . - . .\n    . . . .\n"
                              "    . . . .\n  (2,2) d f2/d phi3: differs by sign (" +
                              source.string() +
                              ":20:13)\n      J(1, 1) = p.l3 * c3;\n                ^\n"
                              "    printed     p.l3 * c3\n"),
            std::string::npos)
      << found.output;

  const std::string wrong = "J(1, 1) = p.l3 * c3;";
  ASSERT_NE(code.find(wrong), std::string::npos);
  code.replace(code.find(wrong), wrong.size(), "J(1, 1) = -p.l3 * c3;");
  directory.write("gear_five_bar.cpp", code);
  const CommandResult mended = run_assur("audit " + file.string());
  EXPECT_EQ(mended.status, 0);
  EXPECT_NE(mended.output.find("all 16 agree"), std::string::npos) << mended.output;
}

}  // namespace
}  // namespace assur::test::own_model_test
