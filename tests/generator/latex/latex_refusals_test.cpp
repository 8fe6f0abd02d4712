// Law: ambiguous notation is refused at its place in the paper, and never guessed; so are mistakes
// in a map or a paper.
#include <gtest/gtest.h>

#include <algorithm>

#include "audit/latex/paper_audit.hpp"

namespace assur::test::latex_refusals_test {
namespace {

using namespace generator::audit;

const std::string quantities = R"(length a b c ab x_1 x1 M
angle theta phi
unknown c
closure f1 = a - c
J = matrix of f1 by a b
K = matrix by its titles
S = matrix of b by a
P = matrix of b by b
Q = matrix of b by a
w = as printed
m_? = a
s_? = a
index u = 1..30
index v = 1..30
index z = 1..30
sum over p = 1..40
sum over q = 1..40
sum over r = 1..40
)";

struct Refusal {
  const char* latex;
  std::size_t column;  ///< on the second line of the paper
  const char* reason;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.latex; }

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, HaveTheirPlaceAndReason) {
  const std::string paper =
      std::string("\\begin{equation}\n") + GetParam().latex + "\n\\end{equation}\n";
  const AuditReport report = latex::audit_paper_text(paper, "p.tex", quantities, "p.map");
  ASSERT_EQ(report.statements.size(), 1U);
  const Finding& finding = report.statements[0].findings.at(0);
  EXPECT_EQ(finding.comparison.verdict, Verdict::unreadable);
  EXPECT_EQ(finding.comparison.evidence, GetParam().reason);
  EXPECT_EQ(finding.place.line, 2U);
  EXPECT_EQ(finding.place.column, GetParam().column);
}

const char* const argument =
    "does the function's argument go on here? write brackets, or \\, after the argument";
const char* const number =
    "a number stands directly after a factor; write \\cdot, or braces around an index or a power "
    "of two digits";
const char* const below = "what is below the '/' is not clear; write \\frac or brackets";
const char* const sums =
    "written out, the sums have more than 20000 parts; let the map skip this equation";
const char* const call =
    "this may be a product or a function's argument; write \\cdot, or 'brackets multiply' in the "
    "map";

