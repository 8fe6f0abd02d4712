// Law: an audit gives each printed item one answer, and every text is answered or refused.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include "audit/audit_report.hpp"

namespace assur::test::audit_test {
namespace {

using namespace generator::audit;

/// A crank, a bar and a slider on the x-axis.
const std::string slider_crank = R"(angle phi theta
length r l s
unknown theta s
moving phi
loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)
)";

std::vector<Finding> findings_of(const std::string& text) {
  std::vector<Finding> all;
  for (const AuditedStatement& statement : audit_text(text, "f.audit").statements) {
    all.insert(all.end(), statement.findings.begin(), statement.findings.end());
  }
  return all;
}

Finding only_finding(const std::string& text) {
  const std::vector<Finding> all = findings_of(text);
  EXPECT_EQ(all.size(), 1U);
  return all.empty() ? Finding{} : all[0];
}

TEST(Audit, EachEntryOfAMatrixHasItsAnswer) {
  const std::vector<Finding> all =
      findings_of(slider_crank + R"(printed matrix J of f1 f2 by theta s
  l*sin(theta), -1
  l*sin(theta), 0*)");
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].comparison.verdict, Verdict::differs_by_sign);
  EXPECT_EQ(all[0].derived, "-l*sin(theta)");
  EXPECT_EQ(all[1].comparison.verdict, Verdict::agrees);
  EXPECT_EQ(all[1].comparison.evidence, "identically");
  EXPECT_EQ(all[2].comparison.verdict, Verdict::differs);
  EXPECT_EQ(all[2].derived, "l*cos(theta)");
  EXPECT_EQ(all[3].comparison.verdict, Verdict::unreadable);
  EXPECT_EQ(all[3].place.line, 8U);
  EXPECT_EQ(all[3].place.column, 19U);
}

TEST(Audit, ADifferenceIsShownAtAPointThatCanBeChecked) {
  const Finding finding =
      only_finding(slider_crank + "printed matrix J of f1 by phi\n  -2*r*sin(phi)\n");
  ASSERT_EQ(finding.comparison.verdict, Verdict::differs);
  // The text tells r, cos and sin of phi, and printed minus derived: -r sin(phi).
  long r_above = 0;
  long r_below = 1;
  long s_above = 0;
  long s_below = 1;
  std::array<long, 2> cosine{};
  ASSERT_EQ(std::sscanf(finding.comparison.point.c_str(),
                        "(cos, sin)(phi) = (%ld/%ld, %ld/%ld), r = %ld/%ld", cosine.data(),
                        &cosine[1], &s_above, &s_below, &r_above, &r_below),
            6)
      << finding.comparison.point;
  EXPECT_EQ(cosine[0] * cosine[0] + s_above * s_above, cosine[1] * cosine[1]);
  const GiNaC::numeric expected =
      -GiNaC::numeric(r_above, r_below) * GiNaC::numeric(s_above, s_below);
  std::ostringstream text;
  text << expected;
  EXPECT_EQ(finding.comparison.difference, text.str());
}

TEST(Audit, ClosuresMayBePrintedWithAllSignsTurned) {
  const std::string closure = "printed closure (1) f1 : s - r*cos(phi) = l*cos(theta)\n";
  const std::vector<Finding> all = findings_of(
      slider_crank + closure + "printed matrix J of f1 by s theta\n  1, l*sin(theta)\n");
  ASSERT_EQ(all.size(), 3U);
  for (const Finding& finding : all) {
    EXPECT_TRUE(finding.agrees()) << finding.item;
  }
  EXPECT_EQ(only_finding(slider_crank + "printed closure (1) f2 : r*sin(phi) - l*sin(theta)\n")
                .comparison.verdict,
            Verdict::differs);
}

