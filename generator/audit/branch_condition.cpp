#include "audit/branch_condition.hpp"

#include <algorithm>

namespace assur::generator::audit {

namespace {

using Telling = closures::ClosurePoints::Telling;

/// The condition by the sign of one quantity; empty if it does not tell.
BranchCondition told_by(closures::ClosurePoints& points, const Telling& telling,
                        const std::vector<Trial>& trials) {
  int sense = 0;
  bool reaches_zero = false;
  const bool tells = std::ranges::all_of(trials, [&](const Trial& trial) {
    const int sign = points.sign(telling, *trial.point);
    const int here = trial.holds ? sign : -sign;
    sense = sense == 0 ? here : sense;
    reaches_zero = reaches_zero || here == 0;
    return here == sense || (here == 0 && trial.holds);
  });
  if (!tells || sense == 0) {
    return {};
  }
  const std::string equal = reaches_zero ? "=" : "";
  return {telling.text + (sense > 0 ? " >" : " <") + equal + " 0",
          telling.text + (sense > 0 ? " < 0" : " > 0")};
}

/// Whether two quantities have equal signs at all points, or opposite ones at all, also where the
/// closures do not hold.
bool have_like_signs(closures::ClosurePoints& points, const Telling& one, const Telling& other) {
  constexpr std::size_t compared = 40;
  int sense = 0;
  for (std::size_t index = 0; index < compared; ++index) {
    closures::ClosurePoints::Point* const point = points.point(index, false);
    if (point == nullptr) {
      return false;
    }
    const int here = points.sign(one, *point) * points.sign(other, *point);
    sense = sense == 0 ? here : sense;
    if (here != 0 && here != sense) {
      return false;
    }
  }
  return sense != 0;
}

}  // namespace

BranchCondition branch_condition(closures::ClosurePoints& points, const GiNaC::ex& statement,
                                 const std::vector<Trial>& trials) {
  const std::vector<Telling> list = points.telling(statement);
  // Two ways of assembly are separated by the determinant of the Jacobian, which a quantity has the
  // sign of: that of another may do so only by chance, for these lengths.
  const Telling determinant = points.determinant();
  const BranchCondition by_determinant = told_by(points, determinant, trials);
  for (const Telling& telling : list) {
    if (by_determinant.empty() || have_like_signs(points, telling, determinant)) {
      BranchCondition condition = told_by(points, telling, trials);
      if (!condition.empty()) {
        return condition;
      }
    }
  }
  return by_determinant;
}

std::string branch_text(const std::vector<Trial>& trials, const BranchCondition& condition) {
  const auto holding =
      std::ranges::count_if(trials, [](const Trial& trial) { return trial.holds; });
  return "agrees at " + std::to_string(holding) + " of " + std::to_string(trials.size()) +
         " points, " +
         (condition.empty() ? "and no simple condition tells which"
                            : "all those where " + condition.where_it_holds);
}

}  // namespace assur::generator::audit