const std::vector<Refusal> refusals = {
    {"\\sin 2\\theta a = b", 14, argument},
    {"\\sin\\theta a = b", 12, argument},
    {"\\sin\\theta\\phi = b", 11, argument},
    {"\\sin\\theta(a + b) = c", 11, argument},
    {"\\sin\\theta\\sqrt{a} = c", 11, argument},
    {"\\sin\\theta/2 = b", 11, "is the function divided or its argument? write \\frac or brackets"},
    {"\\sin\\theta^2 = b", 5,
     "is the function raised or its argument? write \\sin^2 x, or brackets"},
    {"\\sin(\\theta)^2 = b", 13,
     "the base of this power is not clear; write \\sin^2 x, or brackets around it all"},
    {"\\sin^{-1}\\theta = b", 1,
     "only whole powers of functions are clear; write brackets around the function"},
    {"\\sin{\\theta + \\phi} = b", 5, "the function's argument is not clear; write brackets"},
    {"\\sin -\\theta = b", 1, "the function has no argument"},
    {"\\sin = b", 1, "the function has no argument"},
    {"\\sin(\\theta, \\phi) = b", 5, "sin takes another number of arguments"},
    {"a/bc = c", 4, below},
    {"a/b/c = c", 4, below},
    {"a/b\\cdot c = c", 4, below},
    {"1/2(a + b) = c", 4, below},
    {"a(b) = c", 2, call},
    {"a(b + c) = c", 2, call},
    {"a\\left(b + c\\right) = c", 7, call},
    {"b a2 = c", 4, number},
    {"a^12 = c", 4, number},
    {"\\frac12 3 = c", 9, number},
    {"a2 = c", 2, number},
    {"2\\frac12 a = c", 2,
     "this may be a mixed number or a product; write \\cdot, or a sum in brackets"},
    {"a^{(1)} = a", 1,
     "this may be an index or a power; say in the map what it is, or write the power without "
     "brackets"},
    {"ab = c", 1,
     "'ab' is a quantity, and may be a product here; set it as \\mathit{...} or say in the map "
     "what "
     "it is"},
    {"x_1 = c", 1, "'x_1' and 'x1' are both quantities; say in the map which of them this is"},
    {"z = c", 1, "no quantity is known as 'z'"},
    {"a + z_{12}^2 = c", 5, "no quantity is known as 'z_12^2'"},
    {"\\varphi = \\phi", 1, "no quantity is known as 'varphi'"},
    {"\\foo a = c", 1, "\\foo is not read"},
    {"|a| = c", 1, "an absolute value or a determinant is not read"},
    {"a = \\pm b", 5, "'\\pm' is two statements; write each of them"},
    {"a \\approx b", 3, "only equations can be compared, and this is '\\approx'"},
    {"a + b", 1, "an equation with two sides is expected"},
    {"a = ", 1, "a side of this equation is missing"},
    {"a + = c", 3, "a factor is missing"},
    {"a \\cdot \\cdot b = c", 9, "\\cdot is not read"},
    {"a \\cdot -b = c", 3, "a factor is missing"},
    {"(a + b = c", 1, "'(' is not closed"},
    {"(a + b] = c", 7, "'(' is closed by ']'"},
    {"a) = c", 2, "')' closes nothing"},
    {"{a + b} c = c", 1, "braces around a sum are not printed; write brackets"},
    {"{a b}^2 = c", 6,
     "braces are not printed, so the base of the power is not clear; write brackets"},
    {"a^b^c = c", 4, "this has two superscripts; write brackets"},
    {"a_1_2 = c", 4, "this has two indices; write them as one"},
    {"\\sqrt[3]{a} = c", 1, "only square roots can be compared"},
    {"2,5 a = c", 2, "',' is not expected here"},
    {"5. a = c", 2, "a digit is missing after the point"},
    {"\\frac{\\partial^2 a}{\\partial b} = c", 1,
     "the orders of this derivative above and below the bar differ"},
    {"\\frac{\\partial^{12} a}{\\partial b^{12}} = c", 1,
     "the order of a derivative is a number from 1 to 9"},
    {"\\frac{\\partial a}{\\partial c} = b", 1,
     "what follows the closures is differentiated by a parameter, and 'c' is an unknown"},
    {"\\frac{d^2 a}{d b} = c", 1, "the orders of this derivative above and below the bar differ"},
    {"\\frac{d^2 a}{d t^3} = c", 1, "the orders of this derivative above and below the bar differ"},
    {"\\frac{d^2 a}{d b\\,d a\\,d b} = c", 1,
     "the orders of this derivative above and below the bar differ"},
    {"\\partial c/\\partial c = b", 1,
     "what follows the closures is differentiated by a parameter, and 'c' is an unknown"},
    {"\\frac{\\partial\\dot c}{\\partial\\dot b} = a", 31, "'b' has no rate; declare 'moving b'"},
    {"\\frac{d}{d t} a\\,b = c", 16, "write brackets around what is differentiated"},
    {"\\dot{a b} = c", 1, "dots stand above a single symbol"},
    {"\\dot{\\ddddot{a}} = c", 1, "more than four dots are not read"},
    {"\\sum_{i}^{3} a_i = c", 1, "write a sum as \\sum_{i=1}^{4}"},
    {"\\sum_{i=1}^{99}\\sum_{j=1}^{99}\\sum_{k=1}^{99}\\sum_{l=1}^{99} m_{ijkl} = c", 1, sums},
    {"a = s_{pqr}", 5, sums},
    {"a = m_{uvz}", 1,
     "the indices make more than 20000 equations of this one; let the map skip it"},
    {"K = \\begin{array}{c|c} a \\\\ f_1 \\end{array}", 5, "this matrix has no entries"},
    {"K = \\begin{array}{c|c} a & b \\end{array}", 5, "this matrix has no entries"},
    {"S = -P^{-1} Q", 5, "'b' is not a closure, and such a product has derivatives of closures"},
    {"a = w", 5, "the paper does not define 'w' in a way that can be read"},
    {"J = \\begin{vmatrix} 1 & 0 \\end{vmatrix}", 5, "a determinant is not read; write it out"},
    {"J = 2\\begin{pmatrix} 1 & 0 \\end{pmatrix}", 6,
     "only a matrix by itself can be compared, without factors, terms and superscripts"},
    {"J = \\begin{pmatrix} 1 & 0 & 0 \\end{pmatrix}", 5,
     "the map says 1 by 2 entries, and these are 1 by 3"},
    {"J = \\begin{pmatrix} 1 & 0 \\\\ 0 \\end{pmatrix}", 30,
     "the number of entries in this row is 1, and in the first row it is 2"},
    {"J = a", 5, "a matrix is expected here"},
    {"K = \\begin{pmatrix} 1 & 0 \\end{pmatrix}", 5,
     "the matrix has no titles that rules separate from its entries"},
    {"a = \\begin{pmatrix} 1 & 0 \\end{pmatrix}", 5, "a matrix stands where a number is expected"},
    {"M = M^{\\mathrm{T}}", 8, "no quantity is known as 'T'"}};