TEST(Audit, TotalDerivativesFollowTheClosures) {
  const auto verdict = [](const std::string& equation) {
    return only_finding(slider_crank + "printed equation (1) : " + equation + "\n")
        .comparison.verdict;
  };
  EXPECT_EQ(verdict("D(theta, phi) = -r*cos(phi)/(l*cos(theta))"), Verdict::agrees);
  EXPECT_EQ(verdict("D(theta, phi) = r*cos(phi)/(l*cos(theta))"), Verdict::differs_by_sign);
  EXPECT_EQ(verdict("D(s, r) = cos(phi)"), Verdict::differs);
  EXPECT_EQ(verdict("D(s, r) = cos(phi) + tan(theta)*sin(phi)*(0-1) + 2*tan(theta)*sin(phi)"),
            Verdict::agrees);
  EXPECT_EQ(verdict("rate(s) = D(s, phi)*rate(phi)"), Verdict::agrees);
  EXPECT_EQ(verdict("l*cos(theta)*rate2(theta) = l*sin(theta)*rate(theta)^2 - r*cos(phi)*rate2(phi)"
                    " + r*sin(phi)*rate(phi)^2"),
            Verdict::agrees);
  EXPECT_EQ(verdict("l*cos(theta)*rate2(theta) = l*sin(theta)*rate(theta)^2 - r*cos(phi)*rate2(phi)"
                    " - r*sin(phi)*rate(phi)^2"),
            Verdict::differs);
  // Holds where the group is assembled, and only there.
  EXPECT_EQ(verdict("r*sin(phi) = -l*sin(theta)"), Verdict::agrees);
}

/// Everything that is needed to compute both sides by hand stands beside a difference.
TEST(Audit, ADifferenceIsShownWithRatesAndUnknowns) {
  const auto names = [](const std::string& equation) {
    const Finding finding =
        only_finding(slider_crank + "printed equation (1) : " + equation + "\n");
    EXPECT_EQ(finding.comparison.verdict, Verdict::differs) << equation;
    std::string list;
    const std::string& point = finding.comparison.point;
    for (std::size_t at = point.find(" = "); at != std::string::npos;
         at = point.find(" = ", at + 1)) {
      const std::size_t from = point.rfind(' ', at - 1);
      const std::size_t begin = from == std::string::npos ? 0 : from + 1;
      list += point.substr(begin, at - begin) + " ";
    }
    return list;
  };
  const std::string all = "sin)(phi) sin)(theta) r l s ";
  EXPECT_EQ(names("s = r*cos(phi)"), all);
  EXPECT_EQ(names("rate(s) = r*rate(phi)"), all + "rate(phi) rate(s) rate(theta) ");
  EXPECT_EQ(names("rate2(s) = r"),
            all + "rate(phi) rate2(phi) rate(s) rate(theta) rate2(s) rate2(theta) ");
  EXPECT_EQ(names("D(s, r) = 1"), all + "r) r) ");  // D(s, r), D(theta, r)
}

/// At constant speed the second rate and all higher ones vanish.
TEST(Audit, ARateMayBeConstant) {
  const auto verdict = [](const std::string& declared, const std::string& equation) {
    return only_finding(slider_crank + declared + "printed equation (1) : " + equation + "\n")
        .comparison.verdict;
  };
  for (const char* equation :
       {"rate2(phi) = 0", "rate(rate2(phi)) = 0",
        "l*cos(theta)*rate2(theta) = l*sin(theta)*rate(theta)^2 + r*sin(phi)*rate(phi)^2",
        "rate(rate2(s)) = rate(rate2(r*cos(phi) + l*cos(theta)))"}) {
    EXPECT_EQ(verdict("constant rate(phi)\n", equation), Verdict::agrees) << equation;
  }
  EXPECT_EQ(verdict("", "rate2(phi) = 0"), Verdict::differs);
  EXPECT_EQ(verdict("constant rate(phi)\n", "rate2(s) = 0"), Verdict::differs);
}

