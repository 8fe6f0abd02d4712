#include "redundant_joints.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/support/redundant.hpp>
#include <assur/text/names.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <limits>

#include "group_words.hpp"
#include "plan/redundancy.hpp"

namespace assur::mechanism::solve {

namespace {

/// The two features of a redundant joint in the ground's frame.
struct Pair {
  Frame one, other;
  bool is_line, are_lines;  ///< whether the first one is a line, and whether both are
  double size;              ///< the largest coordinate of the features and of the links' origins
  double reach;             ///< the largest of these and of the features on their links
};

Pair placed(const Values& values, const Table<LinkIndex, Frame>& links,
            const RedundantJoint& joint) {
  const Mechanism& mechanism = values.plan().mechanism;
  const auto frame = [&](FeatureIndex feature) {
    return composed(links[mechanism.features()[feature].link], values.frame(feature));
  };
  const HeldPair held = held_by(mechanism, joint);
  Pair pair{frame(joint.one), frame(joint.other), !held.holds[0], held.holds[2], 0, 0};
  const std::array features = {pair.one.pose, pair.other.pose};
  const auto include = [](const Pose<double>& place, double& largest) {
    largest = std::max({largest, std::abs(place.x), std::abs(place.y)});
  };
  pair.size = support::largest_coordinate(features);
  for (const Frame& link : links) {
    include(link.pose, pair.size);
  }
  pair.reach = pair.size;
  for (const Joint& at : mechanism.joints()) {
    for (const FeatureIndex feature : at.between) {
      include(values.frame(feature).pose, pair.reach);
    }
  }
  return pair;
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
  return pair.are_lines ? support::lines_apart(pair.one.pose, pair.other.pose, pair.size)
         : pair.is_line ? support::point_off_line(pair.one.pose, pair.other.pose)
                        : support::points_apart(pair.one.pose, pair.other.pose);
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
Rates parting(const Pair& pair) {
  const Eigen::Vector3d rate = pair.other.velocity - pair.one.velocity;
  const Eigen::Vector3d second_rate = pair.other.acceleration - pair.one.acceleration;
  if (pair.are_lines) {
    return {std::abs(rate(2)) * pair.size, std::abs(second_rate(2)) * pair.size};
  }
  const Eigen::Vector2d first = rate.head<2>();
  const Eigen::Vector2d second = second_rate.head<2>();
  if (!pair.is_line) {
    return {first.norm(), second.norm()};
  }
  const auto& [c, s] = pair.one.pose.direction;
  const Eigen::Vector2d along(c, s);
  const Eigen::Vector2d across(-s, c);
  const Eigen::Vector2d apart(pair.other.pose.x - pair.one.pose.x,
                              pair.other.pose.y - pair.one.pose.y);
  const double turning = pair.one.velocity(2);
  return {std::abs(across.dot(first) - turning * along.dot(apart)),
          std::abs(across.dot(second) - 2 * turning * along.dot(first) -
                   pair.one.acceleration(2) * along.dot(apart) -
                   turning * turning * across.dot(apart))};
}

/// Whether the features of a redundant joint stay together, to first and second order. Rates that
/// are not known do not part them.
bool stays_together(const Values& values, const Table<LinkIndex, Frame>& links,
                    const RedundantJoint& joint, const RoundingOfRates& rounding) {
  if (values.plan().request.redundancy_tolerance.exists()) {
    return true;
  }
  const Pair pair = placed(values, links, joint);
  const Rates rates = parting(pair);
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
  return std::ranges::all_of(values.plan().redundant, [&](const RedundantJoint& joint) {
    return stays_together(values, links, joint, rounding);
  });
}

/// The error for a mechanism with too many constraints; `without` says what it does without them.
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

double gap_of_redundant(const Values& values, const Table<LinkIndex, Frame>& links,
                        Status regularity) {
  double worst = 0;
  for (const RedundantJoint& joint : values.plan().redundant) {
    const Pair pair = placed(values, links, joint);
    const double gap = gap_of(pair);
    if (!std::isfinite(gap)) {
      return std::numeric_limits<double>::infinity();
    }
    if (gap > tolerance_of(values, pair.reach, regularity)) {
      worst = std::max(worst, gap);
    }
  }
  return worst;
}

bool goes_on_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                         Status regularity) {
  constexpr double anything = std::numeric_limits<double>::infinity();
  return all_stay_together(values, links, {1e-8, regularity == Status::ok ? 1e-4 : anything});
}

bool moves_redundantly(const Values& values, const Table<LinkIndex, Frame>& links) {
  return all_stay_together(values, links, {1e-6, 1e-6});
}

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

OverConstrained refusal_without_groups(const OverConstrained& excess) {
  if (excess.surplus > plan::most_surplus) {
    return {"",
            std::string(excess.what()) + "; at most " + std::to_string(plan::most_surplus) +
                " can be left out to check whether they hold; remove some of the joints",
            excess.surplus, excess.joints};
  }
  const std::string constraints =
      excess.surplus == 1 ? "constraint was" : std::to_string(excess.surplus) + " constraints were";
  return {"",
          std::string(excess.what()) + "; no " + constraints +
              " found without which the links form groups that are known, so that it was not "
              "checked whether they hold",
          excess.surplus, excess.joints};
}

OverConstrained refusal_without_assembly(const PlanData& plan, const std::string& reason) {
  return refused(plan, "cannot be assembled either" + (reason.empty() ? reason : ": " + reason));
}

}  // namespace assur::mechanism::solve
