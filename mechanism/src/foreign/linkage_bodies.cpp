#include "foreign/linkage_bodies.hpp"

#include <algorithm>
#include <assur/text/quoted.hpp>
#include <cmath>
#include <numeric>

namespace assur::mechanism::foreign {

namespace {

/// Finds the parts of a file that move as one body, and their slots.
class BodyBuilder {
 public:
  explicit BodyBuilder(const std::string& text)
      : mechanism_(result_.mechanism), file_(result_.file) {
    file_ = read_linkage(text, mechanism_);
    for (std::size_t place = 0; place < file_.connectors.size(); ++place) {
      result_.connector_of_id.emplace(file_.connectors[place].id, place);
    }
    check_links();
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      result_.link_of_id.emplace(file_.links[place].id, place);
    }
  }
  BodyBuilder(const BodyBuilder&) = delete;
  BodyBuilder& operator=(const BodyBuilder&) = delete;

  LinkageBodies build() {
    // The program stores places in this unit, whichever unit it shows.
    mechanism_.unit = "1/96 in";
    mechanism_.remark("lengths are those of the file, in 1/96 inch: the program shows " +
                      std::string(file_.unit == "in" ? "0.010417 in" : "0.264583 mm") +
                      " for each");
    add_points();
    join_bodies();
    add_links();
    list_fastened_connectors();
    add_slides();
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const std::size_t near = body_of(place);
      const std::size_t far = file_.links[place].is_actuator ? near + 1 : near;
      result_.links.push_back({link_at(near), link_at(far)});
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const LinkageConnector* connector(int id) const { return result_.connector(id); }
  [[nodiscard]] ForeignPointIndex point(int id) const { return result_.point(id); }
  /// Leaves out what the program itself ignores: missing connectors, and links whose only connector
  /// belongs to another link, too, unless they are gears.
  void check_links() {
    std::map<int, int> links_of_connector;
    for (LinkageLink& link : file_.links) {
      const std::string what = "Link " + std::to_string(link.id);
      std::erase_if(link.connectors, [&](int id) {
        if (connector(id) == nullptr) {
          mechanism_.miss(what + ": the file has no connector " + std::to_string(id));
        }
        return connector(id) == nullptr;
      });
      if (link.is_actuator && link.connectors.size() != 2) {
        mechanism_.miss(what + ": an actuator has two connectors; it is a rigid link in the scene");
        link.is_actuator = false;
      }
      for (const int id : link.connectors) {
        ++links_of_connector[id];
      }
    }
    std::erase_if(file_.links, [&](const LinkageLink& link) {
      const bool is_idle =
          link.connectors.empty() || (link.connectors.size() == 1 && !link.is_gear &&
                                      links_of_connector[link.connectors.front()] > 1);
      if (is_idle) {
        mechanism_.remark("Link " + std::to_string(link.id) + " is left out: it has no length");
      }
      return is_idle;
    });
  }

  void add_points() {
    for (const LinkageConnector& connector : file_.connectors) {
      mechanism_.points.add(
          {"C" + std::to_string(connector.id), connector.name, connector.x, connector.y});
    }
  }

  // Bodies: a body is the ground (0), a link (2 k + 1 for the link k), which for an actuator is the
  // side of its first connector, or an actuator's other side (2 k + 2). Joined ones have one root.

  static std::size_t body_of(std::size_t link) { return 2 * link + 1; }
  [[nodiscard]] std::size_t root(std::size_t body) const {
    while (roots_[body] != body) {
      body = roots_[body];
    }
    return body;
  }
  void join(std::size_t one, std::size_t other) {
    const std::size_t first = root(one);
    const std::size_t second = root(other);
    roots_[std::max(first, second)] = std::min(first, second);
  }

  /// The bodies, by their roots, that hold a connector as one of their own.
  [[nodiscard]] std::vector<std::size_t> holders(int id) const {
    std::vector<std::size_t> found;
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const LinkageLink& link = file_.links[place];
      const auto at = std::ranges::find(link.connectors, id);
      if (at != link.connectors.end()) {
        const bool is_far = link.is_actuator && at != link.connectors.begin();
        found.push_back(body_of(place) + (is_far ? 1 : 0));
      }
    }
    return found;
  }

  /// The body to which an element is fastened by a connector; the first if several hold it, with a
  /// remark.
  std::optional<std::size_t> body_at(int id, const std::string& what,
                                     std::optional<std::size_t> except = {}) {
    const LinkageConnector* const at = connector(id);
    if (at == nullptr) {
      mechanism_.miss(what + ": it is fastened to the connector " + std::to_string(id) +
                      ", which the file does not have");
      return std::nullopt;
    }
    if (at->is_anchor) {
      return 0;
    }
    std::vector<std::size_t> bodies = holders(id);
    std::erase_if(bodies, [&](std::size_t body) { return except && root(body) == root(*except); });
    if (bodies.empty() && at->link && result_.link_of_id.contains(*at->link)) {
      return body_of(result_.link_of_id.at(*at->link));
    }
    if (bodies.empty()) {
      mechanism_.miss(what + ": it is fastened to the connector " + std::to_string(id) +
                      ", which no link holds");
      return std::nullopt;
    }
    const std::size_t first = root(bodies.front());
    if (std::ranges::any_of(bodies, [&](std::size_t body) { return root(body) != first; })) {
      mechanism_.miss(what + ": it is fastened to the connector " + std::to_string(id) +
                      ", which several links hold; in the scene it belongs to the first of them");
    }
    return first;
  }

