// Law: code that looks right but computes something else is refused at its place, or called wrong;
// similar code that is right is read.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/command.hpp"

namespace assur::test::code_traps_test {
namespace {

namespace fs = std::filesystem;

/// Code in a file that fills J = df/d(q_0, s), f1 = l*cos(q_0) - s^2/2, f2 = l*sin(q_0), and the
/// status and the answer of its audit.
struct Trap {
  const char* name;
  const char* file;
  std::string text;
  int status;
  const char* answer;
};

void PrintTo(const Trap& trap, std::ostream* out) { *out << trap.name; }

class CodeTraps : public testing::TestWithParam<Trap> {};

TEST_P(CodeTraps, AreSeen) {
  const Trap& trap = GetParam();
  const TemporaryDirectory directory;
  const fs::path file =
      directory.write("mine.audit",
                      "length l s\nangle q_0\nunknown q_0 s\nlet p_l = l\nlet q_1 = s\n"
                      "closure f1 = l*cos(q_0) - s^2/2\nclosure f2 = l*sin(q_0)\nprinted code J " +
                          std::string(trap.file) + " J of f1 f2 by q_0 s\n");
  directory.write(trap.file, trap.text);
  const CommandResult result = run_assur("audit " + file.string());
  EXPECT_EQ(result.status, trap.status) << result.output << result.messages;
  const std::string& said = trap.status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(trap.answer), std::string::npos)
      << "expected: " << trap.answer << "\nfound:    " << said;
  if (trap.status == 2) {
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

const std::string rest = "J(0, 1) = -s; J(1, 0) = l*cos(q_0); ";
const std::string right = "J(0, 0) = -l*sin(q_0); " + rest + "J(1, 1) = 0;";

std::string body(const std::string& text) { return "void f(M& J, double l) {\n" + text + "\n}\n"; }
std::string head(const std::string& parameters, const std::string& text) {
  return "void f(M& J, " + parameters + ") {\n" + text + "\n}\n";
}
std::string tenth(const std::string& declared) {
  return body(declared + " J(0, 0) = -l*sin(q_0)*k*10; " + rest + "J(1, 1) = 0;");
}

constexpr const char* agree = "all 4 agree";
constexpr const char* type = "its type does not keep every number as it is; write double";
constexpr const char* size = "J has another size here, and is audited as 2 by 2";

/// Numbers that the compiler rounds or wraps round.
INSTANTIATE_TEST_SUITE_P(
    Numbers, CodeTraps,
    testing::Values(
        Trap{"Float", "a.cpp", tenth("const float k = 0.1;"), 2, "'k' cannot be read: its type"},
        Trap{"FloatLiteral", "a.cpp", tenth("auto k = 0.1f;"), 1, "3 of 4 agree"},
        Trap{"FloatAlias", "a.cpp", tenth("using Scalar = float; Scalar k = 0.1;"), 2, type},
        Trap{"FloatSetLater", "a.cpp", tenth("float k; k = 0.1;"), 2, type},
        Trap{"FloatParameterSet", "a.cpp",
             head("float k", "k = 0.1; J(0, 0) = -l*sin(q_0)*k*10;" + rest), 2, type},
        Trap{"FloatElementSet", "a.cpp",
             body("Eigen::Vector2f k; k(0) = 0.1; J(0, 0) = -l*sin(q_0)*k(0)*10;" + rest), 2, type},
        Trap{"FloatNameInAType", "a.cpp",
             "struct N { using Scalar = float; };\n" + tenth("N::Scalar k = 0.1;"), 2,
             "a type that is more than a list of members"},
        Trap{"ElementSet", "a.cpp",
             body("Eigen::Vector2d k; k(0) = 2; J(0, 0) = -l*sin(q_0)*k(0)/2;" + rest), 0, agree},
        Trap{"FloatMatrix", "a.cpp", "void f(Eigen::Matrix2f& J) {" + right + "}", 2,
             "J holds numbers that do not keep every value"},
        Trap{"FloatParameter", "a.cpp", head("float l", right), 2, type},
        Trap{"FloatMember", "a.cpp",
             "struct P { float l; };\n" + head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest), 2,
             "'p.l' cannot be read: its type"},
        Trap{"WholeMember", "a.cpp",
             "struct P { int l; };\n" + head("const P& p", "J(0, 0) = -p.l/2*2*sin(q_0);" + rest),
             2, "'p.l' cannot be read: its type"},
        Trap{"WholeElement", "a.cpp",
             head("double l, const int q[2]",
                  "J(0, 0) = -l*sin(q_0); J(0, 1) = -q[1]/2*2; J(1, 0) = l*cos(q_0);"),
             2, "'q[1]' cannot be read: its type holds whole numbers alone; write double"},
        Trap{"WholeParameter", "a.cpp", head("int l, double s", right), 2,
             "'l' cannot be read: its type holds whole numbers alone; write double"},
        Trap{"ParameterOfUnknownType", "a.cpp", head("Angle l, double s", right), 2,
             "'l' cannot be read: its type is not known; write double"},
        Trap{"InitialisedByItself", "a.cpp", tenth("const double k = k;"), 2,
             "'k' cannot be read: its first value reads the variable itself"},
        Trap{"InitialisedByAMember", "a.cpp",
             "struct P { double l; };\nvoid f(M& J, const P& p) { const double l = p.l; " + right +
                 "}",
             0, agree},
        Trap{"ParameterAsAnElement", "a.m",
             "function J = f(l, s, q_0)\nl(1) = 2;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n",
             2, "'l[1]' may be 'l' itself"},
        Trap{"PartsByName", "a.cpp",
             head("Eigen::VectorXd q", "q.head(1) = 2*q.head(1); J(0, 0) = -q(0)*sin(q_0);" + rest),
             2, "'q.head' may be another name of a value"},
        Trap{"ElementByName", "a.cpp",
             head("Eigen::VectorXd q", "q.coeffRef(0) = 2; J(0, 0) = -q(0)*sin(q_0);" + rest), 2,
             "'q.coeffRef' may be another name of a value"},
        Trap{"ScalarAsAnElement", "a.m", "k = l;\nk(1) = 2*k;\nJ = [-k*sin(q_0), -s; 0, 0];\n", 2,
             "'k[1]' may be 'k' itself"},
        Trap{"MemberAsAnElement", "a.m", "p.x(1) = 2;\nJ = [-p.x*sin(q_0), -s; 0, 0];\n", 2,
             "'p.x[1]' may be another name of a value"},
        Trap{"OneAndTwoIndices", "a.m",
             "k(2, 1) = l;\nk(2) = 2;\nJ = [-k(2, 1)*sin(q_0), -s; 0, 0];\n", 2,
             "may be one value"},
        Trap{"WholeOfATemplate", "a.cpp",
             "template <int l> " + head("double s", "J(0, 0) = -l/2*2*sin(q_0);" + rest), 2,
             "the types of a template are not known here"},
        Trap{"WholeAlias", "a.cpp", tenth("using Real = int; Real k = 0.1;"), 2,
             "its value is rounded to a whole number"},
        Trap{"TypeFromElsewhere", "a.cpp", tenth("Angle k = 0.1;"), 2,
             "its type is not known; write double"},
        Trap{"Unsigned", "a.cpp", body("J(0, 0) = l*(1 - 2u) + l;" + rest), 2,
             "a number of type unsigned"},
        Trap{"UnsignedVariable", "a.cpp", tenth("unsigned k = 1;"), 2, type},
        Trap{"Bool", "a.cpp", tenth("bool k = 2;"), 2, type},
        Trap{"TooLarge", "a.cpp", tenth("int k = 3000000000;"), 2,
             "whole numbers beyond 2147483647 wrap round"},
        Trap{"WrapsRound", "a.cpp", body("J(0, 0) = 100000*100000*l;" + rest), 2,
             "whole numbers beyond 2147483647 wrap round"},
        Trap{"NoSize", "a.cpp", body("J(0, 0) = 1e999;" + right), 0, agree},
        Trap{"Octal", "a.cpp", body("J(00, 0) = -l*sin(q_0);" + rest), 2, "cannot read this use"},
        Trap{"LongDouble", "a.cpp", tenth("long double k = 0.1;"), 0, agree},
        Trap{"OwnReal", "a.cpp",
             "using Real = double;\n" + head("Real l",
                                             "const Real c = cos(q_0); J(0, 0) = -l*sin(q_0);"
                                             "J(0, 1) = -s; J(1, 0) = l*c;"),
             0, agree},
        Trap{"UnusedFloat", "a.cpp", head("float w, bool up", "float v = w;" + right), 0, agree}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// Other ways to reach the matrix, and calls that may use them.
INSTANTIATE_TEST_SUITE_P(
    Ways, CodeTraps,
    testing::Values(
        Trap{"SecondReference", "a.cpp", head("M& K", right + "\nK(0, 0) = 7;"), 2,
             "a.cpp:3:1: what is set through 'K' may be J"},
        Trap{"PointerGiven", "a.cpp", head("double* K", right + "\nK[0] = 7;"), 2,
             "a.cpp:3:1: what is set through 'K' may be J"},
        Trap{"ModelGiven", "a.cpp", head("Model& K", right + "\nK.J(0, 0) = 7;"), 2,
             "a.cpp:3:1: what is set through 'K' may be J"},
        Trap{"ViewGiven", "a.cpp", head("View K", right + "\nK.m = 7;"), 2,
             "a.cpp:3:1: what is set through 'K' may be J"},
        Trap{"GlobalView", "a.cpp", "View K;\n" + body(right + "\nK.m = 7;"), 2,
             "a.cpp:4:1: 'K' is set, but it is not declared"},
        Trap{"MemberSet", "a.cpp", "void M::f() {" + right + "\nalias(0, 0) = 7; }", 2,
             "a.cpp:2:1: 'alias' is set, but it is not declared"},
        Trap{"ViewByAuto", "a.cpp", body(right + "\nauto K = view; K(0, 0) = 7;"), 2,
             "a.cpp:3:16: what 'K' does cannot be followed"},
        Trap{"SineGiven", "a.cpp", head("std::function<double(double)> sin", right), 2,
             "a.cpp:1:44: 'sin' is given another meaning"},
        Trap{"SinePointer", "a.cpp", head("double (*sin)(double)", right), 2,
             "a.cpp:1:23: 'sin' is given another meaning"},
        Trap{"SineOfTheFile", "a.cpp", "constexpr auto cos = sinf;\n" + body(right), 2,
             "a.cpp:1:16: 'cos' is given another meaning"},
        Trap{"SineOfTheFileThatMayChange", "a.cpp",
             "auto cos = [](double x) { return x; };\n" + body(right), 2,
             "a.cpp:1:6: 'cos' is given another meaning"},
        Trap{"ViewInBraces", "a.cpp", body(right + "\nView v{J, 2}; v.m(0, 0) = 7;"), 2,
             "a.cpp:3:8: cannot read this use of J"},
        Trap{"ViewInBrackets", "a.cpp", body(right + "\nMap v(J.data(), 2); v(0, 0) = 7;"), 2,
             "a.cpp:3:7: cannot read this use of J"},
        Trap{"PassedOnInAList", "a.cpp", body(right + "\ndouble t[2] = {fix(J), 1};"), 2,
             "a.cpp:3:20: cannot read this use of J"},
        Trap{"CalledInAList", "a.cpp",
             "void M::f() {" + right + "\ndouble t[2][2]{{scale(l), 1}, 2}; }", 2,
             "a.cpp:2:17: what 'scale' does"},
        Trap{"CalledWithANumber", "a.cpp", "void M::f() {" + right + "\ndouble t = scale(2); }", 2,
             "a.cpp:2:12: what 'scale' does"},
        Trap{"CalledAndCompared", "a.cpp",
             "void M::f() {" + right + "\nbool t = scale(l) > 0 ? 1 : 2; }", 2,
             "a.cpp:2:10: what 'scale' does"},
        Trap{"CalledInASum", "a.cpp", "void M::f() {" + right + "double t;\nt += scale(2); }", 2,
             "a.cpp:2:6: what 'scale' does"},
        Trap{"TemplateCalled", "a.cpp", "void M::f() {" + right + "\ndouble t = scale<2>(); }", 2,
             "a.cpp:2:17: a call of a template's function"},
        Trap{"FunctionLikeAnElement", "a.cpp",
             "double q(int i);\n" + body("J(0, 0) = -l*sin(q_0); J(0, 1) = -q(1);"), 2,
             "what 'q' does"},
        Trap{"OwnZero", "a.cpp", "M Zero() { return 1; }\n" + body("J = m::Zero();" + right), 2,
             "a.cpp:1:3: a function 'Zero' of your own"},
        Trap{"SecondInItsLine", "a.cpp", "void f() { Eigen::Matrix2d K, J;" + right + " }", 2,
             "J is filled here and never"},
        Trap{"Attributes", "a.cpp",
             "const double l = 3;\n" + head("[[maybe_unused]] double l, const V& q", right), 0,
             agree}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// Lines that the preprocessor changes, or hides.
INSTANTIATE_TEST_SUITE_P(
    Preprocessor, CodeTraps,
    testing::Values(
        Trap{"HeaderBeforeAComment", "a.cpp", "#include \"mine.hpp\" // <cmath>\n" + body(right), 2,
             "a.cpp:1:1: a header of your own"},
        Trap{"HeaderBesideEigen", "a.cpp", "#include <Eigen/../mine.hpp>\n" + body(right), 2,
             "a.cpp:1:1: a header of your own"},
        Trap{"CommentFromADirective", "a.cpp", "#include <cmath> /*\n" + body(right) + "// */\n", 2,
             "a.cpp:1:1: a comment that begins here"},
        Trap{"GuardThatReplaces", "a.cpp", "#ifndef cos\n#define cos\n" + body(right) + "#endif\n",
             2, "a.cpp:1:1: '#ifndef cos' may change"},
        Trap{"GuardThatIsDefined", "a.cpp",
             "#ifndef __cplusplus\n#define __cplusplus\n" + body(right) + "#endif\n", 2,
             "a.cpp:1:1: '#ifndef __cplusplus' may change"},
        Trap{"CommentEndsOverTwoLines", "a.cpp", body(right + "\n/* *\\\n/ J(0, 0) = 7; /* */"), 2,
             "a.cpp:3:1: a comment that ends"},
        Trap{"Enumeration", "a.cpp", "enum { s = 2 };\n" + body(right), 2,
             "a.cpp:1:8: 's' cannot be read: it is a constant of an enumeration"},
        Trap{"Guarded", "a.hpp",
             "#ifndef A_HPP_\r\n#define A_HPP_\r\n#include<cmath> // sines\r\n#include <vector> "
             "/* x */\r\n" +
                 body("J(0, 0) = -l \\\n *sin(q_0); /* * \\ */" + rest) + "#endif /* A_HPP_ */\r\n",
             0, agree}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// Matrices of another size, and entries without values.
INSTANTIATE_TEST_SUITE_P(
    Sizes, CodeTraps,
    testing::Values(
        Trap{"Larger", "a.cpp",
             "M f() { Eigen::Matrix3d J = Eigen::Matrix3d::Zero();" + right + "return J; }", 2,
             size},
        Trap{"LargerWhenMade", "a.cpp",
             "M f() { Eigen::MatrixXd J(3, 3); J.setZero();" + right + "return J; }", 2, size},
        Trap{"LargerWhenCleared", "a.cpp", body("J.setZero(3, 3);" + right), 2, size},
        Trap{"LargerWhenZero", "a.cpp", body("J = Eigen::MatrixXd::Zero(3, 3);" + right), 2, size},
        Trap{"LargerWhenGiven", "a.cpp", "void f(double (&J)[2][3]) {" + right + "}", 2, size},
        Trap{"LargerTemplate", "a.cpp", "void f(Eigen::Matrix<double, 2, 3>& J) {" + right + "}", 2,
             size},
        Trap{"LargerList", "a.cpp",
             "void f(std::array<std::array<double, 2>, 3>& J) {" + right + "}", 2, size},
        Trap{"BeyondNumbers", "a.cpp", "void f(double J[99999999999999999999][2]) {" + right + "}",
             2, size},
        Trap{"NotSetByBraces", "a.cpp",
             "M f() { Eigen::Matrix2d J{}; J(0, 0) = -l*sin(q_0);" + rest + "return J; }", 2,
             "row 2, column 2 of J is never assigned"},
        Trap{"NotSetInItsLine", "a.cpp",
             "M f() { Eigen::Matrix2d K, J; J(0, 0) = -l*sin(q_0);" + rest + "return J; }", 2,
             "row 2, column 2 of J is never assigned"},
        Trap{"Template", "a.cpp",
             "template <class S> void f(S l) { Eigen::Matrix<S, 2, 2> J = "
             "Eigen::Matrix<S, 2, 2>::Zero();" +
                 right + "return J; }",
             2, "a.cpp:1:25: the types of a template are not known here"},
        Trap{"Array", "a.cpp",
             "A f() { std::array<std::array<double, 2>, 2> J{}; J[0][0] = -l*sin(q_0);"
             "J[0][1] = -s; J[1][0] = l*cos(q_0); return J; }",
             0, agree},
        Trap{"MatlabLarger", "a.m",
             "function J = f(l, q_0, s)\nJ = zeros(3);\n" + right + "\nend\n", 2,
             "this entry is outside"},
        Trap{"OtherLanguage", "a.py", "J[0][0] = 1", 2, "'.py' is neither; audit it by running"}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

std::string matlab(const std::string& text) {
  return "function J = f(l, s, q_0)\n" + text + "J(1, 2) = -s;\nJ(2, 1) = l*cos(q_0);\nend\n";
}

INSTANTIATE_TEST_SUITE_P(
    Matlab, CodeTraps,
    testing::Values(
        Trap{"NestedComments", "a.m",
             matlab("J = zeros(2);\n%{\n%{\n%}\nJ(1, 1) = -l*sin(q_0);\n%}\n"), 1, "3 of 4 agree"},
        Trap{"CarriageReturn", "a.m", matlab("% so\rJ(1, 1) = 7;\nJ(1, 1) = -l*sin(q_0);\n"), 2,
             "a.m:2:5: a line that ends with a carriage return alone"},
        Trap{"LargerSquare", "a.m", matlab("J = zeros(3);\nJ(1, 1) = -l*sin(q_0);\n"), 2,
             "J is 3 by 3 in the end, and is audited as 2 by 2"},
        Trap{"BeyondAll", "a.m", matlab("J = zeros(99999999999999999999);\n"), 2, "in the end"},
        Trap{"Smaller", "a.m", "function J = f(l, q_0)\nJ(1, 1) = -l*sin(q_0);\nend\n", 2,
             "J is 1 by 1 in the end, and is audited as 2 by 2"},
        Trap{"SineGiven", "a.m", "function J = f(l, sin)\nJ(1, 1) = 0;\nend\n", 2,
             "a.m:1:19: 'sin' is given another meaning"},
        Trap{"OtherComments", "a.m", matlab("J(1, 1) = 1; // J(1, 1) = 0;\n"), 2,
             "a.m:2:14: '//' begins no comment in MATLAB"},
        Trap{"Grows", "a.m", matlab("J(1, 1) = -l*sin(q_0); % as http://a.b\n"), 0, agree}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::code_traps_test
