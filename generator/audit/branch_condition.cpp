#include "audit/branch_condition.hpp"

#include <algorithm>

namespace assur::generator::audit {

BranchCondition branch_condition(closures::ClosurePoints& points, const GiNaC::ex& statement,
                                 const std::vector<Trial>& trials) {
  for (const closures::ClosurePoints::Telling& telling : points.telling(statement)) {
    int sense = 0;
    bool reaches_zero = false;
    const bool tells = std::ranges::all_of(trials, [&](const Trial& trial) {
      const int sign = points.sign(telling, *trial.point);
      const int here = trial.holds ? sign : -sign;
      sense = sense == 0 ? here : sense;
      reaches_zero = reaches_zero || here == 0;
      return here == sense || (here == 0 && trial.holds);
    });
    if (tells && sense != 0) {
      const std::string equal = reaches_zero ? "=" : "";
      return {telling.text + (sense > 0 ? " >" : " <") + equal + " 0",
              telling.text + (sense > 0 ? " < 0" : " > 0")};
    }
  }
  return {};
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
