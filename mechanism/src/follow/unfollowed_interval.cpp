#include "unfollowed_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "branch_matching.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::follow {

namespace {

bool is_singular(const Snapshot& step, PointIndex point) {
  return step.configuration(point).regularity != Status::ok;
}

/// The number of branches known to go through a configuration.
std::size_t room(const Snapshot& step, PointIndex point) {
  return std::max<std::size_t>(1, step.configuration(point).branches.size());
}

}  // namespace

UnfollowedInterval::UnfollowedInterval(IntervalEnd before, IntervalEnd after, double length)
    : before_(std::move(before)), after_(std::move(after)), length_(length) {
  Table<PointIndex, bool> continues(after_.branches.size(), false);
  for (const PointIndex point : before_.branches.keys()) {
    const auto same =
        std::find(after_.branches.begin(), after_.branches.end(), before_.branches[point]);
    PointIndex later;
    if (same != after_.branches.end()) {
      later = PointIndex(static_cast<std::size_t>(same - after_.branches.begin()));
      continues[later] = true;
    }
    if (before_.branches[point] > 0) {
      leads_.push_back({before_.branches[point], &before_, point, later});
    }
  }
  for (const PointIndex point : after_.branches.keys()) {
    if (!continues[point] && after_.branches[point] > 0) {
      leads_.push_back({after_.branches[point], &after_, point, {}});
    }
  }
}

std::vector<StepRow> UnfollowedInterval::rows(const Snapshot& step) const {
  const Table<PointIndex, std::vector<const BranchAtEnd*>> leads = assigned(step);
  std::vector<StepRow> rows;
  for (const PointIndex point : leads.keys()) {
    add_rows(step, point, leads[point], rows);
  }
  return rows;
}

std::vector<int> UnfollowedInterval::branches_without_place(const Snapshot& step) const {
  const Table<PointIndex, std::vector<const BranchAtEnd*>> leads = assigned(step);
  std::vector<int> branches;
  for (const BranchAtEnd& lead : leads_) {
    if (std::ranges::none_of(leads, [&](const std::vector<const BranchAtEnd*>& there) {
          return std::ranges::find(there, &lead) != there.end();
        })) {
      branches.push_back(lead.branch);
    }
  }
  return branches;
}

/// The predicted place of a branch: on the cubic through the interval, or straight on from one end.
Eigen::VectorXd UnfollowedInterval::expected(const BranchAtEnd& lead, double parameter) const {
  const ConfigurationPoint& start = lead.from->set->points[lead.point];
  const double move = parameter - lead.from->set->parameter;
  if (!lead.goes_through()) {
    return start.at + move * start.slope;
  }
  const double step = after_.set->parameter - before_.set->parameter;
  return cubic(start, after_.set->points[lead.later], step, move / step);
}

/// A branch that meets k others moves as the root of order 1 to k + 1 of the way h, so that a
/// tangent of slope x' predicts its place to k h |x'|. One that rests meets branches that move. The
/// place where they meet is known to half of the digits.
double UnfollowedInterval::reach(const BranchAtEnd& lead, double parameter) const {
  static const double half_of_digits = std::sqrt(std::numeric_limits<double>::epsilon());
  const Snapshot& set = *lead.from->set;
  double fastest = 0;
  for (const ConfigurationPoint& point : set.points) {
    fastest = std::max(fastest, point.slope.norm());
  }
  return static_cast<double>(leads_.size()) * std::abs(parameter - set.parameter) * fastest +
         16 * half_of_digits;
}

Table<PointIndex, std::vector<const UnfollowedInterval::BranchAtEnd*>> UnfollowedInterval::assigned(
    const Snapshot& step) const {
  struct Choice {
    double distance;
    const BranchAtEnd* lead;
    PointIndex point;
  };
  std::vector<Choice> choices;
  for (const BranchAtEnd& lead : leads_) {
    const Eigen::VectorXd place = expected(lead, step.parameter);
    for (const PointIndex point : step.points.keys()) {
      const double distance = (step.points[point].at - place).norm();
      if (step.configuration(point).is_consistent && distance <= reach(lead, step.parameter)) {
        choices.push_back({distance, &lead, point});
      }
    }
  }
  std::stable_sort(choices.begin(), choices.end(), [](const Choice& one, const Choice& other) {
    return one.distance < other.distance;
  });
  Table<PointIndex, std::vector<const BranchAtEnd*>> result(step.count());
  std::vector<const BranchAtEnd*> placed;
  const auto place = [&](const auto& has_room) {
    for (const Choice& choice : choices) {
      if (std::find(placed.begin(), placed.end(), choice.lead) == placed.end() &&
          has_room(choice)) {
        result[choice.point].push_back(choice.lead);
        placed.push_back(choice.lead);
      }
    }
  };
  place([&](const Choice& choice) {
    return result[choice.point].size() < room(step, choice.point) && choice.lead->goes_through();
  });
  place(
      [&](const Choice& choice) { return result[choice.point].size() < room(step, choice.point); });
  place([&](const Choice& choice) { return is_singular(step, choice.point); });
  return result;
}

void UnfollowedInterval::add_rows(const Snapshot& step, PointIndex point,
                                  std::vector<const BranchAtEnd*> leads,
                                  std::vector<StepRow>& rows) const {
  const Configuration& here = step.configuration(point);
  const auto first = rows.size();
  // The redundant constraints permit only one of several motions.
  if (here.rates_known && here.path_known && leads.size() > 1 && !here.plan->redundant.empty()) {
    const auto rank = [&](const BranchAtEnd* lead) {
      return std::pair(difference_of_rates(*lead, here), lead->branch);
    };
    leads = {*std::min_element(
        leads.begin(), leads.end(),
        [&](const BranchAtEnd* one, const BranchAtEnd* other) { return rank(one) < rank(other); })};
  }
  for (const Configuration& branch : here.branches) {
    const auto best = std::min_element(
        leads.begin(), leads.end(), [&](const BranchAtEnd* one, const BranchAtEnd* other) {
          return difference_of_rates(*one, branch) < difference_of_rates(*other, branch);
        });
    if (best != leads.end()) {
      rows.push_back({point, (*best)->branch, &branch});
      leads.erase(best);
    }
  }
  int least = 0;
  for (const BranchAtEnd* lead : leads) {
    least = least == 0 ? lead->branch : std::min(least, lead->branch);
  }
  const auto through = std::count_if(leads.begin(), leads.end(),
                                     [](const BranchAtEnd* lead) { return lead->goes_through(); });
  const bool one_row = rows.size() == first && through < 2;
  for (const BranchAtEnd* lead : leads) {
    if (!one_row && lead->goes_through()) {
      rows.push_back({point, lead->branch, &here});
    }
  }
  if (one_row) {
    rows.push_back({point, least, &here});
  }
  std::sort(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(),
            [](const StepRow& one, const StepRow& other) { return one.branch < other.branch; });
}

double UnfollowedInterval::difference_of_rates(const BranchAtEnd& lead,
                                               const Configuration& state) const {
  const Configuration& beside = lead.from->set->configuration(lead.point);
  double difference = 0;
  for (const LinkIndex link : state.links.keys()) {
    const Eigen::Vector3d apart = state.links[link].velocity - beside.links[link].velocity;
    difference = std::max({difference, apart.head<2>().norm() / length_, std::abs(apart(2))});
  }
  return difference;
}

}  // namespace assur::mechanism::follow
