#include <algorithm>
#include <assur/mechanism/structure.hpp>

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

Table<LinkIndex, bool> Structure::carried_by_ground() const {
  Table<LinkIndex, bool> stands(linkage.links.size(), false);
  stands[linkage.ground] = true;
  for (const CarriedLink& link : carried) {
    stands[link.to] = stands[link.from];
  }
  return stands;
}

std::vector<std::size_t> Structure::carried_by_base(GroupIndex group) const {
  Table<LinkIndex, bool> stands(linkage.links.size(), false);
  std::vector<std::size_t> result;
  if (const LinkIndex base = groups[group].base; base.exists()) {
    stands[base] = true;
    for (std::size_t place = 0; place < carried.size(); ++place) {
      const CarriedLink& link = carried[place];
      const bool is_known = !link.group.exists() || link.group < group;
      stands[link.to] = stands[link.to] || (stands[link.from] && is_known);
      if (stands[link.from] && is_known) {
        result.push_back(place);
      }
    }
  }
  return result;
}

bool Structure::has_relative_groups() const {
  return std::ranges::any_of(groups, [](const FoundGroup& group) { return group.base.exists(); });
}

bool Structure::moves_by_laws(const Mechanism& mechanism) const {
  return std::ranges::any_of(carried, [&](const CarriedLink& link) {
    return link.groups_before > 0 ||
           !mechanism.numbers()[mechanism.drivers()[link.driver].position].formula.joints().empty();
  });
}

const CarriedLink* Structure::carried_link(LinkIndex link) const {
  const auto found =
      std::ranges::find_if(carried, [link](const CarriedLink& one) { return one.to == link; });
  return found == carried.end() ? nullptr : &*found;
}

NamedParts Structure::named_parts(const Mechanism& mechanism) const {
  const auto link_name = [&](FeatureIndex feature) -> const std::string& {
    return mechanism.links()[mechanism.features()[feature].link].name;
  };
  NamedParts parts;
  const Table<LinkIndex, bool> stands = carried_by_ground();
  for (const LinkIndex link : mechanism.links().keys()) {
    if (!stands[link]) {
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

}  // namespace assur::mechanism
