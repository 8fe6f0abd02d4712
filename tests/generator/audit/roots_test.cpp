// Law: a statement is called true, false, or right on one branch in agreement with its values in
// double precision at thousands of independently found configurations: with roots, and without
// rational points of assembly.
#include <gtest/gtest.h>

#include <assur/text/expression.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

#include "audit/audit.hpp"
#include "whole_campaign.hpp"

namespace assur::test::roots_test {
namespace {

using namespace generator::audit;

constexpr unsigned seed = 1967;
constexpr int configurations = 4000;

enum class Truth : unsigned char { always, never, on_one_branch };

using Values = std::map<std::string, double>;

class Random {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(engine_);
  }
  bool coin() { return (engine_() & 1U) != 0; }

 private:
  std::mt19937 engine_{seed};
};

/// A mechanism: how an audit file declares it, and a random configuration of it.
struct Mechanism {
  const char* name;
  const char* declared;
  Values (*configuration)(Random&);
};

const Mechanism numbers{"numbers", "length a b c\nangle t u\n", [](Random& random) -> Values {
                          return {{"a", random(0.1, 3)},
                                  {"b", random(0.1, 3)},
                                  {"c", random(0.1, 3)},
                                  {"t", random(-3.14, 3.14)},
                                  {"u", random(-3.14, 3.14)}};
                        }};

const Mechanism slider_crank{"slider_crank",
                             "angle phi theta\nlength r l s\nunknown theta s\nmoving phi\n"
                             "loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)\n",
                             [](Random& random) -> Values {
                               const double r = random(0.1, 3);
                               const double phi = random(-3.14, 3.14);
                               const double l = std::abs(r * std::sin(phi)) + random(0.01, 2);
                               const double up = std::asin(-r * std::sin(phi) / l);
                               const double theta = random.coin() ? up : std::numbers::pi - up;
                               return {{"r", r},
                                       {"l", l},
                                       {"phi", phi},
                                       {"theta", theta},
                                       {"s", r * std::cos(phi) + l * std::cos(theta)}};
                             }};

const Mechanism dyad{
    "dyad",
    "angle p q\nlength b c x y\nunknown p q\n"
    "loop f1 f2 = polar(b, p) + polar(c, q) - point(x, y)\n"
    "let w = x^2 + y^2\n"
    "let h = sqrt(4*b^2*w - (w + b^2 - c^2)^2)\n",
    [](Random& random) -> Values {
      const double b = random(0.1, 3);
      const double c = random(0.1, 3);
      const double p = random(-3.14, 3.14);
      const double q = random(-3.14, 3.14);
      const double x = b * std::cos(p) + c * std::cos(q);
      const double y = b * std::sin(p) + c * std::sin(q);
      const double w = x * x + y * y;
      const double under = 4 * b * b * w - (w + b * b - c * c) * (w + b * b - c * c);
      return {{"b", b}, {"c", c}, {"p", p}, {"q", q},
              {"x", x}, {"y", y}, {"w", w}, {"h", std::sqrt(std::max(under, 0.0))}};
    }};

// Fixed or equal lengths, angles of 30 degrees and roots in closures: no rational points close.

const Mechanism fixed_crank{
    "fixed_crank",
    "angle phi theta\nlength s\nunknown theta s\nmoving phi\n"
    "loop f1 f2 = polar(1, phi) + polar(3, theta) - point(s, 0)\n",
    [](Random& random) -> Values {
      const double phi = random(-3.14, 3.14);
      const double up = std::asin(-std::sin(phi) / 3);
      const double theta = random.coin() ? up : std::numbers::pi - up;
      return {{"phi", phi}, {"theta", theta}, {"s", std::cos(phi) + 3 * std::cos(theta)}};
    }};

/// The angles of two bars b and c that reach from the origin to a point.
std::pair<double, double> reaching(double b, double c, double x, double y, bool up) {
  const double w = x * x + y * y;
  const double turn = std::acos((w + b * b - c * c) / (2 * b * std::sqrt(w)));
  const double p = std::atan2(y, x) + (up ? turn : -turn);
  return {p, std::atan2(y - b * std::sin(p), x - b * std::cos(p))};
}

const Mechanism four_bar{"four_bar",
                         "angle p q u\nunknown q u\nmoving p\n"
                         "loop f1 f2 = polar(1, p) + polar(5/2, q) - polar(2, u) - point(2.2, 0)\n",
                         [](Random& random) -> Values {
                           const double p = random(-3.14, 3.14);
                           const auto [q, v] =
                               reaching(2.5, 2, 2.2 - std::cos(p), -std::sin(p), random.coin());
                           return {{"p", p}, {"q", q}, {"u", v + std::numbers::pi}};
                         }};

const Mechanism equal_bars{"equal_bars",
                           "length a b x\nangle p q\nunknown p q\n"
                           "loop f1 f2 = polar(a, p) + polar(a, q) - point(x, b)\n",
                           [](Random& random) -> Values {
                             const double a = random(0.1, 3);
                             const double x = random(-1, 1) * a;
                             const double b = random(-1, 1) * a;
                             const auto [p, q] = reaching(a, a, x, b, random.coin());
                             return {{"a", a}, {"b", b}, {"x", x}, {"p", p}, {"q", q}};
                           }};

const Mechanism tilted{"tilted",
                       "length a b s\nangle p q\nunknown q s\nmoving p\nlet g = 30*deg\n"
                       "loop f1 f2 = polar(a, p) + polar(b, q + g) - point(s, 0)\n",
                       [](Random& random) -> Values {
                         const double a = random(0.1, 3);
                         const double p = random(-3.14, 3.14);
                         const double b = std::abs(a * std::sin(p)) + random(0.01, 2);
                         const double up = std::asin(-a * std::sin(p) / b);
                         const double whole = random.coin() ? up : std::numbers::pi - up;
                         return {{"a", a},
                                 {"b", b},
                                 {"p", p},
                                 {"q", whole - std::numbers::pi / 6},
                                 {"s", a * std::cos(p) + b * std::cos(whole)}};
                       }};

const Mechanism rooted{
    "rooted",
    "length r l s\nangle p\nunknown s\nmoving p\n"
    "closure f = r*cos(p) + sqrt(l^2 - r^2*sin(p)^2) - s\n",
    [](Random& random) -> Values {
      const double r = random(0.1, 3);
      const double p = random(-3.14, 3.14);
      const double l = std::abs(r * std::sin(p)) + random(0.01, 2);
      return {{"r", r},
              {"l", l},
              {"p", p},
              {"s", r * std::cos(p) + std::sqrt(l * l - std::pow(r * std::sin(p), 2))}};
    }};

struct Statement {
  const Mechanism* mechanism;
  const char* left;
  const char* right;
  Truth truth;
  bool angles = false;  ///< equal up to whole turns
};

const std::vector<Statement> statements = {
    // Roots of squares.
    {&numbers, "cos(t)", "sqrt(1 - sin(t)^2)", Truth::on_one_branch},
    {&numbers, "cos(t)", "-sqrt(1 - sin(t)^2)", Truth::on_one_branch},
    {&numbers, "sin(t)", "sqrt(1 - cos(t)^2)", Truth::on_one_branch},
    {&numbers, "cos(t)^2", "sqrt(1 - sin(t)^2)^2", Truth::always},
    {&numbers, "cos(t)^2", "sqrt((1 - sin(t)^2)^2)", Truth::always},
    {&numbers, "cos(t)", "sqrt(1 + sin(t)^2)", Truth::never},
    {&numbers, "sqrt(a^2)", "a", Truth::always},
    {&numbers, "sqrt((a - b)^2)", "a - b", Truth::on_one_branch},
    {&numbers, "sqrt((a + b)^2)", "a + b", Truth::always},
    {&numbers, "sqrt(a^2 + b^2)", "a + b", Truth::never},
    {&numbers, "sqrt(a)*sqrt(b)", "sqrt(a*b)", Truth::always},
    {&numbers, "sqrt(a)/sqrt(b)", "sqrt(a/b)", Truth::always},
    {&numbers, "sqrt(a) + sqrt(b)", "sqrt(a + b + 2*sqrt(a*b))", Truth::always},
    {&numbers, "sqrt(a) - sqrt(b)", "sqrt(a + b - 2*sqrt(a*b))", Truth::on_one_branch},
    {&numbers, "sqrt(a) + sqrt(b)", "sqrt(a + b)", Truth::never},
    {&numbers, "1/(sqrt(a) + sqrt(b))", "(sqrt(a) - sqrt(b))/(a - b)", Truth::always},
    {&numbers, "sqrt(a^2 + b^2 + 2*a*b*cos(t))", "a + b*cos(t)", Truth::never},
    {&numbers, "sin(2*t)", "2*sin(t)*sqrt(1 - sin(t)^2)", Truth::on_one_branch},
    {&numbers, "sin(t)*cos(u)", "sqrt(1 - cos(t)^2)*sqrt(1 - sin(u)^2)", Truth::on_one_branch},
    {&numbers, "cos(t - u)", "cos(t)*cos(u) + sqrt((1 - cos(t)^2)*(1 - cos(u)^2))",
     Truth::on_one_branch},
    {&numbers, "sqrt(2 - 2*cos(2*t))", "2*sin(t)", Truth::on_one_branch},
    {&numbers, "sqrt(2 - 2*cos(2*t))^2", "4*sin(t)^2", Truth::always},
    {&numbers, "tan(t)", "sqrt(1/cos(t)^2 - 1)", Truth::on_one_branch},
    {&numbers, "sqrt(a)", "-sqrt(a)", Truth::never},
    // Inverse functions.
    {&numbers, "t", "acos(cos(t))", Truth::on_one_branch, true},
    {&numbers, "t", "asin(sin(t))", Truth::on_one_branch, true},
    {&numbers, "t", "atan2(sin(t), cos(t))", Truth::always, true},
    {&numbers, "t", "atan2(a*sin(t), a*cos(t))", Truth::always, true},
    {&numbers, "t", "atan2(cos(t), sin(t))", Truth::never, true},
    {&numbers, "t", "atan(tan(t))", Truth::on_one_branch, true},
    {&numbers, "2*t - u", "t - u + t", Truth::always, true},
    {&numbers, "2*t", "u", Truth::never, true},
    {&numbers, "0", "2*t - u", Truth::never, true},
    {&numbers, "t + 2*pi", "t", Truth::always, true},
    {&numbers, "cos(acos(sin(t)))", "sin(t)", Truth::always},
    {&numbers, "sin(acos(cos(t)))", "sin(t)", Truth::on_one_branch},
    {&numbers, "cos(atan2(b, a))", "a/sqrt(a^2 + b^2)", Truth::always},
    {&numbers, "cos(atan2(b, a))", "b/sqrt(a^2 + b^2)", Truth::never},
    // The slider-crank.
    {&slider_crank, "s", "r*cos(phi) + sqrt(l^2 - r^2*sin(phi)^2)", Truth::on_one_branch},
    {&slider_crank, "s", "r*cos(phi) - sqrt(l^2 - r^2*sin(phi)^2)", Truth::on_one_branch},
    {&slider_crank, "(s - r*cos(phi))^2", "sqrt(l^2 - r^2*sin(phi)^2)^2", Truth::always},
    {&slider_crank, "s", "r*cos(phi) + sqrt(l^2 + r^2*sin(phi)^2)", Truth::never},
    {&slider_crank, "s", "r*cos(phi) + sqrt(l^2 - r^2*cos(phi)^2)", Truth::never},
    {&slider_crank, "s", "r*sin(phi) + sqrt(l^2 - r^2*sin(phi)^2)", Truth::never},
    {&slider_crank, "s", "r*cos(phi) + l*cos(asin(r*sin(phi)/l))", Truth::on_one_branch},
    {&slider_crank, "theta", "asin(-r*sin(phi)/l)", Truth::on_one_branch, true},
    {&slider_crank, "theta", "asin(r*sin(phi)/l)", Truth::never, true},
    {&slider_crank, "theta", "acos((s - r*cos(phi))/l)", Truth::on_one_branch, true},
    {&slider_crank, "theta", "atan2(-r*sin(phi), s - r*cos(phi))", Truth::always, true},
    {&slider_crank, "theta", "pi - asin(-r*sin(phi)/l)", Truth::on_one_branch, true},
    {&slider_crank, "sqrt(s^2)", "s", Truth::on_one_branch},
    {&slider_crank, "sqrt((s - r*cos(phi))^2 + r^2*sin(phi)^2)", "l", Truth::always},
    // Closures without rational points.
    {&fixed_crank, "sin(theta)", "-sin(phi)/3", Truth::always},
    {&fixed_crank, "sin(theta)", "sin(phi)/3", Truth::never},
    {&fixed_crank, "s", "cos(phi) + 3*cos(theta)", Truth::always},
    {&fixed_crank, "s", "cos(phi) + sqrt(9 - sin(phi)^2)", Truth::on_one_branch},
    {&fixed_crank, "s", "cos(phi) - sqrt(9 - sin(phi)^2)", Truth::on_one_branch},
    {&fixed_crank, "s", "cos(phi) + sqrt(9 + sin(phi)^2)", Truth::never},
    {&fixed_crank, "theta", "asin(-sin(phi)/3)", Truth::on_one_branch, true},
    {&fixed_crank, "(s - cos(phi))^2", "9 - sin(phi)^2", Truth::always},
    {&four_bar, "cos(p) + 5*cos(q)/2", "2*cos(u) + 11/5", Truth::always},
    {&four_bar, "cos(p) + 5*cos(q)/2", "2*cos(u) + 2", Truth::never},
    {&four_bar, "sin(q - u)", "sqrt(1 - cos(q - u)^2)", Truth::on_one_branch},
    {&four_bar, "10*cos(q - u) - 4.4*cos(p)", "4.41", Truth::always},
    {&four_bar, "10*cos(q - u) + 4.4*cos(p)", "4.41", Truth::never},
    {&four_bar, "sin(q - u)", "-sqrt(1 - ((4.41 + 4.4*cos(p))/10)^2)", Truth::on_one_branch},
    {&equal_bars, "x^2 + b^2", "2*a^2*(1 + cos(p - q))", Truth::always},
    {&equal_bars, "x^2 + b^2", "2*a^2*(1 + cos(p + q))", Truth::never},
    {&equal_bars, "x*sin(q) - b*cos(q)", "b*cos(p) - x*sin(p)", Truth::always},
    {&equal_bars, "b*(cos(p) + cos(q))", "x*(sin(p) + sin(q))", Truth::always},
    {&equal_bars, "sin(p - q)", "sqrt(1 - cos(p - q)^2)", Truth::on_one_branch},
    {&tilted, "a*sin(p)", "-b*sin(q + 30*deg)", Truth::always},
    {&tilted, "a*sin(p)", "-b*sin(q + 45*deg)", Truth::never},
    {&tilted, "a*sin(p)", "-b*(sin(q)*sqrt(3) + cos(q))/2", Truth::always},
    {&tilted, "s", "a*cos(p) + sqrt(b^2 - a^2*sin(p)^2)", Truth::on_one_branch},
    {&tilted, "sin(p + 45*deg)", "(sin(p) + cos(p))/sqrt(2)", Truth::always},
    {&tilted, "sin(p + pi/3)", "(sin(p) + sqrt(3)*cos(p))/2", Truth::always},
    {&tilted, "sin(p + 60*deg)", "(sin(p) - sqrt(3)*cos(p))/2", Truth::never},
    {&tilted, "cos(15*deg)", "(sqrt(6) + sqrt(2))/4", Truth::always},
    {&rooted, "(s - r*cos(p))^2", "l^2 - r^2*sin(p)^2", Truth::always},
    {&rooted, "s - r*cos(p)", "sqrt(l^2 - r^2*sin(p)^2)", Truth::always},
    {&rooted, "s - r*cos(p)", "-sqrt(l^2 - r^2*sin(p)^2)", Truth::never},
    // The dyad RRR.
    {&dyad, "b*cos(p)", "((w + b^2 - c^2)*x + h*y)/(2*w)", Truth::on_one_branch},
    {&dyad, "b*cos(p)", "((w + b^2 - c^2)*x - h*y)/(2*w)", Truth::on_one_branch},
    {&dyad, "b*sin(p)", "((w + b^2 - c^2)*y - h*x)/(2*w)", Truth::on_one_branch},
    {&dyad, "b*sin(p)", "((w + b^2 + c^2)*y - h*x)/(2*w)", Truth::never},
    {&dyad, "h", "2*b*c*sin(q - p)", Truth::on_one_branch},
    {&dyad, "h^2", "4*b^2*c^2*sin(q - p)^2", Truth::always},
    {&dyad, "p", "atan2(y, x) + acos((w + b^2 - c^2)/(2*b*sqrt(w)))", Truth::on_one_branch, true},
    {&dyad, "p", "atan2(y, x) - acos((w + b^2 - c^2)/(2*b*sqrt(w)))", Truth::on_one_branch, true},
    {&dyad, "p", "atan2(y, x) + acos((w + c^2 - b^2)/(2*c*sqrt(w)))", Truth::never, true},
    {&dyad, "q", "atan2(y - b*sin(p), x - b*cos(p))", Truth::always, true},
    {&dyad, "q - p", "acos((w - b^2 - c^2)/(2*b*c))", Truth::on_one_branch, true},
    {&dyad, "sqrt(w)", "sqrt(b^2 + c^2 + 2*b*c*cos(p - q))", Truth::always},
    {&dyad, "sqrt(w)", "sqrt(b^2 + c^2 - 2*b*c*cos(p - q))", Truth::never}};

double value(const char* formula, const Values& values) {
  return text::evaluate<double>(text::parse_expression(formula),
                                [&](const std::string& name) { return values.at(name); });
}

/// Whether both sides have equal values always, never or on one branch.
Truth numeric_truth(const Statement& statement) {
  constexpr double tolerance = 1e-6;
  Random random;
  int right = 0;
  int wrong = 0;
  for (int count = 0; count < configurations; ++count) {
    const Values values = statement.mechanism->configuration(random);
    double difference = value(statement.left, values) - value(statement.right, values);
    if (!std::isfinite(difference)) {
      continue;
    }
    difference = statement.angles ? std::remainder(difference, 2 * std::numbers::pi) : difference;
    ++(std::abs(difference) < tolerance ? right : wrong);
  }
  EXPECT_GT(right + wrong, configurations / 20) << statement.left << " = " << statement.right;
  // A few values are equal by chance, or differ near a singularity.
  const int few = (right + wrong) / 100;
  return wrong <= few ? Truth::always : right <= few ? Truth::never : Truth::on_one_branch;
}

TEST(Roots, StatementsAreDecidedAsTheirValuesAre) {
  std::map<Truth, int> count;
  int undecided = 0;
  for (const Statement& statement : share_of(statements, 2)) {
    const std::string text = std::string(statement.left) + " = " + statement.right;
    ASSERT_EQ(numeric_truth(statement), statement.truth) << text;
    const AuditReport report =
        audit_text(statement.mechanism->declared + ("printed equation (1) : " + text) + "\n", "r");
    const Comparison& comparison = report.statements.at(0).findings.at(0).comparison;
    ++count[statement.truth];
    undecided += comparison.verdict == Verdict::undecided ? 1 : 0;
    const bool decided = statement.truth == Truth::always ? comparison.verdict == Verdict::agrees
                         : statement.truth == Truth::never
                             ? comparison.verdict == Verdict::differs ||
                                   comparison.verdict == Verdict::differs_by_sign
                             : comparison.verdict == Verdict::on_one_branch;
    EXPECT_TRUE(decided) << text << ": " << verdict_text(comparison.verdict) << ", "
                         << comparison.evidence;
    if (comparison.verdict == Verdict::on_one_branch) {
      EXPECT_NE(comparison.evidence.find("; not where "), std::string::npos);
      EXPECT_FALSE(comparison.point.empty());
      EXPECT_FALSE(comparison.difference.empty());
    }
  }
  std::cout << statements.size() << " statements: " << count[Truth::always] << " true, "
            << count[Truth::never] << " false, " << count[Truth::on_one_branch]
            << " true on one branch, " << undecided << " undecided; seed " << seed << "\n";
  EXPECT_GE(statements.size(), 40U);
}

TEST(Roots, ABranchIsToldByASignAndAPointOfEach) {
  const auto evidence = [](const std::string& declared, const std::string& equation) {
    return audit_text(declared + "printed equation (1) : " + equation + "\n", "r")
        .statements.at(0)
        .findings.at(0)
        .comparison.evidence;
  };
  const std::string cosine = evidence(numbers.declared, "cos(t) = sqrt(1 - sin(t)^2)");
  EXPECT_TRUE(cosine.starts_with(
      "agrees at 32 of 64 points, all those where cos(t) > 0, as at (cos, sin)(t) = ("))
      << cosine;
  EXPECT_NE(cosine.find("; not where cos(t) < 0, as at (cos, sin)(t) = (-"), std::string::npos);
  EXPECT_NE(evidence(slider_crank.declared, "s = r*cos(phi) + sqrt(l^2 - r^2*sin(phi)^2)")
                .find("points, all those where cos(theta) > 0, as at "),
            std::string::npos);
  EXPECT_NE(evidence(dyad.declared, "h = 2*b*c*sin(q - p)")
                .find("points, all those where sin(p - q) <= 0, as at "),
            std::string::npos)
      << evidence(dyad.declared, "h = 2*b*c*sin(q - p)");
  // The sign of sin(q) tells, too, for these lengths; that of sin(q - u) always does.
  EXPECT_TRUE(
      evidence(four_bar.declared, "sin(q - u) = sqrt(1 - cos(q - u)^2)")
          .starts_with("agrees at 20 of 40 points, all those where sin(q - u) > 0, as at "));
  EXPECT_NE(evidence(slider_crank.declared, "sqrt(rate(s)^2) = rate(s)")
                .find("points, all those where rate(s) > 0, as at "),
            std::string::npos);
}

TEST(Roots, RatesAreComparedWhereLengthsAreFixed) {
  const auto verdict = [](const Mechanism& mechanism, const std::string& equation) {
    return audit_text(mechanism.declared + ("printed equation (1) : " + equation + "\n"), "r")
        .statements.at(0)
        .findings.at(0)
        .comparison;
  };
  const Comparison right = verdict(fixed_crank, "rate(theta) = -cos(phi)*rate(phi)/(3*cos(theta))");
  EXPECT_EQ(right.verdict, Verdict::agrees);
  EXPECT_EQ(right.evidence, "at 40 points of 100 digits where the closures hold");
  EXPECT_EQ(verdict(fixed_crank, "rate(theta) = cos(phi)*rate(phi)/(3*cos(theta))").verdict,
            Verdict::differs_by_sign);
  EXPECT_EQ(
      verdict(fixed_crank, "rate(theta) = -cos(phi)*rate(phi)/(3*cos(theta)) + 1e-20").verdict,
      Verdict::differs);
  EXPECT_EQ(verdict(fixed_crank,
                    "3*cos(theta)*rate2(theta) = 3*sin(theta)*rate(theta)^2"
                    " - cos(phi)*rate2(phi) + sin(phi)*rate(phi)^2")
                .verdict,
            Verdict::agrees);
  EXPECT_EQ(verdict(four_bar, "rate(u) = rate(p)*sin(p - q)/(2*sin(u - q))").verdict,
            Verdict::agrees);
  EXPECT_EQ(verdict(four_bar, "rate(u) = rate(p)*sin(p - u)/(2*sin(u - q))").verdict,
            Verdict::differs);
  EXPECT_EQ(verdict(tilted, "rate(q) = -a*cos(p)*rate(p)/(b*cos(q + g))").verdict, Verdict::agrees);
  EXPECT_EQ(verdict(tilted, "d(f1, q) = -b*sin(q + g)").verdict, Verdict::agrees);
  EXPECT_EQ(verdict(tilted, "d(f1, q) = -b*cos(q + g)").verdict, Verdict::differs);
}

/// A parallelogram and the crossed one: nothing has one sign in the one and another in the other.
TEST(Roots, ABranchThatNoSignTellsIsCounted) {
  const AuditReport report = audit_text(
      "length a b\nangle p q u\nunknown q u\nmoving p\n"
      "loop f1 f2 = polar(a, p) + polar(b, q) - polar(a, u) - point(b, 0)\n"
      "printed equation (1) : rate(u) = rate(p)\n"
      "printed equation (2) : rate(q) = 0\n"
      "printed equation (3) : rate(u) = 2*rate(p)\n",
      "r");
  for (const std::size_t right : {0U, 1U}) {
    const Comparison& comparison = report.statements.at(right).findings.at(0).comparison;
    EXPECT_EQ(comparison.verdict, Verdict::differs);
    EXPECT_EQ(comparison.branch, "agrees at 20 of 40 points, and no simple condition tells which");
  }
  EXPECT_EQ(report.statements.at(2).findings.at(0).comparison.branch, "");
}

/// A triangle of rational sides and a rational height has often a right angle, where the derivative
/// of its angle by a side vanishes; such triangles alone must not be compared.
TEST(Roots, PointsWithRationalRootsAreNotPreferred) {
  const std::string triangle =
      "length a b c x\nangle p\nunknown x\nmoving p\n"
      "let alpha = acos((a^2 + b^2 - c^2)/(2*a*b))\nclosure f = x - b*cos(p - alpha)\n";
  for (const char* statement : {"printed equation (1) : d(f, a) = -d(f, a)\n",
                                "printed equation (1) : D(x, a) = -D(x, a)\n",
                                "printed matrix (1) of f by a\n  b*sin(p - alpha)*d(alpha, a)\n"}) {
    const AuditReport report = audit_text(triangle + statement, "r");
    EXPECT_EQ(report.statements.at(0).findings.at(0).comparison.verdict, Verdict::differs_by_sign)
        << statement;
  }
}

TEST(Roots, NumbersWithoutRootsAreComparedWhole) {
  const auto verdict = [](const std::string& equation) {
    return audit_text(numbers.declared + ("printed equation (1) : " + equation + "\n"), "r")
        .statements.at(0)
        .findings.at(0)
        .comparison.verdict;
  };
  EXPECT_EQ(verdict("a = a + 1e-50"), Verdict::differs);
  EXPECT_EQ(verdict("sin(t) = sin(t)*(1 + 1e-60)"), Verdict::differs);
  EXPECT_EQ(verdict("sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)"), Verdict::agrees);
  EXPECT_EQ(verdict("sqrt(5 + 2*sqrt(6)) = sqrt(2) - sqrt(3)"), Verdict::differs);
}

TEST(Roots, OtherSignsOfManyRootsAreNotTriedAndItIsSaid) {
  std::string declared;
  std::string left;
  std::string right;
  for (int root = 1; root <= 8; ++root) {
    const std::string name = "x" + std::to_string(root);
    declared += "length " + name + "\n";
    left += (root > 1 ? " + " : "") + ("sqrt(" + name + ")");
    right += (root > 1 ? " - " : "") + ("sqrt(" + name + ")");
  }
  const Comparison comparison =
      audit_text(declared + "printed equation (1) : " + left + " = " + right + "\n", "r")
          .statements.at(0)
          .findings.at(0)
          .comparison;
  EXPECT_EQ(comparison.verdict, Verdict::differs);
  EXPECT_TRUE(comparison.evidence.ends_with("; the other signs of its 7 roots were not tried"))
      << comparison.evidence;
}

TEST(Roots, WhatHasNoRealRootIsUndecidedAndSaysSo) {
  const Comparison comparison =
      audit_text(std::string(numbers.declared) + "printed equation (1) : a = sqrt(-1 - b^2)\n", "r")
          .statements.at(0)
          .findings.at(0)
          .comparison;
  EXPECT_EQ(comparison.verdict, Verdict::undecided);
  EXPECT_EQ(comparison.evidence, "no rational points were found where its roots are real");
}

}  // namespace
}  // namespace assur::test::roots_test
