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
/// A function whose first entry is right if `factor` is 1 after what is declared.
std::string times(const std::string& factor, const std::string& declared) {
  return body(declared + " J(0, 0) = -l*sin(q_0)*" + factor + "; " + rest + "J(1, 1) = 0;");
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
             "a.cpp:3:1: an assignment through 'K' may change J"},
        Trap{"PointerGiven", "a.cpp", head("double* K", right + "\nK[0] = 7;"), 2,
             "a.cpp:3:1: an assignment through 'K' may change J"},
        Trap{"ModelGiven", "a.cpp", head("Model& K", right + "\nK.J(0, 0) = 7;"), 2,
             "a.cpp:3:1: an assignment through 'K' may change J"},
        Trap{"ViewGiven", "a.cpp", head("View K", right + "\nK.m = 7;"), 2,
             "a.cpp:3:1: an assignment through 'K' may change J"},
        Trap{"GlobalView", "a.cpp", "View K;\n" + body(right + "\nK.m = 7;"), 2,
             "a.cpp:4:1: 'K' is set, but it is not declared"},
        Trap{"MemberSet", "a.cpp", "void M::f() {" + right + "\nalias(0, 0) = 7; }", 2,
             "a.cpp:2:1: 'alias' is set, but it is not declared"},
        Trap{"ViewByAuto", "a.cpp", body(right + "\nauto K = view; K(0, 0) = 7;"), 2,
             "a.cpp:3:16: the effect of 'K' is not known"},
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
             "a.cpp:2:17: the effect of 'scale'"},
        Trap{"CalledWithANumber", "a.cpp", "void M::f() {" + right + "\ndouble t = scale(2); }", 2,
             "a.cpp:2:12: the effect of 'scale'"},
        Trap{"CalledAndCompared", "a.cpp",
             "void M::f() {" + right + "\nbool t = scale(l) > 0 ? 1 : 2; }", 2,
             "a.cpp:2:10: the effect of 'scale'"},
        Trap{"CalledInASum", "a.cpp", "void M::f() {" + right + "double t;\nt += scale(2); }", 2,
             "a.cpp:2:6: the effect of 'scale'"},
        Trap{"TemplateCalled", "a.cpp", "void M::f() {" + right + "\ndouble t = scale<2>(); }", 2,
             "a.cpp:2:17: a call of a template's function"},
        Trap{"FunctionLikeAnElement", "a.cpp",
             "double q(int i);\n" + body("J(0, 0) = -l*sin(q_0); J(0, 1) = -q(1);"), 2,
             "the effect of 'q'"},
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

