// Law: of a user's code the audit reads what the code says, or refuses it in one line.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/command.hpp"

namespace assur::test::code_matrix_test {
namespace {

namespace fs = std::filesystem;

/// How some code fills J = df/d(q_0, s), f1 = l*cos(q_0) - s^2/2, f2 = l*sin(q_0): what the audit
/// answers, and with what status.
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
        Code{"Suffixes", "J(0, 0) = -2.0f*l*0.5F*1.e0f*sin(q_0);" REST, 0, "all 4 agree"},
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
        Code{"DeclaredZero",
             "Eigen::Matrix2d J = Eigen::Matrix2d::Zero();"
             "J(0, 0) = -l*sin(q_0);" REST,
             0, "all 4 agree"},
        Code{"RepeatsAnEntry",
             "J(1, 0) = l*cos(q_0); J(0, 0) = -l*sin(q_0); J(0, 1) = -s + "
             "J(1, 0) - J(1,0);",
             0, "all 4 agree"},
        Code{"OtherMatrix", "JJ(0, 0) += 1; H.J(0, 0) = 3; J(0, 0) = -l*sin(q_0);" REST, 0,
             "all 4 agree"},
        Code{"InAFunction",
             "void f(M& J, P p) { if (p.l < 0) { return; } J(0, 0) = -l*sin(q_0);" REST "\n}", 0,
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
        Code{"Ternary", "J(0, 0) = s > 0 ? -l*sin(q_0) : 0;" REST, 1, "does not parse"},
        Code{"WrongOnTheSecondLine", "J(0, 0) = -l*sin(q_0);" REST "\n  J(1, 1) =\n     s;", 1,
             "/mine.cpp:3:6)"},
        Code{"NotAssigned", "J(0, 0) = -l*sin(q_0); J(0, 1) = -s;", 1,
             "nothing is assigned to it, so it counts as zero"},
        Code{"UnknownName", "J(0, 0) = -l\n * sin(r);" REST, 1, "/mine.cpp:2:8)"},
        Code{"UnknownFunction", "J(0, 0) = -l*sine(q_0);" REST, 1, "no function named 'sine'"},
        Code{"Cast", "J(0, 0) = -l*\n static_cast<double>(s);" REST, 2,
             "mine.cpp:2:2: a cast cannot be read"},
        Code{"OldCast", "J(0, 0) = -(double)l*sin(q_0);" REST, 2, "mine.cpp:1:12: a cast"},
        Code{"CastInALocal", "auto c = double(s);\nJ(0, 0) = c;" REST, 2,
             "mine.cpp:1:10: 'c' cannot be read: a cast"},
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
             "mine.cpp:1:14: J is filled inside a condition or a loop"},
        Code{"ConditionalStatement", "if (s > 0) J(0, 0) = -l*sin(q_0);" REST, 2,
             "cannot read this use of J"},
        Code{"Loop", "for (int i = 0; i < 2; ++i) J(i, 0) = l;" REST, 2,
             "cannot read this use of J"},
        Code{"ListTooShort", "J << l, s, l;", 2, "audited as 2 by 2, and this lists 3 entries"},
        Code{"Outside", "J(2, 0) = l;", 2, "audited as 2 by 2, and this entry is outside"},
        Code{"Nothing", "K(0, 0) = l;", 2, "mine.cpp:1:1: nothing is assigned to J"}),
    [](const testing::TestParamInfo<Code>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::code_matrix_test
