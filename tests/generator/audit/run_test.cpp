// Law: what a program computes is compared with the derivation where closures hold: a wrong entry
// is named with a point and its slip, one without a value with a point and the reason, and a
// program that cannot be run at all gets one line and status 2.
#include <gtest/gtest.h>

#include "run_program.hpp"
#include "whole_campaign.hpp"

namespace assur::test::run_test {
namespace {

class RunProgram : public testing::TestWithParam<Program> {};

TEST_P(RunProgram, IsJudgedByWhatItComputes) { expect_judged(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Cpp, RunProgram,
    testing::ValuesIn(share_of<Program>(
        {Program{"Right", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 0,
                 "all 4 agree, computed at 40 assembled rational points: evidence, not proof"},
         Program{
             "Looped", "a.cpp",
             CPP("Rows J(2, std::vector<double>(2)); double c[] = {-sin(theta), cos(theta)};"
                 "for (int i = 0; i < 2; ++i) { J[i][0] = l*c[i]; J[i][1] = i - 1; } return J;"),
             CALL, 0, "all 4 agree"},
         Program{"ByMacro", "a.cpp",
                 VECTORS
                 "#define SQ(x) ((x)*(x))\ntemplate <class T> Rows f(T l, T theta) { return "
                 "{{-SQ(l)/l*sin(theta), -1}, {l*cos(theta), 0}}; }",
                 CALL, 0, "all 4 agree"},
         Program{"Filled", "a.cpp",
                 "#include <cmath>\nstruct P { double l; };\nvoid f(const P& p, double q, double "
                 "(&J)[2][2]) { J[0][0] = -p.l*std::sin(q); J[0][1] = -1; J[1][0] = "
                 "p.l*std::cos(q); J[1][1] = 0; }\nint main() { return 1; }",
                 FRAME "  before double J[2][2]; f(P{l}, theta, J)\n  result J", 0, "all 4 agree"},
         Program{"ByColumns", "a.cpp",
                 "#include <cmath>\n#include <array>\nstd::array<double, 4> f(double l, double t) "
                 "{ return {-l*std::sin(t), l*std::cos(t), -1, 0}; }",
                 FRAME "  result f(l, theta)\n  entry result[i + 2*j]", 0, "all 4 agree"},
         Program{"FlatUnsaid", "a.cpp",
                 "#include <array>\nstd::array<double, 4> f(double, double) { return {}; }", CALL,
                 2, "say, for instance, 'entry result[i*2 + j]'"},
         Program{"Closures", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double s, double p, double t) { return {r*std::cos(p) + l*std::cos(t) - s, "
                 "r*std::sin(p) + l*std::sin(t)}; }",
                 "f1, f2\n  result f(r, l, s, phi, theta)", 0, "all 2 agree"},
         Program{"Rates", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double p, double t, double w) { double v = -r*std::cos(p)*w/(l*std::cos(t)); "
                 "return {v, -r*std::sin(p)*w - l*std::sin(t)*v}; }",
                 "rate(theta), rate(s)\n  result f(r, l, phi, theta, rate_phi)", 0, "all 2 agree"},
         // At points with r = l and cos(phi) < 0 the slider is at zero, up to rounding.
         Program{"PositionThatVanishes", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double p) { return {r*std::cos(p) + std::sqrt(l*l - r*r*std::sin(p)*std::sin(p))"
                 "}; }",
                 "s\n  result f(r, l, phi)\n  where cos(theta)", 0, "agrees, computed at 40"},
         Program{"RatesOfUnknowns", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double p, double t, double w, double v, double a) { return {-r*std::sin(p)*a - "
                 "r*std::cos(p)*w*w - l*std::sin(t)*v - l*std::cos(t)*std::pow(v, 2)*0}; }",
                 "rate2(s)\n  result f(r, l, phi, theta, rate_phi, rate_theta, rate2_phi)", 1,
                 "rate2(s): differs"},
         Program{"AccelerationOfASlider", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double p, double t, double w, double v, double a, double b) { return "
                 "{-r*std::sin(p)*a - r*std::cos(p)*w*w - l*std::sin(t)*b - l*std::cos(t)*v*v}; }",
                 "rate2(s)\n  result f(r, l, phi, theta, rate_phi, rate_theta, rate2_phi, "
                 "rate2_theta)",
                 0, "agrees, computed at 40"},
         Program{
             "TotalDerivatives", "a.cpp",
             "#include <cmath>\n#include <vector>\nstd::vector<std::vector<double>> f(double l, "
             "double p, double t) { double d = -std::sin(p)/(l*std::cos(t)); "
             "return {{d}, {std::cos(p) - l*std::sin(t)*d}}; }",
             "theta s by r\n  result f(l, phi, theta)", 0, "all 2 agree"},
         Program{"OneBranch", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<double> f(double r, double l, "
                 "double p) { return {-l*std::cos(std::asin(-r*std::sin(p)/l))}; }",
                 "-l*cos(theta)\n  result f(r, l, phi)\n  where cos(theta)\n  where l", 0,
                 "agrees, computed at"},
         Program{"Singles", "a.cpp",
                 CPP("float k = l; return {{-k*sin(theta), -1}, {k*cos(theta), 0}};"), CALL, 1,
                 "2 of 4 agree"},
         Program{"SinglesAllowed", "a.cpp",
                 CPP("float k = l; return {{-k*sin(theta), -1}, {k*cos(theta), 0}};"),
                 CALL "\n  rounding 1e-6", 0, "all 4 agree"},
         Program{"SinglesDeclared", "a.cpp",
                 "#include <cmath>\n#include <vector>\nstd::vector<std::vector<float>> f(float l, "
                 "float t) { return {{-l*std::sin(t), -1}, {l*std::cos(t), 0}}; }",
                 CALL, 0, "all 4 agree, computed at 40 assembled rational points, in single"},
         Program{"SinglesAsParameters", "a.cpp",
                 "#include <cmath>\n/* float */ double f(float l, float t) { return "
                 "-l*std::sin(t); }",
                 "-l*sin(theta)\n  result f(l, theta)", 0, "in single precision"},
         Program{"NoSinglesInComments", "a.cpp",
                 "#include <cmath>\n// f(float l, float t)\ndouble f(double l, double t) { float k "
                 "= l; return -k*std::sin(t); }",
                 "-l*sin(theta)\n  result f(l, theta)", 1,
                 "at all points: is it computed in single precision (float)?"},
         Program{
             "AnglesUpToTurns", "a.cpp",
             "#include <cmath>\ndouble f(double r, double p, double s) { return 12*std::acos(-1) "
             "+ std::atan2(-r*std::sin(p), s - r*std::cos(p)); }",
             "theta\n  result f(r, phi, s)", 0, "agrees, computed at 40"},
         Program{"DifferenceOfAngles", "a.cpp",
                 "#include <cmath>\ndouble f(double r, double p, double s) { return "
                 "std::remainder(std::atan2(-r*std::sin(p), s - r*std::cos(p)) - p, "
                 "2*std::acos(-1)); }",
                 "theta - phi\n  result f(r, phi, s)", 0, "agrees, computed at 40"},
         Program{"Talks", "a.cpp",
                 "#include <cstdio>\n" CPP(
                     "std::puts(\"1 2 3 nan\\n%s\"); return {{-l*sin(theta), -1}, "
                     "{l*cos(theta), 0}};"),
                 CALL, 0, "all 4 agree"},
         Program{"Alone", "a.cpp",
                 "#include <cstdlib>\n" CPP("if (std::getenv(\"ASSUR_SECRET\")) std::abort();"
                                            "return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"),
                 CALL, 0, "all 4 agree"}},
        4)),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Slips, RunProgram,
    testing::ValuesIn(share_of<Program>(
        {Program{"Sign", "a.cpp", CPP("return {{l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 1,
                 "differs by sign"},
         Program{"Exchanged", "a.cpp", CPP("return {{l*cos(theta), -1}, {-l*sin(theta), 0}};"),
                 CALL, 1, "it is exchanged with (2,1)"},
         Program{"Degrees", "a.cpp",
                 CPP("theta *= 3.14159265358979323846/180; return {{-l*sin(theta), -1}, "
                     "{l*cos(theta), 0}};"),
                 CALL, 1, "theta is taken to be in degrees where it is in radians"},
         Program{"WrongRow", "a.cpp", CPP("return {{l*cos(theta), 0}, {l*cos(theta), 0}};"), CALL,
                 1, "row 1 is what row 2 should be"},
         Program{"Transposed", "a.cpp", CPP("return {{-l*sin(theta), l*cos(theta)}, {-1, 0}};"),
                 CALL, 1, "the matrix is transposed"},
         Program{"FactorTwo", "a.cpp", CPP("return {{-l*sin(theta)/2, -1}, {l*cos(theta), 0}};"),
                 CALL, 1, "it is 1/2 times what it should be"},
         Program{"LeftOut", "a.cpp", CPP("return {{0, -1}, {l*cos(theta), 0}};"), CALL, 1,
                 "it is always zero"},
         Program{"MissingTerm", "a.cpp",
                 VECTORS
                 "double f(double r, double phi, double l, double theta) { return r*cos(phi); }",
                 "r*cos(phi) + l*cos(theta)\n  result f(r, phi, l, theta)", 1,
                 "the term l*cos(theta) is missing"},
         Program{
             "SignOfATerm", "a.cpp",
             VECTORS
             "double f(double r, double phi, double l, double t) { return r*cos(phi) - l*cos(t); }",
             "r*cos(phi) + l*cos(theta)\n  result f(r, phi, l, theta)", 1,
             "the term l*cos(theta) has the wrong sign"},
         Program{"OtherAngle", "a.cpp",
                 VECTORS "double f(double r, double phi) { return r*cos(phi); }",
                 "r*cos(theta)\n  result f(r, phi)", 1, "phi stands where theta should"},
         Program{"SineForCosine", "a.cpp",
                 VECTORS "double f(double r, double phi) { return r*sin(phi); }",
                 "r*cos(phi)\n  result f(r, phi)", 1, "sine and cosine of phi are exchanged"},
         Program{"Factor", "a.cpp", CPP("return {{-sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 1,
                 "the factor l is missing"},
         Program{"FactorAndSign", "a.cpp",
                 CPP("return {{-l*sin(theta), -1}, {-l*l*cos(theta), 0}};"), CALL, 1,
                 "the factor l is too many, and the sign is wrong"},
         Program{"Fraction", "a.cpp", CPP("return {{-l*sin(theta), -1}, {2*l*cos(theta)/5, 0}};"),
                 CALL, 1, "it is 2/5 times what it should be"},
         Program{"Percent", "a.cpp", CPP("return {{-l*sin(theta), -1}, {1.0375*l*cos(theta), 0}};"),
                 CALL, 1, "it is 1.0375 times what it should be"},
         Program{"FactorOfASingle", "a.cpp",
                 "#include <cmath>\nfloat f(float l, float t) { return -std::sin(t); }",
                 "-l*sin(theta)\n  result f(l, theta)", 1, "the factor l is missing"},
         Program{"AngleInDegrees", "a.cpp",
                 "#include <cmath>\ndouble f(double r, double p, double s) { return "
                 "180/std::acos(-1)*std::atan2(-r*std::sin(p), s - r*std::cos(p)); }",
                 "theta\n  result f(r, phi, s)", 1,
                 "the angle is in degrees and should be in radians"},
         Program{"AngleFromAnotherAxis", "a.cpp",
                 "#include <cmath>\ndouble f(double r, double p, double s) { return "
                 "std::acos(0) + std::atan2(-r*std::sin(p), s - r*std::cos(p)); }",
                 "theta\n  result f(r, phi, s)", 1, "the angle is 90 degrees too large"},
         Program{
             "NeverSet", "a.cpp",
             "#include <array>\n" VECTORS "using M = std::array<std::array<double, 2>, 2>;\nM f("
             "double l, double t) { M J; J[0][0] = -l*sin(t); J[0][1] = -1; J[1][0] = l*cos(t); "
             "return J; }",
             CALL, 1, "3 of 4 agree"},
         Program{
             "NeverSetOnTheHeap", "a.cpp",
             "#include <cmath>\ndouble* f(double l, double t) { double* J = new double[4]; J[0] = "
             "-l*std::sin(t); J[1] = -1; J[2] = l*std::cos(t); return J; }",
             CALL "\n  entry result[2*i + j]", 1, "3 of 4 agree"},
         Program{"OfOneSideAlone", "a.cpp",
                 "#include <cmath>\ndouble f(double s) { return -std::fabs(s); }",
                 "-s\n  result f(s)", 1, "-s: holds on one branch"},
         Program{"OverOneHalfTurn", "a.cpp",
                 CPP("return {{-l*sin(theta), -1}, {l*sqrt(1 - sin(theta)*sin(theta)), 0}};"), CALL,
                 1, "3 of 4 agree"},
         Program{"WholeNumbers", "a.cpp",
                 CPP("int c = l*cos(theta); return {{-l*sin(theta), -1}, {double(c), 0}};"), CALL,
                 1, "3 of 4 agree"},
         Program{"HelperByReference", "a.cpp",
                 VECTORS "void h(double& c) { c = -c; }\nRows f(double l, double t) { double c = "
                         "cos(t); h(c); return {{-l*sin(t), -1}, {l*c, 0}}; }",
                 CALL, 1, "3 of 4 agree"},
         Program{"ASwitchThatEndsEarly", "a.cpp",
                 CPP("double c = 0; switch ((int)l) { case 1: c = cos(theta); break; case 2: c = "
                     "cos(theta); } return {{-l*sin(theta), -1}, {l*c, 0}};"),
                 CALL, 1, "3 of 4 agree"},
         Program{
             "AddedToTheLast", "a.cpp",
             CPP("static Rows J(2, std::vector<double>(2)); J[0][0] += -l*sin(theta); J[0][1] = "
                 "-1; J[1][0] = l*cos(theta); return J;"),
             CALL, 1, "3 of 4 agree"},
         Program{"KeptFromTheFirstCall", "a.cpp",
                 CPP("static double c = cos(theta); return {{-l*sin(theta), -1}, {l*c, 0}};"), CALL,
                 1, "3 of 4 agree"},
         Program{"KeptFromTheLastCall", "a.cpp",
                 CPP("static double last = 0; double c = last; last = cos(theta); return "
                     "{{-l*sin(theta), -1}, {l*c, 0}};"),
                 CALL, 1, "the same call gives another value later"},
         Program{"Pencil", "a.cpp", CPP("return {{l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 1,
                 "l = 1, s = 3/5, (cos, sin)(phi) = (0, -1), (cos, sin)(theta) = (3/5, 4/5)"}},
        4)),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Failing, RunProgram,
    testing::ValuesIn(share_of<Program>(
        {Program{"Crashes", "a.cpp", CPP("*(volatile int*)0 = 1; return {};"), CALL, 1,
                 "printed     it was ended by a signal: Segmentation fault (SIGSEGV)"},
         Program{
             "FailsAtSome", "a.cpp",
             "#include <stdexcept>\n" CPP(
                 "if (l > 1) { throw std::out_of_range(\"too long\"); } return "
                 "{{-l*sin(theta), -1}, {l*cos(theta), 0}};"),
             CALL, 1,
             "printed     it ended with an exception: too long\n    derived     -l*sin(theta) = "
             "-1.2\n    at          l = 2, (cos, sin)(theta) = (4/5, 3/5)\n    note        it "
             "fails at 35 of 40 points; it agrees at the others"},
         Program{"EndsAtSome", "a.cpp",
                 "#include <cstdlib>\n" CPP(
                     "if (l < 1) std::abort(); return {{l*sin(theta), -1}, {l*cos(theta), 0}};"),
                 CALL, 1, "of 40; it differs at the others"},
         Program{"ComplexNumber", "a.cpp",
                 "#include <complex>\nstd::complex<double> f(double l) { return "
                 "std::sqrt(std::complex<double>(-l*l)); }",
                 "l\n  result f(l)", 1, "printed     it is a complex number, 0+"},
         Program{"SizeOfItsOwn", "a.cpp",
                 CPP("Rows J = {{-l*sin(theta), -1}, {l*cos(theta), 0}}; if (l < 1) J.pop_back(); "
                     "return J;"),
                 CALL, 1, "printed     the result is 1 by 2, not 2 by 2"},
         Program{"Throws", "a.cpp", CPP("throw 1;"), CALL, 1,
                 "printed     it ended with an exception\n"},
         Program{"Hangs", "a.cpp", CPP("for (volatile int i = 0;; i = i) {} return {};"), CALL, 1,
                 "printed     it did not end within 1 s"},
         Program{"Sleeps", "a.cpp", "#include <unistd.h>\n" CPP("sleep(100); return {};"), CALL, 1,
                 "printed     it did not end within 1 s"},
         Program{
             "Forks", "a.cpp",
             "#include <unistd.h>\n" CPP("if (fork() == 0) { sleep(100); } _exit(0); return {};"),
             CALL, 1, "ended with status 0\n"},
         Program{
             "Eats", "a.cpp",
             CPP("std::vector<double>* all = new std::vector<double>(std::size_t{1} << 31, 1.0);"
                 "return {{(*all)[5], 0}, {0, 0}};"),
             CALL, 1, "it ended with an exception: std::bad_alloc"},
         Program{"WritesGigabytes", "a.cpp",
                 "#include <cstdio>\n" CPP("std::FILE* o = std::fopen(\"big\", \"w\"); for (;;) "
                                           "std::fputs(\"0123456789\", o); return {};"),
                 CALL, 1, "File size limit exceeded (SIGXFSZ)"},
         Program{"PrintsForEver", "a.cpp",
                 "#include <cstdio>\n" CPP("for (;;) std::puts(\"0 0 0 0\"); return {};"), CALL, 1,
                 "did not end within 1 s"},
         Program{"WantsInput", "a.py", "def f(l, t):\n  return input()\n", CALL, 1,
                 "ended with EOFError"},
         Program{"Exits", "a.cpp", "#include <cstdlib>\n" CPP("std::exit(7);"), CALL, 1,
                 "ended with status 7\n"},
         Program{"NoNumber", "a.cpp", CPP("return {{-l*sin(theta), -1}, {std::sqrt(-l - 4), 0}};"),
                 CALL, 1, "(2,1) d f2/d theta: fails"},
         Program{"Infinite", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l, 1/(l-l)}};"), CALL, 1,
                 "printed     it is infinite"},
         Program{"WrongSize", "a.cpp", CPP("return {{1, 2, 3}, {4, 5, 6}};"), CALL, 2,
                 "the result is 2 by 3, not 2 by 2, at point 1"},
         Program{"Empty", "a.cpp", CPP("return {};"), CALL, 2, "the result is 0 by 0, not 2 by 2"},
         Program{"DoesNotCompile", "a.cpp", CPP("return lamda;"), CALL, 2,
                 "a.cpp cannot be audited: it does not compile: "},
         Program{"NoSuchFunction", "a.cpp", CPP("return {};"), FRAME "  result g(l)", 2,
                 "'g' was not declared in this scope"},
         Program{"NoCompiler", "a.cpp", CPP("return {};"), CALL "\n  compiler no-such-compiler", 2,
                 "'no-such-compiler' cannot be started here, so nothing was run; install it"},
         Program{"UnknownRow", "a.cpp", "", FRAME "  reslt f(l)", 2,
                 "mine.audit:7:3: no row 'reslt' (did you mean 'result'?)"},
         Program{"NoResult", "a.cpp", "", FRAME "  points 5", 2, "a row is missing: 'result"},
         Program{"NoLanguage", "a.txt", "", CALL, 2, "its language is not known"},
         Program{"Nowhere", "a.cpp", CPP("return {};"), CALL "\n  where -l^2", 2,
                 "no points were found at which the closures hold and the program can be run"},
         Program{"WrongCondition", "a.cpp", CPP("return {};"), CALL "\n  where lenth", 2,
                 "mine.audit:8:9: no symbol named 'lenth'"}},
        4)),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::run_test