/// References, pointers and views by any name.
INSTANTIATE_TEST_SUITE_P(
    References, CodeTraps,
    testing::Values(
        Trap{"AliasOfAReference", "a.cpp", times("1", "using R = double&; R k = l; k = 2;"), 2,
             "a.cpp:2:22: 'k' cannot be read: its type is not known; write"},
        Trap{"TypedefOfAReference", "a.cpp", times("1", "typedef double& R; R k = l; k = 2;"), 2,
             "a.cpp:2:22: 'k' cannot be read: its type is not known; write"},
        Trap{"AliasOfAPointer", "a.cpp", times("1", "using R = double*; R k = &l; *k = 2;"), 2,
             "a.cpp:2:22: 'k' cannot be read: its type is not known; write"},
        Trap{"ReferenceByAuto", "a.cpp", times("1", "auto& k = l; k = 2;"), 2,
             "a.cpp:2:1: changes through a pointer or a reference cannot be"},
        Trap{"ForwardedReference", "a.cpp", times("1", "auto&& k = l; k = 2;"), 2,
             "a.cpp:2:1: changes through a pointer or a reference cannot be"},
        Trap{"Block", "a.cpp", body(right + "\nauto k = J.block<1, 1>(0, 0); k(0, 0) = 7;"), 2,
             "a.cpp:3:10: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"RowByAuto", "a.cpp", body(right + "\nauto k = J.row(0); k(0) = 7;"), 2,
             "a.cpp:3:10: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"MapOfTheData", "a.cpp",
             body(right + "\nEigen::Map<Eigen::Matrix2d> k(J.data()); k(0, 0) = 7;"), 2,
             "a.cpp:3:31: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"Iterator", "a.cpp", body(right + "\nauto k = J.reshaped().begin(); *k = 7;"), 2,
             "a.cpp:3:10: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"OneIndex", "a.cpp", body(right + "\nJ(0) = 7;"), 2,
             "a.cpp:3:1: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"CoefficientReference", "a.cpp", body(right + "\nJ.coeffRef(0, 0) = 7;"), 2,
             "a.cpp:3:1: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"RefGiven", "a.cpp",
             head("double l, Eigen::Ref<Eigen::VectorXd> k", right + "\nk(0) = 7;"), 2,
             "a.cpp:3:1: an assignment through 'k' may change J, or another value"},
        Trap{"SpanGiven", "a.cpp", head("double l, std::span<double> k", right + "\nk[0] = 7;"), 2,
             "a.cpp:3:1: an assignment through 'k' may change J, or another value"},
        Trap{"AliasGiven", "a.cpp",
             "using R = double&;\n" + head("double l, R k", right + "\nk = 7;"), 2,
             "a.cpp:4:1: an assignment through 'k' may change J, or another value"},
        Trap{"AutoGiven", "a.cpp", head("double l, auto k", right), 2,
             "a.cpp:1:6: the types of a template are not known here"},
        Trap{"MemberIsAReference", "a.cpp",
             "struct P { double& r; };\n" + head("double l, P k", right + "\nk.r = 7;"), 2,
             "a.cpp:4:1: an assignment through 'k' may change J, or another value"},
        Trap{"MemberIsAPointer", "a.cpp",
             "struct P { double* r; };\n" + head("double l, P k", right + "\nk.r[0] = 7;"), 2,
             "a.cpp:4:1: an assignment through 'k' may change J, or another value"},
        Trap{"ArrayGiven", "a.cpp", head("double l, double k[2]", right + "\nk[0] = 7;"), 2,
             "a.cpp:3:1: an assignment through 'k' may change J, or another value"},
        Trap{"MemberIsAnArray", "a.cpp",
             "struct P { double r[2]; };\n" + head("double l, P k", right + "\nk.r[0] = 7;"), 0,
             agree},
        Trap{"ListReadsTheMatrix", "a.cpp", body("J << -l*sin(q_0), -s, l*cos(q_0), J(0, 0)*0;"), 2,
             "a.cpp:2:35: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"Tie", "a.cpp", body(right + "\nstd::tie(J(0, 0), J(1, 1)) = pair;"), 2,
             "a.cpp:3:10: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"DestroyedLater", "a.cpp", body(right + "\nG k{J(0, 0)};"), 2,
             "a.cpp:3:5: cannot read this use of J; write J(i, j) = EXPRESSION"}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// Types that contain a known word, and types by other names.
INSTANTIATE_TEST_SUITE_P(
    Types, CodeTraps,
    testing::Values(
        Trap{"SizeOfAVector", "a.cpp", times("k", "std::vector<double>::size_type k = 1.5;"), 2,
             "a.cpp:2:32: 'k' cannot be read: its type is not known; write"},
        Trap{"IndexOfAVector", "a.cpp", times("k", "Eigen::VectorXd::Index k = 1.5;"), 2,
             "a.cpp:2:24: 'k' cannot be read: its type is not known; write"},
        Trap{"PairWithAWhole", "a.cpp", times("k.first", "std::pair<int, double> k{1.5, 1.5};"), 2,
             "a.cpp:2:24: 'k' cannot be read: its type is not known; write"},
        Trap{"Conditional", "a.cpp", times("k", "std::conditional_t<true, int, double> k = 1.5;"),
             2, "a.cpp:2:39: 'k' cannot be read: its type is not known; write"},
        Trap{"AliasTemplate", "a.cpp",
             "template <class T> using V = int;\n" + times("k", "V<double> k = 1.5;"), 2,
             "a.cpp:1:20: this template cannot be read"},
        Trap{"Decltype", "a.cpp", times("k", "decltype(1) k = 1.5;"), 2,
             "a.cpp:2:1: 'decltype' is set, but it is not declared in this"},
        Trap{"ArrayOfEigen", "a.cpp", times("k(0, 0)", "Eigen::Array22d k; k(0, 0) = 2;"), 2,
             "a.cpp:2:17: 'k' cannot be read: its type is not known; write"},
        Trap{"VectorOfWholes", "a.cpp", times("k(0)", "Eigen::Vector2i k; k(0) = 1.5;"), 2,
             "a.cpp:2:27: 'k[0]' cannot be read: its value is rounded to a"},
        Trap{"ListOfWholes", "a.cpp", times("k[0]", "std::array<int, 2> k{}; k[0] = 1.5;"), 2,
             "a.cpp:2:32: 'k[0]' cannot be read: its value is rounded to a"},
        Trap{"SixteenBits", "a.cpp", times("k", "std::int16_t k = 1.5;"), 2,
             "a.cpp:2:14: 'k' cannot be read: its type does not keep every"},
        Trap{"LongWhole", "a.cpp", times("k", "long k = 1.5;"), 2,
             "a.cpp:2:10: 'k' cannot be read: its value is rounded to a whole"},
        Trap{"FloatKeptAsDouble", "a.cpp", times("k*10", "double k = 0.1f;"), 1, "3 of 4 agree"},
        Trap{"FloatsAdded", "a.cpp", times("k", "double k = 0.1f + 0.2f;"), 2,
             "a.cpp:2:17: the result of numbers of type float is rounded; write"},
        Trap{"SineOfAFloat", "a.cpp", times("k", "double k = std::sin(0.5f);"), 2,
             "a.cpp:2:17: a function of numbers of type float is rounded; write"},
        Trap{"Volatile", "a.cpp", times("k", "volatile double k = 1;"), 2,
             "a.cpp:2:1: 'volatile': an operation on memory cannot be read;"},
        Trap{"Attribute", "a.cpp", times("k", "[[gnu::cleanup(fix)]] double k = 1;"), 2,
             "a.cpp:2:1: this attribute cannot be read"},
        Trap{"DeclaredTwice", "a.cpp", times("k", "double k = 1; double k = 2;"), 2,
             "a.cpp:2:22: 'k' is declared twice"},
        Trap{"ClassMembers", "a.cpp",
             "class P { public: int l; };\n" + head("const P& p, double s", right), 2,
             "a.cpp:1:1: a type that is more than a list of members cannot be"},
        Trap{"AliasedMember", "a.cpp",
             "using R = int;\nstruct P { R l; };\n" +
                 head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest),
             2, "a.cpp:3:23: 'p.l' cannot be read: its type holds whole numbers"},
        Trap{"MemberOfUnknownType", "a.cpp",
             "struct P { Angle l; };\n" + head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest), 2,
             "a.cpp:2:23: 'p.l' cannot be read: its type is not known; write"},
        Trap{"MemberWithAnAttribute", "a.cpp",
             "struct P { [[maybe_unused]] int l; };\n" +
                 head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest),
             2, "a.cpp:2:23: 'p.l' cannot be read: its type holds whole numbers"},
        Trap{"BitField", "a.cpp",
             "struct P { int l : 3; };\n" + head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest),
             2, "a.cpp:1:8: a type that is more than a list of members cannot be"},
        Trap{"Inherited", "a.cpp",
             "struct B { int l; };\nstruct P : B { double s; };\n" +
                 head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest),
             2, "a.cpp:2:1: a type that is more than a list of members cannot be"},
        Trap{"TwoStructures", "a.cpp",
             "namespace a { struct P { double l; }; }\nnamespace b { struct P { int l; }; }\n" +
                 head("const P& p", "J(0, 0) = -p.l*sin(q_0);" + rest),
             2, "a.cpp:2:22: 'P' is declared twice"},
        Trap{"OneSymbolOfTwo", "a.cpp",
             "struct P { double q_1; double q[2]; };\n" +
                 head("const P& p", "J(0, 0) = -p.q_1*p.q[1];" + rest),
             2, "a.cpp:3:18: 'p.q[1]' and 'p.q_1' would be read as one; give one"},
        Trap{"MemberOfATypedef", "a.cpp",
             "typedef struct { double l; } P;\n" +
                 head("const P* p", "J(0, 0) = -p->l*sin(q_0);" + rest + "J(1, 1) = 0;"),
             0, agree},
        Trap{"MatrixByAName", "a.cpp",
             "using M3 = Eigen::Matrix3d;\nvoid f(M3& J, double l) {" + right + "}", 2,
             "a.cpp:2:12: J has another size here, and is audited as 2 by 2"},
        Trap{"MatrixOfAliasedWholes", "a.cpp",
             "using M = int[2][2];\nvoid f(M J, double l) { J[0][0] = 0; }", 2,
             "a.cpp:2:10: J holds whole numbers"},
        Trap{"MatrixOfElements", "a.cpp", "void f(Eigen::Array22d& J, double l) {" + right + "}", 2,
             "a.cpp:1:25: the type of J is not known"},
        Trap{"SizesByNames", "a.cpp", "void f(double J[n][n], double l) { J[0][0] = 0; }", 2,
             "a.cpp:1:16: this size cannot be read; write a number"},
        Trap{"VectorOfVectors", "a.cpp",
             "void f(std::vector<std::vector<double>>& J, double l, double s, double q_0) { "
             "J[0][0] = -l*sin(q_0); J[0][1] = -s; J[1][0] = l*cos(q_0); }",
             0, agree},
        Trap{"RowMajor", "a.cpp",
             "void f(Eigen::Matrix<double, 2, 2, Eigen::RowMajor>& J, double l) {" + right + "}", 0,
             agree},
        Trap{"RefToAMatrix", "a.cpp",
             "void f(Eigen::Ref<Eigen::Matrix2d> J, double l) {" + right + "}", 0, agree},
        Trap{"NameOfALibrary", "a.cpp",
             "using namespace std;\nvoid f(valarray& J, double l) {" + right + "}", 2,
             "a.cpp:2:18: the type of J is not known"}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// Numbers, names and declarations that mean something else than they seem to.
