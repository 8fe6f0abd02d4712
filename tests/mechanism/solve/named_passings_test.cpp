// Law: well-known mechanisms are solved correctly where they would be singular without their
// redundant constraints, or where another of their configurations moves by itself.
#include <gtest/gtest.h>

#include <array>

#include "named_linkages.hpp"

namespace assur::test::named_passings_test {
namespace {

const double pi = std::acos(-1.0);
constexpr double rate = 2;
constexpr double second = 1;

std::string at(double place) { return " at " + std::to_string(place); }

SceneMaker with_ways() {
  SceneMaker maker;
  return maker.line("ground", "way", {0, 0}, {1, 0}).line("ground", "rise", {0, 0}, {0, 1});
}

/// A mechanism with a crank MB, and with a rod whose arms on either side of B are as long.
SceneMaker with_crank_and_rod(double length) {
  return with_ways()
      .point("ground", "M", 0, 0)
      .bar("crank", {{"M", 0}, {"B", length}})
      .bar("rod", {{"B", 0}, {"X", length}, {"Y", -length}});
}

// Scott Russell's linkage with two blocks: X slides along the x-axis, and Y along the y-axis. A
// turned piston points the other way on its slide. Only half of this slide's constraints are kept,
// since of the two slides its name comes first.
SceneMaker two_blocks_scene(bool is_turned) {
  return with_crank_and_rod(5)
      .point("piston", "X", 0, 0)
      .point("piston", "Z", 0, 1)
      .line("piston", "way", {0, 0}, {is_turned ? -1.0 : 1.0, 0})
      .point("ram", "Y", 0, 0)
      .line("ram", "rise", {0, 0}, {0, 1})
      .slide("Across", "ground.way", "piston.way")
      .slide("Upwards", "ground.rise", "ram.rise");
}

KnownAssembly two_blocks(const JetPoint& b, bool is_turned, bool regular = true) {
  const Jet x = Jet(2) * b.x;
  const Jet y = Jet(2) * b.y;
  return {{{"B", b}, {"X", {x, 0}}, {"Y", {0, y}}, {"Z", {x, is_turned ? -1 : 1}}},
          {{"Across", x}, {"Upwards", y}},
          regular};
}

SceneMaker turned_blocks_scene(double phi, bool is_turned) {
  return two_blocks_scene(is_turned).parameter("phi", phi).drive("M", "phi", rate, second);
}

NamedPlace turned_blocks(double phi, bool is_turned) {
  return {"Scott Russell's linkage on two blocks" + at(phi),
          turned_blocks_scene(phi, is_turned),
          {{two_blocks(at_angle({phi, rate, second}, 5), is_turned)}, {}},
          {},
          1e-9};
}

SceneMaker pushed_blocks_scene(double s, bool is_turned) {
  return two_blocks_scene(is_turned).parameter("s", s).drive("Across", "s", rate, second);
}

NamedPlace pushed_blocks(double s, bool is_turned) {
  const Jet x{s / 2, rate / 2, second / 2};
  const Jet under = Jet(25) - x * x;
  Known known;
  if (under.value == 0) {
    known.assemblies.push_back(two_blocks({x, 0}, is_turned, false));
  } else {
    known.assemblies.push_back(two_blocks({x, sqrt(under)}, is_turned));
    known.assemblies.push_back(two_blocks({x, Jet(0) - sqrt(under)}, is_turned));
  }
  return {"Scott Russell's linkage, pushed" + at(s),
          pushed_blocks_scene(s, is_turned),
          known,
          {},
          1e-9};
}

// The elliptic trammel with a crank to the middle of its rod.
SceneMaker trammel_scene(double phi) {
  return with_crank_and_rod(4)
      .parameter("phi", phi)
      .drive("M", "phi", rate, second)
      .slot("Across", "ground.way", "rod.X")
      .slot("Upwards", "ground.rise", "rod.Y");
}

NamedPlace trammel(double phi) {
  const JetPoint b = at_angle({phi, rate, second}, 4);
  const Jet x = Jet(2) * b.x;
  const Jet y = Jet(2) * b.y;
  return {"the trammel with a crank" + at(phi),
          trammel_scene(phi),
          {{{{{"B", b}, {"X", {x, 0}}, {"Y", {0, y}}}, {{"Across", x}, {"Upwards", y}}}}, {}},
          {},
          1e-9};
}

const Theorem is_upright{"Y is on the line x = 0", 1,
                         [](const Points& points) { return points.at("Y").x; }};

/// A platform congruent with its base: if its legs are parallel and equal, they go around together.
SceneMaker like_its_base() {
  SceneMaker maker;
  for (const std::string link : {"ground", "platform"}) {
    const std::string name = link == "ground" ? "G" : "P";
    maker.point(link, name + "1", 0, 0).point(link, name + "2", 4, 0).point(link, name + "3", 0, 4);
  }
  return maker;
}

SceneMaker on_legs_scene() {
  SceneMaker maker = like_its_base();
  maker.parameter("leg", 3);
  for (const std::string leg : {"1", "2", "3"}) {
    maker.bar(
        "leg" + leg,
        {{"G" + leg, 0}, {"P" + leg, leg == "1" ? SceneMaker::Json("leg") : SceneMaker::Json(3)}});
  }
  return maker;
}

SceneMaker on_cranks_scene() {
  SceneMaker maker = like_its_base();
  maker.parameter("phi", 0);
  for (const std::string leg : {"1", "2", "3"}) {
    maker.drive("G" + leg, leg == "1" ? SceneMaker::Json("phi") : SceneMaker::Json(0), 0, 0)
        .bar("crank" + leg, {{"G" + leg, 0}, {"E" + leg, 1}})
        .bar("leg" + leg, {{"E" + leg, 0}, {"P" + leg, 1}});
  }
  return maker;
}

// A platform of half the size of its base, which is turned, on two legs of half the base's sides.
// Its two assemblies turn in opposite directions, by theta with leg = sqrt(8) - a theta^4 and so
// on, until the swept leg is on the line of symmetry.
SceneMaker half_as_large_scene() {
  SceneMaker maker;
  return maker.parameter("leg", 2)
      .point("ground", "G1", 7, -5)
      .point("ground", "G2", 7 + 4 * .6, -5 + 4 * .8)
      .point("ground", "G3", 7 - 4 * .8, -5 + 4 * .6)
      .point("platform", "P1", 0, 0)
      .point("platform", "P2", 2, 0)
      .point("platform", "P3", 0, 2)
      .bar("leg1", {{"G1", 0}, {"P1", "leg"}})
      .bar("leg2", {{"G2", 0}, {"P2", 2}})
      .bar("leg3", {{"G3", 0}, {"P3", 2}});
}

// Dixon's mechanism: nine bars join three points P of a line to three points Q of a line square to
// it, which move from x^2 = 9, 25, 49 and y^2 = 16, 36, 64 to x^2 + t and y^2 - t. P1 Q1 is the
// ground and P1 Q2 is driven; P2, P3 and Q3 are on either side of the crossing.
NamedPlace dixon(double t) {
  const auto name = [](char of, std::size_t place) { return of + std::to_string(place + 1); };
  const std::array<double, 3> x2{9, 25, 49};
  const std::array<double, 3> y2{16, 36, 64};
  const double x = std::sqrt(x2[0] + t);
  const double y = std::sqrt(y2[0] - t);
  const double tilt = std::atan2(y, -x);  // of the ground's bar in the axes
  SceneMaker scene;
  scene.parameter("phi", std::atan2(std::sqrt(y2[1] - t), -x) - tilt)
      .drive("D", "phi", 0, 0)
      .bar("ground", {{"P1", 0}, {"D", 0}, {"Q1", 5}});
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t q = p == 0 ? 1 : 0; q < 3; ++q) {
      const bool is_driven = p == 0 && q == 1;
      scene.bar(name('P', p) + name('Q', q),
                {{is_driven ? "D" : name('P', p), 0}, {name('Q', q), std::sqrt(x2[p] + y2[q])}});
    }
  }
  Known known;
  const auto from_ground = [&](double along, double aside) {
    return at_angle(-tilt, along - x, aside);
  };
  for (int signs = 0; signs < 8; ++signs) {
    const auto signed_root = [signs](int bit, double square) {
      return (signs >> bit) % 2 == 0 ? std::sqrt(square) : -std::sqrt(square);
    };
    known.assemblies.push_back({{{"Q2", from_ground(0, std::sqrt(y2[1] - t))},
                                 {"P2", from_ground(signed_root(0, x2[1] + t), 0)},
                                 {"P3", from_ground(signed_root(1, x2[2] + t), 0)},
                                 {"Q3", from_ground(0, signed_root(2, y2[2] - t))}},
                                {}});
  }
  return {"Dixon's mechanism" + at(t), scene, known, {}, 1e-9};
}

