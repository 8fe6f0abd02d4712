#include <algorithm>
#include <assur/mechanism/forces.hpp>
#include <limits>

#include "balance.hpp"
#include "link_loads.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism {

bool JointForce::is_determined() const {
  return std::ranges::all_of(on, [](const auto& part) { return part.second.allFinite(); }) &&
         std::isfinite(moment);
}

}  // namespace assur::mechanism

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

/// Turns the unknowns of the equilibrium into efforts and the forces of joints.
class ForceReader {
 public:
  ForceReader(const Values& values, const Balance& balance, const Eigen::VectorXd& unknowns)
      : mechanism_(values.plan().mechanism), balance_(balance) {
    result_.efforts.assign(mechanism_.drivers().size(), 0);
    for (std::size_t index = 0; index < balance.pairs().size(); ++index) {
      begin(index);
    }
    for (std::size_t column = 0; column < balance.held().size(); ++column) {
      read(balance.held()[column], unknowns(static_cast<Eigen::Index>(column)));
    }
  }

  [[nodiscard]] Forces take() { return std::move(result_); }

 private:
  [[nodiscard]] JointForce& joint_of(std::size_t pair) {
    const std::string& name = balance_.joint_of(pair);
    const auto found = std::ranges::find(result_.joints, name, &JointForce::joint);
    if (found != result_.joints.end()) {
      return *found;
    }
    result_.joints.push_back({name, {}, false, 0});
    return result_.joints.back();
  }

  [[nodiscard]] static Vector2d& force_on(JointForce& joint, LinkIndex link) {
    for (auto& [own, force] : joint.on) {
      if (own == link) {
        return force;
      }
    }
    joint.on.emplace_back(link, Vector2d::Zero());
    return joint.on.back().second;
  }

  /// Lists the links of a pair, those of a joint in the order of its `between`.
  void begin(std::size_t index) {
    const HeldPair& pair = balance_.pairs()[index];
    JointForce& joint = joint_of(index);
    const JointIndex described = index_of(mechanism_.joints(), joint.joint);
    if (described.exists()) {
      for (const FeatureIndex feature : mechanism_.joints()[described].between) {
        (void)force_on(joint, mechanism_.features()[feature].link);
      }
    }
    const Feature& first = mechanism_.features()[pair.first];
    const Feature& second = mechanism_.features()[pair.second];
    (void)force_on(joint, first.link);
    (void)force_on(joint, second.link);
    joint.has_moment = joint.has_moment || (first.is_line && second.is_line);
  }

  void read(const HeldCoordinate& held, double size) {
    if (held.driver.exists()) {
      result_.efforts[held.driver] = size * (held.coordinate == 2 ? held.unit.couple : 1);
      return;
    }
    JointForce& joint = joint_of(held.pair);
    if (held.coordinate == 2) {
      joint.moment += size * held.unit.couple;
      return;
    }
    // A vector is unknown as a whole: which of its components is would depend on the axes.
    const Vector2d force =
        std::isfinite(size) ? Vector2d(size * held.unit.force) : Vector2d::Constant(size);
    force_on(joint, held.unit.on) += force;
    force_on(joint, held.unit.from) -= force;
  }

  const Mechanism& mechanism_;
  const Balance& balance_;
  Forces result_;
};

/// The resultant of all that acts on the ground: by the equilibrium of all links together, the sum
/// of what acts on each.
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

}  // namespace

}  // namespace assur::mechanism::forces

namespace assur::mechanism {

Forces forces_of(const Values& values, const Configuration& configuration) {
  const forces::Balance balance(values, configuration);
  const forces::LinkLoads loads = forces::link_loads(values, configuration, balance);
  const Eigen::VectorXd load = balance.rows_of(loads.applied) + balance.rows_of(loads.inertia);
  const Eigen::VectorXd unknowns = forces::LinearEquations(balance.matrix(), balance.threshold(),
                                                           forces::LinearEquations::OfLinks::rows)
                                       .solve(-load);
  Forces result = forces::ForceReader(values, balance, unknowns).take();
  result.ground = forces::ground_resultant(values.plan().mechanism, balance, loads);
  const bool is_determined =
      std::ranges::all_of(result.efforts, [](double effort) { return std::isfinite(effort); }) &&
      std::ranges::all_of(result.joints, &JointForce::is_determined);
  result.reason = is_determined ? "" : balance.reason();
  return result;
}

}  // namespace assur::mechanism
