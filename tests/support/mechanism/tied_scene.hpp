// A random group on a lattice whose slides couple the angles of its links, as a scene, with its
// closure and mobility in exact arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fraction.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::tied {

struct Vector {
  Fraction x, y;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
};
inline Fraction dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
inline Fraction cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

constexpr int ground = 0;

/// Both features of a joint in the links' initial poses; they need not meet there. The direction is
/// that of a slide.
struct TiedJoint {
  std::string name;
  int first, second;
  bool slides;
  Vector along, on_first, on_second;
};

/// A group: its links are counted from one. A link with two pins, or the ground with
/// two, is a bar between links that do not turn against each other.
struct Group {
  int links = 0;
  std::vector<TiedJoint> joints;
};

/// The joints of a dyad, triad or tetrad and the letters of its kind, in the order of the letters.
inline Group group_of(const std::string& kind) {
  struct Ends {
    const char* name;
    int first, second;
  };
  const std::vector<Ends> dyad = {{"B", 0, 1}, {"C", 1, 2}, {"D", 2, 0}};
  const std::vector<Ends> triad = {{"B", 0, 1}, {"C", 1, 2}, {"D", 0, 3},
                                   {"E", 3, 2}, {"F", 0, 4}, {"G", 4, 2}};
  const std::vector<Ends> tetrad = {{"B", 0, 1}, {"C", 1, 2}, {"G", 1, 3},
                                    {"E", 0, 4}, {"D", 4, 2}, {"F", 4, 3}};
  const std::vector<Ends>& ends = kind.size() == 3 ? dyad : kind.size() == 7 ? tetrad : triad;
  Group group{kind.size() == 3 ? 2 : 4, {}};
  for (const char letter : kind) {
    if (letter != '-') {
      const Ends& at = ends[group.joints.size()];
      group.joints.push_back({at.name, at.first, at.second, letter == 'P', {}, {}, {}});
    }
  }
  return group;
}

/// The exact answer for a group.
struct Truth {
  bool closes = false;
  int mobility = 0;
};

/// No link turns except one bar, so that every other link moves by a vector: a slide holds it
/// across the slide's line, a pin in both directions. The bar keeps the distance of its pins.
class ExactSolution {
 public:
  explicit ExactSolution(const Group& group) : group_(group), bar_(bar_of(group)) {
    fixed_ = bar_ == ground ? 1 : ground;
    for (const TiedJoint& joint : group.joints) {
      const Vector apart = joint.on_first - joint.on_second;
      if (joint.first == bar_ || joint.second == bar_) {
        continue;
      }
      if (joint.slides) {
        add_row(joint, {Fraction(0) - joint.along.y, joint.along.x}, apart);
      } else {
        add_row(joint, {1, 0}, apart);
        add_row(joint, {0, 1}, apart);
      }
    }
    eliminate();
  }

  [[nodiscard]] Truth truth() const {
    for (std::size_t row = pivots_.size(); row < rows_.size(); ++row) {
      if (!(rows_[row].back() == Fraction(0))) {
        return {};
      }
    }
    const int moving = group_.links - (bar_ == none ? 0 : 1);
    const int free = 2 * moving - static_cast<int>(pivots_.size());
    return bar_ == none ? Truth{true, free} : with_bar(free);
  }

 private:
  static constexpr int none = -1;

  static int bar_of(const Group& group) {
    for (int link = 0; link <= group.links; ++link) {
      int pins = 0;
      int joints = 0;
      for (const TiedJoint& joint : group.joints) {
        if (joint.first == link || joint.second == link) {
          ++joints;
          pins += joint.slides ? 0 : 1;
        }
      }
      if (joints == 2 && pins == 2) {
        return link;
      }
    }
    return none;
  }

  [[nodiscard]] std::size_t columns() const {
    return 2 * static_cast<std::size_t>(group_.links + 1);
  }

  /// Adds the equation for the displacement of the second link relative to the first along a
  /// direction.
  void add_row(const TiedJoint& joint, const Vector& direction, const Vector& apart) {
    std::vector<Fraction> row(columns() + 1, Fraction(0));
    const auto add = [&](int link, const Fraction& sign) {
      if (link != fixed_) {
        const auto place = 2 * static_cast<std::size_t>(link);
        row[place] = row[place] + sign * direction.x;
        row[place + 1] = row[place + 1] + sign * direction.y;
      }
    };
    add(joint.second, 1);
    add(joint.first, -1);
    row.back() = dot(direction, apart);
    rows_.push_back(row);
  }

  void eliminate() {
    for (std::size_t column = 0; column < columns(); ++column) {
      const std::size_t next = pivots_.size();
      std::size_t found = next;
      while (found < rows_.size() && rows_[found][column] == Fraction(0)) {
        ++found;
      }
      if (found >= rows_.size()) {
        continue;
      }
      std::swap(rows_[next], rows_[found]);
      const Fraction pivot = rows_[next][column];
      for (Fraction& entry : rows_[next]) {
        entry = entry / pivot;
      }
      for (std::size_t row = 0; row < rows_.size(); ++row) {
        const Fraction factor = rows_[row][column];
        for (std::size_t place = 0; row != next && place <= columns(); ++place) {
          rows_[row][place] = rows_[row][place] - factor * rows_[next][place];
        }
      }
      pivots_.push_back(column);
    }
  }

