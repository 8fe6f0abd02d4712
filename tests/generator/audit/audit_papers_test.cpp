// Law: the findings of `assur audit` in the papers are exactly those found by hand.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "command/command.hpp"

namespace assur::test::audit_papers_test {
namespace {

using Json = nlohmann::json;

/// What one statement of a paper has wrong, all with one verdict.
struct Disagreement {
  std::string statement;
  std::string verdict;
  std::vector<std::string> items;

  bool operator==(const Disagreement&) const = default;
};

void PrintTo(const Disagreement& disagreement, std::ostream* out) {
  *out << disagreement.statement << " " << disagreement.verdict << ":";
  for (const std::string& item : disagreement.items) {
    *out << " [" << item << "]";
  }
}

struct Paper {
  std::string file;
  std::size_t audited;  ///< number of findings, with those that agree
  std::vector<Disagreement> disagreements;
};

void PrintTo(const Paper& paper, std::ostream* out) { *out << paper.file; }

/// Both (5) and (6) of Zhauyt et al. lack a minus, which shows where the derivative is not zero.
const std::vector<std::string> without_the_minus = {
    "j = a1, k = f1", "j = a3, k = f1",  "j = a4, k = f1", "j = a5, k = f1",  "j = a7, k = f1",
    "j = a9, k = f1", "j = a2, k = f2",  "j = a3, k = f2", "j = a4, k = f2",  "j = a5, k = f2",
    "j = a7, k = f2", "j = a10, k = f2", "j = a1, k = f3", "j = a3, k = f3",  "j = a4, k = f3",
    "j = a5, k = f3", "j = a6, k = f3",  "j = a8, k = f3", "j = a11, k = f3", "j = a13, k = f3",
    "j = a2, k = f4", "j = a3, k = f4",  "j = a4, k = f4", "j = a5, k = f4",  "j = a6, k = f4",
    "j = a8, k = f4", "j = a12, k = f4", "j = a13, k = f4"};

const std::vector<Paper> papers = {
    {"mitsi_tetrad_kinds.audit",
     126,
     {
         {"kinds Table_2",
          "differs",
          {"row 7, family 3", "row 9, PPR-PRR", "row 9, RPR-PRR left out", "row 12, family 3+4",
           "row 14, PPR-RPP", "row 14, PPR-RPR left out", "row 15, PPR-RPR",
           "row 15, PPR-RPP left out", "row 15, family 3+4", "row 16, family 3+4",
           "row 17, family 4", "row 18, PRP-PRR", "row 18, PRP-PRP left out", "row 20, family 3+4",
           "row 22, family 4"}},
         {"number (1)", "differs", {"M_7"}},
         {"number text_c", "differs", {"M_17", "M_21", "M_22", "M_23"}},
         {"number text_d", "differs", {"M_12", "M_15", "M_16", "M_20"}},
         {"number summary", "differs", {"degenerate", "tetrads", "kinds_of_tetrads"}},
     }},
    {"quintero_2011.audit",
     55,
     {
         {"number lengths", "differs", {"L_BS3, mm", "L_DS3, mm", "L_FS5, mm", "L_ES5, mm"}},
         {"number (32)", "differs", {"v_BA, mm/s"}},
         {"number (35)", "differs", {"bs3_v, mm/s"}},
         {"number (36)", "differs", {"gs3_v, mm/s"}},
         {"number (37)", "differs", {"bs5_v, mm/s"}},
         {"number (38)", "differs", {"gs5_v, mm/s"}},
         {"number (35-38)", "differs", {"omega4, rad/s", "omega5, rad/s", "v_S3S2, mm/s"}},
         {"number (42)", "differs", {"a_S2B_n, mm/s^2", "a_S3S2_c, mm/s^2"}},
         {"number (44)", "differs", {"a_DG_n, mm/s^2", "a_S3D_n, mm/s^2"}},
         {"number (46)", "differs", {"a_FG_n, mm/s^2", "a_S5F_n, mm/s^2"}},
         {"number (48)", "differs", {"a_S5E_n, mm/s^2"}},
         {"number (50)", "differs", {"t_s5b, mm/s^2"}},
         {"number (51)", "differs", {"t_s5g, mm/s^2"}},
         {"number (52)", "differs", {"t_s3b, mm/s^2"}},
         {"number (53)", "differs", {"t_s3g, mm/s^2"}},
         {"number (50-53)",
          "differs",
          {"alpha5, rad/s^2", "a_S3S2_p, mm/s^2", "a_S3S2_p_in_m, m/s^2"}},
     }},
    {"zhauyt_2017.audit",
     208,
     {
         {"closure (4)", "differs", {"f1", "f2", "f3", "f4"}},
         {"equation (5)", "differs by sign", without_the_minus},
         {"equation (6)", "differs by sign", without_the_minus},
         {"matrix (8)",
          "differs",
          {"(1,1) d f1/d a1", "(2,2) d f2/d a2", "(3,1) d f3/d a1", "(3,5) d f3/d a5",
           "(3,6) d f3/d a6", "(3,13) d f3/d a13", "(4,2) d f4/d a2", "(4,3) d f4/d a3",
           "(4,5) d f4/d a5", "(4,6) d f4/d a6", "(4,13) d f4/d a13"}},
     }},
};

/// Explanations of the worked example's numbers, as far as its printed numbers allow.
const std::map<std::string, std::string> explanations = {
    {"v_BA, mm/s",
     "the printed numbers give 100; it would be right with omega1 = 0.1, or with AB = 10"},
    {"omega4, rad/s",
     "follows from gs3_v = 138.2264 as printed (derived 138.250199), or from gs5_v = 119.3355 as "
     "printed (derived 119.3195145), or from L_ES5 = 155.1123 as printed (derived 155.0343572)"},
    {"omega5, rad/s", "follows from gs5_v = 119.3355 as printed (derived 119.3195145)"},
    {"v_S3S2, mm/s", "follows from the printed numbers together"},
    {"a_S2B_n, mm/s^2", "follows from the printed numbers together"},
    {"a_S3S2_c, mm/s^2", "follows from the printed numbers together"},
    {"a_DG_n, mm/s^2", "follows from omega4 = 0.4746 as printed (derived 0.4746637549)"},
    {"a_S3D_n, mm/s^2", "follows from omega2 = 0.0086 as printed (derived 0.008607838872)"},
    {"a_FG_n, mm/s^2", "follows from the printed numbers within their rounding"},
    {"a_S5F_n, mm/s^2", "follows from the printed numbers together"},
    {"a_S5E_n, mm/s^2", "follows from the printed numbers together"},
    {"alpha5, rad/s^2",
     "follows from t_s5g = 137.7597 as printed (derived 137.7347511), or from L_ES5 = 155.1123 as "
     "printed (derived 155.0343572)"},
    {"a_S3S2_p, mm/s^2", "follows from the printed numbers within their rounding"},
    {"a_S3S2_p_in_m, m/s^2",
     "the printed numbers give -0.0256695; it would be right with a_S3S2_p = -25669.5"},
};

std::string path_of(const std::string& file) { return ASSUR_EXAMPLES "/audit/" + file; }

/// The findings of a file's audit, each with its statement's name.
std::vector<Json> audit(const std::string& file) {
  const CommandResult result = run_assur("audit --format json " + path_of(file));
  EXPECT_EQ(result.status, 1) << result.messages;
  EXPECT_EQ(result.messages, "");
  std::vector<Json> findings;
  const Json report = Json::parse(result.output);
  for (const Json& statement : report["files"][0]["statements"]) {
    for (Json finding : statement["findings"]) {
      finding["statement"] = statement["statement"];
      findings.push_back(finding);
    }
  }
  return findings;
}

class Papers : public testing::TestWithParam<Paper> {};

TEST_P(Papers, DisagreeInTheseItemsAlone) {
  const std::vector<Json> findings = audit(GetParam().file);
  std::vector<Disagreement> found;
  for (const Json& finding : findings) {
    const Disagreement one{finding["statement"], finding["verdict"], {}};
    if (one.verdict == "agrees") {
      continue;
    }
    if (found.empty() || found.back().statement != one.statement ||
        found.back().verdict != one.verdict) {
      found.push_back(one);
    }
    found.back().items.push_back(finding["item"]);
  }
  EXPECT_EQ(findings.size(), GetParam().audited);
  EXPECT_EQ(found, GetParam().disagreements);
}

INSTANTIATE_TEST_SUITE_P(Audit, Papers, testing::ValuesIn(papers), [](const auto& paper) {
  return paper.param.file.substr(0, paper.param.file.find('.'));
});

TEST(WorkedExampleAudit, ExplainsItsNumbers) {
  std::map<std::string, std::string> found;
  for (const Json& finding : audit("quintero_2011.audit")) {
    if (finding.contains("note")) {
      found[finding["item"]] = finding["note"];
    }
  }
  EXPECT_EQ(found, explanations);
}

}  // namespace
}  // namespace assur::test::audit_papers_test
