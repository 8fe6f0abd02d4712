// Law: the LaTeX that `assur derive --format latex` writes of any model is read back and agrees.
#include <gtest/gtest.h>

#include <map>

#include "audit/latex/paper_audit.hpp"
#include "generator/all_models.hpp"
#include "generator/derived_latex.hpp"
#include "whole_campaign.hpp"

namespace assur::test::read_back_test {
namespace {

using namespace generator;
using namespace generator::audit;
using generator::structure::Model;

class DerivedLatex : public testing::TestWithParam<const Model*> {
 protected:
  const document::Derivation derivation_ =
      document::derive(*GetParam()->group, GetParam()->representative);
  const std::string paper_ = document::derivation_latex(derivation_);
  // The forces are of loads that the map does not know; the text that is read back holds them.
  const std::string map_ =
      map_of(derivation_) + (derivation_.elimination ? "skip sections Elimination, Forces\n" : "");
};

TEST_P(DerivedLatex, IsReadBackAndAgrees) {
  const AuditReport report = latex::audit_paper_text(paper_, "derived.tex", map_, "derived.map");
  std::map<std::string, std::size_t> count;
  for (const AuditedStatement& statement : report.statements) {
    for (const Finding& finding : statement.findings) {
      ++count[statement.label.substr(0, statement.label.find(' '))];
      EXPECT_TRUE(finding.agrees())
          << statement.label << " " << finding.item << " " << finding.place.line << ":"
          << finding.place.column << ": " << finding.printed << " | " << finding.derived << " | "
          << finding.comparison.evidence;
    }
  }
  const std::size_t rows = derivation_.jacobian.rows.size();
  EXPECT_EQ(count["closure"], rows);
  EXPECT_EQ(count["matrix"], rows * (derivation_.jacobian.columns.size() +
                                     derivation_.dimension_jacobian.columns.size() +
                                     derivation_.input_jacobian.columns.size()));
  EXPECT_EQ(count["equation"], is_square(derivation_) ? 2 * rows : 0U);
}

INSTANTIATE_TEST_SUITE_P(AllModels, DerivedLatex, testing::ValuesIn(share_of(all_models(), 3)),
                         name_of_model);

}  // namespace
}  // namespace assur::test::read_back_test
