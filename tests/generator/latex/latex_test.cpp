// Law: a formula in LaTeX means what the same formula means in an audit file, however a paper sets
// it; no text makes the reader do anything but answer or refuse in one line.
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <random>

#include "audit/audit_report.hpp"
#include "audit/latex/paper_audit.hpp"
#include "whole_campaign.hpp"

namespace assur::test::latex_test {
namespace {

using namespace generator::audit;

const std::string quantities = R"(length a b c a1 a2 a12 bs x_M AB
angle theta phi theta_1 theta_2
moving theta_1 a
b\!s_? = bs
\varphi = phi
L_{AB} = AB
s_{12} = sin(theta_1 + theta_2)
EM = c
)";

AuditReport report_of(const std::string& paper, const std::string& map) {
  return latex::audit_paper_text(paper, "p.tex", map, "p.map");
}

struct Meaning {
  const char* latex;
  const char* formula;
};

class LatexMeaning : public testing::TestWithParam<Meaning> {};

TEST_P(LatexMeaning, IsThatOfTheFormula) {
  const std::string map = quantities + "q = " + GetParam().formula + "\n";
  const std::string paper =
      std::string("\\begin{equation}\n") + GetParam().latex + " = q\n\\end{equation}\n";
  const AuditReport report = report_of(paper, map);
  ASSERT_EQ(report.statements.size(), 1U);
  ASSERT_EQ(report.statements[0].findings.size(), 1U);
  const Finding& finding = report.statements[0].findings[0];
  EXPECT_TRUE(finding.agrees()) << finding.printed << ": " << finding.comparison.evidence;
}

const std::vector<Meaning> meanings = {
    {"a b", "a*b"},
    {"2a\\,b", "2*a*b"},
    {"2ab + 3", "2*a*b + 3"},
    {"-a + b - c", "b - a - c"},
    {"a \\cdot b \\times c", "a*b*c"},
    {"\\frac{a}{b}", "a/b"},
    {"\\dfrac ab", "a/b"},
    {"\\tfrac12 a", "a/2"},
    {"\\frac{1}{2}\\frac{a+b}{c}", "(a + b)/(2*c)"},
    {"a/b + c", "a/b + c"},
    {"a/(b c)", "a/(b*c)"},
    {"ab/c", "a*b/c"},
    {"a^2 + b^{3}", "a^2 + b^3"},
    {"a_1^2 a_{12}", "a1^2*a12"},
    {"(a + b)^2", "(a + b)^2"},
    {"\\left( a + b \\right)\\left[ a - b \\right]", "a^2 - b^2"},
    {"\\left\\{ a + b \\right\\} c", "(a + b)*c"},
    {"a^2(b + c)", "a^2*(b + c)"},
    {"2(b + c)", "2*(b + c)"},
    {"(a)(b + c)", "a*(b + c)"},
    {"a\\,(b + c)", "a*(b + c)"},
    {"\\sqrt{a^2 + b^2}", "sqrt(a^2 + b^2)"},
    {"\\sqrt[2]{a} \\sqrt a", "a"},
    {"\\sin\\theta", "sin(theta)"},
    {"\\sin \\theta \\cos \\varphi", "sin(theta)*cos(phi)"},
    {"\\sin^2\\theta + \\cos^{2}\\theta", "1"},
    {"\\sin 2\\theta", "sin(2*theta)"},
    {"\\sin\\theta + b", "sin(theta) + b"},
    {"a \\sin\\theta - b\\cos\\theta_1", "a*sin(theta) - b*cos(theta_1)"},
    {"\\sin\\theta\\,a", "a*sin(theta)"},
    {"\\sin\\theta \\cdot a", "a*sin(theta)"},
    {"\\sin(\\theta_1 + \\theta_2)", "sin(theta_1 + theta_2)"},
    {"\\sin\\left(\\theta_{1} + \\theta_{2}\\right) a", "a*sin(theta_1 + theta_2)"},
    {"s_{12}", "sin(theta_1 + theta_2)"},
    {"s_{12}^2", "sin(theta_1 + theta_2)^2"},
    {"\\cos{\\theta}", "cos(theta)"},
    // As SymPy prints.
    {"\\cos{\\left(\\theta \\right)}", "cos(theta)"},
    {"\\sin^{2}{\\left(\\theta_{1} + \\theta_{2} \\right)} a_{1}", "a1*sin(theta_1 + theta_2)^2"},
    {"- a_{1} \\tan{\\left(2 \\theta \\right)} \\cos{\\left(\\phi \\right)}",
     "-a1*tan(2*theta)*cos(phi)"},
    {"\\cos{\\left(\\operatorname{atan_{2}}{\\left(a,b \\right)} \\right)}", "b/sqrt(a^2 + b^2)"},
    {"\\cos{\\left(\\operatorname{atan}_{2}{\\left(a,b \\right)} \\right)}", "b/sqrt(a^2 + b^2)"},
    {"\\sqrt{a^{2} + b^{2}} \\cos{\\left(\\operatorname{atan}{\\left(\\frac{a}{b} \\right)} "
     "\\right)}",
     "b"},
    {"\\cos\\theta_1 (a + b)", "cos(theta_1)*(a + b)"},
    {"\\cos\\theta_1 \\left(a + b\\right) c", "cos(theta_1)*(a + b)*c"},
    {"\\sin(\\theta + \\pi/6)", "sin(theta)*sqrt(3)/2 + cos(theta)/2"},
    {"\\cos(\\theta - 45^\\circ)", "(cos(theta) + sin(theta))/sqrt(2)"},
    {"\\cos\\frac{\\pi}{2}", "0"},
    {"\\sin(\\theta + 90^\\circ)", "cos(theta)"},
    {"\\sin(\\theta + \\pi/2)", "cos(theta)"},
    {"\\tan\\theta\\cot\\theta", "1"},
    {"\\cos(\\arccos(a/b))", "a/b"},
    {"\\cos(\\operatorname{atan2}(a, b))", "b/sqrt(a^2 + b^2)"},
    {"\\cos\\left(\\operatorname{arctan} \\frac{a}{b}\\right)", "1/sqrt(1 + (a/b)^2)"},
    {"\\dot\\theta_1", "rate(theta_1)"},
    {"\\dot{\\theta}_1^2", "rate(theta_1)^2"},
    {"\\dot{\\theta_1}", "rate(theta_1)"},
    {"\\ddot{\\theta}_{1}", "rate2(theta_1)"},
    {"\\frac{d\\theta_1}{dt}", "rate(theta_1)"},
    {"\\frac{\\mathrm{d}^2 a}{\\mathrm{d}t^2}", "rate2(a)"},
    {"L_{\\mathrm{AB}}", "AB"},
    {"L_{\\text{AB}} \\; L_{AB}", "AB^2"},
    {"\\mathit{AB}", "AB"},
    {"x_{M}", "x_M"},
    {"EM\\, a", "a*c"},
    {"EM^2", "c^2"},
    {"EM \\sin\\theta", "c*sin(theta)"},
    {"0.5 a", "a/2"},
    {"{a} {b}", "a*b"},
    {"a % a comment, a + b\n + b", "a + b"},
    {"\\displaystyle a \\! b", "a*b"},
    {"\\sum_{i=1}^{2} a_i", "a1 + a2"},
    {"\\sum_{i=1}^{2} a_i^2 \\cos\\theta_i", "a1^2*cos(theta_1) + a2^2*cos(theta_2)"}};

INSTANTIATE_TEST_SUITE_P(Formulas, LatexMeaning, testing::ValuesIn(meanings),
                         [](const auto& tested) { return "n" + std::to_string(tested.index); });

/// A crank and a slider, as papers set them.
const std::string crank_map = R"(angle phi theta
length r l s
unknown theta s
moving phi
loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)
\varphi = phi
J = matrix of f1 f2 by theta s
)";

