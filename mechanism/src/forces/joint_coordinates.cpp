#include "joint_coordinates.hpp"

#include <algorithm>
#include <assur/directions.hpp>

#include "plan/plan_data.hpp"
#include "solve/relative_frames.hpp"

namespace assur::mechanism::forces {

CoordinatePair JointCoordinates::pair_of(JointIndex joint) const {
  const std::vector<FeatureIndex>& between = values_.plan().mechanism.joints()[joint].between;
  return pair_of({between[0], between[1]});
}

CoordinatePair JointCoordinates::pair_of(const std::array<FeatureIndex, 2>& between) const {
  const auto& features = values_.plan().mechanism.features();
  if (!features[between[0]].is_line && !features[between[1]].is_line) {
    return {between[0], between[1], 2};
  }
  const std::size_t line = features[between[0]].is_line ? 0 : 1;
  return {between[line], between[1 - line], 0};
}

Frame JointCoordinates::relative(const CoordinatePair& pair) const {
  const auto placed = [this](FeatureIndex feature) {
    return composed(configuration_.links[values_.plan().mechanism.features()[feature].link],
                    values_.frame(feature));
  };
  return solve::seen_from(placed(pair.first), placed(pair.second));
}

double JointCoordinates::value(JointIndex joint) const {
  if (const DriverIndex driver = values_.plan().mechanism.driver_of(joint); driver.exists()) {
    return number(values_.plan().mechanism.drivers()[driver].position);
  }
  const auto counted = std::ranges::find(configuration_.counted, joint, &CountedAngle::joint);
  if (counted != configuration_.counted.end()) {
    return counted->angle;
  }
  const CoordinatePair pair = pair_of(joint);
  if (const std::optional<double> angle = followed(pair, {})) {
    return *angle;
  }
  const Pose<double> pose = relative(pair).pose;
  return pair.coordinate == 2 ? angle_of(pose.direction) : pose.x;
}

std::optional<double> JointCoordinates::followed(const CoordinatePair& pair,
                                                 NumberIndex rest) const {
  const auto& features = values_.plan().mechanism.features();
  const auto found = std::ranges::find_if(configuration_.followed, [&](const FollowedAngle& angle) {
    return pair.coordinate == 2 && angle.one == features[pair.first].link &&
           angle.other == features[pair.second].link && angle.rest == rest;
  });
  return found == configuration_.followed.end() ? std::nullopt : std::optional(found->angle);
}

double JointCoordinates::number(NumberIndex number) const {
  return values_.plan().mechanism.numbers()[number].formula.evaluate<double>(
      [this](ParameterIndex parameter) { return values_.parameter(parameter); },
      [this](JointIndex joint) { return value(joint); });
}

std::vector<JointIndex> JointCoordinates::joints_of(DriverIndex driver) const {
  const Mechanism& mechanism = values_.plan().mechanism;
  return mechanism.numbers()[mechanism.drivers()[driver].position].formula.joints();
}

Dual JointCoordinates::law(DriverIndex driver) const {
  const Mechanism& mechanism = values_.plan().mechanism;
  const std::vector<JointIndex> joints = joints_of(driver);
  const auto count = static_cast<Eigen::Index>(joints.size());
  return mechanism.numbers()[mechanism.drivers()[driver].position].formula.evaluate<Dual>(
      [this](ParameterIndex parameter) { return Dual(values_.parameter(parameter)); },
      [&](JointIndex joint) {
        const auto place = std::ranges::find(joints, joint) - joints.begin();
        return Dual(value(joint), Eigen::VectorXd::Unit(count, place),
                    Eigen::MatrixXd::Zero(count, count));
      });
}

}  // namespace assur::mechanism::forces