/// dq'/da' is dq/da, and dq''/da' is 2 d/dt(dq/da).
TEST(Audit, DerivativesByRatesAndRowsThatAreFormulas) {
  const AuditReport report =
      audit_text(slider_crank +
                     "printed equation (1) : D(rate(s), rate(phi)) = D(s, phi)\n"
                     "printed equation (2) : D(rate2(s), rate(phi)) = 2*rate(D(s, phi))\n"
                     "printed equation (3) : D(rate2(s), rate2(phi)) = D(s, phi)\n"
                     "printed equation (4) : D(rate(s)^2, rate(phi)) = 2*rate(s)*D(s, phi)\n"
                     "printed equation (5) : D(D(rate(s), r), rate(phi)) = D(D(s, phi), r)\n"
                     "printed matrix (6) of rate(s) rate(theta) by r phi\n"
                     "  D(rate(s), r), rate(D(s, phi))\n  rate(D(theta, r)), D(rate(theta), phi)\n",
                 "f.audit");
  EXPECT_TRUE(report.agrees()) << audit_report_text({report});
  EXPECT_EQ(only_finding(slider_crank + "printed equation (1) : D(rate2(s), rate(phi)) = "
                                        "rate(D(s, phi))\n")
                .comparison.verdict,
            Verdict::differs);
}

TEST(Audit, SensitivityMatricesAreTotalDerivatives) {
  const std::vector<Finding> all =
      findings_of(slider_crank +
                  "printed matrix S of theta by r phi\n"
                  "  -sin(phi)/(l*cos(theta)), r*cos(phi)/(l*cos(theta))\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].comparison.verdict, Verdict::agrees);
  EXPECT_EQ(all[1].comparison.verdict, Verdict::differs_by_sign);
}

TEST(Audit, RootsAndInverseFunctionsAreExact) {
  const std::string triangle = R"(length a b c
let alpha = acos((a^2 + b^2 - c^2)/(2*a*b))
)";
  const auto verdict = [&](const std::string& equation) {
    return only_finding(triangle + "printed equation (1) : " + equation + "\n").comparison;
  };
  EXPECT_EQ(verdict("a^2*b^2*sin(alpha)^2 = a^2*b^2 - (a^2 + b^2 - c^2)^2/4").evidence,
            "identically");
  EXPECT_EQ(verdict("d(alpha, c) = c/(a*b*sin(alpha))").verdict, Verdict::agrees);
  EXPECT_EQ(verdict("d(alpha, a) = -(a^2 - b^2 + c^2)/(2*a^2*b*sin(alpha))").verdict,
            Verdict::agrees);
  EXPECT_EQ(verdict("d(alpha, a) = -(b^2 - a^2 + c^2)/(2*a^2*b*sin(alpha))").verdict,
            Verdict::differs);
  EXPECT_EQ(verdict("sqrt(a)*sqrt(b) = sqrt(a*b)").verdict, Verdict::agrees);
  EXPECT_EQ(verdict("sqrt(a)*sqrt(b) = sqrt(a*b + 1/1000000000)").verdict, Verdict::differs);
  EXPECT_EQ(verdict("cos(alpha/2) = 1").verdict, Verdict::undecided);
}

TEST(Audit, NumbersAgreeToTheirPrintedDigits) {
  const std::string givens = "given w = 0.5, L = 300\n";
  const auto finding = [&](const std::string& number) {
    return only_finding(givens + "printed number " + number + "\n");
  };
  EXPECT_TRUE(finding("a = 75 is w^2*L").agrees());
  EXPECT_TRUE(finding("a = 74.96 mm/s^2 is w^2*L - 0.036").agrees());
  EXPECT_FALSE(finding("a = 74.96 is w^2*L - 0.034").agrees());
  EXPECT_EQ(finding("a = -75 is w^2*L").comparison.verdict, Verdict::differs_by_sign);
  const Finding wrong = finding("(32) v = 15 mm/s is w*L");
  EXPECT_EQ(wrong.comparison.verdict, Verdict::differs);
  EXPECT_EQ(wrong.derived, "150");
  EXPECT_EQ(wrong.note,
            "the printed numbers give 150; it would be right with w = 0.05, or with L = 30");
  EXPECT_EQ(finding("v = 15 is w*lambda").comparison.verdict, Verdict::unreadable);
}