std::vector<std::string> labels(const AuditReport& report) {
  std::vector<std::string> list;
  for (const AuditedStatement& statement : report.statements) {
    for (const Finding& finding : statement.findings) {
      list.push_back(statement.label + (finding.agrees() ? "" : "!"));
    }
  }
  return list;
}

using Labels = std::vector<std::string>;

TEST(Latex, EnvironmentsAreCountedAsLatexCountsThem) {
  const std::string paper = R"(\documentclass{article}
\newcommand{\rod}{\theta}
\newcommand{\polar}[2]{#1\cos #2}
\begin{document}
In the text, $r = l$ is no equation of its own.
\begin{equation} f_1 = \polar{r}{\varphi} + \polar l\rod - s = 0. \label{eq:x} \end{equation}
\begin{align}
  r\sin\varphi + l\sin\rod &= 0, \\[2mm]
  s &= r\cos\varphi \nonumber \\
    &\quad + l\cos\rod \\
  s &= r \notag
\end{align}
\begin{gather*} s = l \end{gather*}
\[ \dot s = -r\sin\varphi\,\dot\varphi - l\sin\rod\,\dot\rod \]
$$ \frac{\partial s}{\partial r} = \cos\varphi + \sin\varphi \tan\rod \tag{A.1} $$
\begin{verbatim}
\begin{equation} s = 1 \end{equation}
\end{verbatim}
% \begin{equation} s = 2 \end{equation}
\begin{subequations}
\begin{equation} \left\{\begin{array}{l} s^2 = s\,s \\ l = r \end{array}\right. \end{equation}
\end{subequations}
\begin{equation}
J = \left[\begin{array}{cc} -l\sin\rod & -1 \\ l\cos\rod & 0 \end{array}\right]
\qquad J = \begin{bmatrix} l\sin\rod & -1 \\ l\cos\rod & 0 \end{bmatrix}
\end{equation}
\end{document}
\begin{equation} s = 3 \end{equation}
)";
  EXPECT_EQ(labels(report_of(paper, crank_map)),
            (Labels{"closure (1)", "equation (2)", "equation line 9", "equation line 11!",
                    "equation line 13!", "equation line 14", "equation (A.1)", "equation (3a)",
                    "equation (3a)!", "matrix (4)", "matrix (4)", "matrix (4)", "matrix (4)",
                    "matrix (4)!", "matrix (4)", "matrix (4)", "matrix (4)"}));
}

/// By a rate, by several parameters, of rates in matrices, at constant speed, as functions of time.
TEST(Latex, DerivativesOfRatesAndByRates) {
  const std::string paper = R"(
\[ \frac{\partial\dot s}{\partial\dot\varphi} = -r\sin\varphi + r\cos\varphi\tan\theta \]
\[ \frac{\partial\ddot s}{\partial\ddot\varphi} = \frac{\partial s}{\partial\varphi} \]
\[ \frac{\partial\ddot s}{\partial\dot\varphi} = 2\frac{d}{dt}\left(\frac{ds}{d\varphi}\right) \]
\[ \frac{\partial\ddot s}{\partial\dot\varphi} = \frac{d}{dt}\left(\frac{ds}{d\varphi}\right) \]
\[ \frac{d^2 s}{d\varphi\,dr} = \frac{d}{dr}\left(\frac{ds}{d\varphi}\right) \]
\[ \frac{d^2 s}{d\varphi dr} = 0 \]
\[ \ddot s = \frac{d^2 s}{d\varphi^2}\dot\varphi^2 \]
\[ V = \begin{pmatrix} \frac{\partial\dot s}{\partial r} & 0 \end{pmatrix} \]
\[ s = r\cos{\left(\varphi{\left(t \right)} \right)} + l\cos{\left(\theta \right)} \]
)";
  const std::string map = crank_map +
                          "constant rate(phi)\nV = matrix of rate(s) by r l\n"
                          "\\varphi{\\left(t \\right)} = phi\n";
  EXPECT_EQ(labels(report_of(paper, map)),
            (Labels{"equation line 2", "equation line 3", "equation line 4", "equation line 5!",
                    "equation line 6", "equation line 7!", "equation line 8", "matrix line 9",
                    "matrix line 9!", "equation line 10"}));
  // Without the constant speed, the acceleration has another term.
  EXPECT_EQ(
      labels(report_of("\\[ \\ddot s = \\frac{d^2 s}{d\\varphi^2}\\dot\\varphi^2 \\]", crank_map)),
      (Labels{"equation line 1!"}));
}

