// Law: statements on repeated derivatives, by parameters, by time and partial, get the verdicts
// that follow exactly from explicit formulas of a slider-crank.
#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "audit/latex/paper_audit.hpp"
#include "whole_campaign.hpp"

namespace assur::test::nested_derivatives {
namespace {

using namespace generator::audit;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::sin;
using GiNaC::symbol;

/// x = r cos th + l cos ph and 0 = r sin th + l sin ph, solved for derivatives by hand.
class SliderCrank {
 public:
  static constexpr const char* declared =
      "length r l x\nangle th ph\nunknown ph x\nmoving th\n"
      "loop f1 f2 = polar(r, th) + polar(l, ph) - point(x, 0)\n";

  [[nodiscard]] ex total(const ex& of, const symbol& by) const {
    return of.diff(by) + of.diff(ph) * turn(by) + of.diff(x) * slide(by);
  }
  [[nodiscard]] ex rate(const ex& of) const {
    ex sum = of.diff(ph) * turn(th) * rates[0] + of.diff(x) * slide(th) * rates[0] +
             of.diff(th) * rates[0];
    for (std::size_t order = 0; order + 1 < rates.size(); ++order) {
      sum += of.diff(rates.at(order)) * rates.at(order + 1);
    }
    return sum;
  }

  symbol r{"r"}, l{"l"}, x{"x"}, th{"th"}, ph{"ph"};
  std::array<symbol, 6> rates = {symbol("rate(th)"),
                                 symbol("rate2(th)"),
                                 symbol("rate(rate2(th))"),
                                 symbol("rate2(rate2(th))"),
                                 symbol("rate(rate2(rate2(th)))"),
                                 symbol("rate2(rate2(rate2(th)))")};

