// Random chains of dyads on a small integer lattice, as scenes in any listing, position and unit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "mechanism/gaussian.hpp"

namespace assur::test {

/// The pose of a link: a point p of its frame is at origin + turn p.
template <typename Number>
struct ChainPose {
  Number turn;
  Number origin;

  [[nodiscard]] Number operator()(const Number& point) const { return origin + turn * point; }
};

/// A point of a link, or a line through it along a unit vector, in the link's frame.
struct ChainFeature {
  bool line = false;
  Gaussian at;
  Gaussian along;
};

/// How a listing of a chain differs from another: in order, place, direction and unit.
struct ChainListing {
  unsigned order = 0;      ///< 0: the original order
  bool exchanged = false;  ///< the two sides of joints that are not driven
  int x = 0, y = 0;        ///< where the ground's origin is moved
  int quarters = 0;        ///< by which the ground is turned
  bool expressed = false;  ///< turned by expressions: what is zero there is computed as rounded
  int unit = 0;            ///< a power of two by which all lengths are multiplied
};

/// One link of a chain, with the pose that it has in the known configuration.
struct ChainLink {
  std::string name;
  ChainPose<Gaussian> known;
  std::vector<ChainFeature> features;
};

struct ChainJoint {
  enum class Type : unsigned char { revolute, prismatic, slot };
  Type type;
  std::array<std::size_t, 2> links;
  std::array<std::size_t, 2> features;
};

/// A dyad and its bases: two links, that of the first joint first, or one link and a block.
struct ChainDyad {
  enum class Kind : unsigned char { rrr, rpr, rrp, prp, rpp };
  Kind kind;
  std::array<std::size_t, 2> bases;
  std::array<std::size_t, 2> links;  ///< equal where the second link is a block
  /// Features, from the first base to the second: on the base and on its own link, on both links,
  /// on the second link and on the base.
  std::array<ChainFeature, 6> features;
};

/// A driven crank, another one on it or on the ground, and dyads, each held by earlier links.
class DyadChain {
 public:
  explicit DyadChain(unsigned seed) : seed_(seed), engine_(seed) {
    reach_ = std::array<int, 6>{1, 1, 2, 2, 3, 3}[draw(6)];
    pythagorean_ = draw(5) == 0;
    links_.push_back({"ground", {{1, 0}, {0, 0}}, {}});
    add_crank(0);
    if (draw(3) == 0) {
      add_crank(draw(2));
    }
    const std::size_t dyads = 1 + draw(3);
    for (std::size_t dyad = 0; dyad < dyads; ++dyad) {
      add_dyad();
    }
  }

  [[nodiscard]] std::string name() const { return "chain " + std::to_string(seed_); }
  [[nodiscard]] const std::vector<ChainLink>& links() const { return links_; }
  /// Links that need no dyad: the ground and the cranks, which come first.
  [[nodiscard]] std::size_t driven() const { return driven_; }
  [[nodiscard]] const std::vector<ChainDyad>& dyads() const { return dyads_; }
  [[nodiscard]] std::size_t joint_count() const { return joints_.size(); }
  /// Where a joint is in the known configuration.
  [[nodiscard]] std::complex<double> place_of(std::size_t joint) const {
    const ChainLink& link = links_[joints_[joint].links[0]];
    return link.known(link.features[joints_[joint].features[0]].at).rounded();
  }

  /// The pose of the ground's frame in that of the scene.
  [[nodiscard]] static ChainPose<std::complex<double>> ground_of(const ChainListing& listing) {
    return {std::pow(std::complex<double>(0, 1), listing.quarters),
            std::complex<double>(listing.x, listing.y)};
  }