TEST(Audit, NumbersSayWhichPrintedInputTheyFollowFrom) {
  const std::vector<Finding> all = findings_of(R"(given L = 300
value true_speed = 2/3
printed number w = 0.66 is true_speed
printed number v = 198 is w*L
printed number n = 130.68 is w*v
)");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].note, "follows from w = 0.66 as printed (derived 0.6666666667)");
  EXPECT_EQ(all[2].note, "follows from the printed numbers together");
}

TEST(Audit, KindsAndFamilies) {
  const AuditReport report = audit_text(R"(printed kinds (T) of tetrad
  1 : RRR-RRR : 3
  3 : RPR-RRP, RRP-RPP : 3+4
  4 : RPR-RPR, RRP-RRP, RRX-RRR
)",
                                        "f.audit");
  std::ostringstream seen;
  for (const Finding& finding : report.statements[0].findings) {
    if (!finding.agrees()) {
      seen << finding.item << ": " << verdict_text(finding.comparison.verdict) << "; ";
    }
  }
  EXPECT_EQ(seen.str(),
            "row 3, RRP-RPP: differs; row 3, RRP-RPR left out: differs; row 3, family 3+4: "
            "differs; row 4, RRX-RRR: does not parse; ");
}

TEST(Audit, ReportsAreReadByPeopleAndPrograms) {
  const std::vector<AuditReport> reports = {audit_text(
      "source A | B\n" + slider_crank + "printed matrix J of f1 by theta s\n  l*sin(theta), -1\n",
      "f.audit")};
  const std::string text = audit_report_text(reports);
  EXPECT_NE(text.find("matrix J: 1 of 2 agree\n    - .\n"), std::string::npos) << text;
  EXPECT_NE(text.find("f.audit:8:3"), std::string::npos) << text;
  EXPECT_NE(audit_report_markdown(reports).find("differs by sign"), std::string::npos);
  EXPECT_NE(audit_report_json(reports).find("\"verdict\": \"differs by sign\""), std::string::npos);
}

/// What cannot be read is a finding like others, so that the rest of the file is audited.
TEST(Audit, APrintedFormulaThatCannotBeReadIsAFinding) {
  const auto evidence = [](const std::string& printed) {
    const Finding finding = only_finding(slider_crank + "printed " + printed + "\n");
    EXPECT_EQ(finding.comparison.verdict, Verdict::unreadable) << printed;
    EXPECT_EQ(finding.place.line, 6U) << printed;
    return finding.comparison.evidence;
  };
  EXPECT_EQ(evidence("equation (6) : r"), "expected an equation LEFT = RIGHT");
  EXPECT_EQ(evidence("equation (6) : d(k, = 0"), "expected an equation LEFT = RIGHT");
  EXPECT_EQ(evidence("equation (6) for k in f1 : d(k, r)"), "expected an equation LEFT = RIGHT");
  EXPECT_EQ(evidence("closure (6) f1 : r ="), "a formula is missing");
  EXPECT_EQ(evidence("closure (6) f1 : r^10000000 = 0"),
            "the degree of this, of numerator and denominator together, is higher than 1000, the "
            "highest that is read");
}

