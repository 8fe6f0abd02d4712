#include "watched_limits.hpp"

#include <algorithm>
#include <cmath>

#include "limits.hpp"
#include "listed_configuration.hpp"
#include "longest_on_links.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

WatchedLimits::WatchedLimits(const Placement& placement)
    : placement_(placement), joints_(placement.structure().groups.size() + 1) {
  const Table<LinkIndex, std::size_t> before = placement.structure().groups_before();
  const Mechanism& mechanism = placement.plan().mechanism;
  for (const JointIndex joint : mechanism.joints().keys()) {
    if (mechanism.joints()[joint].lowest.exists()) {
      std::size_t groups = 0;
      for (const FeatureIndex feature : mechanism.joints()[joint].between) {
        groups = std::max(groups, before[mechanism.features()[feature].link]);
      }
      joints_[groups].push_back(joint);
      exist_ = true;
    }
  }
}

bool WatchedLimits::are_kept_at(std::size_t groups, std::vector<LimitBreach>& breaches) const {
  bool keeps = true;
  for (const JointIndex joint : joints_[groups]) {
    const double beyond = beyond_limits(placement_.values(), placement_.placed().links,
                                        placement_.placed().slides, joint);
    if (beyond > 0) {
      add_breach({joint, 1, beyond}, breaches);
      keeps = false;
    }
  }
  return keeps;
}

bool WatchedLimits::are_kept(std::vector<LimitBreach>& breaches) const {
  bool keeps = true;
  for (std::size_t groups = 0; groups < joints_.size(); ++groups) {
    keeps = are_kept_at(groups, breaches) && keeps;
  }
  return keeps;
}

double WatchedLimits::square_of(const std::vector<NearestToLimits::Excess>& excesses) const {
  const double length = longest_on_links(placement_.values());
  double square = 0;
  for (const NearestToLimits::Excess& excess : excesses) {
    const JointType type = placement_.plan().mechanism.joints()[excess.joint].type;
    square += std::pow(type == JointType::revolute ? excess.by : excess.by / length, 2);
  }
  return square;
}

void WatchedLimits::keep_nearest(std::optional<NearestToLimits>& nearest) const {
  std::vector<NearestToLimits::Excess> excesses;
  for (const std::vector<JointIndex>& joints : joints_) {
    for (const JointIndex joint : joints) {
      const double by = beyond_limits(placement_.values(), placement_.placed().links,
                                      placement_.placed().slides, joint);
      if (by > 0) {
        excesses.push_back({joint, by});
      }
    }
  }
  if (!nearest || square_of(excesses) < square_of(nearest->excesses)) {
    nearest.emplace();
    nearest->excesses = std::move(excesses);
    write_configuration(placement_, false, nearest->configuration);
    nearest->configuration.within_limits = false;
  }
}

std::string reason_of_limits(std::size_t count, const std::string& breaches) {
  return (count == 1 ? "the one configuration is beyond the limits of joints: "
                     : "each of the " + std::to_string(count) +
                           " configurations is beyond the limits of a joint: ") +
         breaches;
}

}  // namespace assur::mechanism::solve
