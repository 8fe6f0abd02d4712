#include "clusters.hpp"

#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <map>
#include <set>
#include <tuple>

#include "grouping.hpp"

namespace assur::mechanism::plan {

namespace {

using Links = std::vector<LinkIndex>;  ///< ascending

bool is_among(LinkIndex link, const Links& links) {
  return std::ranges::binary_search(links, link);
}

/// Makes `hub` the link that all joints of a pin share. Each joint of a pin has the shared link as
/// its first.
void set_hub(Linkage& linkage, const std::vector<ElementaryJointIndex>& pin, LinkIndex hub) {
  ElementaryJoint at = linkage.joints[*std::ranges::find_if(
      pin, [&](ElementaryJointIndex joint) { return linkage.joints[joint].second == hub; })];
  std::swap(at.first, at.second);
  std::swap(at.on_first, at.on_second);
  std::swap(at.holder_first, at.holder_second);
  for (const ElementaryJointIndex index : pin) {
    ElementaryJoint& joint = linkage.joints[index];
    if (joint.second == hub) {
      joint = at;
    } else {
      joint.first = at.first;
      joint.on_first = at.on_first;
      joint.holder_first = at.holder_first;
    }
  }
}

class ClusterFinder {
 public:
  ClusterFinder(Linkage& linkage, const Component& component)
      : linkage_(linkage), component_(component), names_(linkage.links) {
    for (const ElementaryJointIndex index : component.joints) {
      const ElementaryJoint& at = linkage.joints[index];
      const bool is_of_pin = std::ranges::any_of(
          linkage.pins, [&](const SharedPin& pin) { return pin.joint == at.joint; });
      pins_[is_of_pin ? std::make_pair(at.joint, ElementaryJointIndex())
                      : std::make_pair(at.joint, index)]
          .push_back(index);
    }
  }

  std::optional<Cluster> run() {
    std::set<Links> sets;
    for (const LinkIndex link : component_.links) {
      sets.insert({link});
    }
    std::size_t most_links = 0;
    for (const GroupModels& group : known_groups()) {
      most_links = std::max(most_links, group.structure.link_count());
    }
    for (std::size_t links = 1; links <= most_links; ++links) {
      sets = grown(sets);
      for (const Links& set : sets) {
        if (2 * joints_within(set) == 3 * links) {
          consider(set);
        }
      }
      if (best_) {
        return concluded();
      }
    }
    return std::nullopt;
  }

 private:
  /// The links of a pin, or of a joint of two links; the shared one comes first.
  [[nodiscard]] Links links_at(const std::vector<ElementaryJointIndex>& pin) const {
    Links links = {linkage_.joints[pin.front()].first};
    for (const ElementaryJointIndex joint : pin) {
      links.push_back(linkage_.joints[joint].second);
    }
    return links;
  }

  /// All sets that result when a set is extended by an adjacent link of the component.
  [[nodiscard]] std::set<Links> grown(const std::set<Links>& sets) const {
    std::set<Links> result;
    for (const Links& set : sets) {
      for (const auto& [name, pin] : pins_) {
        const Links links = links_at(pin);
        if (std::ranges::none_of(links, [&](LinkIndex link) { return is_among(link, set); })) {
          continue;
        }
        for (const LinkIndex link : links) {
          if (!is_among(link, set) && is_among(link, component_.links)) {
            Links larger = set;
            larger.insert(std::ranges::upper_bound(larger, link), link);
            result.insert(std::move(larger));
          }
        }
      }
    }
    return result;
  }

  [[nodiscard]] std::size_t joints_within(const Links& set) const {
    std::size_t count = 0;
    for (const auto& [name, pin] : pins_) {
      const auto joined =
          std::ranges::count_if(links_at(pin), [&](LinkIndex link) { return is_among(link, set); });
      count += joined > 0 ? static_cast<std::size_t>(joined - 1) : 0;
    }
    return count;
  }

