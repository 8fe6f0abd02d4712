#include <algorithm>
#include <assur/mechanism/structure.hpp>
#include <assur/text/names.hpp>
#include <optional>

#include "decomposition.hpp"
#include "grouping.hpp"

namespace assur::mechanism::plan {

namespace {

/// Places the ground, then the driven links, then the groups.
class PlacementPlanner {
 public:
  explicit PlacementPlanner(const Mechanism& mechanism) : mechanism_(mechanism) {
    structure_.linkage = linkage_of(mechanism);
    placed_.assign(structure_.linkage.links.size(), false);
    spent_.assign(structure_.linkage.joints.size(), false);
  }

  Structure run() {
    order_drivers();
    find_groups();
    return std::move(structure_);
  }

 private:
  [[nodiscard]] const ElementaryJoint& joint(ElementaryJointIndex index) const {
    return structure_.linkage.joints[index];
  }

  void order_drivers() {
    if (!structure_.linkage.ground.exists()) {
      throw MechanismError("links", "no link is named 'ground', so nothing holds the mechanism");
    }
    placed_[structure_.linkage.ground] = true;
    std::vector<DriverIndex> waiting;
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      const Joint& at = mechanism_.joints()[mechanism_.drivers()[driver].joint];
      if (at.type == JointType::pin_in_slot || at.between.size() != 2) {
        throw MechanismError("drivers." + at.name,
                             "a driver moves a revolute or prismatic joint of two links");
      }
      waiting.push_back(driver);
    }
    while (!waiting.empty()) {
      const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](DriverIndex driver) {
        const ElementaryJoint& at = joint(joint_of(driver));
        return placed_[at.first] != placed_[at.second];
      });
      if (ready == waiting.end()) {
        refuse(waiting[0]);
      }
      const ElementaryJointIndex index = joint_of(*ready);
      const ElementaryJoint& at = joint(index);
      const LinkIndex from = placed_[at.first] ? at.first : at.second;
      const LinkIndex to = at.other(from);
      structure_.driven.push_back({*ready, index, from, to});
      placed_[to] = true;
      spent_[index] = true;
      waiting.erase(ready);
    }
  }

  [[noreturn]] void refuse(DriverIndex driver) const {
    const ElementaryJoint& at = joint(joint_of(driver));
    const std::string part = "drivers." + at.name;
    const std::string what = "the driven joint joins the links " +
                             text::listed(structure_.names_of({at.first, at.second}));
    if (placed_[at.first]) {
      throw MechanismError(
          part, what + ", which are placed already; take this driver or another one away");
    }
    throw MechanismError(
        part, what + ", and neither is the ground or a driven link; drive a joint at the " +
                  "ground or at a driven link, or make the two one link that has the driven " +
                  "position as a parameter");
  }

  [[nodiscard]] ElementaryJointIndex joint_of(DriverIndex driver) const {
    for (const ElementaryJointIndex index : structure_.linkage.joints.keys()) {
      if (joint(index).joint == mechanism_.drivers()[driver].joint) {
        return index;
      }
    }
    return {};
  }

  void find_groups() {
    Decomposition decomposition = decompose(structure_.linkage, placed_, spent_);
    expect_balance(decomposition);
    structure_.linkage = std::move(decomposition.linkage);
    for (const Component& component : decomposition.components) {
      std::optional<FoundGroup> found =
          find_group(structure_.linkage, component.links, component.joints);
      if (!found) {
        refuse(component);
      }
      structure_.groups.add(std::move(*found));
    }
  }

  [[noreturn]] void refuse(const Component& component) const {
    std::vector<std::string> known;
    for (const GroupModels& group : known_groups()) {
      known.push_back(group.structure.name);
    }
    const int assur_class = assur_class_of(structure_.linkage, component.links, component.joints);
    throw MechanismError(
        "links", "the links " + text::listed(structure_.names_of(component.links)) +
                     " can only be solved together, as a group of class " +
                     std::to_string(assur_class) + " with " +
                     std::to_string(component.links.size()) +
                     " links, which is not known here (known: " + text::listed(known) + ")");
  }

  static void expect_balance(const Decomposition& decomposition) {
    const Imbalance& over = decomposition.overloaded;
    const Imbalance& under = decomposition.free;
    const std::string excess = "over-constrained by " + std::to_string(over.surplus) +
                               ": the joints " + text::listed(over.joints) +
                               (over.links.empty() ? " join links that are placed already"
                                                   : " hold the links " + text::listed(over.links) +
                                                         " more often than they can move") +
                               "; take a joint or a driver away";
    const std::string lack = "under-constrained by " + std::to_string(under.surplus) +
                             ": the links " + text::listed(under.links) +
                             " keep a freedom; drive one of their joints, or add a joint";
    if (over.surplus > 0) {
      throw MechanismError("joints", excess + (under.surplus > 0 ? "; elsewhere " + lack : ""));
    }
    if (under.surplus > 0) {
      throw MechanismError("links", lack);
    }
  }

  const Mechanism& mechanism_;
  Structure structure_;
  Table<LinkIndex, bool> placed_;
  Table<ElementaryJointIndex, bool> spent_;  ///< joints that carry drivers
};

}  // namespace

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

