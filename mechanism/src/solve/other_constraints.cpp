#include "other_constraints.hpp"

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <assur/text/names.hpp>
#include <limits>
#include <utility>

#include "all_constraints.hpp"
#include "configuration_order.hpp"
#include "left_mobility.hpp"
#include "plan/other_plans.hpp"
#include "relative_frames.hpp"
#include "search_bounds.hpp"
#include "settled_redundancy.hpp"
#include "solver.hpp"

namespace assur::mechanism::solve {

namespace {

/// The reason for a family without a known motion that satisfies all constraints.
std::string reason_without(const std::string& reason, const PlanData& plan) {
  std::vector<std::string> names;
  for (const RedundantJoint& joint : plan.redundant) {
    names.push_back(joint.name);
  }
  return reason + " without constraints of " + text::listed(names) +
         "; the positions in which these constraints hold are unknown";
}

const std::vector<LinkIndex>& links_of(const Family& family, const Values& values) {
  return values.plan().structure.groups[family.group].links;
}

/// Sets the mobility of each family under all constraints and returns whether every one still
/// moves. Returns false where the constraints cannot be closed together (`can_close`). Stops at the
/// first family without a motion, since a fruitless search takes long.
bool are_left(std::vector<Family>& families, const Values& values) {
  if (families.empty()) {
    return true;
  }
  if (!SettledRedundancy::can_close(values.plan())) {
    return false;
  }
  const AllConstraints constraints(values);
  return std::ranges::all_of(families, [&](Family& family) {
    family.mobility =
        family.mobility > 0 ? left_mobility(family, constraints, links_of(family, values)) : 0;
    return family.mobility > 0;
  });
}

/// Sets the mobilities of families under all constraints, with a reason where no motion is found.
void tell_what_is_left(std::vector<Family>& families, const Values& values) {
  const AllConstraints constraints(values);
  for (Family& family : families) {
    if (family.mobility > 0) {
      family.mobility = left_mobility(family, constraints, links_of(family, values));
      if (family.mobility == 0) {
        family.reason = reason_without(family.reason, values.plan());
      }
    }
  }
}

/// Converts the solution by another plan of a mechanism into the form of the mechanism's own plan.
class Adoption {
 public:
  Adoption(const Values& values, const PlanData& other)
      : values_(values), plan_(values.plan()), other_(other) {}

  void adopt(Solution& solution) const {
    for (Configuration& configuration : solution.configurations) {
      adopt(configuration);
    }
    for (Family& family : solution.families) {
      adopt(family);
    }
    for (LimitBreach& breach : solution.breaches) {
      breach.joint = own(breach.joint);
    }
    if (solution.nearest_to_limits) {
      adopt(solution.nearest_to_limits->configuration);
      for (NearestToLimits::Excess& excess : solution.nearest_to_limits->excesses) {
        excess.joint = own(excess.joint);
      }
    }
    if (!(most_configurations(plan_.structure) > Plan::most_listed)) {
      ConfigurationOrder(plan_.named_parts).sort(solution.configurations);
    }
  }

 private:
  [[nodiscard]] JointIndex own(JointIndex joint) const {
    return index_of(plan_.mechanism.joints(), other_.mechanism.joints()[joint].name);
  }

  void adopt(Configuration& configuration) const {
    configuration.plan = values_.shared_plan();
    configuration.slides.clear();
    for (const JointIndex joint : plan_.mechanism.joints().keys()) {
      if (plan_.mechanism.joints()[joint].type != JointType::revolute) {
        configuration.slides.push_back(measured_slide(values_, configuration.links, joint));
      }
    }
    for (CountedAngle& counted : configuration.counted) {
      counted.joint = own(counted.joint);
    }
    if (plan_.request.sweep) {
      configuration.determinants.assign(plan_.structure.groups.size(),
                                        std::numeric_limits<double>::quiet_NaN());
    }
    for (Configuration& branch : configuration.branches) {
      adopt(branch);
    }
  }

  void adopt(Family& family) const {
    const std::vector<LinkIndex>& moving = other_.structure.groups[family.group].links;
    const auto has_any = [&](const FoundGroup& group) {
      return std::ranges::find_first_of(group.links, moving) != group.links.end();
    };
    const auto found = std::ranges::find_if(plan_.structure.groups, has_any);
    family.group = GroupIndex(static_cast<std::size_t>(found - plan_.structure.groups.begin()));
    family.is_placed.resize(plan_.structure.linkage.links.size());
    family.links.resize(plan_.structure.linkage.links.size());
  }

  const Values& values_;
  const PlanData& plan_;
  const PlanData& other_;
};

}  // namespace

Answer OtherConstraints::settled(const SearchOptions& search, const Sought& sought, Answer own,
                                 Solution& result) const {
  const PlanData& plan = values_.plan();
  const bool has_others = plan.others != nullptr && !keeps_own_choice_;
  if (!has_others || (own.refusal && !own.is_unsure)) {
    return own;
  }
  const auto may_lack_all = [](const Answer& answer, const Solution& found) {
    return answer.is_unsure && found.left_out.value_or(0) == 0 &&
           std::ranges::none_of(found.configurations, &Configuration::is_consistent);
  };
  const bool lacks_all = may_lack_all(own, result);
  if (result.families.empty() && !lacks_all) {
    return own;
  }
  if (!lacks_all) {
    std::vector<Family> left = result.families;
    if (are_left(left, values_)) {
      result.families = std::move(left);
      return own;
    }
  }
  for (const std::shared_ptr<const PlanData>& other : plan.others->all()) {
    const Values values(other, values_.replaced());
    MechanismSolver solver(values);
    try {
      Solution solution;
      Answer answer = solver.solve(search, sought, solution);
      if (answer.refusal) {
        if (!lacks_all && !answer.is_unsure) {
          return answer;
        }
      } else if (are_left(solution.families, values) && !may_lack_all(answer, solution)) {
        Adoption(values_, *other).adopt(solution);
        result = std::move(solution);
        return answer;
      }
    } catch (const MechanismError&) {
      continue;  // as where a slot has no direction
    }
  }
  if (!own.refusal && SettledRedundancy::can_close(plan)) {
    tell_what_is_left(result.families, values_);
  }
  return own;
}

}  // namespace assur::mechanism::solve