  void join_bodies() {
    roots_.resize(2 * file_.links.size() + 1);
    std::iota(roots_.begin(), roots_.end(), std::size_t{0});
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const LinkageLink& link = file_.links[place];
      const std::string what = "Link " + std::to_string(link.id);
      if (link.link) {
        if (const auto other = result_.link_of_id.find(*link.link);
            other != result_.link_of_id.end()) {
          join(body_of(place), body_of(other->second));
          tell_of_fastened_actuators(place, other->second);
        } else {
          mechanism_.miss(what + ": it is fastened to the link " + std::to_string(*link.link) +
                          ", which does not move or is not in the file");
        }
      }
      if (link.connector) {
        if (const auto body = body_at(*link.connector, what, body_of(place))) {
          join(body_of(place), *body);
        }
      }
    }
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const LinkageLink& link = file_.links[place];
      const auto anchors =
          std::ranges::count_if(link.connectors, [&](int id) { return connector(id)->is_anchor; });
      if (anchors > 1 && !link.is_actuator) {
        join(0, body_of(place));
      }
    }
  }

  void tell_of_fastened_actuators(std::size_t one, std::size_t other) {
    for (const std::size_t place : {one, other}) {
      if (file_.links[place].is_actuator) {
        mechanism_.remark("Link " + std::to_string(file_.links[place].id) +
                          ": what is fastened to the actuator moves with its first connector");
      }
    }
  }

  void add_links() {
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const LinkageLink& link = file_.links[place];
      const std::string id = "L" + std::to_string(link.id);
      const ForeignLinkIndex near = link_of_body(
          body_of(place), link.is_actuator ? id + "_tube" : id, link.is_actuator ? "" : link.name);
      const ForeignLinkIndex far =
          link.is_actuator ? link_of_body(body_of(place) + 1, id + "_rod", "") : near;
      for (std::size_t at = 0; at < link.connectors.size(); ++at) {
        mechanism_.list(at == 0 ? near : far, point(link.connectors[at]));
      }
    }
    for (const LinkageConnector& connector : file_.connectors) {
      if (connector.is_anchor && connector.moves) {
        mechanism_.list(mechanism_.ground(), point(connector.id));
      }
    }
  }

  /// The link of a body; a new one if its root has none yet.
  ForeignLinkIndex link_of_body(std::size_t body, const std::string& id, const std::string& name) {
    if (root(body) == 0) {
      return mechanism_.ground();
    }
    auto found = link_of_root_.find(root(body));
    if (found == link_of_root_.end()) {
      found = link_of_root_.emplace(root(body), mechanism_.links.add({id, name})).first;
    } else if (mechanism_.links[found->second].name.empty()) {
      mechanism_.links[found->second].name = name;
    }
    return found->second;
  }
  [[nodiscard]] ForeignLinkIndex link_at(std::size_t body) const {
    return root(body) == 0 ? mechanism_.ground() : link_of_root_.at(root(body));
  }

  void list_fastened_connectors() {
    for (const LinkageConnector& each : file_.connectors) {
      const std::string what = "connector " + std::to_string(each.id);
      if (each.link) {
        if (const auto link = result_.link_of_id.find(*each.link);
            link != result_.link_of_id.end()) {
          mechanism_.list(link_at(body_of(link->second)), point(each.id));
        } else if (each.moves) {
          mechanism_.miss(what + ": it is fastened to the link " + std::to_string(*each.link) +
                          ", which does not move or is not in the file");
        }
      } else if (each.connector && each.moves) {
        if (const auto body = body_at(*each.connector, what)) {
          mechanism_.list(link_at(*body), point(each.id));
        }
      }
    }
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      for (const int id : file_.links[place].fastened) {
        if (connector(id) != nullptr) {
          mechanism_.list(link_at(body_of(place)), point(id));
        }
      }
    }
  }

  void add_slides() {
    for (const LinkageConnector& slider : file_.connectors) {
      if (slider.slide_limits.empty() || !slider.moves) {
        continue;
      }
      const std::string what = "connector " + std::to_string(slider.id);
      const ForeignPointIndex pin = point(slider.id);
      const std::array<ForeignPointIndex, 2> ends = {point(slider.slide_limits[0]),
                                                     point(slider.slide_limits[1])};
      if (!ends[0].exists() || !ends[1].exists() || mechanism_.distance(ends[0], ends[1]) == 0) {
        mechanism_.miss(what + ": the slot in which it slides has no two ends");
        continue;
      }
      const ForeignLinkIndex slotted = link_that_lists(ends, pin);
      const ForeignLinkIndex pinned = slotted.exists() ? pinned_link(pin, slotted) : slotted;
      if (!slotted.exists()) {
        mechanism_.miss(what + ": no link has both ends of the slot in which it slides");
      } else if (!pinned.exists()) {
        mechanism_.miss(what + ": no link but that of the slot has it, so that it holds nothing");
      } else if (slider.slide_radius != 0) {
        add_arc(slider, ends, slotted);
      } else {
        add_slot(what, pin, ends, pinned, slotted);
      }
    }
  }

  /// A link that has both ends of a slot; the ground is the last choice.
  [[nodiscard]] ForeignLinkIndex link_that_lists(const std::array<ForeignPointIndex, 2>& ends,
                                                 ForeignPointIndex pin) const {
    ForeignLinkIndex found;
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      const bool is_better = !found.exists() || found == mechanism_.ground() ||
                             (mechanism_.lists(found, pin) && !mechanism_.lists(link, pin));
      if (mechanism_.lists(link, ends[0]) && mechanism_.lists(link, ends[1]) && is_better) {
        found = link;
      }
    }
    return found;
  }
  [[nodiscard]] ForeignLinkIndex pinned_link(ForeignPointIndex pin,
                                             ForeignLinkIndex slotted) const {
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      if (link != slotted && mechanism_.lists(link, pin)) {
        return link;
      }
    }
    return {};
  }

  void add_slot(const std::string& what, ForeignPointIndex pin,
                const std::array<ForeignPointIndex, 2>& ends, ForeignLinkIndex pinned,
                ForeignLinkIndex slotted) {
    const ForeignPoint& from = mechanism_.points[ends[0]];
    const ForeignPoint& to = mechanism_.points[ends[1]];
    const ForeignPoint& at = mechanism_.points[pin];
    const double length = mechanism_.distance(ends[0], ends[1]);
    const double place =
        ((at.x - from.x) * (to.x - from.x) + (at.y - from.y) * (to.y - from.y)) / length;
    ForeignJoint joint{JointType::pin_in_slot, pinned, slotted, pin};
    joint.along = ends;
    if (place >= 0 && place <= length) {
      joint.limits = {0, length};
    } else {
      mechanism_.remark(what + ": it is drawn beyond the ends of its slot, which are left out");
    }
    mechanism_.joints.add(joint);
  }

  /// A pin in a slot along an arc is replaced by a link from the centre of the arc.
  void add_arc(const LinkageConnector& slider, const std::array<ForeignPointIndex, 2>& ends,
               ForeignLinkIndex slotted) {
    const ForeignPoint from = mechanism_.points[ends[0]];
    const ForeignPoint to = mechanism_.points[ends[1]];
    const double half = mechanism_.distance(ends[0], ends[1]) / 2;
    const double radius = std::max(std::abs(slider.slide_radius), half);
    const double height =
        std::copysign(std::sqrt(radius * radius - half * half), slider.slide_radius);
    const std::string id = "C" + std::to_string(slider.id) + "_arc";
    // The centre is to the left of the chord from the first end to the second if the radius is
    // positive.
    const ForeignPointIndex center =
        mechanism_.points.add({id, "", (from.x + to.x) / 2 - height * (to.y - from.y) / (2 * half),
                               (from.y + to.y) / 2 + height * (to.x - from.x) / (2 * half)});
    if (mechanism_.distance(center, point(slider.id)) == 0) {
      mechanism_.miss("connector " + std::to_string(slider.id) +
                      ": it is drawn at the centre of its slot");
      return;
    }
    const ForeignLinkIndex arm = mechanism_.links.add({id + "_arm", ""});
    mechanism_.list(slotted, center);
    mechanism_.list(arm, center);
    mechanism_.list(arm, point(slider.id));
    mechanism_.remark("connector " + std::to_string(slider.id) +
                      ": its slot is an arc, for which the link " + id +
                      "_arm stands; the ends of the slot are left out");
  }

  LinkageBodies result_;
  ForeignMechanism& mechanism_;
  LinkageFile& file_;
  std::vector<std::size_t> roots_;
  std::map<std::size_t, ForeignLinkIndex> link_of_root_;
};

}  // namespace

const LinkageConnector* LinkageBodies::connector(int id) const {
  const auto found = connector_of_id.find(id);
  return found == connector_of_id.end() ? nullptr : &file.connectors[found->second];
}

ForeignPointIndex LinkageBodies::point(int id) const {
  const auto found = connector_of_id.find(id);
  return found == connector_of_id.end() ? ForeignPointIndex() : ForeignPointIndex(found->second);
}

LinkageBodies linkage_bodies(const std::string& text) { return BodyBuilder(text).build(); }

}  // namespace assur::mechanism::foreign
