// Turns what a user's program computes at points into findings against a closure system.
#pragma once

#include "audit/asked_points.hpp"
#include "audit/finding.hpp"

namespace assur::generator::audit {

struct RunAnswer {
  std::vector<Finding> findings;
  std::string remark;  ///< at how many points the program was run, and that this is no proof
};

/// Runs the program at assembled points, and once more at simple ones if an entry is wrong, for a
/// counterexample of few digits. Throws FormulaError at `run.result` if the program cannot be
/// audited.
[[nodiscard]] RunAnswer audit_run(closures::ClosurePoints& points, const ExpectedMatrix& expected,
                                  const RunStatement& run, const running::RunLimits& limits);

}  // namespace assur::generator::audit