TEST(Latex, MatricesAsSymPyPrintsThem) {
  const std::string map = R"(length a1 a2 a3 a4
angle theta2 theta3 theta4
unknown theta3 theta4
moving theta2
loop f1 f2 = polar(a2, theta2) + polar(a3, theta3) - polar(a4, theta4) - point(a1, 0)
J = matrix of f1..2 by theta3..4
)";
  const std::string paper =
      R"(\begin{equation}\label{j} J = \left[\begin{matrix}- a_{3} \sin{\left(\theta_{3} \right)} & a_{4} \sin{\left(\theta_{4} \right)}\\a_{3} \cos{\left(\theta_{3} \right)} & - a_{4} \sin{\left(\theta_{4} \right)}\end{matrix}\right]\end{equation}
\begin{equation} \dot{\theta}_3 = - \frac{a_{2} \sin{\left(\theta_{2} - \theta_{4} \right)}}{a_{3} \sin{\left(\theta_{3} - \theta_{4} \right)}} \dot{\theta}_2 \end{equation}
)";
  EXPECT_EQ(labels(report_of(paper, map)),
            (Labels{"matrix (1)", "matrix (1)", "matrix (1)", "matrix (1)!", "equation (2)"}));
}

TEST(Latex, DefinitionsEndWithTheirGroups) {
  const std::string paper = R"(\newcommand{\x}{r}
\setcounter{equation}{6}
{\renewcommand{\x}{l} \begin{equation} \x = l \end{equation} \gdef\y{s}}
\begin{center} \let\x=\varphi \begin{equation} \sin\x = \sin\varphi \end{equation} \end{center}
\begin{equation} \x = r \end{equation}
\let\z\x \renewcommand{\x}{l}
\begin{equation} \z = \y \end{equation}
\begin{equation} \z = r \end{equation}
)";
  EXPECT_EQ(
      labels(report_of(paper, crank_map)),
      (Labels{"equation (7)", "equation (8)", "equation (9)", "equation (10)!", "equation (11)"}));
}

