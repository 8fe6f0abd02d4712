// Law: the audit reads from a user's code what the code computes, or refuses it in one line.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/command.hpp"

namespace assur::test::code_matrix_test {
namespace {

namespace fs = std::filesystem;

/// Code that fills J = df/d(q_0, s), f1 = l*cos(q_0) - s^2/2, f2 = l*sin(q_0), and the status and
/// the answer of its audit.
struct Code {
  const char* name;
  const char* text;
  int status;
  const char* answer;
};

void PrintTo(const Code& code, std::ostream* out) { *out << code.name; }

class HandWritten : public testing::TestWithParam<Code> {};

TEST_P(HandWritten, IsReadAsItStands) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("mine.audit",
                                        "length l s\nangle q_0\nunknown q_0 s\nlet p_l = l\n"
                                        "let q_1 = s\n"
                                        "closure f1 = l*cos(q_0) - s^2/2\n"
                                        "closure f2 = l*sin(q_0)\n"
                                        "printed code J mine.cpp J of f1 f2 by q_0 s\n");
  directory.write("mine.cpp", GetParam().text);
  const CommandResult result = run_assur("audit " + file.string());
  EXPECT_EQ(result.status, GetParam().status) << result.output << result.messages;
  const std::string& said = GetParam().status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(GetParam().answer), std::string::npos)
      << "expected: " << GetParam().answer << "\nfound:    " << said;
  if (GetParam().status == 2) {
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

#define REST "J(0, 1) = -s; J(1, 0) = l*cos(q_0);"
INSTANTIATE_TEST_SUITE_P(
    Code, HandWritten,
    testing::Values(
        Code{"Standard", "J(0, 0) = -p.l * std::sin(q[0]);" REST, 0, "all 4 agree"},
        Code{"Pointer",
             "J(0,0) = -p -> l*std :: sin(q [ 0 ]); J(0,1) = -q(1);"
             "J(1,0) = p.l*cos(q(0));",
             0, "all 4 agree"},
        Code{"Brackets", "J[0][0] = -l*sin(q_0); J[0][1] = -s; J[1][0] = l*cos(q_0);", 0,
             "all 4 agree"},
        Code{"Locals",
             "const double c = std::cos(q[0]), S = sin(q[0]); auto x = p.l * c; double y; y = -S;"
             "J(0, 0) = l*y; J(0, 1) = -q[1]; J(1, 0) = x;",
             0, "all 4 agree"},
        Code{"LastAssignmentCounts", "J(0, 0) = s; " REST "J(0, 0) = -l*sin(q_0);", 0,
             "all 4 agree"},
        Code{"Comments",
             "// J(0, 0) = 1;\n/* J += 2; */ J(0, 0) = -l /* ; */ * sin(q_0); // end\n" REST, 0,
             "all 4 agree"},
        Code{"Powers", "J(0, 0) = -std::pow(l, 2) / l * sin(q_0);" REST, 0, "all 4 agree"},
        Code{"Suffixes", "J(0, 0) = -2.0L*l*0.5l*sin(q_0);" REST, 0, "all 4 agree"},
        Code{"Pi",
             "J(0, 0) = l*cos(q_0 + M_PI/2); J(0, 1) = s*cos(std::numbers::pi);"
             "J(1, 0) = l*cos(q_0);",
             0, "all 4 agree"},
        Code{"CommaInitialiser", "J << -l*sin(q_0), -s,\n     l*cos(q_0), 0;", 0, "all 4 agree"},
        Code{"Cleared", "J(1, 1) = s; J.setZero(); J(0, 0) = -l*sin(q_0);" REST, 0, "all 4 agree"},
        Code{"DeclaredEmpty",
             "double J[2][2] = {}; J[0][0] = -l*sin(q_0); J[0][1] = -s;"
             "J[1][0] = l*cos(q_0);",
             0, "all 4 agree"},
        Code{"DeclaredAndNotSet", "Eigen::Matrix2d J;\nJ(0, 0) = -l*sin(q_0);" REST, 2,
             "mine.cpp:1:17: row 2, column 2 of J is never assigned, and J begins without values"},
        Code{"DeclaredAndAllSet",
             "double J[2][2];\nJ[1][1] = 0; J[0][0] = -l*sin(q_0); J[0][1] = -s;"
             "J[1][0] = l*cos(q_0);",
             0, "all 4 agree"},
        Code{"DeclaredZero",
             "Eigen::Matrix2d J = Eigen::Matrix2d::Zero();"
             "J(0, 0) = -l*sin(q_0);" REST,
             0, "all 4 agree"},
        Code{"RepeatsAnEntry",
             "J(1, 0) = l*cos(q_0); J(0, 0) = -l*sin(q_0); J(0, 1) = -s + "
             "J(1, 0) - J(1,0);",
             0, "all 4 agree"},
        Code{"OtherMatrix", "JJ(0, 0) += 1; J(0, 0) = -l*sin(q_0);" REST, 0, "all 4 agree"},
        Code{"MatrixOfSomethingElse", "H.J(0, 0) = 3; J(0, 0) = -l*sin(q_0);" REST, 2,
             "'H.J[0][0]' may be another name of a value"},
        Code{"InAFunction",
             "struct P { double l; };\nnamespace a { using namespace std;\n"
             "void f(Eigen::Matrix2d& J, const P& p) { J(0, 0) = -p.l*sin(q_0);" REST
             " return; }\n}",
             0, "all 4 agree"},
        Code{"Returned",
             "double f2(double l, double q) { for (;;) { l += q; } return l; }\n"
             "Eigen::Matrix2d f(double l) { Eigen::Matrix2d J; J.setZero();\n"
             "J(0, 0) = -l*sin(q_0);" REST " return J; }",
             0, "all 4 agree"},
        Code{"BracesAndParentheses",
             "double c{std::cos(q_0)}, S(sin(q_0));"
             "J(0, 0) = -l*S; J(0, 1) = -s; J(1, 0) = l*c;",
             0, "all 4 agree"},
        Code{"Guarded",
             "#ifndef F_HPP\n#define F_HPP\n#include <Eigen/Dense>\n"
             "inline void f(M& J) { J(0, 0) = -l*sin(q_0);" REST " }\n#endif  // F_HPP\n",
             0, "all 4 agree"},
        Code{"RawText", "const auto t = R\"(J(0, 0) = 1; \")\"; J(0, 0) = -l*sin(q_0);" REST, 0,
             "all 4 agree"},
        Code{"Includes",
             "#include <cmath>\n # pragma once\ndouble c = l; J(0, 0) = -c*sin(q_0);" REST, 0,
             "all 4 agree"},
        Code{"LocalOfAnyType", "const Eigen::Index l = 2; J(0, 0) = -l*sin(q_0);" REST, 1,
             "2 of 4 agree"},
        Code{"LocalByReference",
             "const auto& b = s; J(0, 0) = -l*sin(q_0); J(0, 1) = -b; J(1, 0) = l*cos(q_0);", 0,
             "all 4 agree"},
        Code{"MemberSet", "p->l = s; J(0, 0) = -p->l*sin(q_0);" REST, 1, "3 of 4 agree"},
        Code{"EntrySet", "q[1] = l; J(0, 0) = -l*sin(q_0); J(0, 1) = -q[1]; J(1, 0) = l*cos(q_0);",
             1, "3 of 4 agree"},
        Code{"Ternary", "J(0, 0) = s > 0 ? -l*sin(q_0) : 0;" REST, 2,
             "mine.cpp:1:13: '>' cannot be read inside an expression"},
        Code{"WrongOnTheSecondLine", "J(0, 0) = -l*sin(q_0);" REST "\n  J(1, 1) =\n     s;", 1,
             "/mine.cpp:3:6)"},
        Code{"NotAssigned", "J(0, 0) = -l*sin(q_0); J(0, 1) = -s;", 1,
             "nothing is assigned to it, so it counts as zero"},
        Code{"UnknownName", "J(0, 0) = -l\n * sin(r);" REST, 1, "/mine.cpp:2:8)"},
        Code{"UnknownFunction", "J(0, 0) = -l*sine(q_0);" REST, 2,
             "mine.cpp:1:14: the effect of 'sine' is not known; audit it by running"},
        Code{"Cast", "J(0, 0) = -l*\n static_cast<double>(s);" REST, 2,
             "mine.cpp:2:2: a cast cannot be read"},
        Code{"OldCast", "J(0, 0) = -(double)l*sin(q_0);" REST, 2, "mine.cpp:1:12: a cast"},
        Code{"CastInALocal", "auto c = double(s);\nJ(0, 0) = c;" REST, 2,
             "mine.cpp:1:10: a cast cannot be read"},
        Code{"Caret", "J(0, 0) = -l^2;" REST, 2, "mine.cpp:1:13: '^' is the exclusive or"},
        Code{"WholeQuotient", "J(0, 0) = 1/2*l;" REST, 2, "a quotient of whole numbers is rounded"},
        Code{"AddedTo", "J(0, 0) += l;" REST, 2, "mine.cpp:1:1: cannot read this use of J"},
        Code{"LocalAddedTo", "double c = l; c += s;\nJ(0, 0) = c;" REST, 2,
             "mine.cpp:1:15: 'c' cannot be read: write its whole value in place of '+='"},
        Code{"Block", "J.block<1, 2>(0, 0) << l, s;" REST, 2, "cannot read this use of J"},
        Code{"Row", "J.row(0) = r;" REST, 2, "cannot read this use of J"},
        Code{"WholeMatrix", "J = A * B;" REST, 2, "cannot read this use of J"},
        Code{"BracedList", "double J[2][2] = {{1, 2}, {3, 4}};" REST, 2,
             "cannot read this use of J"},
        Code{"ConditionalBlock", "if (s > 0) { J(0, 0) = -l*sin(q_0); }" REST, 2,
             "mine.cpp:1:1: 'if': a condition cannot be read; only what always runs once"},
        Code{"ConditionalStatement", "if (s > 0) J(0, 0) = -l*sin(q_0);" REST, 2,
             "mine.cpp:1:1: 'if': a condition cannot be read"},
        Code{"Loop", "for (int i = 0; i < 2; ++i) J(i, 0) = l;" REST, 2,
             "mine.cpp:1:1: 'for': a loop cannot be read"},
        Code{"ListTooShort", "J << l, s, l;", 2, "audited as 2 by 2, and this lists 3 entries"},
        Code{"Outside", "J(2, 0) = l;", 2, "audited as 2 by 2, and this entry is outside"},
        Code{"Nothing", "K(0, 0) = l;", 2, "mine.cpp:1:1: nothing is assigned to J"}),
    [](const testing::TestParamInfo<Code>& at) { return std::string(at.param.name); });

#define RIGHT "J(0, 0) = -l*sin(q_0); J(0, 1) = -s; J(1, 0) = l*cos(q_0); J(1, 1) = 0;"
#define BODY(text) "void f(M& J, double l) {\n" text "\n}\n"
/// Everything that may make right assignments wrong is refused at its place, with a mend.
INSTANTIATE_TEST_SUITE_P(
    Refused, HandWritten,
    testing::Values(
        Code{"Transposed", BODY(RIGHT "\nJ.transposeInPlace();"), 2, "mine.cpp:3:1: cannot read"},
        Code{"PassedOn", BODY(RIGHT "\nfix(J);"), 2, "mine.cpp:3:5: cannot read this use of J"},
        Code{"Swapped", BODY(RIGHT "\nstd::swap(J(0,0), J(1,0));"), 2, "mine.cpp:3:11: cannot"},
        Code{"Reference", BODY(RIGHT "\nauto& K = J; K(0,0) = 7;"), 2,
             "mine.cpp:3:1: changes through a pointer"},
        Code{"Pointer", BODY(RIGHT "\ndouble* p = &J(0,0); *p = 7;"), 2,
             "mine.cpp:3:1: changes through a"},
        Code{"PointerToRow", BODY(RIGHT "\ndouble (*p)[2] = &J[0];"), 2,
             "mine.cpp:3:19: cannot read"},
        Code{"OtherReturned", "M f(double l) {\nM J;" RIGHT "\nreturn 2*J;\n}", 2,
             "mine.cpp:3:10: the returned value is not J itself"},
        Code{"NotReturned", "M f(double l) {\nM J;" RIGHT "\nreturn K;\n}", 2,
             "mine.cpp:2:3: J is filled here and never leaves the function"},
        Code{"ByValue", "void f(M J, double l) {" RIGHT "}", 2, "mine.cpp:1:10: J is filled here"},
        Code{"EarlyReturn", BODY("return;\n" RIGHT), 2,
             "mine.cpp:2:1: nothing after this 'return'"},
        Code{"ConditionalReturn", BODY("if (l < 0) { return; }" RIGHT), 2,
             "mine.cpp:2:1: 'if': a c"},
        Code{"SecondFunction", BODY("J(0, 0) = l;") "void g(M& J) { " RIGHT " }", 2,
             "mine.cpp:4:11: J is mentioned in a second function"},
        Code{"IfDefined", BODY("\n#ifdef RIGHT\n" RIGHT "\n#endif\nJ(0, 0) = 1;"), 2,
             "mine.cpp:3:1: '#ifdef RIGHT' may change what the code says"},
        Code{"Macro", "#define sin cos\n" BODY(RIGHT), 2, "mine.cpp:1:1: '#define sin cos' may"},
        Code{"MacroElsewhere", "#include \"macros.hpp\"\n" BODY(RIGHT), 2,
             "mine.cpp:1:1: a header of your own may define macros"},
        Code{"IncludedInside", BODY(RIGHT "\n#include <cmath>\n"), 2,
             "mine.cpp:3:1: a line for the"},
        Code{"Block", BODY("{ double l = 2; }" RIGHT), 2, "mine.cpp:2:1: a block inside"},
        Code{"While", BODY(RIGHT "\nwhile (l < 0) { l = 1; }"), 2, "mine.cpp:3:1: 'while': a loop"},
        Code{"Jump", BODY("goto end;" RIGHT "\nend: ;"), 2, "mine.cpp:2:1: 'goto': a jump"},
        Code{"Label", BODY(RIGHT "\nend: J(0, 0) = 1;"), 2, "mine.cpp:3:6: cannot read this use"},
        Code{"Lambda", BODY(RIGHT "\nauto g = [&] { J(0, 0) = 1; }; g();"), 2,
             "mine.cpp:3:10: '[' cannot"},
        Code{"LambdaOfOthers", BODY("auto g = [&] { l = 1; }; g();" RIGHT), 2,
             "mine.cpp:2:10: '[' ca"},
        Code{"ReadInACondition", BODY(RIGHT "\nif (J(0, 0) > 0) { l = 1; }"), 2,
             "mine.cpp:3:1: 'if'"},
        Code{"RowByCommas", BODY(RIGHT "\nJ.row(0) << 1, 2;"), 2,
             "mine.cpp:3:1: cannot read this use"},
        Code{"CommaOperator", BODY("J(0, 0) = 1, -l*sin(q_0);" REST), 2,
             "mine.cpp:2:1: cannot read"},
        Code{"Chained", BODY("J(0, 0) = J(0, 1) = 1;" REST), 2,
             "mine.cpp:2:19: '=' cannot be read"},
        Code{"Compound", BODY(RIGHT "\nJ *= 2;"), 2, "mine.cpp:3:1: cannot read this use of J"},
        Code{"Counted", BODY("double t = l++;" RIGHT), 2, "mine.cpp:2:13: '++' cannot be read"},
        Code{"ByReference", BODY("advance(l);" RIGHT), 2, "mine.cpp:2:1: this statement cannot be"},
        Code{"CalledInALocal", BODY("double t = advance(l);" RIGHT), 2,
             "mine.cpp:2:12: the effect of 'advan"},
        Code{"DerivativeOfOwn", BODY("J(0, 0) = d(l, l);" REST), 2,
             "mine.cpp:2:11: the effect of 'd'"},
        Code{"OwnSine", "double sin(double x) { return x; }\n" BODY(RIGHT), 2,
             "mine.cpp:1:8: a function 'sin' of your own"},
        Code{"SineOfAnother", "using mine::sin;\n" BODY(RIGHT), 2,
             "mine.cpp:1:1: the names that this"},
        Code{"OwnOperator", "V operator*(V a, V b) { return a; }\n" BODY(RIGHT), 2,
             "mine.cpp:1:3: an operator of your own"},
        Code{"OwnType", "struct A { A operator=(double); };\n" BODY(RIGHT), 2,
             "mine.cpp:1:1: a type that is more than a list"},
        Code{"ContinuedComment", BODY("// careful \\\nJ(0, 0) = 1;\n" REST), 1, "3 of 4 agree"},
        Code{"ContinuedName", BODY("J(0, 0) = l*l\\\nl;" REST), 2, "a word that goes on"},
        Code{"Digraphs", BODY(RIGHT "\nJ<:0:><:0:> = 7;"), 2,
             "mine.cpp:3:2: '<:' is another spelling"},
        Code{"Trigraph", BODY("// what?\?/\n" RIGHT), 2, "mine.cpp:2:8: a trigraph means"},
        Code{"UniversalName", BODY(RIGHT "\n\\u004A(0, 0) = 7;"), 2,
             "mine.cpp:3:1: this character cannot be read"},
        Code{"Static", BODY("static double c = sin(q_0);\nJ(0, 0) = -l*c;" REST), 2,
             "mine.cpp:2:1: a static variable keeps its value"},
        Code{"Truncated", BODY("int c = l;\nJ(0, 0) = -c*sin(q_0);" REST), 2,
             "mine.cpp:2:9: 'c' cannot be read: its value is rounded to a whole number"},
        Code{"TruncatedParameter", "void f(M& J, int n) {J(0, 0) = n/2*l;" REST "}", 2,
             "'n' cannot be read: its type holds whole numbers alone; write double"},
        Code{"QuotientOfNames", BODY("auto n = 1; J(0, 0) = n/2*l;" REST), 2,
             "a quotient of whole"},
        Code{"QuotientInBrackets", BODY("J(0, 0) = (1 + 1)/(4)*l;" REST), 2, "a quotient of whole"},
        Code{"Octal", BODY("J(0, 0) = 010*l;" REST), 2, "a number spelled '010' cannot be read"},
        Code{"WholeMatrixOfInt", "void f() { Eigen::Matrix2i J;" RIGHT " return J; }", 2,
             "mine.cpp:1:28: J holds whole numbers"},
        Code{"OwnPi", BODY("const double pi = 3; J(0, 0) = l*cos(q_0 + pi/2);" REST), 1,
             "3 of 4 agree"},
        Code{"OwnPiOfTheLibrary",
             BODY("const double pi = std::acos(-1.0); J(0, 0) = l*cos(q_0 + pi/2);" REST), 0,
             "all 4 agree"},
        Code{"LocalStructure", BODY("const P p = other; J(0, 0) = -p.l*sin(q_0);" REST), 2,
             "'p' cannot be read: its type is not known"},
        Code{"LocalArray", BODY("double q[2] = {1, 2}; J(0, 0) = -l*sin(q[0]);" REST), 2,
             "'q[0]' cannot be read: give each value of a list a name of its own"},
        Code{"TwoSpellings", BODY("double p_l = 2; J(0, 0) = -p.l*sin(q_0);" REST), 2,
             "'p.l' and 'p_l' would be read as one"},
        Code{"NoValue", BODY("double k; J(0, 0) = -k*sin(q_0);" REST), 2,
             "'k' cannot be read: it has no"},
        Code{"HeldReference", BODY("const double& b = l; l = 2; J(0, 0) = -b*sin(q_0);" REST), 2,
             "'l' is set while a reference to it is held"},
        Code{"ClearedEntry", BODY(RIGHT "J.setZero(); J(1, 0) = J(0, 0);"), 1, "1 of 4 agree"},
        Code{"Global", "double l = 3;\n" BODY(RIGHT), 0, "all 4 agree"},
        Code{"GlobalUsed", "double w = 3;\nvoid f(M& J) { J(0, 0) = -w*sin(q_0);" REST " }", 2,
             "a variable outside the function may be set by anyone"},
        Code{"Bindings", BODY("auto [c, l] = pair; " RIGHT), 2, "mine.cpp:2:1: this statement"},
        Code{"Throughthis", BODY(RIGHT "\nthis->J(0, 0) += 1;"), 2,
             "mine.cpp:3:7: cannot read this use"},
        Code{"Unclosed", "void f(M& J) { J(0, 0) = 1;", 2, "mine.cpp:1:14: this bracket is not"}),
    [](const testing::TestParamInfo<Code>& at) { return std::string(at.param.name); });

/// The same for MATLAB, in mine.m.
class HandWrittenMatlab : public testing::TestWithParam<Code> {};

TEST_P(HandWrittenMatlab, IsReadAsItStands) {
  const TemporaryDirectory directory;
  const fs::path file =
      directory.write("mine.audit",
                      "length l s\nangle q_0\nunknown q_0 s\nlet p_l = l\nlet q_1 = q_0\n"
                      "closure f1 = l*cos(q_0) - s^2/2\nclosure f2 = l*sin(q_0)\n"
                      "printed code J mine.m J of f1 f2 by q_0 s\n");
  directory.write("mine.m", GetParam().text);
  const CommandResult result = run_assur("audit " + file.string());
  const std::string& said = GetParam().status == 2 ? result.messages : result.output;
  EXPECT_EQ(result.status, GetParam().status) << result.output << result.messages;
  EXPECT_NE(said.find(GetParam().answer), std::string::npos)
      << "expected: " << GetParam().answer << "\nfound:    " << said;
}

#define MFUNCTION(text) "function J = f(p, q, l, s, q_0)\n" text "end\n"
#define MREST "J(1, 2) = -s;\nJ(2, 1) = l*cos(q_0);\n"
INSTANTIATE_TEST_SUITE_P(
    Code, HandWrittenMatlab,
    testing::Values(
        Code{"Entries",
             MFUNCTION("J = zeros(2, 2); % J(1,1) = 7\nJ(1, 1) = -p.l.*sin(q(1));\n" MREST), 0,
             "all 4 agree"},
        Code{"List", MFUNCTION("c = cos(q(1)); S = sin(q(1));\nJ = [-l*S -s; l*c 0];\n"), 0,
             "all 4 agree"},
        Code{"ListOverLines", MFUNCTION("J = [-l*sin(q_0), ... first\n -s\n l * cos(q_0), 0];\n"),
             0, "all 4 agree"},
        Code{"Script", "J(1,1) = -l*sin(q_0), " MREST, 0, "all 4 agree"},
        Code{"Powers", MFUNCTION("J(1, 1) = -l.^2./l*sin(q_0)*1/2*2^1;\n" MREST), 0, "all 4 agree"},
        Code{"Wrong", MFUNCTION("J(1, 1) = l*sin(q_0);\n" MREST), 1, "differs by sign"},
        Code{"SignsInAList", MFUNCTION("J = [-l*sin(q_0) - s; l*cos(q_0) 0];\n"), 2,
             "audited as 2 by 2, and this has 2 rows, one of 1"},
        Code{"IndexFromZero", MFUNCTION("J(0, 1) = 1;\n"), 2, "this entry is outside"},
        Code{"Transposed", MFUNCTION("J(1, 1) = -l*sin(q_0);\n" MREST "J = J';\n"), 2,
             "mine.m:5:6: a transpose"},
        Code{"Loop", MFUNCTION("for i = 1:2\nJ(i, 1) = 0;\nend\n"), 2, "mine.m:2:1: 'for'"},
        Code{"Condition", MFUNCTION("if l > 0, J(1,1) = 1; end\n"), 2, "mine.m:2:1: 'if'"},
        Code{"Row", MFUNCTION("J(1, :) = [1 2];\n"), 2, "mine.m:2:"},
        Code{"PassedOn", MFUNCTION("J(1, 1) = 1;\nJ = fix(J);\n"), 2,
             "mine.m:3:9: cannot read this"},
        Code{"SecondFunction", MFUNCTION("J(1, 1) = 1;\n") "function y = g(x)\ny = x;\nend\n", 2,
             "mine.m:4:1: a second function"},
        Code{"EarlyReturn", MFUNCTION("return\nJ(1, 1) = 1;\n"), 2, "mine.m:3:1: nothing after"},
        Code{"NotGiven", "function K = f(l)\nJ(1, 1) = 1;\nend", 2,
             "the function does not return J"},
        Code{"OwnPi", MFUNCTION("pi = 3;\nJ(1, 1) = 1;\n"), 2, "'pi' is given another meaning"},
        Code{"Towers", MFUNCTION("J(1, 1) = -l^2^2/l^3*sin(q_0);\n" MREST), 0, "all 4 agree"},
        Code{"BlockComment", MFUNCTION("%{\nJ(1, 1) = 1;\n%}\nJ(1, 1) = -l*sin(q_0);\n" MREST), 0,
             "all 4 agree"}),
    [](const testing::TestParamInfo<Code>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::code_matrix_test
