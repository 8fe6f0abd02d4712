// Law: over all models, what the generator derives, printed as an audit file and read back, agrees
// entry by entry; with one slip planted, that entry and no other is reported.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "audit/audit.hpp"
#include "closures/formula_text.hpp"
#include "derivatives/differentiate.hpp"
#include "generator/all_models.hpp"
#include "whole_campaign.hpp"

namespace assur::test::audit_models_test {
namespace {

using namespace generator;
using namespace generator::audit;
using namespace generator::derivatives;
using namespace generator::equations;
using namespace generator::structure;

constexpr unsigned seed = 1914;

/// The generator's own derivatives of one model as the text of an audit file.
class PrintedModel {
 public:
  explicit PrintedModel(const Model& model)
      : equations_(closure_equations(model)), derivatives_(differentiate(equations_)) {
    for (const auto* list : {&equations_.unknowns, &equations_.dimensions, &equations_.inputs}) {
      for (const Variable& variable : *list) {
        if (variable.is_angle()) {
          const GiNaC::symbol angle(variable.name);
          in_angles_[variable.cosine] = GiNaC::cos(angle);
          in_angles_[variable.sine] = GiNaC::sin(angle);
        }
      }
    }
    text_ = "model " + spell(*model.group, model.representative) + "\n";
    for (const NamedQuantity& quantity : equations_.vocabulary.quantities()) {
      text_ += "let " + quantity.symbol.get_name() + " = " + formula(quantity.definition) + "\n";
    }
    const std::vector<GiNaC::ex> residuals = equations_.residuals;
    for (std::size_t row = 0; row < residuals.size(); ++row) {
      names_ += " f" + std::to_string(row + 1);
      text_ += "printed closure (1) f" + std::to_string(row + 1) + " : " + formula(residuals[row]) +
               " = 0\n";
    }
  }

  [[nodiscard]] const ExpressionMatrix& jacobian() const { return derivatives_.jacobian; }

  /// Returns the audit file with all matrices, the given one as the Jacobian.
  [[nodiscard]] std::string with(const ExpressionMatrix& jacobian) const {
    return text_ + matrix("(2)", jacobian, equations_.unknowns) +
           matrix("(3)", derivatives_.dimension_jacobian, equations_.dimensions) +
           matrix("(4)", derivatives_.input_jacobian, equations_.inputs);
  }

 private:
  [[nodiscard]] std::string formula(const GiNaC::ex& expression) const {
    return closures::formula_text(expression.subs(in_angles_));
  }

  [[nodiscard]] std::string matrix(const std::string& label, const ExpressionMatrix& entries,
                                   const std::deque<Variable>& columns) const {
    if (columns.empty()) {
      return "";
    }
    std::string text = "printed matrix " + label + " of" + names_ + " by";
    for (const Variable& column : columns) {
      text += " " + column.name;
    }
    for (const std::vector<GiNaC::ex>& row : entries) {
      std::string line;
      for (const GiNaC::ex& entry : row) {
        line += (line.empty() ? "" : ", ") + formula(entry);
      }
      text += "\n  " + line;
    }
    return text + "\n";
  }

  ClosureEquations equations_;
  Derivatives derivatives_;
  GiNaC::exmap in_angles_;
  std::string text_;
  std::string names_;
};

class AuditOfModel : public testing::TestWithParam<const Model*> {};

TEST_P(AuditOfModel, OwnDerivativesAgree) {
  const PrintedModel printed(*GetParam());
  const AuditReport report = audit_text(printed.with(printed.jacobian()), "own");
  std::size_t entries = 0;
  for (const AuditedStatement& statement : report.statements) {
    for (const Finding& finding : statement.findings) {
      ++entries;
      EXPECT_TRUE(finding.agrees()) << statement.label << " " << finding.item << ": "
                                    << finding.printed << " | " << finding.derived;
      EXPECT_EQ(finding.comparison.evidence, "identically") << statement.label << finding.item;
    }
  }
  EXPECT_GE(entries, printed.jacobian().size() * (1 + printed.jacobian()[0].size()));
}

/// Every slip by `ctest -L long`, two of the four in turn by default.
TEST_P(AuditOfModel, OnePlantedSlipIsFoundAndNoOther) {
  struct Slip {
    const char* name;
    GiNaC::ex (*plant)(const GiNaC::ex&);
    Verdict verdict;
  };
  const std::vector<Slip> slips = {
      {"sign", [](const GiNaC::ex& entry) -> GiNaC::ex { return -entry; },
       Verdict::differs_by_sign},
      {"factor", [](const GiNaC::ex& entry) -> GiNaC::ex { return 2 * entry; }, Verdict::differs},
      {"left out", [](const GiNaC::ex&) -> GiNaC::ex { return 0; }, Verdict::differs},
      {"term", [](const GiNaC::ex& entry) -> GiNaC::ex { return entry + 1; }, Verdict::differs}};
  const PrintedModel printed(*GetParam());
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t row = 0; row < printed.jacobian().size(); ++row) {
    for (std::size_t column = 0; column < printed.jacobian()[row].size(); ++column) {
      if (!printed.jacobian()[row][column].is_zero()) {
        places.emplace_back(row, column);
      }
    }
  }
  ASSERT_FALSE(places.empty());
  std::mt19937 engine(seed);
  int turn = GetParam()->number;
  for (const Slip& slip : slips) {
    if (turn++ % 2 != 0 && !is_whole_campaign()) {
      continue;
    }
    const auto [row, column] = places[engine() % places.size()];
    ExpressionMatrix slipped = printed.jacobian();
    slipped[row][column] = slip.plant(slipped[row][column]);
    const std::string item = "(" + std::to_string(row + 1) + "," + std::to_string(column + 1) + ")";
    int found = 0;
    for (const AuditedStatement& statement : audit_text(printed.with(slipped), "own").statements) {
      for (const Finding& finding : statement.findings) {
        if (finding.agrees()) {
          continue;
        }
        ++found;
        EXPECT_EQ(statement.label, "matrix (2)");
        EXPECT_TRUE(finding.item.starts_with(item)) << slip.name << ": " << finding.item;
        EXPECT_EQ(finding.comparison.verdict, slip.verdict) << slip.name;
        EXPECT_FALSE(finding.comparison.difference.empty()) << slip.name;
      }
    }
    EXPECT_EQ(found, 1) << slip.name << " planted at " << item << ", seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(AllModels, AuditOfModel, testing::ValuesIn(share_of(all_models(), 3)),
                         name_of_model);

}  // namespace
}  // namespace assur::test::audit_models_test
