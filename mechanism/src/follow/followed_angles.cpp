#include "followed_angles.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace assur::mechanism::follow {

namespace {

using LinkPair = std::pair<LinkIndex, LinkIndex>;

/// The links whose relative angles loads and springs read.
std::vector<LinkPair> links_read(const Mechanism& mechanism) {
  std::vector<LinkPair> links;
  const auto add = [&](FeatureIndex first, FeatureIndex second) {
    const Feature& one = mechanism.features()[first];
    const Feature& other = mechanism.features()[second];
    const bool is_driven = std::ranges::any_of(mechanism.drivers(), [&](const Driver& driver) {
      const std::vector<FeatureIndex>& between = mechanism.joints()[driver.joint].between;
      return between[0] == first && between[1] == second;
    });
    const LinkPair pair(one.link, other.link);
    if (!one.is_line && !other.is_line && !is_driven &&
        std::ranges::find(links, pair) == links.end()) {
      links.push_back(pair);
    }
  };
  for (const Spring& spring : mechanism.loading().springs) {
    if (spring.at_joint) {
      add(spring.between[0], spring.between[1]);
    }
  }
  for (const Load& load : mechanism.loading().loads) {
    for (const NumberIndex number : {load.force_x, load.force_y, load.moment}) {
      if (!number.exists()) {
        continue;
      }
      for (const JointIndex joint : mechanism.numbers()[number].formula.joints()) {
        add(mechanism.joints()[joint].between[0], mechanism.joints()[joint].between[1]);
      }
    }
  }
  return links;
}

}  // namespace

std::function<void(const SweepRecord&)> with_followed_angles(
    const Mechanism& mechanism, std::function<void(const SweepRecord&)> record) {
  std::vector<LinkPair> links = links_read(mechanism);
  if (links.empty()) {
    return record;
  }
  std::map<int, std::vector<FollowedAngle>> on_branches;
  return [links = std::move(links), record = std::move(record),
          on_branches](const SweepRecord& at) mutable {
    if (at.branch == 0) {
      record(at);
      return;
    }
    const auto [known, begins] = on_branches.try_emplace(at.branch);
    Configuration state = *at.state;
    for (std::size_t place = 0; place < links.size(); ++place) {
      const auto& [one, other] = links[place];
      const double angle = angle_of(
          turned(state.links[other].pose.direction, reversed(state.links[one].pose.direction)));
      if (begins) {
        known->second.push_back({one, other, angle, angle});
      }
      double& last = known->second[place].angle;
      last += std::remainder(angle - last, 2 * std::numbers::pi);
    }
    state.followed = known->second;
    SweepRecord followed = at;
    followed.state = &state;
    record(followed);
  };
}

}  // namespace assur::mechanism::follow