/// Each of these would have millions of terms if it were multiplied out.
TEST(Audit, HighPowersTakeNoTime) {
  const std::string many = "length a b c e\nangle p q t\nunknown a\nclosure f = a - b\n";
  const auto verdict = [&](const std::string& printed) {
    return only_finding(many + "printed " + printed + "\n").comparison.verdict;
  };
  EXPECT_EQ(verdict("closure (1) f : a^1000 = 0"), Verdict::differs);
  EXPECT_EQ(verdict("closure (1) f : (a + b + c + e)^300 = 0"), Verdict::differs);
  EXPECT_EQ(verdict("equation (1) : (a + b + c + e)^300 = (a + b + c + e)^299*(b + c + e + a)"),
            Verdict::agrees);
  EXPECT_EQ(verdict("equation (1) : (a + b + c + e)^300 = a*(a + b + c + e)^299 + "
                    "(b + c + e)*(a + b + c + e)^299"),
            Verdict::agrees);
  EXPECT_EQ(verdict("equation (1) : sqrt((a + b + c + e)^301 + 1) = 1"), Verdict::undecided);
  EXPECT_EQ(verdict("equation (1) : cos((p + q + t)^400) = 1"), Verdict::undecided);
  EXPECT_EQ(verdict("equation (1) : cos(47*p + 47*q + 47*t) = 1"), Verdict::undecided);
  EXPECT_EQ(verdict("equation (1) : (1e308*a)^60 = (1e308*a)^59*1e308*a"), Verdict::agrees);
  EXPECT_EQ(verdict("equation (1) : (1e308*a + b + c + e)^60 = 1"), Verdict::differs);
}

/// The number of terms is so large that adding one more does not change it in double precision.
TEST(Audit, UncountableTermsTakeNoTime) {
  std::string many = "length";
  std::string sum;
  for (int number = 0; number < 18; ++number) {
    const std::string name = "n" + std::to_string(number);
    many += " " + name;
    sum += (number == 0 ? "" : "+") + name;
  }
  const std::string square = "((" + sum + ")^54 + 1)^2";
  const auto verdict = [&](const std::string& printed) {
    return only_finding(many + " x y\nunknown x\nclosure f1 = x - n1\nprinted " + printed + "\n")
        .comparison.verdict;
  };
  EXPECT_EQ(verdict("closure (1) f1 : " + square + " - x = 0"), Verdict::differs);
  EXPECT_EQ(verdict("closure (1) f1 : sqrt(" + square + " + y) - x = 0"), Verdict::undecided);
  EXPECT_EQ(verdict("equation (1) : " + square + "*(" + square + " + x)^4 = x"), Verdict::differs);
}

TEST(Audit, AFaultOfASceneHasThePlaceOfItsName) {
  const SceneReader broken = [](const std::string& file, int,
                                const std::vector<std::string>&) -> std::map<std::string, double> {
    throw text::InputError(file + ": no links");
  };
  try {
    static_cast<void>(audit_text("given a = 1\nscene  s.json branch 9\n", "f.audit", broken));
    FAIL() << "nothing was thrown";
  } catch (const text::InputError& error) {
    EXPECT_STREQ(error.what(), "f.audit:2:8: s.json: no links");
  }
}

TEST(Audit, SurvivesRandomText) {
  constexpr unsigned seed = 2017;
  constexpr int rounds = 1500;
  const std::string good = slider_crank + R"(let u = sqrt(r^2 + l^2)
given w = 0.5, L = 300
printed number v = 150 is w*L
printed kinds (T) of dyad
  1 : RRR : 3
printed equation (1) for j in r l : D(s, j) = d(u, j) + rate(theta)
printed matrix J of f1 f2 by theta s
  l*sin(theta), -1
  l*cos(theta), 0
)";
  const std::string letters = "abrls()^*/+-=:,.# \n019dDfJ\"\\{";
  std::mt19937 engine(seed);
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string text = good;
    for (unsigned change = 0; change < 1 + engine() % 4; ++change) {
      const std::size_t at = engine() % text.size();
      switch (engine() % 3) {
        case 0:
          text[at] = letters[engine() % letters.size()];
          break;
        case 1:
          text.erase(at, 1 + engine() % 6);
          break;
        default:
          text.insert(at, 1, letters[engine() % letters.size()]);
          break;
      }
    }
    try {
      static_cast<void>(audit_report_text({audit_text(text, "f")}));
    } catch (const text::InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << " for\n" << text;
    }
  }
  std::cout << "seed " << seed << ": " << rounds << " texts, " << refused << " refused\n";
  EXPECT_GT(refused, rounds / 10);
}

}  // namespace
}  // namespace assur::test::audit_test
