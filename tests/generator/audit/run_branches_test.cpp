// Law: a program that solves positions is judged on all branches and at points that close, and the
// report says by itself on which branch it is right.
#include <gtest/gtest.h>

#include "command/command.hpp"

namespace assur::test::run_branches_test {
namespace {

struct Solved {
  const char* name;
  const char* audit;
  const char* python;
  int status;
  const char* answer;
};

void PrintTo(const Solved& solved, std::ostream* out) { *out << solved.name; }

class RunBranches : public testing::TestWithParam<Solved> {};

TEST_P(RunBranches, AreFoundByThemselves) {
  const TemporaryDirectory directory;
  directory.write("p.py", std::string("from math import *\n") + GetParam().python);
  const std::filesystem::path file = directory.write("p.audit", GetParam().audit);
  const CommandResult result = run_assur("audit " + file.string() + " --run");
  EXPECT_EQ(result.status, GetParam().status) << result.output << result.messages;
  EXPECT_NE(result.output.find(GetParam().answer), std::string::npos)
      << "expected: " << GetParam().answer << "\nfound:    " << result.output << result.messages;
}

#define CRANK                                        \
  "length x\nangle th ph\nunknown ph x\nmoving th\n" \
  "loop f1 f2 = polar(1, th) + polar(3, ph) - point(x, 0)\n"
#define ROOT                                       \
  "length r l x\nangle th\nunknown x\nmoving th\n" \
  "closure f1 = r*cos(th) + sqrt(l^2 - r^2*sin(th)^2) - x\n"
#define EQUAL                                    \
  "length x\nangle a b\nunknown b x\nmoving a\n" \
  "loop f1 f2 = polar(2, a) + polar(2, b) - point(x, 0)\n"
#define FOUR_BAR                               \
  "angle th t3 t4\nunknown t3 t4\nmoving th\n" \
  "loop f1 f2 = polar(1, th) + polar(5/2, t3) - polar(2, t4) - point(11/5, 0)\n"
constexpr const char* slider = "def slider(th): return cos(th) + 3*cos(asin(-sin(th)/3))\n";
constexpr const char* four_bar = R"(
def four(th):
    x, y = 2.2 - cos(th), -sin(th)
    w = x*x + y*y
    t3 = atan2(y, x) + acos((w + 2.5**2 - 2**2)/(5*sqrt(w)))
    t4 = atan2(2.5*sin(t3) - y, 2.5*cos(t3) - x)
    return t3, t4
def rates(th, w):
    t3, t4 = four(th)
    s = sin(t4 - t3)
    return [w*sin(th - t4)/(2.5*s), w*sin(th - t3)/(2*s)]
def wrong(th, w):
    t3, t4 = four(th)
    s = sin(t4 - t3)
    return [w*sin(th - t4)/(2.5*s), -w*sin(th - t3)/(2*s)]
)";

INSTANTIATE_TEST_SUITE_P(
    Python, RunBranches,
    testing::Values(
        Solved{"FixedLengths", CRANK "printed run a p.py of x\n  result slider(th)\n", slider, 1,
               "run a (p.py): agrees at 20 of 40 points, all those where cos(ph) > 0, computed at "
               "40 assembled points of 100 digits: evidence, not proof"},
        Solved{"FixedLengthsWhere",
               CRANK "printed run a p.py of x\n  result slider(th)\n  where cos(ph)\n", slider, 0,
               "run a (p.py): agrees, computed at 40 assembled points of 100 digits where"},
        Solved{"FixedLengthsWrong",
               CRANK "printed run a p.py of x\n  result slider(th) + 1e-6\n  where cos(ph)\n",
               slider, 1, "difference  1.00000"},
        Solved{"SymbolicLengths",
               "length r l x\nangle th ph\nunknown ph x\nmoving th\n"
               "loop f1 f2 = polar(r, th) + polar(l, ph) - point(x, 0)\n"
               "printed run a p.py of x, sin(ph)\n  result [f(r, l, th), -r*sin(th)/l]\n",
               "def f(r, l, th): return r*cos(th) + sqrt(l*l - r*r*sin(th)**2)\n", 1,
               "run a (p.py): 1 of 2 agree, the rest agrees at "},
        Solved{"RootInAClosure", ROOT "printed run a p.py of x by th\n  result [[f(r, l, th)]]\n",
               "def f(r, l, th): return -r*sin(th) - r*r*sin(th)*cos(th)/sqrt(l*l - "
               "r*r*sin(th)**2)\n",
               0, "run a (p.py): agrees, computed at 40 assembled "},
        Solved{"FourBar",
               FOUR_BAR "printed run a p.py of rate(t3), rate(t4)\n  result rates(th, rate_th)\n",
               four_bar, 1,
               "run a (p.py): agrees at 20 of 40 points, all those where sin(t3 - t4) < 0,"},
        Solved{"FourBarWrong",
               FOUR_BAR "printed run a p.py of rate(t3), rate(t4)\n  result wrong(th, rate_th)\n",
               four_bar, 1, "rate(t4): differs"},
        Solved{"CounterexampleHasRates",
               FOUR_BAR "printed run a p.py of rate(t4)\n  result [2*rates(th, rate_th)[1]]\n",
               four_bar, 1, ", rate(th) = "},
        Solved{"RateOfAnUnknownInACall",
               "length r l x\nangle a b\nunknown b x\nmoving a\n"
               "loop f1 f2 = polar(r, a) + polar(l, b) - point(x, 0)\n"
               "printed run v p.py of rate(x)\n  result v(r, l, a, b, rate_a, rate_b)\n",
               "def v(r, l, a, b, u, w): return -r*sin(a)*u - l*sin(b)*w\n", 0, "agrees"},
        Solved{"LargeNumbers",
               "length x\nangle a b\nunknown b x\nmoving a\n"
               "loop f1 f2 = polar(50000, a) + polar(200000, b) - point(x, 0)\n"
               "printed equation (1) : x = 50000*cos(a) + 200000*cos(b)\n",
               "", 0, "agrees"},
        Solved{"AllQuadrants",
               "angle t u0 v0 u1 v1 u2 v2\nunknown u0 v0 u1 v1 u2 v2\nmoving t\n"
               "loop f0 g0 = polar(2, t) + polar(3, u0) - polar(5/2, v0) - point(3, 0)\n"
               "loop f1 g1 = polar(2, v0) + polar(3, u1) - polar(5/2, v1) - point(3, 0)\n"
               "loop f2 g2 = polar(2, v1) + polar(3, u2) - polar(5/2, v2) - point(3, 0)\n"
               "printed equation (1) : 1 - sin(t) + cos(t) = sqrt((1 - sin(t) + cos(t))^2)\n",
               "", 1, "points, and"},
        Solved{"UnknownThatVanishes", EQUAL "printed equation (1) : x^2 - 4*x*cos(a) = 0\n", "", 0,
               "agrees"},
        Solved{"RootOfAnUnknownThatVanishes",
               EQUAL "printed equation (1) : sqrt(x) = sqrt(4*cos(a))\n", "", 1,
               "holds on one branch"},
        Solved{"ClosuresThatFactor",
               "length r x\nangle t\nunknown x\nmoving t\nclosure f = x^2 - 2*r*x*cos(t)\n"
               "printed equation (1) : x = 2*r*cos(t)\nprinted equation (2) : x^2 = 2*r*x*cos(t)\n",
               "", 1, "in all: 1 of 2 agree"}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace assur::test::run_branches_test
