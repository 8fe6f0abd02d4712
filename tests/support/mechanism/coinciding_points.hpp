// Random groups on lattices whose ternary links have coincident points.
#pragma once

#include <array>
#include <map>
#include <random>
#include <string>

#include "mechanism/scene_maker.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::coinciding_points {

/// A scene whose features are given by where they are in the world. Each link has its origin at a
/// point of the lattice and is turned by quarter turns.
// NOLINTNEXTLINE(bugprone-exception-escape): destroying JSON throws only where memory is short
struct Lattice {
  SceneMaker scene;
  std::map<std::string, std::array<int, 3>> links;

  [[nodiscard]] std::array<int, 2> local(const std::string& link, int x, int y) const {
    const auto& [from_x, from_y, turns] = links.at(link);
    std::array<int, 2> at = {x - from_x, y - from_y};
    for (int turn = 0; turn < turns; ++turn) {
      at = {at[1], -at[0]};
    }
    return at;
  }
  void point(const std::string& link, const std::string& name, std::array<int, 2> at,
             const std::string& moves_x = "", const std::string& moves_y = "") {
    const auto [x, y] = local(link, at[0], at[1]);
    const auto moving = [](int value, const std::string& by) {
      return by.empty() ? Json(value) : Json(std::to_string(value) + "+" + by);
    };
    scene.point(link, name, moving(x, moves_x), moving(y, moves_y));
  }
};

class LatticeSource {
 public:
  explicit LatticeSource(unsigned seed) : source_(seed) {}
  std::array<int, 2> point() { return {place_(source_), place_(source_)}; }
  std::array<int, 3> link() { return {place_(source_), place_(source_), turns_(source_)}; }
  int choice(int count) { return std::uniform_int_distribution<int>(0, count - 1)(source_); }

 private:
  std::mt19937 source_;
  std::uniform_int_distribution<int> place_{-4, 4};
  std::uniform_int_distribution<int> turns_{0, 3};
};

/// Adds a link of three points, one of which coincides with another and is moved by parameters.
inline void add_ternary(Lattice& lattice, LatticeSource& source, const std::string& link,
                        const std::array<std::string, 3>& names,
                        std::map<std::string, std::array<int, 2>>& world, const std::string& by_x,
                        const std::string& by_y) {
  const int second = source.choice(3);
  const int first = (second + 1 + source.choice(2)) % 3;
  world[names[static_cast<std::size_t>(second)]] = world[names[static_cast<std::size_t>(first)]];
  lattice.links[link] = source.link();
  for (int index = 0; index < 3; ++index) {
    const std::string& name = names[static_cast<std::size_t>(index)];
    index == second ? lattice.point(link, name, world[name], by_x, by_y)
                    : lattice.point(link, name, world[name]);
  }
}

inline void add_bar(Lattice& lattice, LatticeSource& source, const std::string& link,
                    const std::string& one, const std::string& other,
                    std::map<std::string, std::array<int, 2>>& world, const std::string& by = "") {
  lattice.links[link] = source.link();
  lattice.point(link, one, world[one]);
  lattice.point(link, other, world[other], by);
}

/// A slide along the way between two points of the lattice, in place of a pin.
inline void add_slide(Lattice& lattice, LatticeSource& source, const std::string& name,
                      const std::string& one, const std::string& other) {
  std::array<int, 2> along{};
  while (along == std::array<int, 2>{}) {
    along = source.point();
  }
  const std::array<int, 2> through = source.point();
  for (const std::string& link : {one, other}) {
    const auto at = lattice.local(link, through[0], through[1]);
    const auto origin = lattice.local(link, 0, 0);
    const auto to = lattice.local(link, along[0], along[1]);
    lattice.scene.line(link, name, {double(at[0]), double(at[1])},
                       {double(to[0] - origin[0]), double(to[1] - origin[1])});
  }
  lattice.scene.slide(name, one + "." + name, other + "." + name);
}

/// A tetrad of two links of three joints, with parameters s, t, u, v in points that coincide and r
/// in a bar; a slide may stand in place of the pin at F, and then only one link has a length of
/// zero.
inline Json tetrad(unsigned seed, bool slides) {
  LatticeSource source(seed);
  Lattice lattice;
  std::map<std::string, std::array<int, 2>> world;
  for (const char* name : {"B", "C", "G", "E", "D", "F"}) {
    world[name] = source.point();
  }
  add_ternary(lattice, source, "bcg", {"B", "C", "G"}, world, "s", "t");
  if (slides) {
    add_bar(lattice, source, "edf", "E", "D", world);
  } else {
    add_ternary(lattice, source, "edf", {"E", "D", "F"}, world, "u+u*s", "v-u^2");
  }
  add_bar(lattice, source, "cd", "C", "D", world, "r");
  lattice.links["gf"] = source.link();
  lattice.point("gf", "G", world["G"]);
  if (slides) {
    add_slide(lattice, source, "F", "gf", "edf");
  } else {
    lattice.point("gf", "F", world["F"]);
  }
  lattice.links["ground"] = {0, 0, 0};
  lattice.point("ground", "B", world["B"]);
  lattice.point("ground", "E", world["E"]);
  return lattice.scene.scene();
}

/// A link on three legs; the legs may stand on slides.
inline Json triad(unsigned seed, int slides) {
  LatticeSource source(seed);
  Lattice lattice;
  std::map<std::string, std::array<int, 2>> world;
  for (const char* name : {"B", "C", "D", "E", "F", "G"}) {
    world[name] = source.point();
  }
  lattice.links["ground"] = {0, 0, 0};
  add_ternary(lattice, source, "platform", {"B", "C", "D"}, world, "s", "t-s^2");
  const std::array<std::array<std::string, 2>, 3> legs = {{{"B", "E"}, {"C", "F"}, {"D", "G"}}};
  for (const auto& [end, foot] : legs) {
    const std::string leg = "leg" + end;
    lattice.links[leg] = source.link();
    lattice.point(leg, end, world[end]);
    if (slides-- > 0) {
      add_slide(lattice, source, foot, "ground", leg);
    } else {
      lattice.point(leg, foot, world[foot], "r");
      lattice.point("ground", foot, world[foot], "", "u");
    }
  }
  return lattice.scene.scene();
}

}  // namespace assur::test::coinciding_points