INSTANTIATE_TEST_SUITE_P(Formulas, Refusals, testing::ValuesIn(refusals),
                         [](const auto& tested) { return "n" + std::to_string(tested.index); });

TEST(MapOfRefusals, ABlankEntryIsNoZeroUnlessTheMapSaysSo) {
  const std::string paper = "\\[ J = \\begin{pmatrix} 1 & \\end{pmatrix} \\]";
  const auto entry = [&](const std::string& map) {
    return latex::audit_paper_text(paper, "p.tex", map, "p.map").statements[0].findings[1];
  };
  EXPECT_EQ(entry(quantities).comparison.evidence, "a formula is missing");
  EXPECT_TRUE(entry(quantities + "blanks are zero\n").agrees());
}

const Finding& only_finding(const AuditReport& report) {
  return report.statements.at(0).findings.at(0);
}

TEST(MapOfRefusals, AFormulaOfTheMapStaysShort) {
  const std::string map = "length a\nb = a\nw_? = a" + std::string(300, '?') + "\n";
  const std::string paper = "\\[ b = w_{" + std::string(100, '1') + "} \\]";
  const AuditReport report = latex::audit_paper_text(paper, "p.tex", map, "p.map");
  EXPECT_EQ(only_finding(report).comparison.evidence,
            "the map's formula for this has more than 10000 characters");
}

TEST(MapOfRefusals, AFormulaOfTheMapIsNotReadThousandsOfTimes) {
  std::string formula = "a";
  for (int term = 0; term < 500; ++term) {
    formula += " + a";
  }
  std::string sum = "w";
  for (int term = 0; term < 2000; ++term) {
    sum += " + w";
  }
  const AuditReport report = latex::audit_paper_text(
      "\\[ b = " + sum + " \\]", "p.tex", "length a\nb = a\nw = " + formula + "\n", "p.map");
  EXPECT_EQ(only_finding(report).comparison.evidence,
            "written out, this has more than 2000000 tokens; let the map skip this equation");
}

TEST(MapOfRefusals, AnEquationIsNotReadThousandsOfTimes) {
  std::string sum = "m_j";
  for (int term = 0; term < 3000; ++term) {
    sum += " + a";
  }
  const AuditReport report = latex::audit_paper_text(
      "\\[ a = " + sum + " \\]", "p.tex", "length a\nm_? = a\nindex j = 1..999\n", "p.map");
  EXPECT_EQ(only_finding(report).comparison.evidence,
            "the indices make more than 10000000 letters of this one; let the map skip it");
}