TEST(Latex, EveryDisplayIsRead) {
  for (const std::string name : {"dmath", "flalign*", "gather"}) {
    const std::string paper = "\\begin{" + name + "} r = l \\end{" + name + "}";
    EXPECT_FALSE(report_of(paper, crank_map).agrees()) << name;
  }
  for (const std::string name : {"alignat", "xalignat*", "IEEEeqnarray"}) {
    const std::string paper = "\\begin{" + name + "}{2} r &= l \\end{" + name + "}";
    EXPECT_FALSE(report_of(paper, crank_map).agrees()) << name;
  }
}

TEST(Latex, IndicesRunAndAreSummed) {
  const std::string map = R"(length a1 a2 b1 b2
unknown b1 b2
closure f1 = b1 - 2*a1 - a2
closure f2 = b2 - a1
index k = 1..2
index j = 1..2
sum over i = 1 2
)";
  const AuditReport report = report_of(
      R"(\begin{equation} \frac{\partial f_k}{\partial a_j}
      = -\frac{\partial f_k}{\partial b_i}\frac{\partial b_i}{\partial a_j} \qquad (k, j = 1, 2)
      \end{equation}
      \begin{equation} b_j = a_j \end{equation})",
      map);
  EXPECT_EQ(labels(report), (Labels{"equation (1)", "equation (1)", "equation (1)", "equation (1)",
                                    "equation (2)!", "equation (2)!"}));
  EXPECT_EQ(report.statements[1].findings[1].item, "j = 2");
}

TEST(Latex, ClosuresWithAllSignsTurnedCountInAnyOrder) {
  const std::string matrix =
      "\\begin{equation} J = \\begin{pmatrix} l\\sin\\theta & 1 \\\\ l\\cos\\theta & 0 "
      "\\end{pmatrix} \\end{equation}\n";
  const std::string closure =
      "\\begin{equation} f_1 = s - r\\cos\\varphi - l\\cos\\theta \\end{equation}\n";
  EXPECT_TRUE(report_of(matrix + closure, crank_map).agrees());
  EXPECT_TRUE(report_of(closure + matrix, crank_map).agrees());
  EXPECT_FALSE(report_of(matrix, crank_map).agrees());
}

TEST(Latex, WhatThePaperDefinesMayStandBehindItsUse) {
  const std::string map = crank_map + "u = as printed\nw = as printed\n";
  EXPECT_EQ(
      labels(report_of(R"(\[ s = u \] \[ u = w + l\cos\theta \] \[ w = r\cos\varphi \])", map)),
      (Labels{"equation line 1"}));
  EXPECT_EQ(labels(report_of(R"(\[ s = u \] \[ u = w \] \[ w = u \])", map)),
            (Labels{"equation line 1!", "equation line 1!", "equation line 1!"}));
  EXPECT_EQ(labels(report_of(R"(\[ u = s \] \[ u = r \])", map)), (Labels{"equation line 1!"}));
}

