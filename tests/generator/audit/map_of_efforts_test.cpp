// Law: a map of efforts is judged by the transpose of the map of velocities, in print, in code that
// is read and in programs that run, and the usual mistakes are named.
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace assur::test::map_of_efforts_test {
namespace {

/// The tip of an arm of two links.
const std::string arm =
    "length a b\nangle q p\nmoving q p\n"
    "let x = a*cos(q) + b*cos(q + p)\nlet y = a*sin(q) + b*sin(q + p)\n";

struct Printed {
  const char* name;
  const char* statement;
  int status;
  const char* answer;
};

void PrintTo(const Printed& printed, std::ostream* out) { *out << printed.name; }

class MapOfEfforts : public testing::TestWithParam<Printed> {};

TEST_P(MapOfEfforts, IsAnswered) {
  const TemporaryDirectory directory;
  directory.write("arm.cpp",
                  "#include <cmath>\nusing std::sin; using std::cos;\n"
                  "void torques(double a, double b, double q, double p, double T[2][2]) {\n"
                  "  T[0][0] = -a*sin(q) - b*sin(q + p); T[0][1] = a*cos(q) + b*cos(q + p);\n"
                  "  T[1][0] = -b*sin(q + p); T[1][1] = b*cos(q + p); }\n");
  directory.write("arm.py",
                  "from math import sin, cos\n"
                  "def tip(a, b, q, p):\n"
                  "    return [a*cos(q) + b*cos(q + p), a*sin(q) + b*sin(q + p)]\n"
                  "def velocities(a, b, q, p):\n"
                  "    return [[-a*sin(q) - b*sin(q + p), -b*sin(q + p)],\n"
                  "            [a*cos(q) + b*cos(q + p), b*cos(q + p)]]\n"
                  "def torques(a, b, q, p):\n"
                  "    return list(zip(*velocities(a, b, q, p)))\n");
  const auto file = directory.write("arm.audit", arm + GetParam().statement + "\n");
  const CommandResult result = run_assur("audit " + file.string() + " --run");
  EXPECT_EQ(result.status, GetParam().status) << result.output << result.messages;
  const std::string& said = GetParam().status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(GetParam().answer), std::string::npos)
      << "expected: " << GetParam().answer << "\nfound:    " << said;
  EXPECT_TRUE(GetParam().status != 1 || said.find("    at ") != std::string::npos)
      << "no counterexample: " << said;
}

#define VELOCITIES                              \
  "\n  -a*sin(q) - b*sin(q + p), -b*sin(q + p)" \
  "\n  a*cos(q) + b*cos(q + p), b*cos(q + p)"
#define EFFORTS                                           \
  "\n  -a*sin(q) - b*sin(q + p), a*cos(q) + b*cos(q + p)" \
  "\n  -b*sin(q + p), b*cos(q + p)"
#define OF " transpose of x y by q p"

INSTANTIATE_TEST_SUITE_P(
    Statements, MapOfEfforts,
    testing::Values(
        Printed{"Right", "printed matrix (1)" OF EFFORTS, 0, "in all: all 4 agree"},
        Printed{"Untransposed", "printed matrix (1)" OF VELOCITIES, 1,
                "printed is the map of velocities itself; its transpose maps efforts"},
        Printed{"Inverse",
                "printed matrix (1)" OF "\n  cos(q + p)/(a*sin(p)), sin(q + p)/(a*sin(p))"
                "\n  -(a*cos(q) + b*cos(q + p))/(a*b*sin(p)), "
                "-(a*sin(q) + b*sin(q + p))/(a*b*sin(p))",
                1, "printed is the inverse of the map of velocities"},
        Printed{"TransposedInverse",
                "printed matrix (1)" OF
                "\n  cos(q + p)/(a*sin(p)), -(a*cos(q) + b*cos(q + p))/(a*b*sin(p))"
                "\n  sin(q + p)/(a*sin(p)), -(a*sin(q) + b*sin(q + p))/(a*b*sin(p))",
                1, "the transposed inverse, which maps efforts the other way"},
        Printed{"OfOneForce",
                "printed matrix (1) transpose of y by q p\n  a*cos(q) + b*cos(q + p)\n"
                "  b*cos(q + p)",
                0, "in all: all 2 agree"},
        Printed{"OfOneForceInARow",
                "printed matrix (1) transpose of y by q p\n  a*cos(q) + b*cos(q + p), b*cos(q + p)",
                2, "expected 2 rows, found 1"},
        Printed{"Code", "printed code (1) arm.cpp T" OF, 0, "in all: all 4 agree"},
        Printed{"CodeOfVelocities", "printed code (1) arm.cpp T of x y by q p", 1, "2 of 4 agree"},
        Printed{"Run", "printed run (1) arm.py" OF "\n  result torques(a, b, q, p)", 0,
                "in all: all 4 agree"},
        Printed{"RunUntransposed", "printed run (1) arm.py" OF "\n  result velocities(a, b, q, p)",
                1, "2 of 4 agree"},
        Printed{"OwnPosition",
                "printed run (1) arm.py transpose of u v by q p against own position\n"
                "  position tip(a, b, q, p)\n  result torques(a, b, q, p)",
                0, "in all: all 4 agree"},
        Printed{"OwnPositionUntransposed",
                "printed run (1) arm.py transpose of u v by q p against own position\n"
                "  position tip(a, b, q, p)\n  result velocities(a, b, q, p)",
                1, "2 of 4 agree"},
        Printed{"OfAList",
                "printed run (1) arm.py transpose of rate(x), rate(y)\n  result "
                "tip(a, b, q, p)",
                2, "expected 'of ROWS by COLUMNS'"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace assur::test::map_of_efforts_test