INSTANTIATE_TEST_SUITE_P(
    Values, CodeTraps,
    testing::Values(
        Trap{"ProductWraps", "a.cpp", times("m", "int k = 100000; double m = k*k;"), 2,
             "a.cpp:2:29: whole numbers beyond 2147483647 wrap round in C++;"},
        Trap{"QuotientOfAWhole", "a.cpp", times("m", "int k = 7; double m = k/2;"), 2,
             "a.cpp:2:24: a quotient of whole numbers is rounded in C++; write"},
        Trap{"WholeSetLater", "a.cpp", times("k", "int k = 3; k = k/2;"), 2,
             "a.cpp:2:17: a quotient of whole numbers is rounded in C++; write"},
        Trap{"NegativeQuotient", "a.cpp", times("k", "double k = -1/2;"), 2,
             "a.cpp:2:14: a quotient of whole numbers is rounded in C++; write"},
        Trap{"QuotientInBraces", "a.cpp", times("k", "double k{1/2};"), 2,
             "a.cpp:2:11: a quotient of whole numbers is rounded in C++; write"},
        Trap{"NegatedUnsigned", "a.cpp", times("k", "double k = 1 - 2u;"), 2,
             "a.cpp:2:16: a number of type unsigned makes the result wrap"},
        Trap{"Remainder", "a.cpp", times("k", "double k = 5 % 3;"), 2,
             "a.cpp:2:14: '%' cannot be read inside an expression"},
        Trap{"Shift", "a.cpp", times("k", "double k = 1 << 1;"), 2,
             "a.cpp:2:14: '<<' cannot be read inside an expression"},
        Trap{"Compared", "a.cpp", times("k", "double k = l > s;"), 2,
             "a.cpp:2:14: '>' cannot be read inside an expression"},
        Trap{"Negated", "a.cpp", times("k", "double k = !l;"), 2,
             "a.cpp:2:12: '!' cannot be read inside an expression"},
        Trap{"Letter", "a.cpp", times("k", "double k = 'a';"), 2,
             "a.cpp:2:12: ''a'' cannot be read inside an expression"},
        Trap{"Hexadecimal", "a.cpp", times("k", "double k = 0x10;"), 2,
             "a.cpp:2:12: a number spelled '0x10' cannot be read; write a"},
        Trap{"Grouped", "a.cpp", times("k", "double k = 1'0;"), 2,
             "a.cpp:2:12: a number spelled '1'0' cannot be read; write a"},
        Trap{"Sized", "a.cpp", times("k", "double k = sizeof(int);"), 2,
             "a.cpp:2:12: the effect of 'sizeof' is not known"},
        Trap{"RoundedCircle", "a.cpp", times("k", "const double k = 3.141592653589793;"), 2,
             "a.cpp:2:18: a number of so many digits is a rounded one; write"},
        Trap{"Comma", "a.cpp", times("k", "double k = (1, 2);"), 2,
             "a.cpp:2:14: ',' cannot be read inside an expression"},
        Trap{"Elsewhere", "a.cpp", times("1", "double k = l = 2;"), 2,
             "a.cpp:2:14: '=' cannot be read inside an expression"},
        Trap{"PowerOfAQuotient", "a.cpp", times("k", "double k = std::pow(2, 1/2);"), 2,
             "a.cpp:2:25: a quotient of whole numbers is rounded in C++; write"},
        Trap{"Bigger", "a.cpp", times("k", "double k = 2147483648*l;"), 2,
             "a.cpp:2:12: whole numbers beyond 2147483647 wrap round in C++;"},
        Trap{"LargeExponent", "a.cpp", times("k", "double k = 1e99999;"), 2,
             "a.cpp:2:12: the exponent of this number is too large"},
        Trap{"FunctionDeclared", "a.cpp", times("k", "double k(int);"), 2,
             "a.cpp:2:8: this may declare a function"},
        Trap{"FunctionOfNothing", "a.cpp", times("k", "double k();"), 2,
             "a.cpp:2:8: this may declare a function"},
        Trap{"FunctionPointer", "a.cpp", times("k(1)", "double (*k)(double) = f2;"), 2,
             "a.cpp:2:1: changes through a pointer or a reference cannot be"},
        Trap{"StandardFunction", "a.cpp", times("k(1)", "std::function<double(double)> k = f2;"), 2,
             "a.cpp:2:1: this type cannot be read"},
        Trap{"BeyondAList", "a.cpp", times("k[2]", "double k[2]; k[2] = 1;"), 2,
             "a.cpp:2:14: 'k' has no such element"},
        Trap{"ConstantInTwoSpaces", "a.cpp",
             "namespace a { const double k = 1; }\nnamespace b { const double k = 2; }\n" +
                 times("k", ""),
             2, "a.cpp:2:28: 'k' is declared twice"},
        Trap{"ConstantThatWasRounded", "a.cpp", "constexpr int k = 7/2;\n" + times("k", ""), 2,
             "a.cpp:1:20: a quotient of whole numbers is rounded in C++; write"},
        Trap{"OwnCircle", "a.cpp", "const double M_PI = 3;\n" + body(right), 2,
             "a.cpp:1:14: 'M_PI' is given another meaning"},
        Trap{"OwnNumbers", "a.cpp", "namespace numbers { const double pi = 3; }\n" + body(right), 2,
             "a.cpp:1:11: 'numbers' is given another meaning"},
        Trap{"CircleOfALibrary", "a.cpp",
             "using namespace std;\nvoid f(Eigen::Matrix2d& J, double l) { J(0, 0) = l*cos(q_0 + "
             "numbers::pi/2);" +
                 rest + "}",
             0, agree},
        Trap{"NumbersOpened", "a.cpp",
             "using namespace std::numbers;\n" + body("J(0, 0) = -phi*sin(q_0);" + rest), 2,
             "a.cpp:1:1: the names that this declares cannot be read"},
        Trap{"AutoInC", "a.c", body("auto k = 1.5; J[0][0] = k;"), 2,
             "a.c:2:1: 'auto' means a whole number to some compilers of C;"},
        Trap{"MathDefines", "a.cpp",
             "#define _USE_MATH_DEFINES\n#include <cmath>\n" +
                 body("J(0, 0) = l*cos(q_0 + M_PI/2);" + rest),
             0, agree},
        Trap{"WholeByItself", "a.cpp", times("k/2.0", "int k = 2*3 - 4;"), 0, agree},
        Trap{"FloatThatIsExact", "a.cpp", times("k*2", "double k = 0.5f;"), 0, agree},
        Trap{"Signs", "a.cpp", times("+k", "double k = - -1;"), 0, agree},
        Trap{"Asserted", "a.cpp", times("k", "assert(l > 0 && s != 0); double k = 1;"), 0, agree},
        Trap{"ElementsOfALocal", "a.cpp", times("k[1]/l", "double k[2]; k[1] = l;"), 0, agree}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// What a function gives, where its name stands in place of a matrix.
INSTANTIATE_TEST_SUITE_P(
    Results, CodeTraps,
    testing::Values(
        Trap{"List", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) {\nreturn "
             "{-l*sin(q_0), -s, l*cos(q_0), 0};\n}\n",
             0, agree},
        Trap{"WrongList", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) {\nreturn "
             "{-l*sin(q_0), l*cos(q_0), -s, 0};\n}\n",
             1, "2 of 4 agree"},
        Trap{"ShortList", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) {\nreturn "
             "{-l*sin(q_0), -s, l*cos(q_0)};\n}\n",
             2, "a.cpp:3:8: the type that is returned is not known"},
        Trap{"ListOfFloats", "a.cpp",
             "#include <cmath>\nstd::array<float, 4> J(double l, double s, double q_0) {\nreturn "
             "{-l*sin(q_0), -s, l*cos(q_0), 0};\n}\n",
             2, "a.cpp:3:8: the type that is returned is not known"},
        Trap{"RoundedValue", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) {\nint k = "
             "l; return {-l*sin(q_0), -s, l*cos(q_0), k};\n}\n",
             2, "a.cpp:3:9: 'k' cannot be read: its value is rounded to a whole"},
        Trap{"Named", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) "
             "{\nstd::array<double, 4> k; k[0] = -l*sin(q_0); k[1] = -s; k[2] = l*cos(q_0); k[3] = "
             "0; return k;\n}\n",
             0, agree},
        Trap{"NamedAndUnset", "a.cpp",
             "#include <cmath>\nstd::array<double, 4> J(double l, double s, double q_0) "
             "{\nstd::array<double, 4> k; k[0] = -l*sin(q_0); return k;\n}\n",
             2, "a.cpp:3:53: 'k[1]' is never assigned"},
        Trap{"Tuple", "a.cpp",
             "#include <cmath>\nauto J(double l, double s, double q_0) {\nreturn "
             "std::make_tuple(-l*sin(q_0), -s, l*cos(q_0), 0);\n}\n",
             0, agree},
        Trap{"TupleWithAWhole", "a.cpp",
             "#include <cmath>\nstd::tuple<double, double, double, int> J(double l, double s, "
             "double q_0) {\nreturn {-l*sin(q_0), -s, l*cos(q_0), 0};\n}\n",
             2, "a.cpp:3:8: the type that is returned is not known"},
        Trap{"Outputs", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double& a, double& b, "
             "double& c, double& d) {\na = -l*sin(q_0); b = -s; c = l*cos(q_0); d = 0;\n}\n",
             0, agree},
        Trap{"OutputsInAnotherOrder", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double& b, double& a, "
             "double& c, double& d) {\na = -l*sin(q_0); b = -s; c = l*cos(q_0); d = 0;\n}\n",
             1, "2 of 4 agree"},
        Trap{"OutputUnset", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double& a, double& b, "
             "double& c, double& d) {\na = -l*sin(q_0); b = -s; c = l*cos(q_0); \n}\n",
             2, "a.cpp:2:81: 'd' is never assigned"},
        Trap{"OutputOfWholes", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double& a, double& b, "
             "double& c, int& d) {\na = -l*sin(q_0); b = -s; c = l*cos(q_0); d = 0;\n}\n",
             0, agree},
        Trap{"Pointers", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double * a, double * b, "
             "double * c, double * d) {\n*a = -l*sin(q_0); *b = -s; *c = l*cos(q_0); *d = 0;\n}\n",
             0, agree},
        Trap{"PointerReadAfterwards", "a.cpp",
             "#include <cmath>\nvoid J(double l, double s, double q_0, double * a, double * b, "
             "double * c, double * d) {\n*a = -l*sin(q_0); *b = -s; *c = l*cos(q_0); *d = "
             "a[0];\n}\n",
             2, "a.cpp:2:49: 'a[0]' cannot be read: it is set through its pointer"},
        Trap{"TwoFunctions", "a.cpp",
             "#include <cmath>\ndouble J(double l) {\nreturn l; }\ndouble J(double l, double s) { "
             "return s;\n}\n",
             2, "a.cpp:4:8: a second function 'J'"},
        Trap{"Structure", "a.cpp",
             "struct R { double a, b, c, d; };\nR J(double l, double s, double q_0) { return "
             "R{-l*sin(q_0), -s, l*cos(q_0), 0}; }",
             0, agree},
        Trap{"MembersInAnotherOrder", "a.cpp",
             "struct R { double a, c, b, d; };\nR J(double l, double s, double q_0) { R r; r.a = "
             "-l*sin(q_0); r.b = -s; r.c = l*cos(q_0); r.d = 0; return r; }",
             1, "2 of 4 agree"},
        Trap{"MembersOfAStructure", "a.cpp",
             "struct R { double a, b, c, d; };\nR J(double l, double s, double q_0) { R r; r.a = "
             "-l*sin(q_0); r.b = -s; r.c = l*cos(q_0); r.d = 0; return r; }",
             0, agree},
        Trap{"MatlabOutputs", "a.m",
             "function [a, b, c, d] = J(l, s, q_0)\na = -l*sin(q_0);\nb = -s;\nc = l*cos(q_0);\nd "
             "= 0;\nend\n",
             0, agree},
        Trap{"MatlabColumn", "a.m",
             "function v = J(l, s, q_0)\nv = [-l*sin(q_0); -s; l*cos(q_0); 0];\nend\n", 0, agree},
        Trap{"MatlabOutputUnset", "a.m", "function [a, b] = J(l, s, q_0)\na = -l*sin(q_0);\nend\n",
             2, "a.m:1:14: 'b' is never assigned"}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

/// What MATLAB computes from what looks alike.
INSTANTIATE_TEST_SUITE_P(
    MatlabMeans, CodeTraps,
    testing::Values(
        Trap{"ElementOfAStructure", "a.m",
             "function J = f(l, s, q_0)\np(1).l = 2;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n",
             2, "a.m:2:1: this assignment cannot be read"},
        Trap{"Deleted", "a.m",
             "function J = f(l, s, q_0)\nx(1) = l; x(1) = [];\nJ = [-x(1)*sin(q_0), -s; "
             "l*cos(q_0), 0];\nend\n",
             2, "a.m:2:18: this list cannot be read; give each value a name of its"},
        Trap{"LeftPowers", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0)*2^3^2/64, -s; l*cos(q_0), 0];\nend\n", 0,
             agree},
        Trap{"PowersToTheRight", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0)*2^3^2/512, -s; l*cos(q_0), 0];\nend\n", 1,
             "3 of 4 agree"},
        Trap{"PowerOfAPower", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l^cos(0)^2*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 1,
             "3 of 4 agree"},
        Trap{"SignedPower", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l^-+1^2*sin(q_0)*l^3, -s; l*cos(q_0), 0];\nend\n", 0,
             agree},
        Trap{"NegativeExponents", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0)*2^-1^2*4, -s; l*cos(q_0), 0];\nend\n", 0,
             agree},
        Trap{"ElementOfPi", "a.m",
             "function J = f(l, s, q_0)\npi(1) = 3;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n",
             2, "a.m:2:1: 'pi' is given another meaning"},
        Trap{"Whole", "a.m",
             "function J = f(l, s, q_0)\nJ = [-int32(l)*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:7: 'int32' is neither given to this function nor set in it"},
        Trap{"Single", "a.m",
             "function J = f(l, s, q_0)\nJ = [-single(l)*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:7: 'single' is neither given to this function nor set in it"},
        Trap{"SpacedSigns", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0) - s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:5: J is audited as 2 by 2, and this has 2 rows, one of 1"},
        Trap{"UnspacedSigns", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0) -s; l*cos(q_0) 0];\nend\n", 0, agree},
        Trap{"SpacedCall", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin (q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:9: 'sin' cannot be read here"},
        Trap{"Element", "a.m",
             "function J = f(l, s, q_0)\nl(1) = 2;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n",
             2, "a.m:2:1: 'l[1]' may be 'l' itself"},
        Trap{"LastElement", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nJ(end, 1) = "
             "7;\nend\n",
             2, "a.m:3:1: cannot read this use of J; write J(i, j) = EXPRESSION"},
        Trap{"Range", "a.m",
             "function J = f(l, s, q_0)\nx = 1:2;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:6: ':' cannot be read inside an expression"},
        Trap{"Counted", "a.m",
             "function J = f(l, s, q_0)\nl++;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:1: 'l': this statement cannot be read; write NAME ="},
        Trap{"AddedTo", "a.m",
             "function J = f(l, s, q_0)\nl += 1;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:1: 'l': this statement cannot be read; write NAME ="},
        Trap{"Global", "a.m",
             "function J = f(l, s, q_0)\nglobal l2\nJ = [-l2*sin(q_0), -s; l*cos(q_0), 0];\nend\n",
             2, "a.m:2:1: 'global': this statement cannot be read; write NAME ="},
        Trap{"Handle", "a.m",
             "function J = f(l, s, q_0)\ng = @(x) 2*x;\nJ = [-g(1)*l*sin(q_0), -s; l*cos(q_0), "
             "0];\nend\n",
             2, "a.m:2:5: this character cannot be read"},
        Trap{"Imaginary", "a.m",
             "function J = f(l, s, q_0)\nJ = [-l*sin(q_0)*1i, -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:18: a number spelled '1i' cannot be read; write a decimal"},
        Trap{"NotGiven", "a.m",
             "function J = f(l, s, q_0)\nJ = [-e*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:2:7: 'e' is neither given to this function nor set in it"},
        Trap{"SecondOutput", "a.m",
             "function J = f(l, s, q_0)\n[a, l] = deal(1, 2);\nJ = [-l*sin(q_0), -s; l*cos(q_0), "
             "0];\nend\n",
             2, "a.m:2:1: '[': this statement cannot be read; write NAME ="},
        Trap{"Rows", "a.m",
             "function J = f(l, s, q_0)\na = [-l*sin(q_0), -s];\nb = [l*cos(q_0), 0];\nJ = [a; "
             "b];\nend\n",
             0, agree},
        Trap{"RowsExchanged", "a.m",
             "function J = f(l, s, q_0)\na = [-l*sin(q_0), -s];\nb = [l*cos(q_0), 0];\nJ = [b; "
             "a];\nend\n",
             1, "0 of 4 agree"},
        Trap{"ListChanged", "a.m",
             "function J = f(l, s, q_0)\na = [l, s];\na(1) = 2;\nJ = [-a(1)*sin(q_0), -s; "
             "l*cos(q_0), 0];\nend\n",
             1, "3 of 4 agree"},
        Trap{"ListGrows", "a.m",
             "function J = f(l, s, q_0)\na = [-l*sin(q_0), -s];\nb = [l*cos(q_0), 0];\na(3) = "
             "1;\nb(3) = 1;\nJ = [a; b];\nend\n",
             2, "a.m:4:1: this assignment cannot be read"},
        Trap{"ListRead", "a.m",
             "function J = f(l, s, q_0)\na = [l; s];\nJ = [-a(1)*sin(q_0), -a(2); l*cos(q_0), "
             "0];\nend\n",
             0, agree},
        Trap{"OnTheHeadersLine", "a.m",
             "function J = f(l, s, q_0) l = 2;\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:1:1: the head of this function cannot be read; end its line"},
        Trap{"CosineGiven", "a.m",
             "function J = f(l, s, q_0, cos)\nJ = [-l*sin(q_0), -s; l*cos(q_0), 0];\nend\n", 2,
             "a.m:1:27: 'cos' is given another meaning"},
        Trap{"ZerosGiven", "a.m", "function J = f(zeros)\nJ = zeros(2);\nend\n", 2,
             "a.m:1:16: 'zeros' is given another meaning"}),
    [](const testing::TestParamInfo<Trap>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::code_traps_test
