// Variants of a mechanism: advanced drivers, a joint removed or weakened, or a part of the links.
#include <algorithm>
#include <assur/mechanism/mechanism.hpp>

namespace assur::mechanism {

void Mechanism::renumber_drivers(const Table<JointIndex, JointIndex>& joint_of) {
  Table<DriverIndex, Driver> kept;
  for (Driver driver : drivers_) {
    driver.joint = joint_of[driver.joint];
    if (driver.joint.exists()) {
      Formula& law = numbers_[driver.position].formula;
      law = law.renumbered(joint_of);
      kept.add(driver);
    }
  }
  drivers_ = std::move(kept);
  renumber_loads(joint_of);
}

Mechanism Mechanism::driven_on(double by, double length) const {
  Mechanism moved = *this;
  for (const Driver& driver : drivers_) {
    const bool is_angle = joints_[driver.joint].type == JointType::revolute;
    Formula& law = moved.numbers_[driver.position].formula;
    law = Formula::difference(law, Formula(is_angle ? -by : -by * length));
  }
  return moved;
}

Mechanism Mechanism::without(JointIndex joint, FeatureIndex feature) const {
  Mechanism part = *this;
  std::vector<FeatureIndex>& between = part.joints_[joint].between;
  std::erase(between, feature);
  if (between.size() > 1) {
    return part;
  }
  Table<JointIndex, JointIndex> joint_of(joints_.size());
  part.joints_ = {};
  for (const JointIndex index : joints_.keys()) {
    if (index != joint) {
      joint_of[index] = part.joints_.add(joints_[index]);
    }
  }
  part.renumber_drivers(joint_of);
  return part;
}

Mechanism Mechanism::with_pin(JointIndex slide, FeatureIndex line) const {
  Mechanism part = *this;
  Feature pin = features_[line];
  pin.is_line = false;
  pin.name = joints_[slide].name + " as a pin";
  pin.along_x = pin.along_y = NumberIndex();
  Joint& joint = part.joints_[slide];
  joint.type = JointType::pin_in_slot;
  const FeatureIndex first = joint.between[0];
  std::ranges::replace(joint.between, line, part.add_feature(std::move(pin)));
  if (line == first) {  // A pin is measured from the slot, so the slot is reversed.
    Feature back = features_[joint.between[1]];
    back.name = joints_[slide].name + " as a slot";
    for (NumberIndex* along : {&back.along_x, &back.along_y}) {
      const Number& forth = numbers_[*along];
      *along = part.numbers_.add({Formula::difference(Formula(0), forth.formula), forth.part});
    }
    joint.between[1] = part.add_feature(std::move(back));
  }
  return part;
}

Mechanism Mechanism::with_slot(JointIndex pin, FeatureIndex feature,
                               FeatureIndex along_from) const {
  Mechanism part = *this;
  Feature slot = features_[feature];
  slot.is_line = true;
  slot.name = joints_[pin].name + " as a slot";
  const auto along = [&](NumberIndex to, NumberIndex from) {
    return part.numbers_.add(
        {Formula::difference(numbers_[to].formula, numbers_[from].formula), numbers_[to].part});
  };
  slot.along_x = along(slot.x, features_[along_from].x);
  slot.along_y = along(slot.y, features_[along_from].y);
  const FeatureIndex line = part.add_feature(std::move(slot));
  const std::vector<FeatureIndex>& between = joints_[pin].between;
  const FeatureIndex other = between[0] == feature ? between[1] : between[0];
  Joint relaxed{joints_[pin].name, JointType::pin_in_slot, {other, line}, {}, {}};
  if (between.size() == 2) {
    part.joints_[pin] = std::move(relaxed);
  } else {
    std::erase(part.joints_[pin].between, feature);
    relaxed.name += " of " + links_[features_[feature].link].name;
    part.joints_.add(std::move(relaxed));
  }
  return part;
}

Mechanism Mechanism::only(const Table<LinkIndex, bool>& kept) const {
  Mechanism part = *this;
  part.features_ = {};
  part.links_ = {};
  part.joints_ = {};
  part.outputs_ = {};
  Table<FeatureIndex, FeatureIndex> feature_of(features_.size());
  Table<LinkIndex, LinkIndex> link_of(links_.size());
  for (const LinkIndex link : links_.keys()) {
    if (!kept[link]) {
      continue;
    }
    const LinkIndex own = link_of[link] =
        part.links_.add({links_[link].name, {}, links_[link].is_drawn, links_[link].is_idle});
    for (const FeatureIndex index : links_[link].features) {
      Feature feature = features_[index];
      feature.link = own;
      feature_of[index] = part.add_feature(std::move(feature));
    }
  }
  Table<JointIndex, JointIndex> joint_of(joints_.size());
  for (const JointIndex index : joints_.keys()) {
    Joint joint{joints_[index].name,   joints_[index].type,    {},
                joints_[index].lowest, joints_[index].highest, joints_[index].is_measured};
    for (const FeatureIndex feature : joints_[index].between) {
      if (feature_of[feature].exists()) {
        joint.between.push_back(feature_of[feature]);
      }
    }
    if (joint.between.size() > 1) {
      joint_of[index] = part.joints_.add(std::move(joint));
    }
  }
  part.renumber_drivers(joint_of);
  part.renumber_loading(link_of, feature_of);
  for (Output output : outputs_) {
    output.point = feature_of[output.point];
    if (output.point.exists()) {
      part.outputs_.add(std::move(output));
    }
  }
  return part;
}

}  // namespace assur::mechanism
