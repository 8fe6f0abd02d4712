// Parts of a mechanism that are over-constrained by themselves.
#include <algorithm>
#include <map>

#include "mechanism_parts.hpp"

namespace assur::mechanism::plan {

namespace {

class Overloading {
 public:
  explicit Overloading(const Mechanism& mechanism)
      : mechanism_(mechanism),
        carrier_(mechanism.links().size(), LinkIndex()),
        part_(mechanism.links().size(), LinkIndex()) {
    for (const LinkIndex link : mechanism.links().keys()) {
      part_[link] = link;
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (const Driver& driver : mechanism.drivers()) {
        const std::vector<LinkIndex> links = links_of(mechanism.joints()[driver.joint]);
        grown = carry(links.front(), links.back()) || carry(links.back(), links.front()) || grown;
      }
    }
  }

  [[nodiscard]] std::vector<Table<LinkIndex, bool>> run(const OverConstrained& fault) {
    std::vector<LinkIndex> overloaded;  // for each joint, a link of the part to which it belongs
    std::vector<std::vector<LinkIndex>> held;
    for (const Joint& joint : mechanism_.joints()) {
      if (std::ranges::find(fault.joints, joint.name) == fault.joints.end()) {
        continue;
      }
      std::vector<LinkIndex> links = links_of(joint);
      held.push_back(links);
      // A joint between placed links belongs to a part with them.
      if (std::ranges::any_of(links, [&](LinkIndex link) { return !is_placed(link); })) {
        std::erase_if(links, [&](LinkIndex link) { return is_placed(link); });
      } else {
        std::erase(links, mechanism_.ground());
      }
      for (const LinkIndex link : links) {
        unite(links.front(), link);
      }
      overloaded.push_back(links.front());
    }
    std::map<LinkIndex, Table<LinkIndex, bool>> parts;
    for (const LinkIndex link : overloaded) {
      parts[part_of(link)].assign(mechanism_.links().size(), false);
    }
    for (std::size_t joint = 0; joint < overloaded.size(); ++joint) {
      for (const LinkIndex link : held[joint]) {
        keep(link, parts[part_of(overloaded[joint])]);
      }
    }
    std::vector<Table<LinkIndex, bool>> result;
    for (const auto& one : parts) {
      const bool is_within_other = std::ranges::any_of(parts, [&](const auto& other) {
        return other.first != one.first && is_within(one.second, other.second);
      });
      if (!is_within_other) {
        result.push_back(one.second);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<LinkIndex> links_of(const Joint& joint) const {
    std::vector<LinkIndex> links;
    for (const FeatureIndex feature : joint.between) {
      links.push_back(mechanism_.features()[feature].link);
    }
    return links;
  }
  [[nodiscard]] bool is_placed(LinkIndex link) const {
    return link == mechanism_.ground() || carrier_[link].exists();
  }
  /// Records that a placed link carries another one by a driver. Returns whether the latter was
  /// unplaced before.
  bool carry(LinkIndex from, LinkIndex to) {
    const bool is_new = is_placed(from) && !is_placed(to);
    carrier_[to] = is_new ? from : carrier_[to];
    return is_new;
  }
  [[nodiscard]] LinkIndex part_of(LinkIndex link) const {
    return part_[link] == link ? link : part_of(part_[link]);
  }
  void unite(LinkIndex one, LinkIndex other) { part_[part_of(one)] = part_of(other); }
  [[nodiscard]] bool is_within(const Table<LinkIndex, bool>& part,
                               const Table<LinkIndex, bool>& other) const {
    bool is_within = true;
    for (const LinkIndex link : mechanism_.links().keys()) {
      is_within = is_within && (other[link] || !part[link]);
    }
    return is_within;
  }
  /// Adds the link, the links that carry it, and the ground to the part.
  void keep(LinkIndex link, Table<LinkIndex, bool>& part) const {
    for (part[mechanism_.ground()] = true; link.exists(); link = carrier_[link]) {
      part[link] = true;
    }
  }

  const Mechanism& mechanism_;
  Table<LinkIndex, LinkIndex> carrier_;  ///< of a placed link: the base of its driver
  Table<LinkIndex, LinkIndex> part_;     ///< of a link: another link of its part, or itself
};

}  // namespace

std::vector<Table<LinkIndex, bool>> overloaded_parts(const Mechanism& mechanism,
                                                     const OverConstrained& fault) {
  const bool is_read = std::ranges::any_of(mechanism.drivers(), [&](const Driver& driver) {
    return !mechanism.numbers()[driver.position].formula.joints().empty();
  });
  return is_read ? std::vector<Table<LinkIndex, bool>>() : Overloading(mechanism).run(fault);
}

std::vector<RedundantJoint> of_whole(const Mechanism& mechanism, const Table<LinkIndex, bool>& kept,
                                     std::vector<RedundantJoint> redundant) {
  Table<FeatureIndex, FeatureIndex> features;  // the index in the whole, by that in the part
  for (const LinkIndex link : mechanism.links().keys()) {
    for (const FeatureIndex feature : mechanism.links()[link].features) {
      if (kept[link]) {
        features.add(feature);
      }
    }
  }
  for (RedundantJoint& joint : redundant) {
    joint.one = features[joint.one];
    joint.other = features[joint.other];
    joint.from = joint.from.exists() ? features[joint.from] : joint.from;
  }
  return redundant;
}

}  // namespace assur::mechanism::plan