TEST(Latex, EquationsThatStandSideBySideAreSeveral) {
  const auto labels_of = [](const std::string& paper) {
    return labels(latex::audit_paper_text(paper, "p.tex", crank_map, "p.map"));
  };
  const std::vector<std::string> three = {"equation (1)", "equation (1)!", "equation (1)"};
  EXPECT_EQ(labels_of("\\begin{align} r &= r & l &= r & s &= s \\end{align}"), three);
  EXPECT_EQ(labels_of("\\begin{equation}\\begin{aligned} r &= r & l &= r \\\\ s &= s "
                      "\\end{aligned}\\end{equation}"),
            three);
  // One equation in three columns, and one that continues after a second equals sign.
  EXPECT_EQ(labels_of("\\begin{eqnarray} r &=& r \\end{eqnarray}"),
            std::vector<std::string>{"equation (1)"});
  EXPECT_EQ(labels_of("\\begin{align} r &= r &= r \\end{align}"),
            (std::vector<std::string>{"equation (1)", "equation (1)"}));
}

TEST(Latex, SurvivesRandomChanges) {
  constexpr unsigned seed = 2011;
  const int rounds = is_whole_campaign() ? 1500 : 500;
  constexpr double most_seconds = 5;
  const std::string good = R"(\newcommand{\rod}[1]{\theta#1}
\begin{align}
f_1 &= r\cos\varphi + l\cos\rod{} - s = 0, & \nonumber \\
\frac{\partial s}{\partial r} &= \cos\varphi + \sin^2\varphi\,\sqrt[2]{1 + s_{1}'}
\end{align}
\begin{equation} J = \left(\begin{array}{cc} -l\sin\theta & -1 \\ l\cos\theta & 0
\end{array}\right) \tag{2} \end{equation}
\[ \begin{cases} \dot s = \ddot{s}_1, \\ s = \frac12 l \end{cases} \quad (k = 1, \dots, 2) \]
)";
  const std::vector<std::string> pieces = {"{",
                                           "}",
                                           "\\",
                                           "_",
                                           "^",
                                           "&",
                                           "\\\\",
                                           "(",
                                           ")",
                                           "[",
                                           "]",
                                           "\\frac",
                                           "\\sqrt",
                                           "\\dot",
                                           "\\begin{",
                                           "\\end{",
                                           "\\left",
                                           "$",
                                           "$$",
                                           "%",
                                           "\n",
                                           "#1",
                                           "\\rod",
                                           "'",
                                           "\\sin",
                                           "\\sum_{i=1}^{9}",
                                           "\\partial",
                                           "\\[",
                                           "\\]",
                                           "=",
                                           "+",
                                           "9",
                                           ".",
                                           "\\newcommand",
                                           "\\def\\rod{\\rod}",
                                           "\\mathrm",
                                           "\\overline",
                                           "\\tag",
                                           "\xC3\xA9",
                                           "\xE9",
                                           "\\cases",
                                           "array",
                                           "\\quad",
                                           "-",
                                           "\\operatorname"};
  std::mt19937 engine(seed);
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string text = good;
    for (unsigned change = 0; change < 1 + engine() % 5; ++change) {
      const std::size_t at = engine() % (text.size() + 1);
      const std::string& piece = pieces[engine() % pieces.size()];
      switch (engine() % 4) {
        case 0:
          text.insert(at, piece);
          break;
        case 1:
          text.erase(at, 1 + engine() % 8);
          break;
        case 2:
          text.insert(at, text.substr(engine() % text.size(), engine() % 30));
          break;
        default:
          for (auto times = engine() % 200; times > 0; --times) {
            text.insert(at, piece);
          }
      }
    }
    const auto start = std::chrono::steady_clock::now();
    try {
      static_cast<void>(audit_report_text({report_of(text, crank_map)}));
    } catch (const text::InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_TRUE(std::string(error.what()).starts_with("p.tex:")) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << " for\n" << text;
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), most_seconds) << text;
  }
  std::cout << "seed " << seed << ": " << rounds << " papers, " << refused << " refused whole\n";
  EXPECT_GT(refused, rounds / 20);
  EXPECT_LT(refused, rounds * 9 / 10);
}

}  // namespace
}  // namespace assur::test::latex_test
