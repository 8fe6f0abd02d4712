#include "drawn/implied_pins.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <set>
#include <tuple>
#include <unordered_map>

namespace assur::mechanism::drawn {

namespace {

/// Links in the order of their names, with the ground first.
struct ByRank {
  const DrawnParts* parts;
  bool operator()(DrawnLinkIndex one, DrawnLinkIndex other) const {
    const auto rank = [this](DrawnLinkIndex link) {
      const std::string& name = parts->links[link].name;
      return std::tuple<bool, const std::string&>(name != "ground", name);
    };
    return rank(one) < rank(other);
  }
};
using LinkSet = std::set<DrawnLinkIndex, ByRank>;

/// The explicit joints at one point.
struct JointsAtPoint {
  std::vector<std::string> slotted;                   ///< links with a slot there
  std::vector<std::vector<std::string>> joined = {};  ///< links that one revolute joint joins
};

/// The links that explicit revolute joints join at each point, and those with slots there, by name.
std::unordered_map<std::string, JointsAtPoint> joints_at_points(
    const std::vector<DrawnJoint>& joints) {
  std::unordered_map<std::string, JointsAtPoint> result;
  for (const DrawnJoint& joint : joints) {
    if (joint.between.empty()) {
      JointsAtPoint& here = result[joint.at.empty() ? joint.name : joint.at];
      if (joint.type == JointType::revolute) {
        here.joined.push_back(joint.links);
      } else if (joint.type == JointType::pin_in_slot) {
        here.slotted.push_back(joint.links[1]);
      }
    } else if (joint.type == JointType::revolute) {
      std::unordered_map<std::string, std::vector<std::string>> links_of_point;
      for (const std::string& feature : joint.between) {
        const std::size_t dot = feature.find('.');
        if (dot != std::string::npos) {
          links_of_point[feature.substr(dot + 1)].push_back(feature.substr(0, dot));
        }
      }
      for (const auto& [point, links] : links_of_point) {
        result[point].joined.push_back(links);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<ImpliedPin> implied_pins(const DrawnParts& parts,
                                     const std::vector<DrawnJoint>& joints) {
  const auto explicit_joints = joints_at_points(joints);
  Table<DrawnPointIndex, std::vector<DrawnLinkIndex>> listing(parts.points.size());
  for (const DrawnLinkIndex link : parts.links.keys()) {
    for (const DrawnPointIndex point : parts.links[link].points) {
      listing[point].push_back(link);
    }
  }
  std::vector<ImpliedPin> pins;
  for (const DrawnPointIndex point : parts.points.keys()) {
    const std::string& name = parts.points[point].name;
    const auto found = explicit_joints.find(name);
    const JointsAtPoint here = found == explicit_joints.end() ? JointsAtPoint() : found->second;
    const auto is_among = [&](const std::vector<std::string>& names, DrawnLinkIndex link) {
      return std::ranges::find(names, parts.links[link].name) != names.end();
    };
    std::vector<LinkSet> sets;
    LinkSet all(ByRank{&parts});
    for (const DrawnLinkIndex link : listing[point]) {
      if (!is_among(here.slotted, link)) {
        sets.push_back(LinkSet({link}, ByRank{&parts}));
        all.insert(link);
      }
    }
    for (const std::vector<std::string>& names : here.joined) {
      LinkSet joined(ByRank{&parts});
      std::erase_if(sets, [&](const LinkSet& set) {
        const bool meets =
            std::ranges::any_of(set, [&](DrawnLinkIndex link) { return is_among(names, link); });
        if (meets) {
          joined.insert(set.begin(), set.end());
        }
        return meets;
      });
      if (!joined.empty()) {
        sets.push_back(std::move(joined));
      }
    }
    if (sets.size() < 2) {
      continue;
    }
    if (std::ranges::find(joints, name, &DrawnJoint::name) != joints.end()) {
      const std::string links =
          text::joined(all, ", ", [&](DrawnLinkIndex link) { return parts.links[link].name; });
      throw MechanismError("joints." + name,
                           "the links " + links + " are pinned at the point " + name +
                               ", and this joint, which has its name, does not join them all; "
                               "name the joint otherwise, or name all links");
    }
    LinkSet joined(ByRank{&parts});
    for (const LinkSet& set : sets) {
      joined.insert(*set.begin());
    }
    pins.push_back({point, {joined.begin(), joined.end()}});
  }
  return pins;
}

}  // namespace assur::mechanism::drawn
