// Structure of a mechanism: the order in which links are placed and groups are solved.
#include <algorithm>
#include <assur/mechanism/structure.hpp>
#include <assur/text/names.hpp>
#include <optional>
#include <tuple>

#include "clusters.hpp"
#include "decomposition.hpp"
#include "driver_laws.hpp"
#include "grouping.hpp"
#include "redundancy.hpp"

namespace assur::mechanism::plan {

namespace {

/// Places the ground and the links that it carries, then the groups in order, each with the links
/// that its links carry.
class PlacementPlanner {
 public:
  explicit PlacementPlanner(const Mechanism& mechanism) : mechanism_(mechanism) {
    structure_.linkage = linkage_of(mechanism);
    const std::size_t links = structure_.linkage.links.size();
    bodies_.placed.assign(links, false);
    for (const LinkIndex link : structure_.linkage.links.keys()) {
      bodies_.carrier.add(link);
    }
    bodies_.driven.assign(structure_.linkage.joints.size(), false);
    bodies_.read.resize(structure_.linkage.joints.size());
  }

  FoundStructure run() {
    (void)laws_in_order(mechanism_);  // the following steps require an order of the laws
    if (!structure_.linkage.ground.exists()) {
      throw MechanismError("links",
                           "no link is named 'ground', so nothing holds the mechanism; give the "
                           "fixed link this name");
    }
    tie_driven_links();
    Decomposition decomposition = decompose(structure_.linkage, bodies_);
    if (decomposition.overloaded.surplus > 0) {
      return excess_of(decomposition.overloaded, decomposition.free);
    }
    expect_driven(decomposition.free);
    expect_order(decomposition);
    find_groups(std::move(decomposition));
    return std::move(structure_);
  }

 private:
  [[nodiscard]] const ElementaryJoint& joint(ElementaryJointIndex index) const {
    return structure_.linkage.joints[index];
  }

  /// Gives the same carrier to links that drivers connect, which therefore move as one: the ground
  /// if it is one of them.
  void tie_driven_links() {
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      const Joint& named = mechanism_.joints()[mechanism_.drivers()[driver].joint];
      if (named.between.size() != 2) {
        throw MechanismError(
            "drivers." + named.name,
            "a driver moves a joint of two links; give each link a pin of its own");
      }
      const ElementaryJoint& at = joint(joint_of(driver));
      const LinkIndex one = bodies_.carrier[at.first];
      const LinkIndex other = bodies_.carrier[at.second];
      if (one == other) {
        refuse(driver);
      }
      const LinkIndex kept = other == structure_.linkage.ground ? other : one;
      for (LinkIndex& carrier : bodies_.carrier) {
        carrier = carrier == one || carrier == other ? kept : carrier;
      }
      bodies_.driven[joint_of(driver)] = true;
      bodies_.read[joint_of(driver)] = links_read_by(driver);
    }
    for (const LinkIndex link : bodies_.placed.keys()) {
      bodies_.placed[link] = bodies_.carrier[link] == structure_.linkage.ground;
    }
    carry_from(structure_.linkage.ground);
  }

  /// The links at the joints that a law reads. For a driven joint the law reads that joint's law,
  /// and no link.
  [[nodiscard]] std::vector<LinkIndex> links_read_by(DriverIndex driver) const {
    std::vector<LinkIndex> links;
    for (const JointIndex read : joints_read(mechanism_, driver)) {
      for (const FeatureIndex feature : mechanism_.joints()[read].between) {
        links.push_back(mechanism_.features()[feature].link);
      }
    }
    return links;
  }

  /// Lists the links that drivers move relative to a link, those that other drivers move relative
  /// to these, and so on.
  void carry_from(LinkIndex from) {
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      const ElementaryJointIndex index = joint_of(driver);
      const ElementaryJoint& at = joint(index);
      const bool is_listed = std::ranges::any_of(
          structure_.carried, [&](const CarriedLink& link) { return link.driver == driver; });
      if (at.touches(from) && !is_listed) {
        const LinkIndex to = at.other(from);
        structure_.carried.push_back({driver, index, from, to, {}});
        carry_from(to);
      }
    }
  }