TEST(MapOfRefusals, DefinitionsMayEachNeedTheNext) {
  std::string paper;
  for (int name = 1; name < 200; ++name) {
    paper += "\\[ w_{" + std::to_string(name) + "} = w_{" + std::to_string(name + 1) + "} \\]\n";
  }
  const AuditReport report =
      latex::audit_paper_text(paper + "\\[ w_{200} = 2a \\]\n\\[ a + a = w_1 \\]", "p.tex",
                              "length a\nw_? = as printed\n", "p.map");
  EXPECT_TRUE(report.agrees());
}

TEST(MapOfRefusals, OfSeveralDefinitionsTheFirstThatCanBeReadCounts) {
  const AuditReport report = latex::audit_paper_text(
      "\\[ w = u \\] \\[ w = v \\] \\[ v = a \\] \\[ u = 2a \\] \\[ 2a = w \\]", "p.tex",
      "length a\nu = as printed\nv = as printed\nw = as printed\n", "p.map");
  ASSERT_EQ(report.statements.size(), 1U);
  const std::vector<Finding>& findings = report.statements[0].findings;
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].printed, "w = v");
  EXPECT_FALSE(findings[0].agrees());
  EXPECT_TRUE(findings[1].agrees());
}

TEST(MapOfRefusals, BracketsMultiplyWhereTheMapSaysSo) {
  EXPECT_TRUE(latex::audit_paper_text("\\[ a(b + c) = ac + ba \\]", "p.tex",
                                      quantities + "brackets multiply\n", "p.map")
                  .agrees());
}

struct Unusable {
  const char* paper;
  const char* map;
  const char* message;
};

class UnusablePaper : public testing::TestWithParam<Unusable> {};

