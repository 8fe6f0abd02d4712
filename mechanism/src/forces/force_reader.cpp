#include "force_reader.hpp"

#include <algorithm>
#include <limits>

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

Vector2d& force_on(JointForce& joint, LinkIndex link) {
  for (auto& [own, force] : joint.on) {
    if (own == link) {
      return force;
    }
  }
  joint.on.emplace_back(link, Vector2d::Zero());
  return joint.on.back().second;
}

}  // namespace

ForceReader::ForceReader(const Mechanism& mechanism, const Balance& balance)
    : mechanism_(mechanism), balance_(balance) {
  none_.efforts.assign(mechanism_.drivers().size(), 0);
  for (std::size_t index = 0; index < balance.pairs().size(); ++index) {
    begin(index);
  }
  result_ = none_;
}

JointForce& ForceReader::joint_of(std::size_t pair, Forces& forces) const {
  const std::string& name = balance_.pairs()[pair].joint;
  const auto found = std::ranges::find(forces.joints, name, &JointForce::joint);
  if (found != forces.joints.end()) {
    return *found;
  }
  forces.joints.push_back({name, {}, false, 0});
  return forces.joints.back();
}

/// Lists the links of a pair, those of a joint in the order of its `between`.
void ForceReader::begin(std::size_t index) {
  const HeldPair& pair = balance_.pairs()[index];
  JointForce& joint = joint_of(index, none_);
  for (const FeatureIndex feature : pair.between) {
    (void)force_on(joint, mechanism_.features()[feature].link);
  }
  const Feature& first = mechanism_.features()[pair.first];
  const Feature& second = mechanism_.features()[pair.second];
  joint.has_moment = joint.has_moment || (first.is_line && second.is_line);
}

void ForceReader::add_couples(const Eigen::VectorXd& sizes, double couple, Forces& to) const {
  for (std::size_t place = 0; place < balance_.held().size(); ++place) {
    const HeldCoordinate& held = balance_.held()[place];
    const double size =
        sizes(static_cast<Eigen::Index>(place)) * (held.coordinate == 2 ? couple : 1);
    if (held.driver.exists()) {
      to.efforts[held.driver] += size;
    } else if (held.coordinate == 2) {
      joint_of(held.pair, to).moment += size;
    }
  }
}

void ForceReader::add_forces(const Eigen::VectorXd& sizes, const Directions& directions,
                             Forces& to) const {
  for (std::size_t place = 0; place < balance_.held().size(); ++place) {
    const HeldCoordinate& held = balance_.held()[place];
    if (held.driver.exists() || held.coordinate == 2) {
      continue;
    }
    const Vector2d force = sizes(static_cast<Eigen::Index>(place)) * directions[place];
    JointForce& joint = joint_of(held.pair, to);
    const HeldPair& pair = balance_.pairs()[held.pair];
    force_on(joint, mechanism_.features()[pair.second].link) += force;
    force_on(joint, mechanism_.features()[pair.first].link) -= force;
  }
}

void ForceReader::add(const Eigen::VectorXd& sizes, const Directions& directions) {
  add_couples(sizes, balance_.size(), result_);
  add_forces(sizes, directions, result_);
}

void ForceReader::add_forces(const Eigen::VectorXd& sizes, const Directions& directions) {
  add_forces(sizes, directions, result_);
}

void ForceReader::forget(const LinearSolution& unknowns, const Directions& directions) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  // A rotation of the basis does not change the sums of squares over its vectors.
  Forces squares = none_;
  for (const auto& vector : unknowns.null_space.colwise()) {
    Forces change = none_;
    add_couples(vector, 1, change);
    add_forces(vector, directions, change);
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      squares.efforts[driver] += change.efforts[driver] * change.efforts[driver];
    }
    for (std::size_t joint = 0; joint < change.joints.size(); ++joint) {
      squares.joints[joint].moment += change.joints[joint].moment * change.joints[joint].moment;
      for (std::size_t link = 0; link < change.joints[joint].on.size(); ++link) {
        squares.joints[joint].on[link].second.array() +=
            change.joints[joint].on[link].second.squaredNorm();
      }
    }
  }
  const auto is_known = [](double square) {
    return !(square > LinearSolution::response * LinearSolution::response);
  };
  for (const DriverIndex driver : mechanism_.drivers().keys()) {
    if (!is_known(squares.efforts[driver])) {
      result_.efforts[driver] = unknown;
    }
  }
  for (std::size_t joint = 0; joint < squares.joints.size(); ++joint) {
    if (!is_known(squares.joints[joint].moment)) {
      result_.joints[joint].moment = unknown;
    }
    for (std::size_t link = 0; link < squares.joints[joint].on.size(); ++link) {
      if (!is_known(squares.joints[joint].on[link].second.x())) {
        result_.joints[joint].on[link].second.setConstant(unknown);
      }
    }
  }
}

std::vector<Vector2d> directions_of(const std::vector<Reaction>& units) {
  std::vector<Vector2d> directions;
  for (const Reaction& unit : units) {
    directions.push_back(unit.force.value());
  }
  return directions;
}

std::vector<Vector2d> turning_of(const std::vector<Reaction>& units) {
  std::vector<Vector2d> directions;
  for (const Reaction& unit : units) {
    directions.push_back(unit.force.derivative());
  }
  return directions;
}

Wrench ground_resultant(const Mechanism& mechanism, const Balance& balance,
                        const LinkLoads& loads) {
  Wrench sum;
  for (const LinkIndex link : mechanism.links().keys()) {
    for (const Wrench* part : {&loads.applied[link], &loads.inertia[link]}) {
      if (part == &loads.inertia[link] && link == mechanism.ground()) {
        continue;
      }
      const Vector2d& at = balance.pivots()[link];
      sum.force += part->force;
      sum.moment += part->moment + moment_of(at, part->force);
    }
  }
  return sum;
}

}  // namespace assur::mechanism::forces
