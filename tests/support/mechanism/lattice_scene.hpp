// A random group of a given kind in special position on a small integer lattice, as a scene in any
// listing and as the exact numbers of its closures.
#pragma once

#include <algorithm>
#include <array>
#include <assur/mechanism/group_model.hpp>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace assur::test {

/// A kind of a rigid model.
struct LatticeKind {
  const mechanism::GroupStructure* group;
  std::vector<bool> prismatic;  ///< of each joint, in the order of the spelling
  std::string spelling;         ///< `RRP-RRR`
};

/// The kinds of all rigid models, group after group, each group's in the order of the alphabet.
inline std::vector<LatticeKind> lattice_kinds() {
  std::vector<LatticeKind> result;
  for (const mechanism::GroupModels& models : mechanism::known_groups()) {
    const std::size_t first = result.size();
    for (const mechanism::GroupModel& model : models.models) {
      for (const std::string& spelling : model.rigid ? model.kinds : std::vector<std::string>{}) {
        LatticeKind kind{&models.structure, {}, spelling};
        for (const char letter : spelling) {
          if (letter != '-') {
            kind.prismatic.push_back(letter == 'P');
          }
        }
        result.push_back(kind);
      }
    }
    std::sort(result.begin() + static_cast<std::ptrdiff_t>(first), result.end(),
              [](const LatticeKind& a, const LatticeKind& b) { return a.spelling < b.spelling; });
  }
  return result;
}

/// How exactly doubles hold a scene.
enum class LatticeClass : std::uint8_t {
  axis,     ///< every number and every unit vector
  oblique,  ///< every number, but not the unit vectors of slides: (3, 4) / 5
  rational  ///< links are turned by angles of Pythagorean triangles: numbers like 3/5 are rounded
};

inline std::string lattice_class_name(LatticeClass of) {
  return of == LatticeClass::axis ? "axis" : of == LatticeClass::oblique ? "oblique" : "rational";
}

/// An integer vector; as a direction, a multiple of one of the twelve directions of the lattice.
struct LatticeVector {
  int x = 0;
  int y = 0;
};

/// A joint of the group in the known configuration. Its displacement is not zero there: the line's
/// `through` on either link is some steps along the line away from `at`.
struct LatticeJoint {
  char name;
  bool prismatic;
  int first;            ///< index of a link, or `base_link`
  int second;           ///< index of a link
  LatticeVector at;     ///< where the joint is
  LatticeVector along;  ///< of the slide
  std::array<int, 2> steps;
  std::array<int, 2> lengths;  ///< of `along` as either link writes it, in multiples
};

/// A link's own frame in the known configuration: turned by the angle of (c, s) / size.
struct LatticeFrame {
  LatticeVector origin;
  int c = 1;
  int s = 0;
  int size = 1;  ///< 1 or 5
};

/// A group of one kind in its known configuration.
class LatticeScene {
 public:
  LatticeScene(LatticeKind kind, unsigned seed) : kind_(std::move(kind)), seed_(seed) {
    std::uint32_t mixed = 2166136261U;
    for (const char letter : kind_.spelling) {
      mixed = (mixed ^ static_cast<std::uint32_t>(letter)) * 16777619U;
    }
    std::mt19937 engine(mixed + seed);
    constexpr std::array<int, 8> reaches = {3, 3, 3, 3, 2, 2, 2, 1};
    const int reach = reaches[engine() % reaches.size()];
    const bool oblique = engine() % 10 < 3;
    const bool rational = engine() % 10 < 2;
    const auto point = [&engine](int bound) {
      const int x = within(bound, engine);
      return LatticeVector{x, within(bound, engine)};
    };
    for (const auto& link : kind_.group->link_joints) {
      std::string name;
      for (const int joint : link) {
        name += kind_.group->joints[static_cast<std::size_t>(joint)].name;
      }
      links_.push_back(name);
      const LatticeVector origin = point(3);
      const Turn turn = drawn_turn(rational, engine);
      frames_.push_back({origin, turn.c, turn.s, turn.size});
      is_rational_ = is_rational_ || turn.size > 1;
    }
    for (std::size_t index = 0; index < kind_.prismatic.size(); ++index) {
      const ModelJoint& graph = kind_.group->joints[index];
      LatticeJoint joint{
          graph.name, kind_.prismatic[index], graph.first, graph.second, point(reach), {}, {}, {}};
      const Turn turn = drawn_turn(oblique, engine);
      joint.along = {turn.c, turn.s};
      for (std::size_t side = 0; side < 2; ++side) {
        joint.steps[side] = within(2, engine);
        joint.lengths[side] = 1 + static_cast<int>(engine() % 3);
      }
      is_oblique_ = is_oblique_ || (joint.prismatic && turn.size > 1);
      joints_.push_back(joint);
    }
  }

  /// `RRP-RRR 17 axis`
  [[nodiscard]] std::string name() const {
    return kind_.spelling + " " + std::to_string(seed_) + " " + lattice_class_name(exactness());
  }
  [[nodiscard]] const LatticeKind& kind() const { return kind_; }
  [[nodiscard]] const std::vector<std::string>& links() const { return links_; }
  [[nodiscard]] const std::vector<LatticeJoint>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<LatticeFrame>& frames() const { return frames_; }
  [[nodiscard]] LatticeClass exactness() const {
    return is_rational_  ? LatticeClass::rational
           : is_oblique_ ? LatticeClass::oblique
                         : LatticeClass::axis;
  }

