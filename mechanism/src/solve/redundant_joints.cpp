#include "redundant_joints.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/support/redundant.hpp>
#include <cmath>
#include <limits>

#include "group_reasons.hpp"
#include "plan/plan_data.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

/// The largest coordinate of the origins of a mechanism's links, and of the features on them.
struct Extent {
  double origins = 0, features = 0;
};

/// The extent of the links that are placed once `groups` groups are; `before` holds the number of
/// groups that each needs.
Extent extent_of(const Values& values, const Table<LinkIndex, Frame>& links,
                 const Table<LinkIndex, std::size_t>& before, std::size_t groups) {
  const Mechanism& mechanism = values.plan().mechanism;
  Extent extent;
  const auto include = [](const Pose<double>& place, double& largest) {
    largest = std::max(largest, support::largest_coordinate(std::array{place}));
  };
  for (const LinkIndex link : links.keys()) {
    if (before[link] <= groups) {
      include(links[link].pose, extent.origins);
    }
  }
  for (const Joint& joint : mechanism.joints()) {
    for (const FeatureIndex feature : joint.between) {
      if (before[mechanism.features()[feature].link] <= groups) {
        include(values.frame(feature).pose, extent.features);
      }
    }
  }
  return extent;
}

/// The extent of all links.
Extent extent_of(const Values& values, const Table<LinkIndex, Frame>& links) {
  return extent_of(values, links, Table<LinkIndex, std::size_t>(links.size(), 0), 0);
}

/// The two features of a redundant joint in the ground's frame.
struct Pair {
  Pose<double> one, other;
  bool is_line, are_lines;  ///< whether the first one is a line, and whether both are
  double size;              ///< the largest coordinate of the features and of the links' origins
};

Pair placed(const Values& values, const Table<LinkIndex, Frame>& links, const RedundantJoint& joint,
            const Extent& extent) {
  const Mechanism& mechanism = values.plan().mechanism;
  const auto pose = [&](FeatureIndex feature) {
    return support::pose_in(links[mechanism.features()[feature].link].pose,
                            values.frame(feature).pose);
  };
  const HeldPair held = held_by(mechanism, joint);
  const std::array places = {pose(joint.one), pose(joint.other)};
  return {places[0], places[1], !held.holds[0], held.holds[2],
          std::max(support::largest_coordinate(places), extent.origins)};
}

/// The fastest rates and second rates of the mechanism, the scale of their rounding: two links may
/// both be at rest while others move.
struct Fastest {
  double speed = 0, speeding_up = 0;
};

Fastest fastest_of(const Table<LinkIndex, Frame>& links, double size) {
  double turning = 0;
  Fastest fastest;
  for (const Frame& link : links) {
    turning = std::max(turning, std::abs(link.velocity(2)));
    fastest.speed = std::max(fastest.speed, link.velocity.head<2>().norm());
    fastest.speeding_up = std::max({fastest.speeding_up, link.acceleration.head<2>().norm(),
                                    std::abs(link.acceleration(2)) * size});
  }
  fastest.speed += turning * size;
  fastest.speeding_up = std::max(fastest.speeding_up, fastest.speed * turning);
  return fastest;
}

/// The distance between the features that rounding, or the tolerance of the request, allows.
double tolerance_of(const Values& values, double size, Status regularity) {
  const NumberIndex given = values.plan().request.redundancy_tolerance;
  return std::max(support::redundancy_slack(size, regularity),
                  given.exists() ? values.number(given).value() : 0);
}

double gap_of(const Pair& pair) {
  return pair.are_lines ? support::lines_apart(pair.one, pair.other, pair.size)
         : pair.is_line ? support::point_off_line(pair.one, pair.other)
                        : support::points_apart(pair.one, pair.other);
}

/// Whether the features of a redundant joint stay together, to first order and, if requested, to
/// second. Unknown rates count as agreeing.
bool stays_together(const Values& values, const Table<LinkIndex, Frame>& links,
                    const RedundantJoint& joint, const Extent& extent, bool twice) {
  const auto frame = [&](FeatureIndex feature) {
    return composed(links[values.plan().mechanism.features()[feature].link], values.frame(feature));
  };
  const HeldPair held = held_by(values.plan().mechanism, joint);
  const Frame at = seen_from(frame(held.first), frame(held.second));
  const double size = placed(values, links, joint, extent).size;
  const Fastest fastest = fastest_of(links, size);
  for (Eigen::Index coordinate = 0; coordinate < 3; ++coordinate) {
    if (!held.holds[static_cast<std::size_t>(coordinate)]) {
      continue;
    }
    const double unit = coordinate == 2 ? size : 1;
    if (std::abs(at.velocity(coordinate)) * unit >
            support::agreement_of_rates<double> * fastest.speed ||
        (twice && std::abs(at.acceleration(coordinate)) * unit >
                      support::agreement_of_second_rates<double> * fastest.speeding_up)) {
      return false;
    }
  }
  return true;
}

}  // namespace

double gap_of_redundant(const Values& values, const Table<LinkIndex, Frame>& links,
                        Status regularity) {
  if (values.plan().redundant.empty()) {
    return 0;
  }
  const Extent extent = extent_of(values, links);
  double worst = 0;
  for (const RedundantJoint& joint : values.plan().redundant) {
    const Pair pair = placed(values, links, joint, extent);
    const double gap = gap_of(pair);
    if (!std::isfinite(gap)) {
      return std::numeric_limits<double>::infinity();
    }
    if (gap > tolerance_of(values, std::max(pair.size, extent.features), regularity)) {
      worst = std::max(worst, gap);
    }
  }
  return worst;
}

WatchedRedundancy::WatchedRedundancy(const Values& values)
    : values_(values),
      before_(values.plan().structure.groups_before()),
      joints_(values.plan().structure.groups.size() + 1) {
  const PlanData& plan = values.plan();
  for (const RedundantJoint& joint : plan.redundant) {
    const auto before = [&](FeatureIndex feature) {
      return before_[plan.mechanism.features()[feature].link];
    };
    joints_[std::max(before(joint.one), before(joint.other))].push_back(&joint);
  }
}

bool WatchedRedundancy::may_hold_at(std::size_t groups,
                                    const Table<LinkIndex, Frame>& links) const {
  if (joints_[groups].empty()) {
    return true;
  }
  const Extent extent = extent_of(values_, links, before_, groups);
  return std::ranges::all_of(joints_[groups], [&](const RedundantJoint* joint) {
    const Pair pair = placed(values_, links, *joint, extent);
    const double reach = std::max(pair.size, extent.features);
    return !(gap_of(pair) > tolerance_of(values_, reach, Status::near_singular));
  });
}

bool goes_on_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                         Status regularity) {
  const PlanData& plan = values.plan();
  if (plan.redundant.empty() || plan.request.redundancy_tolerance.exists()) {
    return true;
  }
  const Extent extent = extent_of(values, links);
  return std::ranges::all_of(plan.redundant, [&](const RedundantJoint& joint) {
    return stays_together(values, links, joint, extent, regularity == Status::ok);
  });
}

}  // namespace assur::mechanism::solve
