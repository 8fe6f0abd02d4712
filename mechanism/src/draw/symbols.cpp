#include "draw/symbols.hpp"

#include <algorithm>

#include "draw/convex_hull.hpp"

namespace assur::mechanism::draw {

namespace {

/// The shortest cylinder with room for its tube.
constexpr double shortest_cylinder = 0.03;
constexpr double same_place = 1e-9;

class SymbolMaker {
 public:
  explicit SymbolMaker(const Appearance& appearance)
      : seen_(appearance),
        mechanism_(appearance.mechanism),
        point_of_(mechanism_.features().size()),
        corners_(mechanism_.links().size()) {}

  Symbols made() {
    for (const Joint& joint : mechanism_.joints()) {
      if (joint.type == JointType::revolute) {
        add_pin(joint);
      }
    }
    for (const FeatureIndex feature : mechanism_.features().keys()) {
      const Feature& at = mechanism_.features()[feature];
      if (!at.is_line && is_drawn(at.link)) {
        corners_[at.link].push_back(point(feature));
      }
    }
    for (const JointIndex joint : mechanism_.joints().keys()) {
      const Joint& at = mechanism_.joints()[joint];
      if (at.type != JointType::revolute && is_drawn(link(at.between[0])) &&
          is_drawn(link(at.between[1]))) {
        at.type == JointType::prismatic ? add_slide(joint) : add_slot(joint);
      }
    }
    add_links();
    for (const Output& output : mechanism_.outputs()) {
      add({Symbol::tracer,
           link_name(output.point),
           output.name,
           is_ground(link(output.point)),
           {point(output.point)}});
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] LinkIndex link(FeatureIndex feature) const {
    return mechanism_.features()[feature].link;
  }
  [[nodiscard]] const std::string& link_name(FeatureIndex feature) const {
    return mechanism_.links()[link(feature)].name;
  }
  [[nodiscard]] bool is_drawn(LinkIndex link) const { return seen_.poses[link].has_value(); }
  [[nodiscard]] bool is_ground(LinkIndex link) const { return link == mechanism_.ground(); }

  void add(Shape shape) { result_.shapes.push_back(std::move(shape)); }
  std::size_t add(const Anchor& anchor) {
    result_.points.push_back(anchor);
    return result_.points.size() - 1;
  }
  /// The point of a feature: that of its pin, if it has one.
  std::size_t point(FeatureIndex feature) {
    std::optional<std::size_t>& place = point_of_[feature];
    if (!place) {
      place = add(Anchor{feature});
    }
    return *place;
  }
  [[nodiscard]] Eigen::Vector2d place(std::size_t point) const {
    return position(result_.points[point], mechanism_, seen_.frames, seen_.poses, seen_.reaches,
                    seen_.size);
  }

  void add_pin(const Joint& joint) {
    std::optional<std::size_t> shared;
    std::size_t links = 0;
    bool fixed = false;
    for (const FeatureIndex feature : joint.between) {
      if (is_drawn(link(feature))) {
        shared = shared ? shared : point(feature);
        point_of_[feature] = shared;
        fixed = fixed || is_ground(link(feature));
        ++links;
      }
    }
    if (links > 1) {
      add({Symbol::pin, "", joint.name, fixed, {*shared}});
    }
  }

  /// Adds a pin in a slot of a link, or of the ground.
  void add_slot(JointIndex joint) {
    const Joint& at = mechanism_.joints()[joint];
    const bool line_first = mechanism_.features()[at.between[0]].is_line;
    const FeatureIndex line = at.between[line_first ? 0 : 1];
    const FeatureIndex pin = at.between[line_first ? 1 : 0];
    add_line(Symbol::slot, joint, line, 1);
    add({Symbol::pin, "", at.name, is_ground(link(pin)), {point(pin)}});
  }

  /// Adds a slide: a cylinder, or else a block on a line, which belongs to the ground or to the
  /// link that extends farther from it.
  void add_slide(JointIndex joint) {
    const Joint& at = mechanism_.joints()[joint];
    const FeatureIndex first = at.between[0];
    const FeatureIndex second = at.between[1];
    if (is_cylinder(joint)) {
      const std::size_t eye = corner(first);
      const std::size_t mouth = add(Anchor{first, Offset::mouth, joint});
      add({Symbol::rod, link_name(second), at.name, false, {mouth, corner(second)}});
      add({Symbol::tube, link_name(first), at.name, false, {eye, mouth}});
      return;
    }
    const bool second_is_rail =
        is_ground(link(second)) || (!is_ground(link(first)) && extent(second) > extent(first));
    const FeatureIndex rail = second_is_rail ? second : first;
    const FeatureIndex block = second_is_rail ? first : second;
    add_line(Symbol::guide, joint, rail, second_is_rail ? -1 : 1);
    const std::size_t ahead = add(Anchor{block, Offset::ahead});
    add({Symbol::block, link_name(block), at.name, false, {corner(block), ahead}});
  }

  /// Adds the line along which a part slides, from end to end; a link extends to both.
  void add_line(Symbol symbol, JointIndex joint, FeatureIndex line, double sense) {
    const std::vector<std::size_t> ends = {add(Anchor{line, Offset::first_end, joint, sense}),
                                           add(Anchor{line, Offset::second_end, joint, sense})};
    corners_[link(line)].insert(corners_[link(line)].end(), ends.begin(), ends.end());
    add({symbol, link_name(line), mechanism_.joints()[joint].name, is_ground(link(line)), ends});
  }

  /// The `through` of a line as a corner of its link.
  std::size_t corner(FeatureIndex line) {
    const std::size_t at = point(line);
    corners_[link(line)].push_back(at);
    return at;
  }

  /// The largest distance of a link's points from the `through` of one of its lines.
  [[nodiscard]] double extent(FeatureIndex line) const {
    double farthest = 0;
    const Pose<double>& from = seen_.frames[line];
    for (const FeatureIndex feature : mechanism_.links()[link(line)].features) {
      const Pose<double>& to = seen_.frames[feature];
      if (!mechanism_.features()[feature].is_line) {
        farthest = std::max(farthest, std::hypot(to.x - from.x, to.y - from.y));
      }
    }
    return farthest;
  }

  /// Whether a slide between two moving links is drawn as a cylinder: a driver moves it, or it has
  /// an eye at either end and nothing else; and its length is never too short.
  [[nodiscard]] bool is_cylinder(JointIndex joint) const {
    const Joint& at = mechanism_.joints()[joint];
    const std::optional<Reach>& reach = seen_.reaches[joint];
    if (is_ground(link(at.between[0])) || is_ground(link(at.between[1])) || !reach) {
      return false;
    }
    const double shortest = std::max(reach->lowest, -reach->highest);
    const bool eyes_alone = extent(at.between[0]) <= same_place * seen_.size &&
                            extent(at.between[1]) <= same_place * seen_.size;
    return shortest > shortest_cylinder * seen_.size &&
           (mechanism_.driver_of(joint).exists() || eyes_alone);
  }

  /// Adds the links, after the joints have added the points to which the links extend.
  void add_links() {
    for (const LinkIndex link : mechanism_.links().keys()) {
      if (is_ground(link) || !is_drawn(link)) {
        continue;
      }
      std::vector<Eigen::Vector2d> places;
      for (const std::size_t corner : corners_[link]) {
        places.push_back(place(corner));
      }
      std::vector<std::size_t> outline;
      for (const std::size_t at : convex_hull(places, same_place * seen_.size)) {
        outline.push_back(corners_[link][at]);
      }
      if (outline.size() > 1) {
        add({outline.size() == 2 ? Symbol::bar : Symbol::plate, mechanism_.links()[link].name, "",
             false, outline});
      }
    }
  }

  const Appearance& seen_;
  const Mechanism& mechanism_;
  Symbols result_;
  Table<FeatureIndex, std::optional<std::size_t>> point_of_;
  Table<LinkIndex, std::vector<std::size_t>> corners_;
};

}  // namespace

Symbols symbols_of(const Appearance& appearance) { return SymbolMaker(appearance).made(); }

}  // namespace assur::mechanism::draw