  /// The scene file.
  [[nodiscard]] std::string text(const ChainListing& listing) const {
    std::mt19937 order(listing.order);
    const auto shuffled = [&](std::size_t count) {
      std::vector<std::size_t> result(count);
      for (std::size_t index = 0; index < count; ++index) {
        result[index] = index;
      }
      for (std::size_t left = count; left > 1 && listing.order > 0; --left) {
        std::swap(result[left - 1], result[order() % left]);
      }
      return result;
    };
    std::string links;
    for (const std::size_t link : shuffled(links_.size())) {
      std::string features;
      for (const std::size_t feature : shuffled(links_[link].features.size())) {
        features += (features.empty() ? "\"f" : ", \"f") + std::to_string(feature) +
                    "\": " + feature_text(link, feature, listing);
      }
      links += (links.empty() ? "" : ",\n  ") + quoted(links_[link].name) + ": {" + features + "}";
    }
    std::string joints;
    for (const std::size_t index : shuffled(joints_.size())) {
      const ChainJoint& joint = joints_[index];
      std::array<std::string, 2> sides;
      for (std::size_t side = 0; side < 2; ++side) {
        sides[side] =
            quoted(links_[joint.links[side]].name + ".f" + std::to_string(joint.features[side]));
      }
      if (listing.exchanged && index + 1 >= driven_) {
        std::swap(sides[0], sides[1]);
      }
      static constexpr std::array<const char*, 3> types = {"revolute", "prismatic", "pin-in-slot"};
      joints += std::string(joints.empty() ? "" : ",\n  ") + "\"J" + std::to_string(index) +
                R"(": {"type": ")" + types[static_cast<std::size_t>(joint.type)] +
                R"(", "between": [)" + sides[0] + ", " + sides[1] + "]}";
    }
    std::string drivers;
    for (std::size_t link = 1; link < driven_; ++link) {
      // The ground's frame stays where it is, so what turns on it is turned with its features.
      const int more = joints_[link - 1].links[0] == 0 ? 90 * listing.quarters : 0;
      drivers += (drivers.empty() ? "\"J" : ", \"J") + std::to_string(link - 1) +
                 R"(": {"position": ")" + turns_[link - 1] + " + " + std::to_string(more) +
                 R"(*deg", "velocity": 1})";
    }
    return "{\"name\": \"" + name() + "\",\n \"links\": {\n  " + links + "},\n \"joints\": {\n  " +
           joints + "},\n \"drivers\": {" + drivers +
           "},\n \"want\": [\"position\", \"velocity\", \"acceleration\"]}\n";
  }

 private:
  unsigned draw(unsigned count) { return static_cast<unsigned>(engine_() % count); }
  int within(int bound) {
    return static_cast<int>(draw(2 * static_cast<unsigned>(bound) + 1)) - bound;
  }
  Gaussian place() {
    const int x = within(reach_);
    return {x, within(reach_)};
  }
  /// A turn by a multiple of 90 degrees and, where allowed, by the angle of a Pythagorean triangle;
  /// `text` gets its angle as an expression.
  Gaussian turn(std::string* text = nullptr) {
    const unsigned quarters = draw(4);
    Gaussian result{1, 0};
    for (unsigned quarter = 0; quarter < quarters; ++quarter) {
      result = result * Gaussian{0, 1};
    }
    const bool more = pythagorean_ && draw(2) == 0;
    if (text != nullptr) {
      *text = std::to_string(90 * quarters) + "*deg" + (more ? " + atan2(3, 4)" : "");
    }
    return more ? result * Gaussian{Rational(4) / Rational(5), Rational(3) / Rational(5)} : result;
  }

  /// A feature on a link, by where it is in the known configuration.
  ChainFeature feature(std::size_t link, const ChainFeature& world) {
    const ChainPose<Gaussian>& pose = links_[link].known;
    return {world.line, (world.at - pose.origin) / pose.turn, world.along / pose.turn};
  }
  std::size_t add_feature(std::size_t link, const ChainFeature& local) {
    links_[link].features.push_back(local);
    return links_[link].features.size() - 1;
  }
  void add_joint(ChainJoint::Type type, std::size_t one, const ChainFeature& on_one,
                 std::size_t other, const ChainFeature& on_other) {
    joints_.push_back(
        {type, {one, other}, {add_feature(one, on_one), add_feature(other, on_other)}});
  }

  void add_crank(std::size_t base) {
    ChainFeature pivot{false, place(), {1, 0}};
    std::string text;
    const Gaussian by = turn(&text);
    turns_.push_back(text);
    const Gaussian direction = links_[base].known.turn * by;
    // The pivot on the crank: mostly its origin, and sometimes far away, so that the other end of a
    // long crank is the difference of two large numbers.
    const Gaussian far{1000 * within(1), 100 * within(3)};
    const unsigned which = draw(6);
    const Gaussian own = which == 0 ? far : which < 3 ? place() : Gaussian{0, 0};
    if (which == 0 && base == 0) {
      pivot.at = pivot.at + by * own;
    }
    links_.push_back(
        {"crank" + std::to_string(driven_), {direction, pivot.at - direction * own}, {}});
    add_joint(ChainJoint::Type::revolute, base, feature(base, pivot), driven_,
              feature(driven_, pivot));
    ++driven_;
  }

  void add_dyad() {
    using Kind = ChainDyad::Kind;
    using Type = ChainJoint::Type;
    ChainDyad dyad;
    dyad.kind = std::array<Kind, 8>{Kind::rrr, Kind::rrr, Kind::rrr, Kind::rpr,
                                    Kind::rpr, Kind::rrp, Kind::prp, Kind::rpp}[draw(8)];
    dyad.bases[0] = draw(static_cast<unsigned>(links_.size()));
    dyad.bases[1] = links_.size() - 1 - draw(std::min<unsigned>(3, unsigned(links_.size())));
    if (draw(2) == 0) {
      std::swap(dyad.bases[0], dyad.bases[1]);
    }
    const bool is_block = (dyad.kind == Kind::rpr || dyad.kind == Kind::rrp) && draw(2) == 0;
    const std::string number = std::to_string(dyads_.size() + 1);
    dyad.links[0] = links_.size();
    links_.push_back({"a" + number, {turn(), place()}, {}});
    dyad.links[1] = dyad.links[0] + (is_block ? 0 : 1);
    if (!is_block) {
      links_.push_back({"b" + number, {turn(), place()}, {}});
    }
    static constexpr std::array<const char*, 5> spellings = {"RRR", "RPR", "RRP", "PRP", "RPP"};
    const std::string kind = spellings[static_cast<std::size_t>(dyad.kind)];
    std::array<Gaussian, 3> places = {place(), place(), place()};
    // A bar without a length has no direction.
    const auto coincide = [&places](std::size_t a, std::size_t b) {
      return places[a] == places[b];
    };
    while (((kind == "RRR" || kind == "RRP") && coincide(0, 1)) ||
           (kind == "RRR" && coincide(1, 2))) {
      places[1] = place();
    }
    const std::array<std::size_t, 4> chain = {dyad.bases[0], dyad.links[0], dyad.links[1],
                                              dyad.bases[1]};
    // A block's pin stands on the line.
    const std::size_t slot = is_block ? (dyad.kind == Kind::rpr ? 1 : 2) : 3;
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const bool line = kind[joint] == 'P';
      const Gaussian along = turn();
      std::array<ChainFeature, 2> sides;
      for (std::size_t side = 0; side < 2; ++side) {
        sides[side] = {line, places[joint], along};
        if (line && slot > 2) {
          sides[side].at = sides[side].at + Gaussian{within(2)} * along;
        }
        dyad.features[2 * joint + side] = feature(chain[joint + side], sides[side]);
      }
      if (slot > 2) {
        add_joint(line ? Type::prismatic : Type::revolute, chain[joint], dyad.features[2 * joint],
                  chain[joint + 1], dyad.features[2 * joint + 1]);
      }
    }
    if (slot == 1) {  // the second base's pin in a slot of the link
      hold_block(dyad, 3, 4);
      dyad.features[2].at = links_at(dyad.links[0], places[2], dyad.features[2]);
      add_joint(Type::revolute, chain[0], dyad.features[0], chain[1], dyad.features[1]);
      add_joint(Type::slot, chain[1], dyad.features[2], chain[3], dyad.features[5]);
    } else if (slot == 2) {  // the link's pin in a slot of the second base
      hold_block(dyad, 4, 3);
      dyad.features[5].at = links_at(dyad.bases[1], places[1], dyad.features[5]);
      add_joint(Type::revolute, chain[0], dyad.features[0], chain[1], dyad.features[1]);
      add_joint(Type::slot, chain[1], dyad.features[2], chain[3], dyad.features[5]);
    }
    dyads_.push_back(dyad);
  }

  /// A block has its pin on its line, along its x-axis.
  static void hold_block(ChainDyad& dyad, std::size_t line, std::size_t pin) {
    dyad.features[line] = {true, {0, 0}, {1, 0}};
    dyad.features[pin] = {false, {0, 0}, {1, 0}};
  }
  /// A place in a link's frame, on the line that passes `world` in the known configuration.
  Gaussian links_at(std::size_t link, const Gaussian& world, const ChainFeature& line) {
    const ChainPose<Gaussian>& pose = links_[link].known;
    return (world - pose.origin) / pose.turn + Gaussian{within(2)} * line.along;
  }

  static std::string quoted(const std::string& text) { return "\"" + text + "\""; }

  /// A rational number of a denominator that is a power of five, times a power of two.
  static std::string number_text(const Rational& number, int unit) {
    int size = 1;
    Rational numerator = number;
    while (numerator.rounded() != std::rint(numerator.rounded())) {
      size *= 5;
      numerator = numerator * Rational(5);
    }
    std::ostringstream text;
    text.precision(17);
    text << std::ldexp(numerator.rounded(), unit);
    return size == 1 ? text.str() : "\"" + text.str() + "/" + std::to_string(size) + "\"";
  }
  static std::string vector_text(const Gaussian& vector, int unit) {
    return "[" + number_text(vector.re, unit) + ", " + number_text(vector.im, unit) + "]";
  }

  /// A vector that is turned and moved by expressions.
  static std::string expressed_text(const Gaussian& vector, const ChainListing& listing, int x,
                                    int y) {
    const std::string angle = "(" + std::to_string(90 * listing.quarters) + "*deg)";
    const auto term = [&](const Rational& number, const std::string& function) {
      std::string text = number_text(number, listing.unit);
      text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
      return "(" + text + ")*" + function + angle;
    };
    const auto moved = [&](int by) {
      return " + (" + number_text(Rational(by), listing.unit) + ")\"";
    };
    return "[\"" + term(vector.re, "cos") + " - " + term(vector.im, "sin") + moved(x) + ", \"" +
           term(vector.re, "sin") + " + " + term(vector.im, "cos") + moved(y) + "]";
  }

  [[nodiscard]] std::string feature_text(std::size_t link, std::size_t index,
                                         const ChainListing& listing) const {
    ChainFeature feature = links_[link].features[index];
    if (link == 0 && listing.expressed && !feature.line) {
      return expressed_text(feature.at, listing, listing.x, listing.y);
    }
    if (link == 0) {
      for (int quarter = 0; quarter < listing.quarters; ++quarter) {
        feature.at = feature.at * Gaussian{0, 1};
        feature.along = feature.along * Gaussian{0, 1};
      }
      feature.at = feature.at + Gaussian{listing.x, listing.y};
    }
    const std::string place = vector_text(feature.at, listing.unit);
    // A direction has no size: five times it has no denominator.
    return !feature.line ? place
                         : R"({"through": )" + place + R"(, "along": )" +
                               vector_text(Gaussian{25} * feature.along, 0) + "}";
  }

  unsigned seed_;
  std::mt19937 engine_;
  int reach_ = 3;
  bool pythagorean_ = false;
  std::vector<ChainLink> links_;
  std::vector<ChainJoint> joints_;
  std::vector<ChainDyad> dyads_;
  std::vector<std::string> turns_;  ///< of the cranks relative to their bases
  std::size_t driven_ = 1;
};

}  // namespace assur::test