TEST_P(UnusablePaper, GetsOneLineWithItsPlace) {
  try {
    static_cast<void>(latex::audit_paper_text(GetParam().paper, "p.tex", GetParam().map, "p.map"));
    FAIL() << "nothing was thrown";
  } catch (const text::InputError& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, UnusablePaper,
    testing::Values(
        Unusable{"caf\xE9", "length a\n",
                 "p.tex: the byte at offset 3 is not UTF-8; save the file as UTF-8"},
        Unusable{"caf\x1B", "length a\n",
                 "p.tex: the byte at offset 3 is a control character; remove it"},
        Unusable{"\\[ a = a", "length a\n", "p.tex:1:1: \\[ is not closed"},
        Unusable{"\n $a", "length a\n", "p.tex:2:2: $ is not closed"},
        Unusable{"\\begin{align} a &= a", "length a\n", "p.tex:1:1: \\begin{align} is not closed"},
        Unusable{"\\input{more}", "length a\n",
                 "p.tex:1:1: the equations of another file are not followed; audit it by itself"},
        Unusable{"\\iffalse \\[ a = a \\] \\fi", "length a\n",
                 "p.tex:1:1: \\iffalse is not followed; take it out"},
        Unusable{"\\mathcode`\\-=43 \\[ a - a = a + a \\]", "length a\n",
                 "p.tex:1:1: \\mathcode changes what letters mean, which is not followed"},
        Unusable{"\\catcode`\\*=13 \\def*{+}\\[ a * a = a^2 \\]", "length a\n",
                 "p.tex:1:1: \\catcode changes what letters mean, which is not followed"},
        Unusable{"\\begin{empheq}{align} a &= 2a \\end{empheq} \\[ a = a \\]", "length a\n",
                 "p.tex:1:1: what is in 'empheq' is not read; write equation or align"},
        Unusable{"\\setcounter{equation}{\\value{a}}\\[ a = a \\]", "length a\n",
                 "p.tex:1:1: the numbers of equations are set to '\\value{a}', which is not "
                 "followed; write the number"},
        Unusable{"\\begin{equation} a = a \\end{equation}", "length a\nskip (2)\n",
                 "p.map:2:6: the paper has no equation (2) that could be skipped"},
        Unusable{"\\def\\x{\\x\\x}\\[ \\x \\]", "length a\n",
                 "p.tex:1:16: expanding \\x takes more than 20000 replacements; write it out"},
        Unusable{"\\newcommand{\\x}[1][b]{#1}\\[ \\x = a \\]", "length a\n",
                 "p.tex:1:29: the definition of \\x cannot be followed; write it out"},
        Unusable{"Nothing.", "length a\n",
                 "p.tex: nothing to audit: no displayed equation was found"},
        Unusable{"\\[ a = a \\] \\begin{equation} a = a \\end{equation}",
                 "length a\nskip (1)\nskip sections Aim\n",
                 "p.map:3:15: the paper has no section 'Aim' that could be skipped"},
        Unusable{"\\begin{equation} a = a \\end{equation}", "length a\nskip (1)\n",
                 "p.tex: nothing to audit: the map skips every equation"},
        Unusable{"\\section{Aims} \\[ a = a \\]", "length a\nskip sections Aims\n",
                 "p.tex: nothing to audit: the map skips every equation"},
        Unusable{"\\[ b = a \\]", "length a\nb = as printed\n",
                 "p.tex: nothing to audit: the equations only define what the map takes as "
                 "printed"},
        Unusable{"\n $$a = a", "length a\n", "p.tex:2:2: $$ is not closed"},
        Unusable{"\n $$a = a$ b", "length a\n", "p.tex:2:2: $$ is not closed"},
        Unusable{"\\catcode`@=11 \\[ a = a \\]", "length a\n",
                 "p.tex:1:1: \\catcode changes what letters mean, which is not followed"},
        Unusable{"\\def\\x{\\y}\\def\\y{\\x}\\[ \\x \\]", "length a\n",
                 "p.tex:1:24: expanding \\x takes more than 20000 replacements; write it out"},
        Unusable{"\\def\\f#1{#1\\f{#1}}\\def\\g{a}\\[ \\f\\g \\]", "length a\n",
                 "p.tex:1:31: expanding \\f takes more than 20000 replacements; write it out"},
        Unusable{
            "\\def\\f#1{\\f{#1#1}}\\[ \\f a \\]", "length a\n",
            "p.tex:1:22: expanding the commands up to \\f makes more than 2000000 tokens; write "
            "it out"},
        Unusable{"\\section[a \\[ a = a \\]", "length a\n", "p.tex:1:9: [ is not closed"},
        Unusable{"\\[ a = a \\]", "length a\nq_1 = a\nq_{1} = 2*a\n",
                 "p.map:3:1: the notation 'q_{1}' is given twice; leave one out"},
        Unusable{"\\[ a = a \\]", "length a\nq_? = a\n\nq_? = as printed\n",
                 "p.map:4:1: the notation 'q_?' is given twice; leave one out"},
        Unusable{"\\[ a = a \\]", "length a\nJ = matrix by its titles\nJ = a\n",
                 "p.map:3:1: the notation 'J' is given twice; leave one out"},
        Unusable{"\\[ a = a \\]", "length a\nindex j = 1..2\nsum over j = 1..3\n",
                 "p.map:3:10: the index 'j' is given twice; leave one out"},
        Unusable{"\\[ a = a \\]",
                 "length a\ndisplay \\n{EQUATION}{NUMBER}\ndisplay \\n{NUMBER}{EQUATION}\n",
                 "p.map:3:9: the command '\\n' is given twice; leave one out"},
        Unusable{"\\[ a = b_j \\]", "length a\nb_? = a\nsum over j = j\n",
                 "p.map:3:10: the values of the index 'j' contain it again, so that the sum would "
                 "not end; use another letter"},
        Unusable{"\\[ a = b_j \\]", "length a\nb_? = a\nsum over j = 1 kk\nsum over k = 1 j\n",
                 "p.map:4:10: the values of the index 'k' contain it again, so that the sum would "
                 "not end; use another letter"},
        Unusable{"\\[ a = a \\]", "length a\nsum over 1 = 1..2\n",
                 "p.map:2:10: the values of the index '1' contain it again, so that the sum would "
                 "not end; use another letter"},
        Unusable{"\\[ a = a \\]", "length a\nclosure f = a\nJ = matrix of f by ?\n",
                 "p.map:3:20: the notation has no '?' for which the one here could stand"},
        Unusable{
            "\\[ a = a \\] \\setcounter{equation}{2147483647}", "length a\n",
            "p.tex:1:13: the numbers of equations are set to more than 1000000; write a smaller "
            "number"},
        Unusable{"\\[ a = a \\]", "length a\n{} = 4\n",
                 "p.map:2:1: the notation '{}' has no symbol; write the one that the paper prints"},
        Unusable{"\\[ a = a \\]", "length a\n\\, = matrix by its titles\n",
                 "p.map:2:1: the notation '\\,' has no symbol; write the one that the paper "
                 "prints"},
        Unusable{"\\[ a = a \\]", "length a\nskip\n",
                 "p.map:2:5: expected equations, such as 'skip (2) (9)', or 'skip sections TITLE, "
                 "...'"},
        Unusable{"\\[ a = a \\]", "length a\nskip sections\n",
                 "p.map:2:14: the title of a section is missing"},
        Unusable{"\\documentclass{a}\\titleformat{\\section}{}\\begin{document}\\section{Aims}"
                 "\\section{Ends}\\end{document}",
                 "length a\nskip sections Aims, Ends\n",
                 "p.tex: nothing to audit: no displayed equation was found"},
        Unusable{"\\section[Short]{Long title} \\[ a = a \\]",
                 "length a\nskip sections Long title\n",
                 "p.tex: nothing to audit: the map skips every equation"},
        Unusable{"\\section*[A {]} b]{Ends} \\[ a = a \\]", "length a\nskip sections Ends\n",
                 "p.tex: nothing to audit: the map skips every equation"},
        Unusable{"\n\\section[Short{Long} \\[ a = a \\]", "length a\n",
                 "p.tex:2:9: [ is not closed"},
        Unusable{"\\section{Loops, rods, and pins} \\[ a = a \\] \\section{Ends} \\[ a = a \\]"
                 "\\section{Loops} \\[ a = a \\]",
                 "length a\nskip sections Ends, Loops, rods, and pins, Loops\n",
                 "p.tex: nothing to audit: the map skips every equation"},
        Unusable{"\\section{Loops, rods} \\[ a = a \\]", "length a\nskip sections Loops, pins\n",
                 "p.map:2:15: the paper has no section 'Loops' that could be skipped"},
        Unusable{"\\section{Aims} \\[ a = a \\]", "length a\nskip sections Aimz\n",
                 "p.map:2:15: the paper has no section 'Aimz' that could be skipped "
                 "(did you mean 'Aims'?)"},
        Unusable{"\\[ a = a \\]", "length a\nprinted equation (1) : a = a\n",
                 "p.map:2:1: 'printed' is a statement of audit files, and a map has none of them; "
                 "leave it out"},
        Unusable{"\\[ a = a \\]", "length a\ngiven b = 5\n",
                 "p.map:2:1: 'given' is a statement of audit files, and a map has none of them; "
                 "leave it out"},
        Unusable{"\\[ a = a \\]", "length a\nindex j = 9..1\n",
                 "p.map:2:11: expected a range such as 1..4, upwards and of numbers below 1000, "
                 "found '9..1'"},
        Unusable{"\\[ a = a \\]", "length a\nindex j = a..b\n",
                 "p.map:2:11: expected a range such as 1..4, upwards and of numbers below 1000, "
                 "found 'a..b'"},
        Unusable{"\\[ a = a \\]", "length a\nindex j = 1..999999999\n",
                 "p.map:2:11: expected a range such as 1..4, upwards and of numbers below 1000, "
                 "found '1..999999999'"},
        Unusable{"\\[ a = a \\]", "length a\nsum over i = 2..x\n",
                 "p.map:2:14: expected a range such as 1..4, upwards and of numbers below 1000, "
                 "found '2..x'"},
        Unusable{"\\[ a = a \\]", "length a1 a2\nq_1 = a1 +\n  2*aa\n",
                 "p.map:3:5: no symbol named 'aa' (did you mean 'a1'?)"},
        Unusable{"\\[ a = a \\]", "length r\nclosure f1 = r\nJ = matrix of f1..9 by r\n",
                 "p.map:3:15: no symbol named 'f2' (did you mean 'f1'?)"},
        Unusable{"\\[ a = a \\]", "length r\nclosure f1 = r\nJ = matrix of f1 by r f1\n",
                 "p.map:3:23: 'f1' is not the name of a length or an angle"},
        Unusable{"\\[ a = a \\]", "length a\n\n\nq_{1 = a\n",
                 "p.map:4:3: this brace is not closed"},
        Unusable{"\\[ a = a \\]", "length a\n\ndisplay \\n{EQUATION\n",
                 "p.map:3:11: this brace is not closed"},
        Unusable{"\\[ a = a \\]", "length a a\n", "p.map:1:10: 'a' is declared already"},
        Unusable{"\\[ a = a \\]", "length a\nb = 2 +\n",
                 "p.map:2:8: the expression ends where a number, a name or '(' is expected"},
        Unusable{"\\[ a = a \\]", "lenght a\n",
                 "p.map:1:1: expected NOTATION = QUANTITY, or a statement of a map"},
        Unusable{"\\[ a = a \\]", "length a\nclosures no.audit\n",
                 "p.map:2:10: no.audit: cannot be read (does it exist, and is it a file?)"},
        Unusable{"\\[ a = a \\]", "length a\nindex jj = 1..2\n",
                 "p.map:2:7: expected an index and its values, such as j = 1..4"},
        Unusable{"\\[ a = a \\]", "length a\nJ = matrix by a\n",
                 "p.map:2:5: expected 'matrix of ROWS by COLUMNS' or 'matrix by its titles'"},
        Unusable{"\\[ a = a \\]", "length a\ndisplay numbered\n",
                 "p.map:2:9: expected 'display \\COMMAND{EQUATION}{NUMBER}'"},
        Unusable{"\\[ a = a \\]", "length a\nbrackets call\n",
                 "p.map:2:1: expected 'brackets multiply' or 'blanks are zero'"},
        Unusable{"\\[ a = a \\]", "length rate\n",
                 "p.map:1:8: 'rate' cannot be a name: formulas have a function of that name"},
        Unusable{"\\[ a = a \\]",
                 "length a b c\nunknown b c\nclosure f = a - c\nclosure g = b - c\n"
                 "J = matrix of b by a c\n",
                 "p.map:5:22: 'b' follows the closures, and 'c' is an unknown; a matrix has "
                 "derivatives by parameters"},
        Unusable{"\\[ a = a \\]", "length a\nJ = matrix of rate(b) by a\n",
                 "p.map:2:20: no symbol named 'b' (choose from a)"},
        Unusable{"\\[ a = a \\]", "length a\nconstant rate(a)\n",
                 "p.map:2:15: 'a' does not move; declare 'moving a' first"},
        Unusable{"\\[ a = a \\]", "length a\nconstant a\n",
                 "p.map:2:10: expected 'constant rate(NAME) ...', found 'a'"}),
    [](const auto& tested) { return "n" + std::to_string(tested.index); });

}  // namespace
}  // namespace assur::test::latex_refusals_test
