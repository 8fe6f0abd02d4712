// Law: the papers' equations, typed as LaTeX, are found wrong where their audit files find them
// wrong, and nowhere else; their maps are short.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/text/input_file.hpp>
#include <map>
#include <set>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/latex/paper_audit.hpp"
#include "audit/scene/scene_values.hpp"
#include "whole_campaign.hpp"

namespace assur::test::paper_test {
namespace {

using namespace generator::audit;

std::string path_of(const std::string& file) { return ASSUR_EXAMPLES "/audit/" + file; }

/// The verdicts on each equation, in order.
using Verdicts = std::map<std::string, std::vector<Verdict>>;

Verdicts verdicts(const AuditReport& report, const std::vector<std::string>& words) {
  Verdicts all;
  for (const AuditedStatement& statement : report.statements) {
    const std::size_t space = statement.label.find(' ');
    for (const std::string& word : words) {
      if (statement.label.substr(0, space) == word) {
        for (const Finding& finding : statement.findings) {
          all[statement.label.substr(space + 1)].push_back(finding.comparison.verdict);
        }
      }
    }
  }
  return all;
}

std::size_t lines_of(const std::string& map) {
  std::istringstream lines(text::read_input_file(path_of(map)));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.empty() || line[0] == '#' ? 0 : 1;
  }
  return count;
}

struct Paper {
  const char* name;
  /// Equations that only the audit file can audit: their vectors are defined in the paper's text.
  std::set<std::string> of_vectors;
};

void PrintTo(const Paper& paper, std::ostream* out) { *out << paper.name; }

class LatexPapers : public testing::TestWithParam<Paper> {};

AuditReport audited_example(const std::string& name) {
  return audit_file(path_of(name + ".audit"), scene::scene_values);
}

TEST_P(LatexPapers, HaveTheFindingsOfTheirAuditFiles) {
  const std::string name = GetParam().name;
  const AuditReport paper = latex::audit_paper(path_of(name + ".tex"), path_of(name + ".map"));
  // Numbers of worked examples, and kinds, need scenes and groups, which audit files alone have.
  const std::vector<std::string> words = {"closure", "equation", "matrix"};
  const Verdicts found = verdicts(paper, words);
  Verdicts expected = verdicts(audited_example(name), words);
  for (const std::string& label : GetParam().of_vectors) {
    EXPECT_EQ(expected.erase(label), 1U) << label;
  }
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [label, list] : expected) {
    const auto of_paper = found.find(label);
    ASSERT_NE(of_paper, found.end()) << label;
    // Indices may run in another order.
    std::vector<Verdict> one = of_paper->second;
    std::vector<Verdict> other = list;
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    EXPECT_EQ(one, other) << label;
  }
  EXPECT_LE(lines_of(name + ".map"), 20U);
}

/// By default one paper; the other takes three times as long.
std::vector<Paper> papers() {
  std::vector<Paper> list = {
      {"quintero_2011", {"(1)", "(2)", "(9)", "(10)", "(17)", "(18)", "(24)", "(25)"}}};
  if (is_whole_campaign()) {
    list.push_back({"zhauyt_2017", {}});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Papers, LatexPapers, testing::ValuesIn(papers()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// The paper's audit file has these formulas as numbers, because the paper has no closures.
TEST(FormulasOfMobility, HaveTheFindingsOfTheirNumbers) {
  const std::string name = "mitsi_tetrad_kinds";
  const AuditReport paper = latex::audit_paper(path_of(name + ".tex"), path_of(name + ".map"));
  ASSERT_EQ(paper.statements.size(), 2U);
  EXPECT_EQ(paper.statements[1].label, "equation (1)");
  const AuditReport numbers = audited_example(name);
  const auto verdict_of = [&](const std::string& item) {
    for (const AuditedStatement& statement : numbers.statements) {
      for (const Finding& finding : statement.findings) {
        if (finding.item == item) {
          return finding.comparison.verdict;
        }
      }
    }
    return Verdict::unreadable;
  };
  EXPECT_EQ(paper.statements[0].findings.at(0).comparison.verdict, verdict_of("N"));
  for (const Finding& finding : paper.statements[1].findings) {
    EXPECT_EQ(finding.comparison.verdict, verdict_of("M_of_1"));
  }
  EXPECT_EQ(verdict_of("N"), Verdict::agrees);
  EXPECT_LE(lines_of(name + ".map"), 20U);
}

}  // namespace
}  // namespace assur::test::paper_test