  [[noreturn]] void refuse(DriverIndex driver) const {
    const ElementaryJoint& at = joint(joint_of(driver));
    throw MechanismError("drivers." + at.name,
                         "the driven joint joins the links " +
                             text::listed(structure_.names_of({at.first, at.second})) +
                             (bodies_.carrier[at.first] == structure_.linkage.ground
                                  ? ", which are placed already"
                                  : ", which other drivers tie together already") +
                             "; take this driver or another one away");
  }

  [[nodiscard]] ElementaryJointIndex joint_of(DriverIndex driver) const {
    for (const ElementaryJointIndex index : structure_.linkage.joints.keys()) {
      if (joint(index).joint == mechanism_.drivers()[driver].joint) {
        return index;
      }
    }
    return {};
  }

  void find_groups(Decomposition decomposition) {
    structure_.linkage = std::move(decomposition.linkage);
    for (Component& component : decomposition.components) {
      if (component.joints.empty()) {
        continue;  // A driver places this link, and the link that carries it has listed it.
      }
      component.links = carriers_of(component);
      Component rest = component;
      std::optional<FoundGroup> found = find_group(structure_.linkage, rest.links, rest.joints);
      while (!found) {
        std::optional<Cluster> cluster = find_cluster(structure_.linkage, rest);
        if (!cluster) {
          std::string obstacle;
          found = derived_group(structure_.linkage, rest.links, rest.joints, obstacle);
          if (!found) {
            refuse(component, obstacle);
          }
          break;
        }
        add(std::move(cluster->group));
        rest = std::move(cluster->rest);
        found = find_group(structure_.linkage, rest.links, rest.joints);
      }
      add(std::move(*found));
    }
    order_carried_links();
  }

  /// Adds a group and the links that its links carry. If the group is solved relative to a base,
  /// the base carries the group's links.
  void add(FoundGroup group) {
    const GroupIndex index(structure_.groups.size());
    for (const LinkIndex link : group.links) {
      if (group.base.exists()) {
        structure_.carried.push_back({{}, {}, group.base, link, index});
      }
      carry_from(link);
    }
    for (std::size_t place = 0; place < group.links.size(); ++place) {
      for (const CarriedLink& carried : structure_.carried) {
        if (carried.from == group.links[place]) {
          group.links.push_back(carried.to);
        }
      }
    }
    std::ranges::sort(group.links);
    structure_.groups.add(std::move(group));
  }

  /// The links that the law of a carried link's driver reads.
  [[nodiscard]] std::vector<LinkIndex> read_for(const CarriedLink& link) const {
    return link.joint.exists() ? bodies_.read[link.joint] : std::vector<LinkIndex>();
  }

  /// Sorts carried links. A carried link can be placed once the link that carries it and the links
  /// that its law reads are placed.
  void order_carried_links() {
    Table<LinkIndex, std::size_t> groups_before(structure_.linkage.links.size(), 0);
    for (const GroupIndex group : structure_.groups.keys()) {
      for (const LinkIndex link : structure_.groups[group].links) {
        groups_before[link] = group.place() + 1;
      }
    }
    const auto latest = [&](const std::vector<LinkIndex>& links) {
      std::size_t groups = 0;
      for (const LinkIndex link : links) {
        groups = std::max(groups, groups_before[link]);
      }
      return groups;
    };
    put_carried_links_behind_what_they_read();
    for (CarriedLink& link : structure_.carried) {
      link.groups_before = std::max(groups_before[link.from], latest(read_for(link)));
      groups_before[link.to] = link.groups_before;
    }
    std::ranges::stable_sort(structure_.carried, {}, &CarriedLink::groups_before);
    Table<LinkIndex, std::size_t> links_before(structure_.linkage.links.size(), 0);
    for (std::size_t place = 0; place < structure_.carried.size(); ++place) {
      links_before[structure_.carried[place].to] = place + 1;
    }
    structure_.laws = laws_in_order(mechanism_);
    for (const DriverIndex driver : structure_.laws) {
      if (std::vector<LinkIndex>& read = bodies_.read[joint_of(driver)]; !read.empty()) {
        std::size_t links = 0;
        for (const LinkIndex link : read) {
          links = std::max(links, links_before[link]);
        }
        structure_.reading.push_back({driver, latest(read), links, std::move(read)});
      }
    }
    std::ranges::stable_sort(structure_.reading, {}, [](const ReadingDriver& reading) {
      return std::make_pair(reading.groups_before, reading.links_before);
    });
  }