  /// The scene file; `listing` gives the order of links, features and joints, `exchange` for which
  /// joints the two links change places: for none where it is 0.
  [[nodiscard]] std::string text(unsigned listing, unsigned exchange) const {
    std::mt19937 engine(listing);
    std::mt19937 exchanges(exchange);
    std::string links;
    for (const int link : shuffled(static_cast<int>(links_.size()) + 1, engine)) {
      links += (links.empty() ? "" : ",\n  ") + link_text(link - 1, engine);
    }
    std::string joints;
    for (const int index : shuffled(static_cast<int>(joints_.size()), engine)) {
      const LatticeJoint& joint = joints_[static_cast<std::size_t>(index)];
      std::array<std::string, 2> sides = {link_name(joint.first), link_name(joint.second)};
      if (exchanges() % 2 == 1 && exchange != 0) {
        std::swap(sides[0], sides[1]);
      }
      const std::string name(1, joint.name);
      joints += std::string(joints.empty() ? "" : ",\n  ") + "\"" + name + R"(": {"type": ")" +
                (joint.prismatic ? "prismatic" : "revolute") + R"(", "between": [")" + sides[0] +
                "." + name + "\", \"" + sides[1] + "." + name + "\"]}";
    }
    return "{\"name\": \"" + name() + "\",\n \"links\": {\n  " + links + "},\n \"joints\": {\n  " +
           joints + "},\n \"want\": [\"position\"]}\n";
  }

 private:
  struct Turn {
    int c, s, size;
  };

  static int within(int bound, std::mt19937& engine) {
    return static_cast<int>(engine() % static_cast<unsigned>(2 * bound + 1)) - bound;
  }
  /// A multiple of 90 degrees, plus a Pythagorean angle every other time where that is allowed.
  static Turn drawn_turn(bool pythagorean, std::mt19937& engine) {
    const bool drawn = engine() % 2 == 1;
    const bool longer = engine() % 2 == 1;
    Turn turn = pythagorean && drawn ? (longer ? Turn{4, 3, 5} : Turn{3, 4, 5}) : Turn{1, 0, 1};
    for (unsigned quarters = engine() % 4; quarters > 0; --quarters) {
      turn = {-turn.s, turn.c, turn.size};
    }
    return turn;
  }
  static std::vector<int> shuffled(int count, std::mt19937& engine) {
    std::vector<int> result(static_cast<std::size_t>(count));
    std::iota(result.begin(), result.end(), 0);
    for (std::size_t left = result.size(); left > 1; --left) {
      std::swap(result[left - 1], result[engine() % left]);
    }
    return result;
  }

  [[nodiscard]] std::string link_name(int link) const {
    return link == base_link ? "ground" : links_[static_cast<std::size_t>(link)];
  }

  /// A number over the size of a frame: an integer, or an expression where it is not one.
  static std::string number_text(int numerator, int size) {
    return numerator % size == 0
               ? std::to_string(numerator / size)
               : "\"" + std::to_string(numerator) + "/" + std::to_string(size) + "\"";
  }

  [[nodiscard]] std::string feature_text(const LatticeJoint& joint, int link) const {
    const std::size_t side = joint.first == link ? 0 : 1;
    const LatticeFrame frame =
        link == base_link ? LatticeFrame{} : frames_[static_cast<std::size_t>(link)];
    const int step = joint.prismatic ? joint.steps[side] : 0;
    const int x = joint.at.x + step * joint.along.x - frame.origin.x;
    const int y = joint.at.y + step * joint.along.y - frame.origin.y;
    std::string place = "[" + number_text(frame.c * x + frame.s * y, frame.size) + ", " +
                        number_text(frame.c * y - frame.s * x, frame.size) + "]";
    if (!joint.prismatic) {
      return place;
    }
    // A direction has no size: it stays an integer vector in every frame.
    const int dx = frame.c * joint.along.x + frame.s * joint.along.y;
    const int dy = frame.c * joint.along.y - frame.s * joint.along.x;
    return R"({"through": )" + place + R"(, "along": [)" +
           std::to_string(joint.lengths[side] * dx) + ", " +
           std::to_string(joint.lengths[side] * dy) + "]}";
  }

  [[nodiscard]] std::string link_text(int link, std::mt19937& engine) const {
    std::string features;
    for (const int index : shuffled(static_cast<int>(joints_.size()), engine)) {
      const LatticeJoint& joint = joints_[static_cast<std::size_t>(index)];
      if (joint.first == link || joint.second == link) {
        features += std::string(features.empty() ? "\"" : ", \"") + joint.name +
                    "\": " + feature_text(joint, link);
      }
    }
    return "\"" + link_name(link) + "\": {" + features + "}";
  }

  LatticeKind kind_;
  unsigned seed_;
  std::vector<std::string> links_;
  std::vector<LatticeJoint> joints_;
  std::vector<LatticeFrame> frames_;
  bool is_oblique_ = false;
  bool is_rational_ = false;
};

}  // namespace assur::test
