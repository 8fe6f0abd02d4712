// Links that spin freely on one pin, held at rest by drivers.
#include <algorithm>
#include <assur/mechanism/mechanism.hpp>

namespace assur::mechanism::description {

namespace {

/// Three for each moving link, less one for each closure of a joint and each driver.
int freedoms_of(const Mechanism& mechanism) {
  int count = 3 * static_cast<int>(mechanism.links().size()) -
              (mechanism.ground().exists() ? 3 : 0) - static_cast<int>(mechanism.drivers().size());
  for (const Joint& joint : mechanism.joints()) {
    count -= joint.type == JointType::revolute    ? 2 * (static_cast<int>(joint.between.size()) - 1)
             : joint.type == JointType::prismatic ? 2
                                                  : 1;
  }
  return count;
}

}  // namespace

}  // namespace assur::mechanism::description

namespace assur::mechanism {

/// The only joint of a link that turns freely; does not exist for other links.
JointIndex Mechanism::pin_of_idle(LinkIndex link) const {
  if (link == ground()) {
    return {};
  }
  JointIndex only;
  for (const JointIndex index : joints_.keys()) {
    const auto count = std::ranges::count_if(
        joints_[index].between, [&](FeatureIndex at) { return features_[at].link == link; });
    if (count > 1 || (count == 1 && only.exists())) {
      return {};
    }
    only = count == 1 ? index : only;
  }
  if (!only.exists()) {
    return {};
  }
  const auto reads_it = [&](const Number& number) {
    const std::vector<JointIndex> read = number.formula.joints();
    return std::find(read.begin(), read.end(), only) != read.end();
  };
  const auto bears = [&](const auto& at) { return at.at.link == link; };
  const auto pulls = [&](const Spring& spring) {
    return std::ranges::any_of(spring.between,
                               [&](FeatureIndex at) { return features_[at].link == link; });
  };
  const Joint& joint = joints_[only];
  const bool is_free =
      joint.type == JointType::revolute && !joint.lowest.exists() && !driver_of(only).exists() &&
      std::none_of(numbers_.begin(), numbers_.end(), reads_it) &&
      std::ranges::none_of(loading_.masses, bears) && std::ranges::none_of(loading_.loads, bears) &&
      std::ranges::none_of(loading_.springs, pulls);
  return is_free ? only : JointIndex();
}

void Mechanism::hold_idle_links(const std::function<Formula(LinkIndex)>& angle_of) {
  std::vector<std::pair<LinkIndex, JointIndex>> idle;
  for (const LinkIndex link : links_.keys()) {
    if (const JointIndex pin = pin_of_idle(link); pin.exists()) {
      idle.emplace_back(link, pin);
    }
  }
  if (description::freedoms_of(*this) > static_cast<int>(idle.size())) {
    return;  // other links can move: the mechanism is incomplete, and no link is idle
  }
  for (const auto& [link, pin] : idle) {
    if (joints_[pin].between.size() > 2) {  // the other links keep their pin
      const auto is_own = [&, held = link](FeatureIndex at) { return features_[at].link == held; };
      const FeatureIndex own = *std::ranges::find_if(joints_[pin].between, is_own);
      std::erase(joints_[pin].between, own);
      Joint held{joints_[pin].name + " of " + links_[link].name,
                 JointType::revolute,
                 {joints_[pin].between.front(), own},
                 {},
                 {}};
      hold(joints_.add(std::move(held)), angle_of);
    } else if (!driver_of(pin).exists()) {  // two links pinned only to each other are held once
      joints_[pin].is_measured = true;
      hold(pin, angle_of);
    }
    links_[link].is_idle = true;
  }
}

bool Mechanism::holds_idle(DriverIndex driver) const {
  return std::ranges::any_of(joints_[drivers_[driver].joint].between, [&](FeatureIndex feature) {
    return links_[features_[feature].link].is_idle;
  });
}

void Mechanism::hold(JointIndex joint, const std::function<Formula(LinkIndex)>& angle_of) {
  const std::vector<FeatureIndex>& between = joints_[joint].between;
  const auto angle = [&](std::size_t place) { return angle_of(features_[between[place]].link); };
  const NumberIndex at =
      numbers_.add({Formula::difference(angle(1), angle(0)), "the rest of " + joints_[joint].name});
  drivers_.add({joint, at, {}, {}});
}

}  // namespace assur::mechanism