  /// Puts carried links after those that carry them, and after those that their laws read.
  void put_carried_links_behind_what_they_read() {
    std::vector<CarriedLink> waiting = std::move(structure_.carried);
    structure_.carried.clear();
    Table<LinkIndex, bool> waits(structure_.linkage.links.size(), false);
    for (const CarriedLink& link : waiting) {
      waits[link.to] = true;
    }
    const auto is_ready = [&](const CarriedLink& link) {
      return !waits[link.from] &&
             std::ranges::none_of(read_for(link), [&](LinkIndex read) { return waits[read]; });
    };
    while (!waiting.empty()) {
      std::vector<CarriedLink> still_waiting;
      for (const CarriedLink& link : waiting) {
        if (is_ready(link)) {
          waits[link.to] = false;
          structure_.carried.push_back(link);
        } else {
          still_waiting.push_back(link);
        }
      }
      waiting = std::move(still_waiting);
    }
  }

  static void expect_order(const Decomposition& decomposition) {
    const Imbalance& coupled = decomposition.coupled;
    if (!coupled.links.empty()) {
      const bool is_one = coupled.joints.size() == 1;
      throw MechanismError(
          "drivers",
          (is_one ? "the law of the " : "the laws of the ") +
              text::listed_as("joint", coupled.joints) + (is_one ? " reads" : " read") +
              " joints of the " + text::listed_as("link", coupled.links) +
              (is_one ? ", which this law moves" : ", which these laws move") +
              ": the links can only be solved together, as a group that is not supported; let a "
              "law read joints that are placed before the links that it moves");
    }
  }