  /// How a link moves per unit of a free column, or, for no column, where all of these are zero.
  [[nodiscard]] Vector moved(int link, std::size_t free_column) const {
    const auto entry = [&](std::size_t column) {
      const auto pivot = std::ranges::find(pivots_, column);
      if (pivot == pivots_.end()) {
        return Fraction(column == free_column ? 1 : 0);
      }
      const auto& row = rows_[static_cast<std::size_t>(pivot - pivots_.begin())];
      return free_column < columns() ? Fraction(0) - row[free_column] : row.back();
    };
    const auto place = 2 * static_cast<std::size_t>(link);
    return link == fixed_ ? Vector{0, 0} : Vector{entry(place), entry(place + 1)};
  }

  [[nodiscard]] Truth with_bar(int free) const {
    std::array<const TiedJoint*, 2> pins{};
    std::size_t count = 0;
    for (const TiedJoint& joint : group_.joints) {
      if (joint.first == bar_ || joint.second == bar_) {
        pins.at(count++) = &joint;
      }
    }
    const auto holder = [&](const TiedJoint& pin) {
      return pin.first == bar_ ? pin.second : pin.first;
    };
    const auto on = [&](const TiedJoint& pin, bool bar) {
      return (pin.first == bar_) == bar ? pin.on_first : pin.on_second;
    };
    const Vector length = on(*pins[1], true) - on(*pins[0], true);
    const Fraction square = dot(length, length);
    const Vector start = on(*pins[1], false) - on(*pins[0], false) +
                         moved(holder(*pins[1]), columns()) - moved(holder(*pins[0]), columns());
    // The directions of relative motion of the pins: none, one line, or the plane.
    std::vector<Vector> ways;
    for (std::size_t column = 0; column < columns(); ++column) {
      const Vector way = moved(holder(*pins[1]), column) - moved(holder(*pins[0]), column);
      const bool moves = !(dot(way, way) == Fraction(0));
      const bool is_new =
          ways.empty() || (ways.size() == 1 && !(cross(ways[0], way) == Fraction(0)));
      if (std::ranges::find(pivots_, column) == pivots_.end() && moves && is_new) {
        ways.push_back(way);
      }
    }
    const auto planes = static_cast<int>(ways.size());
    bool reaches = planes == 2;
    if (planes == 1) {
      const Fraction across = cross(start, ways[0]);
      reaches = !(square * dot(ways[0], ways[0]) < across * across);
    } else if (planes == 0) {
      reaches = dot(start, start) == square;
    }
    const int of_bar = square == Fraction(0) ? 1 : std::max(planes - 1, 0);
    return reaches ? Truth{true, free - planes + of_bar} : Truth{};
  }

  const Group& group_;
  int bar_;
  int fixed_ = ground;
  std::vector<std::vector<Fraction>> rows_;
  std::vector<std::size_t> pivots_;
};

/// The group as a scene, its links in frames of their own and in any order.
class SceneOfGroup {
 public:
  SceneOfGroup(const Group& group, double unit, std::mt19937& random)
      : group_(group), unit_(unit), random_(random) {}

  [[nodiscard]] Json scene() {
    std::vector<Json> features(static_cast<std::size_t>(group_.links) + 1, Json::object());
    std::vector<Vector> turns;
    std::vector<Vector> origins;
    for (int link = 0; link <= group_.links; ++link) {
      turns.push_back(any_turn());
      origins.push_back({any(3), any(3)});
    }
    std::vector<std::pair<std::string, Json>> joints;
    for (const TiedJoint& joint : group_.joints) {
      std::array<std::string, 2> between;
      for (const bool second : {false, true}) {
        const int link = second ? joint.second : joint.first;
        const auto place = static_cast<std::size_t>(link);
        const Vector at =
            seen(turns[place], (second ? joint.on_second : joint.on_first) - origins[place]);
        const Vector along = seen(turns[place], joint.along);
        const Json point = {unit_ * at.x.value(), unit_ * at.y.value()};
        features[place][joint.name] =
            joint.slides ? Json{{"through", point}, {"along", {along.x.value(), along.y.value()}}}
                         : point;
        between.at(second ? 1 : 0) = name_of(link) + "." + joint.name;
      }
      if (random_() % 2 == 0) {
        std::swap(between[0], between[1]);
      }
      joints.emplace_back(joint.name, Json{{"type", joint.slides ? "prismatic" : "revolute"},
                                           {"between", between}});
    }
    std::vector<std::pair<std::string, Json>> links;
    for (int link = 0; link <= group_.links; ++link) {
      links.emplace_back(name_of(link), features[static_cast<std::size_t>(link)]);
    }
    return {{"links", listed(links)}, {"joints", listed(joints)}};
  }

 private:
  static std::string name_of(int link) {
    return link == ground ? "ground" : "L" + std::to_string(link);
  }
  [[nodiscard]] long long any(int most) {
    return static_cast<long long>(random_() % static_cast<unsigned>(2 * most + 1)) - most;
  }
  /// A random turn by right angles, or by the angles of a Pythagorean triangle.
  [[nodiscard]] Vector any_turn() {
    const std::array<Vector, 6> turns = {{{1, 0},
                                          {0, 1},
                                          {-1, 0},
                                          {Fraction(3) / 5, Fraction(4) / 5},
                                          {Fraction(-4) / 5, Fraction(3) / 5},
                                          {Fraction(5) / 13, Fraction(-12) / 13}}};
    return turns.at(random_() % turns.size());
  }
  static Vector seen(const Vector& turn, const Vector& v) { return {dot(turn, v), cross(turn, v)}; }
  [[nodiscard]] Json listed(std::vector<std::pair<std::string, Json>>& entries) {
    std::shuffle(entries.begin(), entries.end(), random_);
    Json result = Json::object();
    for (const auto& [name, entry] : entries) {
      result[name] = entry;
    }
    return result;
  }

  const Group& group_;
  double unit_;
  std::mt19937& random_;
};

}  // namespace assur::test::tied
