// Law: what a program computes is compared with the derivation where closures hold: a wrong entry
// is named with a point and its slip, and a program that gives no values is one line and status 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "command/command.hpp"

namespace assur::test::run_test {
namespace {

namespace fs = std::filesystem;

/// A slider-crank: J = d(f1, f2)/d(theta, s) is -l sin(theta), -1; l cos(theta), 0.
const std::string slider_crank =
    "length r l s\nangle phi theta\nunknown theta s\nmoving phi\n"
    "loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)\n";

/// A program that fills J, and what the audit answers, and with what status.
struct Program {
  const char* name;
  const char* file;
  const char* text;
  const char* rows;  ///< of the statement, the first of them what it is compared with
  int status;
  const char* answer;
};

void PrintTo(const Program& program, std::ostream* out) { *out << program.name; }

CommandResult audited(const TemporaryDirectory& directory, const Program& program,
                      const std::string& options = "--run --time-limit 2") {
  directory.write(program.file, program.text);
  const std::string rows = program.rows;
  const std::size_t end = rows.find('\n');
  const fs::path file =
      directory.write("mine.audit", slider_crank + "printed run J " + program.file + " of " +
                                        rows.substr(0, end) + rows.substr(end) + "\n");
  return run_assur("audit " + file.string() + " " + options);
}

class RunProgram : public testing::TestWithParam<Program> {};

TEST_P(RunProgram, IsJudgedByWhatItComputes) {
  const Program& program = GetParam();
  if (std::string(program.file).ends_with(".m") &&
      std::system("octave-cli --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "octave-cli is not installed";
  }
  const TemporaryDirectory directory;
  const CommandResult result = audited(directory, program);
  EXPECT_EQ(result.status, program.status) << result.output << result.messages;
  const std::string& said = program.status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(program.answer), std::string::npos)
      << "expected: " << program.answer << "\nfound:    " << said;
  if (program.status == 2) {
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

#define FRAME "f1 f2 by theta s\n"
#define VECTORS                                                            \
  "#include <cmath>\n#include <vector>\nusing std::sin; using std::cos;\n" \
  "using Rows = std::vector<std::vector<double>>;\n"
#define CALL FRAME "  result f(l, theta)"
#define CPP(body) VECTORS "Rows f(double l, double theta) { " body " }"

INSTANTIATE_TEST_SUITE_P(
    Cpp, RunProgram,
    testing::Values(
        Program{"Right", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 0,
                "all 4 agree, computed at 40 assembled rational points: evidence, not proof"},
        Program{"Looped", "a.cpp",
                CPP("Rows J(2, std::vector<double>(2)); double c[] = {-sin(theta), cos(theta)};"
                    "for (int i = 0; i < 2; ++i) { J[i][0] = l*c[i]; J[i][1] = i - 1; } return J;"),
                CALL, 0, "all 4 agree"},
        Program{"ByMacro", "a.cpp",
                VECTORS "#define SQ(x) ((x)*(x))\ntemplate <class T> Rows f(T l, T theta) { return "
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
                "#include <array>\nstd::array<double, 4> f(double, double) { return {}; }", CALL, 2,
                "say, for instance, 'entry result[i*2 + j]'"},
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
        Program{"TotalDerivatives", "a.cpp",
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
        Program{
            "Talks", "a.cpp",
            "#include <cstdio>\n" CPP("std::puts(\"1 2 3 nan\\n%s\"); return {{-l*sin(theta), -1}, "
                                      "{l*cos(theta), 0}};"),
            CALL, 0, "all 4 agree"},
        Program{"Alone", "a.cpp",
                "#include <cstdlib>\n" CPP("if (std::getenv(\"ASSUR_SECRET\")) std::abort();"
                                           "return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"),
                CALL, 0, "all 4 agree"}),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Slips, RunProgram,
    testing::Values(
        Program{"Sign", "a.cpp", CPP("return {{l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 1,
                "differs by sign"},
        Program{"Exchanged", "a.cpp", CPP("return {{l*cos(theta), -1}, {-l*sin(theta), 0}};"), CALL,
                1, "it is exchanged with (2,1)"},
        Program{"Degrees", "a.cpp",
                CPP("theta *= 3.14159265358979323846/180; return {{-l*sin(theta), -1}, "
                    "{l*cos(theta), 0}};"),
                CALL, 1, "theta is taken as degrees where it is radians"},
        Program{"WrongRow", "a.cpp", CPP("return {{l*cos(theta), 0}, {l*cos(theta), 0}};"), CALL, 1,
                "row 1 is what row 2 should be"},
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
        Program{"KeptFromTheFirstCall", "a.cpp",
                CPP("static double c = cos(theta); return {{-l*sin(theta), -1}, {l*c, 0}};"), CALL,
                1, "3 of 4 agree"},
        Program{"KeptFromTheLastCall", "a.cpp",
                CPP("static double last = 0; double c = last; last = cos(theta); return "
                    "{{-l*sin(theta), -1}, {l*c, 0}};"),
                CALL, 1, "the same call gives another value later"},
        Program{"Pencil", "a.cpp", CPP("return {{l*sin(theta), -1}, {l*cos(theta), 0}};"), CALL, 1,
                "at          l = 2, (cos, sin)(theta) = (4/5, 3/5)"}),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Unusable, RunProgram,
    testing::Values(
        Program{"Crashes", "a.cpp", CPP("*(volatile int*)0 = 1; return {};"), CALL, 2,
                "mine.audit:7:10: a.cpp cannot be audited: ended by a signal: Segmentation fault "
                "(SIGSEGV), at point 1"},
        Program{"Throws", "a.cpp", CPP("throw 1;"), CALL, 2, "Aborted (SIGABRT), at point 1"},
        Program{"Hangs", "a.cpp", CPP("for (volatile int i = 0;; i = i) {} return {};"), CALL, 2,
                "did not end within 2 s, at point 1"},
        Program{"Sleeps", "a.cpp", "#include <unistd.h>\n" CPP("sleep(100); return {};"), CALL, 2,
                "did not end within 2 s, at point 1"},
        Program{
            "Forks", "a.cpp",
            "#include <unistd.h>\n" CPP("if (fork() == 0) { sleep(100); } _exit(0); return {};"),
            CALL, 2, "ended with status 0 after 0 of 41 points"},
        Program{"Eats", "a.cpp",
                CPP("std::vector<double>* all = new std::vector<double>(std::size_t{1} << 31, 1.0);"
                    "return {{(*all)[5], 0}, {0, 0}};"),
                CALL, 2, "(SIGABRT), at point 1"},
        Program{"Exits", "a.cpp", "#include <cstdlib>\n" CPP("std::exit(7);"), CALL, 2,
                "ended with status 7 after 0 of 41 points"},
        Program{"NoNumber", "a.cpp", CPP("return {{-l*sin(theta), -1}, {std::sqrt(-l - 4), 0}};"),
                CALL, 2, "entry (2,1) is not a number, at point 1"},
        Program{"Infinite", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l, 1/(l-l)}};"), CALL, 2,
                "entry (2,2) is infinite, at point 1"},
        Program{"WrongSize", "a.cpp", CPP("return {{1, 2, 3}, {4, 5, 6}};"), CALL, 2,
                "the result is 2 by 3, not 2 by 2, at point 1"},
        Program{"Empty", "a.cpp", CPP("return {};"), CALL, 2, "the result is 0 by 0, not 2 by 2"},
        Program{"DoesNotCompile", "a.cpp", CPP("return lamda;"), CALL, 2, "does not compile: "},
        Program{"NoSuchFunction", "a.cpp", CPP("return {};"), FRAME "  result g(l)", 2,
                "'g' was not declared in this scope"},
        Program{"NoCompiler", "a.cpp", CPP("return {};"), CALL "\n  compiler no-such-compiler", 2,
                "'no-such-compiler' cannot be started here, so nothing was run"},
        Program{"UnknownRow", "a.cpp", "", FRAME "  reslt f(l)", 2,
                "mine.audit:7:3: no row 'reslt' (did you mean 'result'?)"},
        Program{"NoResult", "a.cpp", "", FRAME "  points 5", 2, "say what is called"},
        Program{"NoLanguage", "a.txt", "", CALL, 2, "its language cannot be told"},
        Program{"Nowhere", "a.cpp", CPP("return {};"), CALL "\n  where -l^2", 2,
                "no points are found"},
        Program{"WrongCondition", "a.cpp", CPP("return {};"), CALL "\n  where lenth", 2,
                "mine.audit:8:9: no symbol named 'lenth'"}),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

#define PYTHON(body) "import math\nfrom math import sin, cos\ndef f(l, theta):\n    " body "\n"
INSTANTIATE_TEST_SUITE_P(
    OtherLanguages, RunProgram,
    testing::Values(
        Program{"C", "a.c",
                "#include <math.h>\nstatic double J[2][2];\nvoid f(double l, double t) { J[0][0] = "
                "-l*sin(t); J[0][1] = -1; J[1][0] = l*cos(t); }",
                FRAME "  before f(l, theta)\n  result J", 0, "all 4 agree"},
        Program{"CFlat", "a.c",
                "#include <math.h>\nvoid f(double l, double t, double* J) { J[0] = l*sin(t); "
                "J[1] = -1; J[2] = l*cos(t); J[3] = 0; }",
                FRAME "  before double J[4]; f(l, theta, J)\n  result J\n  entry result[2*i + j]",
                1, "the sign is wrong"},
        Program{"Python", "a.py", PYTHON("return [[-l*sin(theta), -1], (l*cos(theta), 0)]"), CALL,
                0, "all 4 agree"},
        Program{"PythonWrong", "a.py", PYTHON("return [[-l*sin(theta), 1], [l*cos(theta), 0]]"),
                CALL, 1, "(1,2) d f1/d s: differs by sign"},
        Program{"PythonPrints", "a.py",
                PYTHON("print('nan'); return [[-l*sin(theta), -1], [l*cos(theta), 0]]"), CALL, 0,
                "all 4 agree"},
        Program{"PythonBefore", "a.py",
                "from math import *\nclass C:\n  def __init__(self, l): self.l = l\n"
                "def f(c, J, t):\n  J += [-c.l*sin(t), -1, c.l*cos(t), 0]\n",
                FRAME "  before J = []; c = C(l)\n  before f(c, J, theta)\n  result J\n"
                      "  entry result[2*i + j]",
                0, "all 4 agree"},
        Program{"PythonFlat", "a.py", PYTHON("return [1, 2, 3, 4]"), CALL, 2,
                "say, for instance, 'entry result[i*2 + j]'"},
        Program{"PythonRaises", "a.py", PYTHON("return math.sqrt(-5 - l)"), CALL, 2,
                "a.py cannot be audited: ended with ValueError: "},
        Program{"PythonExits", "a.py", PYTHON("raise SystemExit(0)"), CALL, 2, "SystemExit: 0"},
        Program{"PythonHangs", "a.py", PYTHON("while True: pass"), CALL, 2,
                "did not end within 2 s"},
        Program{"PythonText", "a.py", PYTHON("return [['a', 1], [2, 3]]"), CALL, 2,
                "ended with ValueError: could not convert string to float"},
        Program{"PythonNoNumber", "a.py", PYTHON("return [[math.nan, 1], [2, 3]]"), CALL, 2,
                "entry (1,1) is not a number"},
        Program{"PythonWrongSize", "a.py", PYTHON("return [[1, 2]]"), CALL, 2,
                "the result is 1 by 2, not 2 by 2"},
        Program{"PythonSyntax", "a.py", "def f(l:\n", CALL, 2, "ended with SyntaxError"},
        Program{"Octave", "f.m",
                "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0];\nend\n", CALL,
                0, "all 4 agree"},
        Program{"OctaveWrong", "f.m",
                "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0]';\nend\n", CALL,
                1, "the matrix is transposed"}),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

const Program right = {"Right", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"),
                       CALL,    0,       ""};

TEST(RunAudit, RunsNothingUnlessAsked) {
  const TemporaryDirectory directory;
  Program program = right;
  const std::string mark = (directory.path() / "mark").string();
  const std::string text =
      "#include <cstdio>\nstatic int x = (std::fopen(\"" + mark + "\", \"w\"), 1);\n" + right.text;
  program.text = text.c_str();
  const CommandResult result = audited(directory, program, "");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("nothing is run without --run"), std::string::npos);
  EXPECT_FALSE(fs::exists(mark));
  EXPECT_EQ(audited(directory, program).status, 0);
  EXPECT_TRUE(fs::exists(mark));
}

TEST(RunAudit, LeavesNothingBehind) {
  const auto directories = [] {
    std::ptrdiff_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
      count += entry.path().filename().string().starts_with("assur-audit-") ? 1 : 0;
    }
    return count;
  };
  const TemporaryDirectory directory;
  const std::ptrdiff_t before = directories();
  EXPECT_EQ(audited(directory, right).status, 0);
  EXPECT_LE(directories(), before + 8);  // other tests may run at the same time
  for (const auto& entry : fs::directory_iterator(directory.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "a.cpp" || name == "mine.audit") << name;
  }
}

TEST(RunAudit, AnswersTheSameBesideOthers) {
  const TemporaryDirectory directory;
  directory.write("a.py", PYTHON("return [[l*sin(theta), -1], [l*cos(theta), 0]]"));
  const std::string one = "printed run J a.py of f1 f2 by theta s\n  result f(l, theta)\n";
  const std::string others =
      "printed equation (1) : rate(s) = r*rate(phi)\nprinted matrix (2) of theta by r l\n  r, l\n";
  const auto answer = [&](const std::string& text) {
    const std::string file = directory.write("b.audit", slider_crank + text).string();
    const std::string output = run_assur("audit --run " + file).output;
    const std::size_t from = std::min(output.find("run J"), output.size());
    std::string own = output.substr(from, output.find("\n", output.find("note", from)) - from);
    for (std::size_t at = own.find(" (/"); at != std::string::npos; at = own.find(" (/")) {
      own.erase(at, own.find('\n', at) - at);  // the place, which does differ
    }
    return own;
  };
  const std::string alone = answer(one);
  EXPECT_NE(alone.find("differs by sign"), std::string::npos) << alone;
  EXPECT_EQ(answer(others + one), alone);
  EXPECT_EQ(answer(one + others), alone);
}

TEST(RunAudit, TheExampleIsFoundWrong) {
  const std::string eigen = ASSUR_EIGEN;
  const std::string example = std::string(ASSUR_EXAMPLES) + "/audit/running/shaper.audit";
  const CommandResult result = run_assur("audit " + example + " --run --flags \"-I" + eigen + "\"");
  EXPECT_EQ(result.status, 1) << result.messages;
  EXPECT_NE(result.output.find("14 of 16 agree"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("it is exchanged with (2,2)"), std::string::npos) << result.output;
}

TEST(AuditOutput, QuotesTheLineWithAMark) {
  const TemporaryDirectory directory;
  directory.write("a.cpp",
                  "void f(M& J) {\n\tJ(0, 0) = l*sin(theta); // \xfc\n"
                  "  J(0, 1) = -1; J(1, 0) = l*cos(theta);\n}\n");
  const fs::path file =
      directory.write("a.audit", slider_crank + "printed code J a.cpp J of f1 f2 by theta s\n");
  const CommandResult text = run_assur("audit " + file.string());
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.output.find("    \tJ(0, 0) = l*sin(theta); // \xfc\n    \t          ^\n"),
            std::string::npos)
      << text.output;
  const CommandResult github = run_assur("audit --format github " + file.string());
  EXPECT_EQ(github.status, 1);
  EXPECT_TRUE(github.output.starts_with(
      "::error file=" + (directory.path() / "a.cpp").string() +
      ",line=2,col=12,title=code J (a.cpp) (1%2C1) d f1/d theta::differs by sign%0Aprinted: "
      "l*sin(theta)%0Aderived: -l*sin(theta)%0A"))
      << github.output;
  EXPECT_EQ(run_assur("audit --format json " + file.string()).status, 1);
}

TEST(AuditOutput, AFileInAnotherEncodingIsOneLine) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("a.audit", "source G\xf6ttingen\n" + slider_crank);
  for (const char* format : {"text", "markdown", "json", "github"}) {
    const CommandResult result =
        run_assur("audit --format " + std::string(format) + " " + file.string());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.messages,
              "error: " + file.string() + ": byte 8 is not UTF-8; save the file as UTF-8\n");
  }
}

}  // namespace
}  // namespace assur::test::run_test