  /// Selects, among links that drivers connect in a group, the one that carries the others: the one
  /// with the most joints of the group, since dimensions between joints on one link stay constant,
  /// and then the one whose name comes first. Moves the group's joints to these carriers and
  /// returns them, ascending.
  std::vector<LinkIndex> carriers_of(const Component& component) {
    Table<LinkIndex, int> joints(bodies_.carrier.size(), 0);
    for (const ElementaryJointIndex index : component.joints) {
      ++joints[joint(index).first];
      ++joints[joint(index).second];
    }
    const auto rank = [&](LinkIndex link) {
      const bool is_block = link.place() >= mechanism_.links().size();
      return std::make_tuple(is_block, -joints[link], structure_.linkage.links[link]);
    };
    Table<LinkIndex, LinkIndex> carrier(bodies_.carrier.size());
    for (const LinkIndex link : component.links) {
      carrier[link] = link;
    }
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      const ElementaryJoint& at = joint(joint_of(driver));
      const LinkIndex one = carrier[at.first];
      const LinkIndex other = carrier[at.second];
      if (one.exists() && other.exists()) {
        const LinkIndex kept = rank(one) < rank(other) ? one : other;
        for (const LinkIndex link : component.links) {
          carrier[link] = carrier[link] == one || carrier[link] == other ? kept : carrier[link];
        }
      }
    }
    for (const ElementaryJointIndex index : component.joints) {
      ElementaryJoint& at = structure_.linkage.joints[index];
      at.first = carrier[at.first].exists() ? carrier[at.first] : at.first;
      at.second = carrier[at.second].exists() ? carrier[at.second] : at.second;
    }
    std::vector<LinkIndex> carriers;
    for (const LinkIndex link : component.links) {
      if (carrier[link] == link) {
        carriers.push_back(link);
      }
    }
    return carriers;
  }

  [[noreturn]] void refuse(const Component& component, const std::string& obstacle) const {
    const int assur_class = assur_class_of(structure_.linkage, component.links, component.joints);
    throw MechanismError("links", "the links " +
                                      text::listed(structure_.names_of(component.links)) +
                                      " can only be solved together, as a group of class " +
                                      std::to_string(assur_class) + " with " +
                                      std::to_string(component.links.size()) +
                                      " links, which is not solved here: " + obstacle);
  }

  /// Whether one of some joints is between unplaced links that drivers connect.
  [[nodiscard]] bool is_within_tied(const std::vector<std::string>& joints) const {
    const auto is_tied = [this](FeatureIndex one, FeatureIndex other) {
      const LinkIndex carrier = bodies_.carrier[mechanism_.features()[one].link];
      return one != other && carrier != structure_.linkage.ground &&
             carrier == bodies_.carrier[mechanism_.features()[other].link];
    };
    return std::ranges::any_of(mechanism_.joints(), [&](const Joint& joint) {
      return std::ranges::find(joints, joint.name) != joints.end() &&
             std::ranges::any_of(joint.between, [&](FeatureIndex one) {
               return std::ranges::any_of(joint.between,
                                          [&](FeatureIndex other) { return is_tied(one, other); });
             });
    });
  }

  /// The excess joints and their links, in words.
  [[nodiscard]] std::string told_excess(const Imbalance& over) const {
    const std::string ending = over.joints.size() == 1 ? "s" : "";
    std::string fault;
    if (over.links.empty()) {
      fault = " join" + ending + " links that " +
              (is_within_tied(over.joints) ? "drivers tie together" : "are placed already");
    } else {
      fault = " constrain" + ending + " the " + text::listed_as("link", over.links) +
              " more than " + (over.links.size() == 1 ? "its" : "their") + " freedoms allow";
    }
    return "over-constrained by " + std::to_string(over.surplus) + ": the " +
           text::listed_as("joint", over.joints) + fault + "; take a joint or a driver away";
  }

  /// The links that keep a freedom, in words.
  [[nodiscard]] std::string lack_of(const Imbalance& under) const {
    return "under-constrained by " + std::to_string(under.surplus) + ": the " +
           text::listed_as("link", under.links) + " can still move; drive one of " +
           (under.links.size() == 1 ? "its" : "their") + " joints, or add a joint" +
           undrawn_among(under.links);
  }

  /// The first link of a drawing that no listed point pins.
  [[nodiscard]] std::string undrawn_among(const std::vector<std::string>& names) const {
    const auto& links = mechanism_.links();
    const auto is_undrawn = [&](const std::string& name) {
      const LinkIndex link = index_of(links, name);
      return link.exists() && !links[link].is_drawn;
    };
    const auto found = std::ranges::find_if(names, is_undrawn);
    return found == names.end() || std::ranges::none_of(links, &Link::is_drawn)
               ? ""
               : "; the link " + *found +
                     " has a frame of its own, so that no point pins it: name its joints";
  }

  [[nodiscard]] OverConstrained excess_of(const Imbalance& over, const Imbalance& under) const {
    const std::string lack = under.surplus > 0 ? "; elsewhere " + lack_of(under) : "";
    return {"joints", told_excess(over) + lack, over.surplus, over.joints, under.surplus};
  }

  void expect_driven(const Imbalance& under) const {
    if (under.surplus > 0) {
      throw MechanismError("links", lack_of(under));
    }
  }

  const Mechanism& mechanism_;
  Structure structure_;
  DrivenBodies bodies_;
};

}  // namespace

FoundStructure found_structure(const Mechanism& mechanism) {
  try {
    return PlacementPlanner(mechanism).run();
  } catch (const MechanismError& fault) {
    return fault;
  }
}

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

Structure structure_of(const Mechanism& mechanism) {
  plan::FoundStructure found = plan::found_structure(mechanism);
  if (const auto* const excess = std::get_if<OverConstrained>(&found)) {
    throw OverConstrained(*excess);
  }
  if (const auto* const fault = std::get_if<MechanismError>(&found)) {
    throw MechanismError(*fault);
  }
  return std::get<Structure>(std::move(found));
}

}  // namespace assur::mechanism
