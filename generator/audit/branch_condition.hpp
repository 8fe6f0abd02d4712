// Turns the points at which a statement holds, and those at which it does not, into the sign of a
// quantity that tells them apart.
#pragma once

#include "closures/closure_points.hpp"

namespace assur::generator::audit {

/// Whether a statement holds at one point.
struct TestedPoint {
  closures::ClosurePoints::Point* point;
  bool holds;
};

/// `cos(ph) > 0`, and its contrary; both empty if the sign of no quantity tells.
struct BranchCondition {
  std::string where_it_holds;
  std::string where_it_fails;

  [[nodiscard]] bool empty() const { return where_it_holds.empty(); }
};

/// The first of a list of simple conditions that holds at all points where the statement does, and
/// at no other: the sign of a cosine, sine, length or derivative, of the cosine or sine of a sum or
/// difference of two angles, ... Preferred are quantities with which the Jacobian becomes singular,
/// and then its determinant.
[[nodiscard]] BranchCondition branch_condition(closures::ClosurePoints& points,
                                               const GiNaC::ex& statement,
                                               const std::vector<TestedPoint>& tested);

/// `agrees at 20 of 40 points, all those where cos(ph) > 0`, or that no simple condition tells.
[[nodiscard]] std::string branch_text(const std::vector<TestedPoint>& tested,
                                      const BranchCondition& condition);

}  // namespace assur::generator::audit
