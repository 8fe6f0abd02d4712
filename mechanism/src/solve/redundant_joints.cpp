#include "redundant_joints.hpp"

#include <algorithm>
#include <cmath>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// Of the mechanism's size: what rounding may leave of a configuration that is regular, or is not.
constexpr double rounding_where_regular = 1e-11;
constexpr double rounding_where_singular = 1e-6;

/// Two features in the ground's frame, and the largest length of the mechanism, which goes into
/// them where they are at the origin too.
struct Pair {
  Frame one, other;
  bool are_lines;
  double size;
};

Pair placed(const Values& values, const Table<LinkIndex, Frame>& links,
            const plan::RedundantJoint& joint) {
  const Mechanism& mechanism = values.plan().mechanism;
  const auto frame = [&](FeatureIndex feature) {
    return composed(links[mechanism.features()[feature].link], values.frame(feature));
  };
  Pair pair{frame(joint.one), frame(joint.other), mechanism.features()[joint.one].is_line, 0};
  for (const FeatureIndex feature : {joint.one, joint.other}) {
    const Pose<double>& local = values.frame(feature).pose;
    pair.size = std::max({pair.size, std::abs(local.x), std::abs(local.y)});
  }
  for (const Frame& link : links) {
    pair.size = std::max({pair.size, std::abs(link.pose.x), std::abs(link.pose.y)});
  }
  return pair;
}

/// What rounding of rates is compared with: two links may both be at rest where others move.
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

bool holds(const Values& values, const Table<LinkIndex, Frame>& links,
           const plan::RedundantJoint& joint, bool is_regular, bool rates_known) {
  const Pair pair = placed(values, links, joint);
  const Pose<double>& one = pair.one.pose;
  const Pose<double>& other = pair.other.pose;
  const double relative = is_regular ? rounding_where_regular : rounding_where_singular;
  const NumberIndex given = values.plan().request.redundancy_tolerance;
  const double tolerance =
      std::max(relative * pair.size, given.exists() ? values.number(given).value() : 0);
  const Eigen::Vector2d arm(other.x - one.x, other.y - one.y);
  const Eigen::Vector2d rate = pair.other.velocity.head<2>() - pair.one.velocity.head<2>();
  constexpr double rounding_of_rates = 1e-8;
  const Fastest fastest = fastest_of(links, pair.size);
  const bool has_rates = rates_known && rate.allFinite() && !given.exists();
  if (pair.are_lines) {
    const Direction<double>& along = one.direction;
    const double across = along.cos * arm.y() - along.sin * arm.x();
    const double sine = turned(other.direction, reversed(along)).sin;
    const double turning = pair.other.velocity(2) - pair.one.velocity(2);
    return std::abs(across) <= tolerance && std::abs(sine) * pair.size <= tolerance &&
           (!has_rates || std::abs(turning) <= rounding_of_rates * fastest.turning);
  }
  return arm.norm() <= tolerance &&
         (!has_rates || rate.norm() <= rounding_of_rates * fastest.speed);
}

}  // namespace

bool holds_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                       Status regularity, bool rates_known) {
  return std::ranges::all_of(values.plan().redundant, [&](const plan::RedundantJoint& joint) {
    return holds(values, links, joint, regularity == Status::ok, rates_known);
  });
}

}  // namespace assur::mechanism::solve
