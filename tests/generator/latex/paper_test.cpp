// Law: the papers' equations, typed as LaTeX, are found wrong where their audit files find them
// wrong, and nowhere else; their maps are short.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/text/input_file.hpp>
#include <map>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/latex/paper_audit.hpp"

namespace assur::test::paper_test {
namespace {

using namespace generator::audit;

std::string path_of(const std::string& file) { return ASSUR_EXAMPLES "/audit/" + file; }

/// For each equation the verdicts, in order.
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

class LatexPapers : public testing::TestWithParam<const char*> {};

TEST_P(LatexPapers, HaveTheFindingsOfTheirAuditFiles) {
  const std::string name = GetParam();
  const AuditReport paper = latex::audit_paper(path_of(name + ".tex"), path_of(name + ".map"));
  // Numbers of worked examples, and kinds, need scenes and groups, which audit files alone have.
  const std::vector<std::string> words = {"closure", "equation", "matrix"};
  const Verdicts found = verdicts(paper, words);
  const Verdicts expected = verdicts(
      audit_text(text::read_input_file(path_of(name + ".audit")), path_of(name + ".audit"),
                 [](const auto&, int, const auto&) { return std::map<std::string, double>{}; }),
      words);
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

INSTANTIATE_TEST_SUITE_P(Papers, LatexPapers, testing::Values("zhauyt_2017"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace assur::test::paper_test