 private:
  /// The derivative of ph by a parameter: l cos ph dph = -d(r sin th + l sin ph), ph held.
  [[nodiscard]] ex turn(const symbol& by) const {
    return -(r * sin(th) + l * sin(ph)).diff(by) / (l * cos(ph));
  }
  [[nodiscard]] ex slide(const symbol& by) const {
    return (r * cos(th) + l * cos(ph)).diff(by) - l * sin(ph) * turn(by);
  }
};

/// A nested derivative, as an audit file spells it and as an explicit formula.
struct Nest {
  std::string text;
  ex formula;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_;
};

Nest random_nest(const SliderCrank& crank, int depth, Random& random) {
  Nest nest = std::array<Nest, 4>{Nest{"x", crank.x},
                                  {"ph", crank.ph},
                                  {"sin(ph + th)", sin(crank.ph + crank.th)},
                                  {"x*cos(ph)", crank.x * cos(crank.ph)}}
                  .at(static_cast<std::size_t>(random.below(4)));
  for (int level = 0; level < depth; ++level) {
    const symbol by =
        std::array{crank.r, crank.l, crank.th}.at(static_cast<std::size_t>(random.below(3)));
    switch (random.below(5)) {
      case 0:
      case 1:
        nest = {"D(" + nest.text + ", " + by.get_name() + ")", crank.total(nest.formula, by)};
        break;
      case 2:
        nest = {"rate(" + nest.text + ")", crank.rate(nest.formula)};
        break;
      case 3:
        nest = {"rate2(" + nest.text + ")", crank.rate(crank.rate(nest.formula))};
        break;
      default: {
        const symbol held = random.below(3) == 0 ? crank.ph : by;
        nest = {"d(" + nest.text + ", " + held.get_name() + ")", nest.formula.diff(held)};
      }
    }
  }
  return nest;
}

std::string text_of(const ex& formula) {
  std::ostringstream text;
  text << formula;
  return text.str();
}

/// What the audit says of `left = right`.
bool agrees(const std::string& left, const std::string& right) {
  const AuditReport report = audit_text(
      SliderCrank::declared + ("printed equation (1) : " + left + " = " + right + "\n"), "nested");
  const Finding& finding = report.statements.at(0).findings.at(0);
  EXPECT_TRUE(finding.agrees() || finding.is_wrong())
      << left << " = " << right << ": " << finding.comparison.evidence;
  return finding.agrees();
}

TEST(NestedDerivatives, AreThoseOfExplicitFormulas) {
  constexpr unsigned seed = 57;
  Random random(seed);
  const SliderCrank crank;
  const int wanted = is_whole_campaign() ? 600 : 60;
  int right = 0;
  int wrong = 0;
  constexpr std::size_t longest = 9000;  // longer formulas are refused
  for (int trial = 0; right < wanted || wrong < wanted; ++trial) {
    const Nest nest = random_nest(crank, 2 + random.below(2), random);
    const std::string formula = text_of(nest.formula);
    if (formula.size() > longest) {
      continue;
    }
    SCOPED_TRACE(nest.text);
    EXPECT_TRUE(agrees(nest.text, formula));
    ++right;
    if (!nest.formula.is_zero()) {
      const std::array<std::string, 4> slips = {"0", "2*(" + formula + ")", "-(" + formula + ")",
                                                formula + " + r/7"};
      EXPECT_FALSE(agrees(nest.text, slips.at(static_cast<std::size_t>(trial % 4))));
      ++wrong;
    }
  }
  std::cout << "seed " << seed << ": " << right << " right and " << wrong << " wrong statements\n";
}

/// Total derivatives and rates may be taken in any order.
TEST(NestedDerivatives, MayBeTakenInAnyOrder) {
  for (const auto& [one, other] :
       {std::pair("D(rate(x), l)", "rate(D(x, l))"), std::pair("D(D(x, r), th)", "D(D(x, th), r)"),
        std::pair("rate(rate2(ph))", "rate2(rate(ph))"),
        std::pair("rate(D(rate(D(x, r)), l))", "D(D(rate2(x), l), r)")}) {
    EXPECT_TRUE(agrees(one, other)) << one;
  }
  EXPECT_FALSE(agrees("D(rate(x), l)", "D(rate(x), r)"));
  EXPECT_FALSE(agrees("d(rate(x), l)", "D(rate(x), l)"));
  EXPECT_TRUE(agrees("D(rate(th), l)", "0"));
}

/// What an audit of a paper with one equation says of it.
bool agrees_in_print(const std::string& equation) {
  const std::string map = SliderCrank::declared + std::string("\\theta = th\n\\varphi = ph\n");
  const AuditReport report = latex::audit_paper_text(
      "\\begin{equation}\n" + equation + "\n\\end{equation}\n", "p.tex", map, "p.map");
  const Finding& finding = report.statements.at(0).findings.at(0);
  EXPECT_TRUE(finding.agrees() || finding.is_wrong())
      << equation << ": " << finding.comparison.evidence;
  return finding.agrees();
}

TEST(NestedDerivatives, OfClosuresArePartial) {
  EXPECT_TRUE(
      agrees_in_print("\\frac{\\partial \\dot f_1}{\\partial\\theta} = "
                      "-r\\cos\\theta\\,\\dot\\theta"));
  EXPECT_FALSE(agrees_in_print("\\frac{\\partial \\dot f_1}{\\partial\\theta} = 0"));
  EXPECT_TRUE(
      agrees_in_print("\\frac{\\partial}{\\partial\\theta}\\left(2 f_1\\right) = "
                      "-2r\\sin\\theta"));
}

/// r = 1, l = 2, th = 1 and a rate of 1: 0.15224 and the like, to all digits that are given.
TEST(NestedDerivatives, AreTheKnownNumbers) {
  const SliderCrank crank;
  const ex turned = GiNaC::asin(-sin(ex(1)) / 2);
  const auto value = [&](const ex& formula) {
    GiNaC::exmap at = {{crank.r, 1}, {crank.l, 2}, {crank.th, 1}, {crank.rates[0], 1}};
    at[crank.ph] = turned;
    return GiNaC::ex_to<GiNaC::numeric>(formula.subs(at).evalf()).to_double();
  };
  EXPECT_NEAR(value(crank.total(crank.total(crank.x, crank.th), crank.th)), -0.34555, 5e-6);
  EXPECT_NEAR(value(crank.total(crank.total(crank.x, crank.r), crank.l)), 0.2371, 5e-5);
  EXPECT_NEAR(value(crank.total(crank.rate(crank.x), crank.l)), 0.15224, 5e-6);
}

TEST(NestedDerivatives, AreReadInPrint) {
  for (const auto& [left, right] : std::vector<std::pair<std::string, std::string>>{
           {"\\frac{d\\varphi}{d\\theta}", "-\\frac{r\\cos\\theta}{l\\cos\\varphi}"},
           {"\\frac{d^2 x}{d\\theta^2}", "\\frac{\\partial^2 x}{\\partial\\theta^{2}}"},
           {"\\frac{\\partial^2 x}{\\partial r\\,\\partial l}",
            "\\frac{\\partial^2 x}{\\partial l \\partial r}"},
           {"\\frac{\\partial^3 x}{\\partial r^2 \\partial l}",
            "\\frac{\\partial}{\\partial l}\\left(\\frac{\\partial^2 x}{\\partial r^2}\\right)"},
           {"\\frac{d}{d\\theta}\\left(\\frac{d\\varphi}{d\\theta}\\right)",
            "\\frac{d^2\\varphi}{d\\theta^2}"},
           {"\\frac{d}{dt}\\ddot{x}", "\\dddot{x}"},
           {"\\frac{d^4 x}{dt^4}", "\\ddddot{x}"},
           {"\\frac{\\partial \\dot{x}}{\\partial l}",
            "\\frac{d}{dt}\\left(\\frac{\\partial x}{\\partial l}\\right)"},
           {"\\frac{\\partial \\ddot{\\varphi}}{\\partial r}",
            "\\frac{d^2}{dt^2}\\frac{\\partial\\varphi}{\\partial r}"},
           {"\\frac{\\partial^2 f_2}{\\partial\\varphi^2}", "-l\\sin\\varphi"}}) {
    EXPECT_TRUE(agrees_in_print(left + " = " + right)) << left;
    EXPECT_FALSE(agrees_in_print(left + " = 0")) << left;
    EXPECT_FALSE(agrees_in_print(left + " = 2 \\left(" + right + "\\right)")) << left;
  }
}

}  // namespace
}  // namespace assur::test::nested_derivatives
