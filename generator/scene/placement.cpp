#include "scene/placement.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"
#include "scene/decomposition.hpp"
#include "scene/names.hpp"

namespace assur::generator {

namespace {

class PlacementPlanner {
 public:
  PlacementPlanner(const Scene& scene, const ParameterValues& values) : scene_(scene) {
    order_.mechanism = mechanism_of(scene, values);
    placed_.assign(order_.mechanism.links.size(), false);
    spent_.assign(order_.mechanism.joints.size(), false);
  }

  PlacementOrder run() {
    order_drivers();
    find_groups();
    return std::move(order_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    throw InputError(scene_.file + ": " + where + ": " + what);
  }
  [[nodiscard]] const MechanismJoint& joint(int index) const {
    return order_.mechanism.joints[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] bool placed(int link) const { return placed_[static_cast<std::size_t>(link)]; }

  void order_drivers() {
    if (order_.mechanism.ground < 0) {
      fail("links", "no link is named 'ground', so nothing holds the mechanism");
    }
    placed_[static_cast<std::size_t>(order_.mechanism.ground)] = true;
    std::vector<const SceneDriver*> waiting;
    for (const SceneDriver& driver : scene_.drivers) {
      const SceneJoint& at = scene_.joints[static_cast<std::size_t>(driver.joint)];
      if (at.type == SceneJointType::pin_in_slot || at.between.size() != 2) {
        fail("drivers." + at.name, "a driver moves a revolute or prismatic joint of two links");
      }
      waiting.push_back(&driver);
    }
    while (!waiting.empty()) {
      const auto ready =
          std::find_if(waiting.begin(), waiting.end(), [&](const SceneDriver* driver) {
            const MechanismJoint& at = joint(joint_of(*driver));
            return placed(at.first) != placed(at.second);
          });
      if (ready == waiting.end()) {
        refuse(*waiting[0]);
      }
      const SceneDriver& driver = **ready;
      const int index = joint_of(driver);
      const MechanismJoint& at = joint(index);
      const int from = placed(at.first) ? at.first : at.second;
      const int to = placed(at.first) ? at.second : at.first;
      order_.driven.push_back({static_cast<int>(&driver - scene_.drivers.data()), index, from, to});
      placed_[static_cast<std::size_t>(to)] = true;
      spent_[static_cast<std::size_t>(index)] = true;
      waiting.erase(ready);
    }
  }

  [[noreturn]] void refuse(const SceneDriver& driver) const {
    const MechanismJoint& at = joint(joint_of(driver));
    const std::vector<std::string> links = names_of({at.first, at.second});
    const std::string where = "drivers." + at.name;
    const std::string what = "the driven joint joins the links " + listed(links);
    if (placed(at.first)) {
      fail(where, what + ", which are placed already; take this driver or another one away");
    }
    fail(where, what + ", and neither is the ground or a driven link; drive a joint at the " +
                    "ground or at a driven link, or make the two one link that has the driven " +
                    "position as a parameter");
  }

  [[nodiscard]] int joint_of(const SceneDriver& driver) const {
    const auto found = std::find_if(
        order_.mechanism.joints.begin(), order_.mechanism.joints.end(),
        [&](const MechanismJoint& candidate) { return candidate.scene_joint == driver.joint; });
    return static_cast<int>(found - order_.mechanism.joints.begin());
  }

  [[nodiscard]] std::vector<std::string> names_of(const std::vector<int>& links) const {
    std::vector<std::string> names;
    names.reserve(links.size());
    for (const int link : links) {
      names.push_back(order_.mechanism.links[static_cast<std::size_t>(link)]);
    }
    return names;
  }

  void find_groups() {
    Decomposition decomposition = decompose(order_.mechanism, placed_, spent_);
    expect_balance(decomposition);
    order_.mechanism = std::move(decomposition.mechanism);
    for (const Component& component : decomposition.components) {
      std::optional<FoundGroup> found =
          find_group(order_.mechanism, component.links, component.joints);
      if (!found) {
        std::vector<std::string> known;
        for (const Group& group : known_groups()) {
          known.push_back(group.name());
        }
        fail("links", "the links " + listed(names_of(component.links)) +
                          " can only be solved together, as a group of class " +
                          std::to_string(
                              assur_class_of(order_.mechanism, component.links, component.joints)) +
                          " with " + std::to_string(component.links.size()) +
                          " links, which is not known here (known: " + listed(known) + ")");
      }
      order_.groups.push_back(std::move(*found));
      order_.group_links.push_back(names_of(component.links));
    }
  }

  void expect_balance(const Decomposition& decomposition) const {
    const Imbalance& over = decomposition.overloaded;
    const Imbalance& under = decomposition.free;
    const std::string excess = "over-constrained by " + std::to_string(over.surplus) +
                               ": the joints " + listed(over.joints) +
                               (over.links.empty() ? " join links that are placed already"
                                                   : " hold the links " + listed(over.links) +
                                                         " more often than they can move") +
                               "; take a joint or a driver away";
    const std::string lack = "under-constrained by " + std::to_string(under.surplus) +
                             ": the links " + listed(under.links) +
                             " keep a freedom; drive one of their joints, or add a joint";
    if (over.surplus > 0) {
      fail("joints", excess + (under.surplus > 0 ? "; elsewhere " + lack : ""));
    }
    if (under.surplus > 0) {
      fail("links", lack);
    }
  }

  const Scene& scene_;
  PlacementOrder order_;
  std::vector<bool> placed_;
  std::vector<bool> spent_;  ///< joints that carry drivers
};

}  // namespace

std::vector<bool> PlacementOrder::placed_by_drivers() const {
  std::vector<bool> placed(mechanism.links.size(), false);
  placed[static_cast<std::size_t>(mechanism.ground)] = true;
  for (const DrivenLink& link : driven) {
    placed[static_cast<std::size_t>(link.to)] = true;
  }
  return placed;
}

PlacementOrder placement_order(const Scene& scene, const ParameterValues& values) {
  return PlacementPlanner(scene, values).run();
}

}  // namespace assur::generator
