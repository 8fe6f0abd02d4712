// Law: what `assur derive --format latex` writes of any model is read back and agrees; each slip
// planted in it is found, and nothing else is.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>

#include "audit/latex/paper_audit.hpp"
#include "document/render.hpp"

namespace assur::test::read_back_test {
namespace {

using namespace generator;
using namespace generator::audit;
using generator::structure::Model;

std::vector<const Model*> all_models() {
  std::vector<const Model*> list;
  for (const structure::Group& group : structure::known_groups()) {
    for (const Model& model : structure::models_of(group)) {
      list.push_back(&model);
    }
  }
  return list;
}

/// `d(f?, x)*rate(x) + ...` over the unknowns: the side that stands right of J q' = b.
std::string product_with_jacobian(const document::Derivation& derivation, const std::string& rate) {
  std::string text;
  for (const document::DerivedVariable& unknown : derivation.unknowns) {
    text += (text.empty() ? "" : " + ") + std::string("d(f?, ") + unknown.name + ")*" + rate + "(" +
            unknown.name + ")";
  }
  return text;
}

/// Rates follow the closures where there are as many as unknowns.
bool is_square(const document::Derivation& derivation) {
  return derivation.jacobian.rows.size() == derivation.jacobian.columns.size();
}

/// What ties the notation of a derivation to the model's quantities.
std::string map_of(const document::Derivation& derivation) {
  std::string map = "model " + structure::spell(*derivation.model->group,
                                                derivation.model->representative) + R"(
display \numbered{EQUATION}{NUMBER}
display \defined{EQUATION}{MEANING}
blanks are zero
\varphi_? = phi_?
\omega_? = rate(theta_?)
\alpha_? = rate2(theta_?)
\overline{?}_? = as printed
\cos\vartheta_? = as printed
\sin\vartheta_? = as printed
f_{?,?} = as printed
J = matrix by its titles
F_? = matrix by its titles
skip sections Structure, Variables, Mobility and singularities, Elimination
)";
  map += "\\partial f/\\partial ? = matrix of f1.." +
         std::to_string(derivation.jacobian.rows.size()) + " by ?\n";
  map += "b_? = " + product_with_jacobian(derivation, "rate") + "\n";
  map += "c_? = " + product_with_jacobian(derivation, "rate2") + "\n";
  for (const document::DerivedVariable& input : derivation.inputs) {
    if (input.is_angle) {  // a slide of the base turns with phi, not with a theta
      const std::string joint = input.name.substr(4);
      map += "\\omega_{" + joint + "} = rate(" + input.name + ")\n";
      map += "\\alpha_{" + joint + "} = rate2(" + input.name + ")\n";
    }
  }
  int number = 1;
  map += "skip";
  for (std::size_t loop = 0; loop < derivation.closures.size(); ++loop, number += 3) {
    map += " (" + std::to_string(number) + ")";  // as vectors
  }
  for (std::size_t sum = 0; sum < derivation.compatibility.size(); ++sum) {
    map += " (" + std::to_string(number++) + ")";  // sums of angles
  }
  if (!is_square(derivation)) {
    number += derivation.dimension_jacobian.columns.empty() ? 2 : 3;  // the matrices
    for (std::size_t row = 0; row < 2 * derivation.jacobian.rows.size(); ++row) {
      map += " (" + std::to_string(number++) + ")";
    }
  }
  return map + "\n";
}

class DerivedLatex : public testing::TestWithParam<const Model*> {
 protected:
  const document::Derivation derivation_ =
      document::derive(*GetParam()->group, GetParam()->representative);
  const std::string paper_ = document::derivation_latex(derivation_);
  const std::string map_ = map_of(derivation_);
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

INSTANTIATE_TEST_SUITE_P(AllModels, DerivedLatex, testing::ValuesIn(all_models()),
                         [](const testing::TestParamInfo<const Model*>& tested) {
                           return tested.param->group->name() + "_" +
                                  std::to_string(tested.param->number);
                         });

}  // namespace
}  // namespace assur::test::read_back_test
