#include "redundant_joints.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/support/redundant.hpp>
#include <cmath>
#include <limits>

#include "group_reasons.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// How far the links of a mechanism reach: the largest coordinate of their origins, and of the
/// features on them.
struct Extent {
  double origins = 0, features = 0;
};

/// The extent of the links that are placed once `groups` groups are; `before` tells how many each
/// of them needs.
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

/// The fastest rates of the mechanism, against which the rounding of rates is measured: two links
/// may both be at rest while others move.
struct Fastest {
  double speed = 0, turning = 0;
};

Fastest fastest_of(const Table<LinkIndex, Frame>& links, double size) {
  Fastest fastest;
  for (const Frame& link : links) {
    fastest.turning = std::max(fastest.turning, std::abs(link.velocity(2)));
    fastest.speed = std::max(fastest.speed, link.velocity.head<2>().norm());
  }
  fastest.speed += fastest.turning * size;
  return fastest;
}

/// The distance that rounding, or the tolerance that the request states, allows between the
/// features.
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

/// The part of the fastest first and second rates that may be rounding.
struct RoundingOfRates {
  double first, second;
};

/// The rate, and the second rate, at which the features of a pair move apart.
struct Rates {
  double first, second;
};

/// The rates at which a pair parts. The angle between two lines counts as the length that it spans
/// over the mechanism's size; a pin parts from a slot across the slot only.
Rates parting(const Frame& one, const Frame& other, const Pair& pair) {
  const Eigen::Vector3d rate = other.velocity - one.velocity;
  const Eigen::Vector3d second_rate = other.acceleration - one.acceleration;
  if (pair.are_lines) {
    return {std::abs(rate(2)) * pair.size, std::abs(second_rate(2)) * pair.size};
  }
  const Eigen::Vector2d first = rate.head<2>();
  const Eigen::Vector2d second = second_rate.head<2>();
  if (!pair.is_line) {
    return {first.norm(), second.norm()};
  }
  const auto& [c, s] = one.pose.direction;
  const Eigen::Vector2d along(c, s);
  const Eigen::Vector2d across(-s, c);
  const Eigen::Vector2d apart(other.pose.x - one.pose.x, other.pose.y - one.pose.y);
  const double turning = one.velocity(2);
  return {std::abs(across.dot(first) - turning * along.dot(apart)),
          std::abs(across.dot(second) - 2 * turning * along.dot(first) -
                   one.acceleration(2) * along.dot(apart) - turning * turning * across.dot(apart))};
}

/// Whether the features of a redundant joint stay together, to first and second order. Rates that
/// are not known do not part them.
bool stays_together(const Values& values, const Table<LinkIndex, Frame>& links,
                    const RedundantJoint& joint, const Extent& extent,
                    const RoundingOfRates& rounding) {
  const auto frame = [&](FeatureIndex feature) {
    return composed(links[values.plan().mechanism.features()[feature].link], values.frame(feature));
  };
  const Pair pair = placed(values, links, joint, extent);
  const Rates rates = parting(frame(joint.one), frame(joint.other), pair);
  const Fastest fastest = fastest_of(links, pair.size);
  double speeding_up = fastest.speed * fastest.turning;
  for (const Frame& link : links) {
    speeding_up = std::max({speeding_up, link.acceleration.head<2>().norm(),
                            std::abs(link.acceleration(2)) * pair.size});
  }
  const double most =
      rounding.first * (pair.are_lines ? fastest.turning * pair.size : fastest.speed);
  const bool is_first = !std::isfinite(rates.first) || rates.first <= most;
  return is_first && !(rates.second > rounding.second * speeding_up);
}

bool all_stay_together(const Values& values, const Table<LinkIndex, Frame>& links,
                       const RoundingOfRates& rounding) {
  if (values.plan().redundant.empty() || values.plan().request.redundancy_tolerance.exists()) {
    return true;
  }
  const Extent extent = extent_of(values, links);
  return std::ranges::all_of(values.plan().redundant, [&](const RedundantJoint& joint) {
    return stays_together(values, links, joint, extent, rounding);
  });
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
  constexpr double anything = std::numeric_limits<double>::infinity();
  return all_stay_together(values, links, {1e-8, regularity == Status::ok ? 1e-4 : anything});
}

bool moves_redundantly(const Values& values, const Table<LinkIndex, Frame>& links) {
  return all_stay_together(values, links, {1e-6, 1e-6});
}

}  // namespace assur::mechanism::solve
