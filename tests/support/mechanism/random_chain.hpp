// Random mechanisms made of known groups, each attached to earlier ones, in any listing.
#pragma once

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "plan/decomposition.hpp"
#include "plan/grouping.hpp"

namespace assur::test {

using mechanism::ElementaryJointIndex;
using mechanism::LinkIndex;

/// `tetrad 2: L3 L4 L5 L7`, the links' names in order.
inline std::string described(const mechanism::GroupModel& model, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  std::string text = model.group->name + " " + std::to_string(model.number) + ":";
  for (const std::string& name : names) {
    text += " " + name;
  }
  return text;
}

struct ListedChain {
  mechanism::Linkage linkage;
  mechanism::plan::DrivenBodies bodies;
};

/// The ground, one to three driven links and one to six groups. An external joint goes to any link
/// that is there already, or joins a pin of such links.
class RandomChain {
 public:
  explicit RandomChain(std::mt19937& engine) {
    add_link();
    const int drivers = 1 + below(3, engine);
    for (int driver = 0; driver < drivers; ++driver) {
      const int base = below(placed_count_, engine);
      joints_.push_back({below(2, engine) == 0, true, {base, add_link()}});
    }
    const int count = 1 + below(6, engine);
    for (int group = 0; group < count; ++group) {
      const auto& groups = mechanism::known_groups();
      add_group(groups[static_cast<std::size_t>(below(static_cast<int>(groups.size()), engine))],
                engine);
    }
    std::sort(groups_.begin(), groups_.end());
  }

  /// The groups as `described` writes them, sorted.
  [[nodiscard]] const std::vector<std::string>& groups() const { return groups_; }

  /// The chain with its links, its joints and the links of every joint in random order.
  [[nodiscard]] ListedChain listed(std::mt19937& engine) const {
    std::vector<int> place(names_.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), engine);
    ListedChain result;
    result.linkage.links.resize(names_.size());
    result.bodies.placed.assign(names_.size(), false);
    for (std::size_t link = 0; link < names_.size(); ++link) {
      const LinkIndex at(static_cast<std::size_t>(place[link]));
      result.linkage.links[at] = names_[link];
      result.bodies.placed[at] = static_cast<int>(link) < driven_count();
    }
    for (const LinkIndex link : result.linkage.links.keys()) {
      result.bodies.carrier.add(link);
    }
    result.linkage.ground = LinkIndex(static_cast<std::size_t>(place[0]));
    std::vector<ChainJoint> joints = joints_;
    std::shuffle(joints.begin(), joints.end(), engine);
    for (std::size_t index = 0; index < joints.size(); ++index) {
      const mechanism::JointIndex number(index);
      const std::string name = "J" + std::to_string(index);
      std::vector<LinkIndex> links;
      for (const int link : joints[index].links) {
        links.emplace_back(static_cast<std::size_t>(place[static_cast<std::size_t>(link)]));
      }
      std::shuffle(links.begin(), links.end(), engine);
      if (links.size() > 2) {
        const std::vector<mechanism::FeatureIndex> features(links.size());
        result.linkage.pins.push_back({name, number, links, features});
      } else {
        result.linkage.joints.add(
            {name, number, joints[index].prismatic, links[0], links[1], {}, {}});
        result.bodies.driven.add(joints[index].driven);
        result.bodies.read.add({});
      }
    }
    return result;
  }

 private:
  struct ChainJoint {
    bool prismatic;
    bool driven;
    std::vector<int> links;
  };

  static int below(int bound, std::mt19937& engine) {
    return static_cast<int>(engine() % static_cast<unsigned>(bound));
  }
  [[nodiscard]] int driven_count() const {
    return 1 + static_cast<int>(std::count_if(joints_.begin(), joints_.end(),
                                              [](const auto& joint) { return joint.driven; }));
  }
  int add_link() {
    names_.push_back("L" + std::to_string(names_.size()));
    return placed_count_++;
  }

  void add_group(const mechanism::GroupModels& group, std::mt19937& engine) {
    const int base_count = placed_count_;
    const std::size_t base_joints = joints_.size();
    std::vector<int> links;
    for (std::size_t link = 0; link < group.structure.link_count(); ++link) {
      links.push_back(add_link());
    }
    std::vector<bool> kind;
    for (const ModelJoint& joint : group.structure.joints) {
      const bool prismatic = below(3, engine) == 0;
      kind.push_back(prismatic);
      const int second = links[static_cast<std::size_t>(joint.second)];
      if (joint.first != base_link) {
        joints_.push_back(
            {prismatic, false, {links[static_cast<std::size_t>(joint.first)], second}});
        continue;
      }
      ChainJoint& other =
          joints_[static_cast<std::size_t>(below(static_cast<int>(base_joints), engine))];
      if (!prismatic && !other.prismatic && !other.driven) {
        other.links.push_back(second);
      } else {
        joints_.push_back({prismatic, false, {below(base_count, engine), second}});
      }
    }
    std::vector<std::string> names;
    for (const int link : links) {
      names.push_back(names_[static_cast<std::size_t>(link)]);
    }
    groups_.push_back(described(*group.serving(kind).model, names));
  }

  std::vector<std::string> names_;
  std::vector<ChainJoint> joints_;
  std::vector<std::string> groups_;
  int placed_count_ = 0;
};

}  // namespace assur::test
