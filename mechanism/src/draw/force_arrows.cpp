#include "draw/force_arrows.hpp"

#include <algorithm>
#include <assur/mechanism/forces.hpp>

namespace assur::mechanism::draw {

namespace {

/// The place at which a joint transmits its force: the pin, or the `through` of the second link's
/// line.
FeatureIndex place_of(const Mechanism& mechanism, const Joint& joint) {
  const FeatureIndex second = joint.between.back();
  return joint.type == JointType::pin_in_slot && mechanism.features()[second].is_line
             ? joint.between.front()
             : second;
}

}  // namespace

void add_forces(const Plan& plan, const Values& values, const Configuration& configuration,
                double size, Drawing& drawing) {
  const Mechanism& mechanism = plan.mechanism();
  double most = 0;
  for (const JointForce& force : forces_of(values, configuration).joints) {
    const JointIndex index = index_of(mechanism.joints(), force.joint);
    if (!index.exists() || !plan.request().reported.has(index)) {
      continue;
    }
    const FeatureIndex feature = place_of(mechanism, mechanism.joints()[index]);
    const Pose<double> pose =
        composed(configuration.links[mechanism.features()[feature].link], values.frame(feature))
            .pose;
    for (std::size_t place = force.on.size() > 2 ? 0 : 1; place < force.on.size(); ++place) {
      const auto& [link, vector] = force.on[place];
      if (vector.allFinite()) {
        drawing.forces.push_back(
            {force.joint, mechanism.links()[link].name, {pose.x, pose.y}, vector});
        most = std::max(most, vector.norm());
      }
    }
  }
  constexpr double longest = 0.25;
  drawing.length_of_force = most > 0 ? longest * size / most : 0;
}

}  // namespace assur::mechanism::draw
