// Linkage of elementary joints of a mechanism, and properties of its structure.
#include <algorithm>
#include <assur/mechanism/structure.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace assur::mechanism::plan {

namespace {

/// A pin in a slot, and its block.
struct PinInSlot {
  JointIndex joint;
  FeatureIndex line, pin;
  LinkIndex block;
  ElementaryJointIndex slide;
};

/// Whether two features of one link have the same formulas, so that they coincide for all
/// parameters.
bool are_written_alike(const Mechanism& mechanism, FeatureIndex one, FeatureIndex other) {
  const Feature& first = mechanism.features()[one];
  const Feature& second = mechanism.features()[other];
  const auto are_alike = [&](NumberIndex number, NumberIndex same) {
    return mechanism.numbers()[number].formula == mechanism.numbers()[same].formula;
  };
  return one == other || (first.link == second.link && are_alike(first.x, second.x) &&
                          are_alike(first.y, second.y) &&
                          (!first.is_line || (are_alike(first.along_x, second.along_x) &&
                                              are_alike(first.along_y, second.along_y))));
}

/// A line on its link.
struct LineNumbers {
  double x, y, along_x, along_y;
};

/// Nothing if the line depends on parameters.
std::optional<LineNumbers> constants_of(const Mechanism& mechanism, FeatureIndex line) {
  const Feature& at = mechanism.features()[line];
  const auto constant = [&](NumberIndex number) {
    return mechanism.numbers()[number].formula.constant();
  };
  const auto x = constant(at.x);
  const auto y = constant(at.y);
  const auto along_x = constant(at.along_x);
  const auto along_y = constant(at.along_y);
  if (!x || !y || !along_x || !along_y) {
    return std::nullopt;
  }
  return LineNumbers{*x, *y, *along_x, *along_y};
}

/// Whether two lines of one link are the same up to the rounding of their numbers, in either sense.
bool are_one_line(const Mechanism& mechanism, FeatureIndex one, FeatureIndex other) {
  if (mechanism.features()[one].link != mechanism.features()[other].link) {
    return false;
  }
  const auto first = constants_of(mechanism, one);
  const auto second = constants_of(mechanism, other);
  if (!first || !second) {
    return are_written_alike(mechanism, one, other);
  }
  // Whether (x, y), rounded like numbers of this size, is along the first line.
  const auto is_along = [&](double x, double y, double size_x, double size_y) {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    return std::abs(first->along_x * y - first->along_y * x) <=
           rounding * (std::abs(first->along_x) * size_y + std::abs(first->along_y) * size_x);
  };
  return is_along(second->along_x, second->along_y, std::abs(second->along_x),
                  std::abs(second->along_y)) &&
         is_along(second->x - first->x, second->y - first->y,
                  std::abs(first->x) + std::abs(second->x),
                  std::abs(first->y) + std::abs(second->y));
}

/// Makes the block of every second pin of a link in a slot slide along the first one's block. The
/// first pin is one that a driver moves, and then the one whose joint's name comes first.
void pair_pins(const Mechanism& mechanism, std::vector<PinInSlot> slots, Linkage& linkage) {
  const auto is_driven = [&](const PinInSlot& slot) {
    return mechanism.driver_of(slot.joint).exists();
  };
  std::ranges::sort(slots, {}, [&](const PinInSlot& slot) {
    return std::make_pair(!is_driven(slot), mechanism.joints()[slot.joint].name);
  });
  for (auto second = slots.begin(); second != slots.end(); ++second) {
    const auto leads = [&](const PinInSlot& first) {
      return mechanism.features()[first.pin].link == mechanism.features()[second->pin].link &&
             are_one_line(mechanism, first.line, second->line) &&
             !are_written_alike(mechanism, first.pin, second->pin);
    };
    const auto first = std::find_if(slots.begin(), second, leads);
    if (first != second && !is_driven(*second)) {
      const std::string& name = mechanism.joints()[second->joint].name;
      linkage.joints[second->slide] = {name,          JointIndex(),   true,          first->block,
                                       second->block, FeatureIndex(), FeatureIndex()};
      linkage.second_pins.push_back(second->joint);
    }
  }
}

}  // namespace

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

Linkage linkage_of(const Mechanism& mechanism) {
  Linkage linkage;
  std::vector<plan::PinInSlot> slots;
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
      slots.push_back({index, line, pin, block,
                       linkage.joints.add(
                           {joint.name, index, true, link_of(line), block, line, FeatureIndex()})});
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
  plan::pair_pins(mechanism, std::move(slots), linkage);
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

Table<LinkIndex, std::size_t> Structure::groups_before() const {
  Table<LinkIndex, std::size_t> before(linkage.links.size(), 0);
  for (const GroupIndex group : groups.keys()) {
    for (const LinkIndex link : groups[group].links) {
      before[link] = group.place() + 1;
    }
  }
  for (const CarriedLink& link : carried) {
    before[link.to] = link.groups_before;
  }
  return before;
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
