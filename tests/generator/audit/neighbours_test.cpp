// Law: the verdict on a statement does not depend on the other statements of an audit or on their
// order; names that formulas could not distinguish from functions are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "audit/audit.hpp"

namespace assur::test::neighbours_test {
namespace {

using namespace generator::audit;

const std::string declared = R"(angle phi theta
length r l s a b
unknown theta s
moving phi
let alpha = acos((a^2 + b^2 - r^2)/(2*a*b))
loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)
)";

/// Statements with roots that are real in different places, and without any.
const std::vector<std::string> statements = {
    "printed equation (1) : s = r*cos(phi) + sqrt(l^2 - r^2*sin(phi)^2)",
    "printed equation (2) : cos(alpha) = (a^2 + b^2 - r^2)/(2*a*b)",
    "printed equation (3) : sqrt(a - 2) = sqrt(a - 2)",
    "printed equation (4) : sqrt(2 - a)^2 = 2 - a",
    "printed equation (5) : cos(phi) = sqrt(1 - sin(phi)^2)",
    "printed equation (6) : sqrt(-a) = 1",
    "printed equation (7) : rate(s) = -r*sin(phi)*rate(phi) - l*sin(theta)*rate(theta)",
    "printed equation (8) : D(s, r) = cos(phi) + sin(phi)*sin(theta)/cos(theta)",
    "printed equation (9) : D(s, r) = cos(phi) - sin(phi)*sin(theta)/cos(theta)",
    "printed closure (10) f1 : r*cos(phi) + l*cos(theta) = s",
    "printed closure (11) f2 : r*sin(phi) - l*sin(theta)",
    "printed matrix (12) of f1 f2 by theta s\n  -l*sin(theta), -1\n  l*cos(theta), 0",
    "printed matrix (13) of f1 by r l\n  cos(phi), sqrt(1 - sin(theta)^2)",
    "printed equation (14) : sqrt(a^2 + b^2 - 2*a*b*cos(alpha)) = r",
    "printed equation (15) : sqrt(a*b) = sqrt(a)*sqrt(b)"};

using Verdicts = std::map<std::string, std::vector<Verdict>>;

Verdicts verdicts(const std::vector<std::string>& list, const std::string& more = "") {
  std::string text = declared + more;
  for (const std::string& statement : list) {
    text += statement + "\n";
  }
  Verdicts all;
  for (const AuditedStatement& statement : audit_text(text, "n").statements) {
    for (const Finding& finding : statement.findings) {
      all[statement.label].push_back(finding.comparison.verdict);
    }
  }
  return all;
}

TEST(Neighbours, EachStatementAloneHasTheVerdictThatItHasAmongAll) {
  const Verdicts together = verdicts(statements);
  ASSERT_EQ(together.size(), statements.size());
  for (const std::string& statement : statements) {
    for (const auto& [label, alone] : verdicts({statement})) {
      EXPECT_EQ(alone, together.at(label)) << statement;
    }
  }
}

TEST(Neighbours, TheOrderOfStatementsDoesNotMatter) {
  constexpr unsigned seed = 15;
  const Verdicts together = verdicts(statements);
  std::mt19937 engine(seed);
  std::vector<std::string> list = statements;
  for (int round = 0; round < 12; ++round) {
    for (std::size_t at = list.size(); at > 1; --at) {
      std::swap(list[at - 1], list[engine() % at]);
    }
    EXPECT_EQ(verdicts(list), together) << "round " << round << ", seed " << seed;
  }
}

TEST(Neighbours, AClosureWithAllSignsTurnedCountsBeforeItAndBehindIt) {
  const std::string closure = "printed closure (1) f1 : s - r*cos(phi) = l*cos(theta)";
  const std::string matrix = "printed matrix (2) of f1 by s theta\n  1, l*sin(theta)";
  const std::string other = "printed closure (3) f1 : r*cos(phi) + l*cos(theta) - s";
  EXPECT_EQ(verdicts({closure, matrix}), verdicts({matrix, closure}));
  EXPECT_EQ(verdicts({matrix, closure})["matrix (2)"],
            (std::vector<Verdict>{Verdict::agrees, Verdict::agrees}));
  // Where a closure is printed with both signs, the derived one counts.
  EXPECT_EQ(verdicts({closure, matrix, other})["matrix (2)"],
            (std::vector<Verdict>{Verdict::differs_by_sign, Verdict::differs_by_sign}));
  EXPECT_EQ(verdicts({closure, matrix, other}), verdicts({other, matrix, closure}));
}

TEST(Names, AreRefusedWhereFormulasHaveAFunctionOfThatName) {
  for (const std::string name : {"rate", "rate2", "pow", "point", "polar"}) {
    for (const auto& [text, column] : std::vector<std::pair<std::string, std::size_t>>{
             {"length " + name, 8}, {"angle x " + name, 9}, {"let " + name + " = 1", 5}}) {
      try {
        static_cast<void>(audit_text(text + "\n", "n"));
        FAIL() << text;
      } catch (const text::InputError& error) {
        EXPECT_EQ(error.what(), "n:1:" + std::to_string(column) + ": '" + name +
                                    "' cannot be a name: formulas have a function of that name");
      }
    }
  }
  // A length may be d or D: the functions have brackets behind them.
  EXPECT_TRUE(audit_text("length d D x\nangle th ph\nunknown ph x\nmoving th\n"
                         "loop f1 f2 = polar(d, th) + polar(D, ph) - point(x, 0)\n"
                         "printed equation (1) : x = d*cos(th) + D*cos(ph)\n"
                         "printed equation (2) : D(x, d) = D(d, d)*(cos(th) + tan(ph)*sin(th))\n"
                         "printed equation (3) : d(D*d, D) = d\n"
                         "printed matrix (4) of f1 by d D\n  cos(th), cos(ph)\n",
                         "n")
                  .agrees());
  // Formulas of numbers have no derivatives, so that d may be a name there.
  EXPECT_TRUE(audit_text("given d = 2\nprinted number n = 4 is 2*d\n", "n").agrees());
}

/// Names that the algebra, GiNaC or LaTeX have uses for mean what is declared.
TEST(Names, OfOtherUsesMeanWhatIsDeclared) {
  for (const std::string name :
       {"e", "I", "E", "i", "cos_phi", "sin_phi", "root_1", "Pi", "theta_", "f", "J", "x"}) {
    const std::string text =
        "angle phi q\nlength " + name + " w\nunknown w\nclosure g = w - " + name +
        "*cos(phi)\nprinted equation (1) : w = " + name +
        "*cos(phi)\nprinted equation (2) : w = " + name + "*sin(phi)\nprinted matrix (3) of g by " +
        name + " phi\n  -cos(phi), " + name + "*sin(phi)\nprinted equation (4) : sqrt(" + name +
        "^2) = " + name + "\n";
    const AuditReport report = audit_text(text, "n");
    EXPECT_TRUE(report.statements[0].findings[0].agrees()) << name;
    EXPECT_EQ(report.statements[1].findings[0].comparison.verdict, Verdict::differs) << name;
    EXPECT_TRUE(report.statements[2].findings[0].agrees()) << name;
    EXPECT_TRUE(report.statements[2].findings[1].agrees()) << name;
    EXPECT_TRUE(report.statements[3].findings[0].agrees()) << name;
  }
}

}  // namespace
}  // namespace assur::test::neighbours_test
