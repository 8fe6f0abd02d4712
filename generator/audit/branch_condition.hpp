// The sign condition that separates the points at which a statement holds from the others.
#pragma once

#include "closures/closure_points.hpp"

namespace assur::generator::audit {

/// Whether a statement holds at one point.
struct TestedPoint {
  closures::ClosurePoints::Point* point;
  bool holds;
};

/// `cos(ph) > 0` and its opposite; both empty if no quantity's sign separates the points.
struct BranchCondition {
  std::string where_it_holds;
  std::string where_it_fails;

  [[nodiscard]] bool empty() const { return where_it_holds.empty(); }
};

/// The first of a list of simple conditions that holds exactly at the points where the statement
/// does: the sign of a cosine, sine, length or derivative, of the cosine or sine of a sum or
/// difference of two angles, ... Quantities at whose zeros the Jacobian is singular come first,
/// then its determinant.
[[nodiscard]] BranchCondition branch_condition(closures::ClosurePoints& points,
                                               const GiNaC::ex& statement,
                                               const std::vector<TestedPoint>& tested);

/// `agrees at 20 of 40 points, all those where cos(ph) > 0`, or that there is no simple condition.
[[nodiscard]] std::string branch_text(const std::vector<TestedPoint>& tested,
                                      const BranchCondition& condition);

}  // namespace assur::generator::audit