class NamedPassing : public testing::TestWithParam<NamedPlace> {};

TEST_P(NamedPassing, IsAnsweredAsKnown) { expect_as_known(GetParam()); }

std::vector<NamedPlace> places() {
  std::vector<NamedPlace> result;
  for (const double phi : {0.0, 1e-9, 1e-7, 1e-5, 0.5, pi / 2, pi / 2 + 1e-7, pi, 4.0}) {
    result.push_back(turned_blocks(phi, false));
    result.push_back(turned_blocks(phi, true));
    result.push_back(trammel(phi));
  }
  for (const double s : {-10.0, -6.0, 0.0, 1e-6, 8.0, 10.0}) {
    result.push_back(pushed_blocks(s, false));
    result.push_back(pushed_blocks(s, true));
  }
  for (const double t : {0.0, 7.0, -8.0}) {
    result.push_back(dixon(t));
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(Everywhere, NamedPassing, testing::ValuesIn(places()));

class NamedPassingSwept : public testing::TestWithParam<NamedSweep> {};

TEST_P(NamedPassingSwept, IsFollowedAsKnown) { expect_swept_as_known(GetParam()); }

std::vector<NamedSweep> sweeps() {
  const auto about_upright = [](double reach) {
    return trammel_scene(0).sweep("phi", pi / 2 - reach, pi / 2 + reach, 0);
  };
  return {
      {"the trammel with a crank", about_upright(2), {4, 5}, {}, 1, {is_upright}},
      {"the trammel, from its change point",
       trammel_scene(0).sweep("phi", pi / 2, 3, 0),
       {4},
       {},
       1,
       {is_upright}},
      {"the trammel, a little", about_upright(1e-5), {4, 5}, {}, 1, {is_upright}},
      {"the trammel, hardly", about_upright(1e-7), {5}, {}, 1, {is_upright}},
      {"Scott Russell's linkage on two blocks",
       turned_blocks_scene(1, false).sweep("phi", 0.25, 3, 0),
       {5},
       {},
       1,
       {is_upright}},
      {"Scott Russell's linkage, pushed",
       pushed_blocks_scene(1, true).sweep("s", -10.5, 10.5, 0),
       {7, 8},
       {{{"birth"}, -10}, {{"fold"}, 10}},
       0,
       {}},
      {"a platform whose legs are equal on a step",
       on_legs_scene().sweep("leg", 2, 4, 0),
       {3},
       {{{"degenerate"}, 3}},
       4,
       {}},
      {"a platform half as large, whose fold is flat",
       half_as_large_scene().sweep("leg", 1, 5, 0),
       {5},
       {{{"fold"}, std::sqrt(8)}},
       0,
       {}},
      {"a platform whose cranks are parallel between two steps",
       on_cranks_scene().sweep("phi", -.25, .25, 0),
       {2},
       {},
       6,
       {}},
  };
}
INSTANTIATE_TEST_SUITE_P(Along, NamedPassingSwept, testing::ValuesIn(sweeps()));

}  // namespace
}  // namespace assur::test::named_passings_test
