#include "audit/branch_condition.hpp"

#include <algorithm>

namespace assur::generator::audit {

namespace {

using Telling = closures::ClosurePoints::Telling;

/// The condition by the sign of one quantity; empty if the sign does not separate the points.
BranchCondition told_by(closures::ClosurePoints& points, const Telling& telling,
                        const std::vector<TestedPoint>& tested) {
  int sense = 0;
  bool reaches_zero = false;
  const bool tells = std::ranges::all_of(tested, [&](const TestedPoint& one) {
    const int sign = points.sign(telling, *one.point);
    const int here = one.holds ? sign : -sign;
    sense = sense == 0 ? here : sense;
    reaches_zero = reaches_zero || here == 0;
    return here == sense || (here == 0 && one.holds);
  });
  if (!tells || sense == 0) {
    return {};
  }
  const std::string equal = reaches_zero ? "=" : "";
  return {telling.text + (sense > 0 ? " >" : " <") + equal + " 0",
          telling.text + (sense > 0 ? " < 0" : " > 0")};
}

}  // namespace

BranchCondition branch_condition(closures::ClosurePoints& points, const GiNaC::ex& statement,
                                 const std::vector<TestedPoint>& tested) {
  BranchCondition first;
  for (const Telling& telling : points.telling(statement)) {
    const BranchCondition condition = told_by(points, telling, tested);
    if (condition.empty()) {
      continue;
    }
    // Where two assembly modes meet, the Jacobian is singular. A quantity that does not vanish
    // there may separate them only by chance, for these lengths.
    if (points.is_singular_with(telling)) {
      return condition;
    }
    first = first.empty() ? condition : first;
  }
  const BranchCondition by_determinant = told_by(points, points.determinant(), tested);
  return by_determinant.empty() ? first : by_determinant;
}

std::string branch_text(const std::vector<TestedPoint>& tested, const BranchCondition& condition) {
  const auto holding =
      std::ranges::count_if(tested, [](const TestedPoint& one) { return one.holds; });
  return "agrees at " + std::to_string(holding) + " of " + std::to_string(tested.size()) +
         " points, " +
         (condition.empty() ? "and no simple condition tells which"
                            : "all those where " + condition.where_it_holds);
}

}  // namespace assur::generator::audit