Linkage linkage_of(const Mechanism& mechanism) {
  Linkage linkage;
  for (const Link& link : mechanism.links()) {
    linkage.links.add(link.name);
  }
  linkage.ground = mechanism.ground();
  const auto link_of = [&](FeatureIndex feature) { return mechanism.features()[feature].link; };
  for (const JointIndex index : mechanism.joints().keys()) {
    const Joint& joint = mechanism.joints()[index];
    if (joint.type == JointType::pin_in_slot) {
      const bool line_first = mechanism.features()[joint.between[0]].is_line;
      const FeatureIndex line = joint.between[line_first ? 0 : 1];
      const FeatureIndex pin = joint.between[line_first ? 1 : 0];
      const LinkIndex block = linkage.links.add(joint.name);
      linkage.joints.add({joint.name, index, true, link_of(line), block, line, FeatureIndex()});
      linkage.joints.add({joint.name, index, false, link_of(pin), block, pin, FeatureIndex()});
    } else if (joint.between.size() > 2) {
      SharedPin pin{joint.name, index, {}, joint.between};
      std::transform(joint.between.begin(), joint.between.end(), std::back_inserter(pin.links),
                     link_of);
      linkage.pins.push_back(std::move(pin));
    } else {
      linkage.joints.add({joint.name, index, joint.type == JointType::prismatic,
                          link_of(joint.between[0]), link_of(joint.between[1]), joint.between[0],
                          joint.between[1]});
    }
  }
  return linkage;
}

std::vector<std::string> Structure::names_of(const std::vector<LinkIndex>& links) const {
  std::vector<std::string> names;
  names.reserve(links.size());
  for (const LinkIndex link : links) {
    names.push_back(linkage.links[link]);
  }
  return names;
}

Table<LinkIndex, bool> Structure::placed_by_drivers() const {
  Table<LinkIndex, bool> placed(linkage.links.size(), false);
  placed[linkage.ground] = true;
  for (const DrivenLink& link : driven) {
    placed[link.to] = true;
  }
  return placed;
}

NamedParts Structure::named_parts(const Mechanism& mechanism) const {
  const auto link_name = [&](FeatureIndex feature) -> const std::string& {
    return mechanism.links()[mechanism.features()[feature].link].name;
  };
  NamedParts parts;
  const Table<LinkIndex, bool> driven_links = placed_by_drivers();
  for (const LinkIndex link : mechanism.links().keys()) {
    if (!driven_links[link]) {
      parts.links.push_back(link);
    }
  }
  std::sort(parts.links.begin(), parts.links.end(), [&](LinkIndex one, LinkIndex other) {
    return mechanism.links()[one].name < mechanism.links()[other].name;
  });
  for (const JointIndex index : mechanism.joints().keys()) {
    const Joint& joint = mechanism.joints()[index];
    if (joint.type == JointType::prismatic) {
      const bool in_order = link_name(joint.between[0]) < link_name(joint.between[1]);
      parts.slides.push_back({index, in_order ? 1.0 : -1.0});
    } else if (joint.type == JointType::pin_in_slot) {
      parts.slides.push_back({index, 1.0});
    }
  }
  std::sort(parts.slides.begin(), parts.slides.end(),
            [&](const NamedSlide& one, const NamedSlide& other) {
              return mechanism.joints()[one.joint].name < mechanism.joints()[other.joint].name;
            });
  return parts;
}

Structure structure_of(const Mechanism& mechanism) {
  return plan::PlacementPlanner(mechanism).run();
}

}  // namespace assur::mechanism
