#include "force_reader.hpp"

#include <algorithm>
#include <cmath>

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
  result_.efforts.assign(mechanism_.drivers().size(), 0);
  for (std::size_t index = 0; index < balance.pairs().size(); ++index) {
    begin(index);
  }
}

JointForce& ForceReader::joint_of(std::size_t pair) {
  const std::string& name = balance_.pairs()[pair].joint;
  const auto found = std::ranges::find(result_.joints, name, &JointForce::joint);
  if (found != result_.joints.end()) {
    return *found;
  }
  result_.joints.push_back({name, {}, false, 0});
  return result_.joints.back();
}

/// Lists the links of a pair, those of a joint in the order of its `between`.
void ForceReader::begin(std::size_t index) {
  const HeldPair& pair = balance_.pairs()[index];
  JointForce& joint = joint_of(index);
  for (const FeatureIndex feature : pair.between) {
    (void)force_on(joint, mechanism_.features()[feature].link);
  }
  const Feature& first = mechanism_.features()[pair.first];
  const Feature& second = mechanism_.features()[pair.second];
  joint.has_moment = joint.has_moment || (first.is_line && second.is_line);
}

void ForceReader::add_couples(const Eigen::VectorXd& unknowns) {
  for (std::size_t place = 0; place < balance_.held().size(); ++place) {
    const HeldCoordinate& held = balance_.held()[place];
    const double size =
        unknowns(static_cast<Eigen::Index>(place)) * balance_.unit_of(held.coordinate);
    if (held.driver.exists()) {
      result_.efforts[held.driver] += size;
    } else if (held.coordinate == 2) {
      joint_of(held.pair).moment += size;
    }
  }
}

void ForceReader::add_forces(const Eigen::VectorXd& unknowns,
                             const std::vector<Vector2d>& directions) {
  for (std::size_t place = 0; place < balance_.held().size(); ++place) {
    const HeldCoordinate& held = balance_.held()[place];
    if (held.driver.exists() || held.coordinate == 2) {
      continue;
    }
    // A vector is unknown as a whole: the choice of an unknown component would depend on the axes.
    const double size = unknowns(static_cast<Eigen::Index>(place));
    const Vector2d force =
        std::isfinite(size) ? Vector2d(size * directions[place]) : Vector2d::Constant(size);
    JointForce& joint = joint_of(held.pair);
    const HeldPair& pair = balance_.pairs()[held.pair];
    force_on(joint, mechanism_.features()[pair.second].link) += force;
    force_on(joint, mechanism_.features()[pair.first].link) -= force;
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
