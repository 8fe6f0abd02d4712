// Part of a mechanism on which its reported parts depend.
#include <algorithm>

#include "driver_laws.hpp"
#include "mechanism_parts.hpp"

namespace assur::mechanism::plan {

namespace {

class PartFinder {
 public:
  PartFinder(const Mechanism& mechanism, const Structure& structure, const Request& request)
      : mechanism_(mechanism),
        structure_(structure),
        needed_(structure.linkage.links.size(), false) {
    const Reported& reported = request.reported;
    const Want& want = request.want;
    needed_[mechanism.ground()] = true;
    for (const Output& output : mechanism.outputs()) {
      needed_[mechanism.features()[output.point].link] = true;
    }
    for (const LinkIndex link : mechanism.links().keys()) {
      needed_[link] = needed_[link] || reported.has(link);
    }
    for (const ReferenceAngle& angle : request.reference) {
      needed_[angle.link] = needed_[angle.link] || !request.drawn;
    }
    for (const Joint& joint : mechanism.joints()) {
      if (joint.lowest.exists()) {  // its limits may exclude configurations of reported parts
        for (const FeatureIndex feature : joint.between) {
          needed_[mechanism.features()[feature].link] = true;
        }
      }
    }
    for (const ElementaryJoint& joint : structure.linkage.joints) {
      if ((joint.prismatic || want.forces || want.coefficients) && reported.has(joint.joint)) {
        needed_[joint.first] = true;
        needed_[joint.second] = true;
      }
    }
    if (want.loaded()) {
      need_loaded();
    }
    for (const JointIndex pin : structure.linkage.second_pins) {
      for (const FeatureIndex feature : mechanism.joints()[pin].between) {
        needed_[mechanism.features()[feature].link] =
            needed_[mechanism.features()[feature].link] || reported.has(pin);
      }
    }
  }

  /// The necessary links. Links that hold another one are placed before it, so that one pass
  /// backwards finds them all.
  [[nodiscard]] Table<LinkIndex, bool> run() {
    for (std::size_t place = structure_.groups.size(); place-- > 0;) {
      need_carriers();
      need_with_bases(structure_.groups[GroupIndex(place)]);
    }
    need_carriers();
    Table<LinkIndex, bool> kept;
    for (const LinkIndex link : mechanism_.links().keys()) {
      kept.add(needed_[link]);
    }
    return kept;
  }

 private:
  /// Adds the links that bear masses, loads or springs, and those that the loads read.
  void need_loaded() {
    const auto need_joint = [this](JointIndex joint) {
      for (const FeatureIndex feature : mechanism_.joints()[joint].between) {
        needed_[mechanism_.features()[feature].link] = true;
      }
    };
    for (const Mass& mass : mechanism_.loading().masses) {
      needed_[mass.at.link] = true;
    }
    for (const Load& load : mechanism_.loading().loads) {
      needed_[load.at.link] = true;
      if (load.frame.exists()) {
        needed_[load.frame] = true;
      }
      for (const NumberIndex number : {load.force_x, load.force_y, load.moment}) {
        if (number.exists()) {
          std::ranges::for_each(mechanism_.numbers()[number].formula.joints(), need_joint);
        }
      }
    }
    for (const Spring& spring : mechanism_.loading().springs) {
      for (const FeatureIndex end : spring.between) {
        needed_[mechanism_.features()[end].link] = true;
      }
    }
  }

  /// Adds the links that move necessary ones: those that carry them, and those that the laws of
  /// drivers read.
  void need_carriers() {
    // NOLINTNEXTLINE(modernize-loop-convert): clang 14 cannot read the reversed views of libstdc++
    for (auto link = structure_.carried.rbegin(); link != structure_.carried.rend(); ++link) {
      if (!needed_[link->to]) {
        continue;
      }
      needed_[link->from] = true;
      if (!link->driver.exists()) {
        continue;
      }
      for (const JointIndex joint : joints_in_laws(mechanism_, link->driver)) {
        for (const FeatureIndex feature : mechanism_.joints()[joint].between) {
          needed_[mechanism_.features()[feature].link] = true;
        }
      }
    }
  }

  void need_with_bases(const FoundGroup& group) {
    if (std::none_of(group.links.begin(), group.links.end(),
                     [this](LinkIndex link) { return needed_[link]; })) {
      return;
    }
    for (const ElementaryJointIndex joint : group.assignments.front().joints) {
      const ElementaryJoint& at = structure_.linkage.joints[joint];
      for (const LinkIndex link : {at.first, at.second, at.holder_first, at.holder_second}) {
        needed_[link] = true;
      }
    }
  }

  const Mechanism& mechanism_;
  const Structure& structure_;
  Table<LinkIndex, bool> needed_;
};

/// The keys of the items with the same names in another mechanism.
template <typename Key, typename Item>
std::optional<std::vector<Key>> translated(const std::optional<std::vector<Key>>& keys,
                                           const Table<Key, Item>& from,
                                           const Table<Key, Item>& to) {
  if (!keys) {
    return std::nullopt;
  }
  std::vector<Key> result;
  for (const Key key : *keys) {
    result.push_back(index_of(to, from[key].name));
  }
  return result;
}

}  // namespace

ReportedPart reported_part(const Mechanism& mechanism, const Structure& structure,
                           const Request& request) {
  Mechanism part = mechanism.only(PartFinder(mechanism, structure, request).run());
  Request asked = request;
  asked.reported = {translated(request.reported.links, mechanism.links(), part.links()),
                    translated(request.reported.joints, mechanism.joints(), part.joints())};
  for (ReferenceAngle& angle : asked.reference) {
    angle.link = index_of(part.links(), mechanism.links()[angle.link].name);
  }
  std::erase_if(asked.reference, [](const ReferenceAngle& angle) { return !angle.link.exists(); });
  return {std::move(part), std::move(asked)};
}

}  // namespace assur::mechanism::plan
