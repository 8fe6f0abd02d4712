#include "refusals.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/numbers.hpp>
#include <vector>

namespace assur::mechanism::plan {

namespace {

/// The error for an over-constrained mechanism; `without` says how it behaves without the excess.
OverConstrained refused(const PlanData& plan, const std::string& without) {
  std::vector<std::string> names;
  for (const RedundantJoint& joint : plan.redundant) {
    if (std::ranges::find(names, joint.name) == names.end()) {
      names.push_back(joint.name);
    }
  }
  return {"",
          std::string(plan.excess->what()) + "; without constraints of " + text::listed(names) +
              " the mechanism " + without,
          plan.excess->surplus, plan.excess->joints};
}

}  // namespace

OverConstrained refusal_of_redundant(const PlanData& plan, double gap) {
  if (gap == 0) {
    return refusal_where_driven_on(plan, true);
  }
  OverConstrained refusal =
      refused(plan, "can be assembled, but then these constraints are violated by " +
                        text::short_number(gap, 3) + " at least");
  refusal.gap = gap;
  return refusal;
}

OverConstrained refusal_where_driven_on(const PlanData& plan, bool assembles) {
  OverConstrained refusal =
      refused(plan, std::string("can be assembled, and these constraints hold in this position, ") +
                        (assembles ? "but not after the drivers advance"
                                   : "but after the drivers advance, or go back, the mechanism "
                                     "cannot be assembled"));
  refusal.gap = 0;
  return refusal;
}

OverConstrained refusal_without_groups(const Mechanism& mechanism, const OverConstrained& excess) {
  if (excess.surplus > most_surplus) {
    return {"",
            std::string(excess.what()) + "; at most " + std::to_string(most_surplus) +
                " can be left out to check whether they hold; remove some of the joints",
            excess.surplus, excess.joints};
  }
  const std::string constraints =
      excess.surplus == 1 ? "constraint was" : std::to_string(excess.surplus) + " constraints were";
  std::vector<std::string> read;
  for (const JointIndex joint : mechanism.joints().keys()) {
    const std::string& name = mechanism.joints()[joint].name;
    if (std::ranges::find(excess.joints, name) != excess.joints.end() &&
        is_read(mechanism, joint)) {
      read.push_back(name);
    }
  }
  return {"",
          std::string(excess.what()) + "; no " + constraints +
              " found whose removal leaves supported groups, so it is unknown whether the excess "
              "constraints hold" +
              (read.empty() ? ""
                            : "; " + text::listed(read) +
                                  " cannot be left out, because laws or "
                                  "loads read the coordinate"),
          excess.surplus, excess.joints};
}

OverConstrained refusal_without_assembly(const PlanData& plan, const std::string& reason) {
  return refused(plan, "cannot be assembled either" + (reason.empty() ? reason : ": " + reason));
}

}  // namespace assur::mechanism::plan