  /// The rank of a candidate for the base of a set; the smallest rank is chosen.
  using Rank = std::tuple<bool, int, std::string, std::vector<std::string>>;
  struct Candidate {
    Rank rank;
    Linkage linkage;
    Cluster cluster;
  };

  void consider(const Links& set) {
    for (const LinkIndex base : set) {
      const Rank rank = rank_of(base, set);
      if (best_ && best_->rank < rank) {
        continue;
      }
      Linkage linkage = with_hubs_in(set, base);
      Links moving = set;
      std::erase(moving, base);
      Component rest;
      std::vector<ElementaryJointIndex> joints;
      for (const ElementaryJointIndex joint : component_.joints) {
        const ElementaryJoint& at = linkage.joints[joint];
        const bool is_within = is_among(at.first, set) && is_among(at.second, set);
        (is_within ? joints : rest.joints).push_back(joint);
      }
      std::optional<FoundGroup> found = find_group(linkage, moving, joints);
      if (found) {
        found->base = base;
        best_ = Candidate{rank, std::move(linkage), {std::move(*found), std::move(rest)}};
      }
    }
  }

  /// A block, which has no feature, is the last choice for a base.
  [[nodiscard]] Rank rank_of(LinkIndex base, const Links& set) const {
    int joints = 0;
    bool is_block = false;
    for (const auto& [name, pin] : pins_) {
      joints += static_cast<int>(std::ranges::count(links_at(pin), base));
    }
    for (const ElementaryJointIndex index : component_.joints) {
      const ElementaryJoint& at = linkage_.joints[index];
      is_block = is_block || (at.touches(base) && at.holder(base) == base && !at.on(base).exists());
    }
    std::vector<std::string> names;
    for (const LinkIndex link : set) {
      names.push_back(names_[link]);
    }
    std::ranges::sort(names);
    return {is_block, -joints, names_[base], names};
  }

  /// The linkage in which the links of a set that share a pin are joined to one of them: the base,
  /// or the one whose name comes first.
  [[nodiscard]] Linkage with_hubs_in(const Links& set, LinkIndex base) const {
    Linkage linkage = linkage_;
    for (const auto& [name, pin] : pins_) {
      const Links links = links_at(pin);
      Links inside;
      std::ranges::copy_if(links, std::back_inserter(inside),
                           [&](LinkIndex link) { return is_among(link, set); });
      if (pin.size() < 2 || inside.size() < 2) {
        continue;
      }
      const LinkIndex hub = *std::ranges::min_element(
          inside, {}, [&](LinkIndex link) { return std::make_pair(link != base, names_[link]); });
      if (hub != links.front()) {
        set_hub(linkage, pin, hub);
      }
    }
    return linkage;
  }

  /// The cluster and the rest of the component, in which the base takes over the joints of the
  /// group's links.
  std::optional<Cluster> concluded() {
    linkage_ = std::move(best_->linkage);
    Cluster& cluster = best_->cluster;
    Links moving = cluster.group.links;
    std::ranges::sort(moving);
    for (const ElementaryJointIndex index : cluster.rest.joints) {
      ElementaryJoint& at = linkage_.joints[index];
      at.first = is_among(at.first, moving) ? cluster.group.base : at.first;
      at.second = is_among(at.second, moving) ? cluster.group.base : at.second;
    }
    std::ranges::copy_if(component_.links, std::back_inserter(cluster.rest.links),
                         [&](LinkIndex link) { return !is_among(link, moving); });
    return std::move(cluster);
  }

  Linkage& linkage_;
  const Component& component_;
  const Table<LinkIndex, std::string> names_;
  /// The component's joints, those of one pin together.
  std::map<std::pair<JointIndex, ElementaryJointIndex>, std::vector<ElementaryJointIndex>> pins_;
  std::optional<Candidate> best_;
};

}  // namespace

std::optional<Cluster> find_cluster(Linkage& linkage, const Component& component) {
  return ClusterFinder(linkage, component).run();
}

}  // namespace assur::mechanism::plan
