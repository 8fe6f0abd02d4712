// Audits the values that a user's program computes at points against a reference.
#pragma once

#include "audit/finding.hpp"
#include "audit/run_reference.hpp"

namespace assur::generator::audit {

struct RunAnswer {
  std::vector<Finding> findings;
  std::string remark;  ///< the number of points, and the reminder that this is not a proof
};

/// Runs the program at points, assembled if closures are declared, and again at simple ones if an
/// entry is wrong, for a counterexample of few digits. A program that fails at a point is wrong
/// there. Throws FormulaError at `run.result` if the program cannot be run at all.
[[nodiscard]] RunAnswer audit_run(closures::ClosurePoints& points, const ExpectedMatrix& expected,
                                  RunReference& reference, const RunStatement& run,
                                  const running::RunLimits& limits);

}  // namespace assur::generator::audit
