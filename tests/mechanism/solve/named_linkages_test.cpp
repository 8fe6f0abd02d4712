// Law: well-known linkages, other than those for straight lines, have the configurations that are
// known of them, at their special positions and beside them.
#include "named_linkages.hpp"

#include <gtest/gtest.h>

namespace assur::test::named_linkages_test {
namespace {

const double pi = std::acos(-1.0);
constexpr double rate = 2;
constexpr double second = 1;

std::string at(double place) { return " at " + std::to_string(place); }

// The pantograph: bars OD of 2 a and DQ of 2 b, with bars of b and a from their middles A and B to
// P, which two driven slides move. Q is at twice P wherever ADBP is a parallelogram.
struct Pantograph {
  double a, b;

  [[nodiscard]] SceneMaker scene(double x, double y) const {
    SceneMaker maker;
    return maker.parameter("x", x)
        .parameter("y", y)
        .drive("X", "x", rate, second)
        .drive("Y", "y", -1, 3)
        .point("ground", "O", 0, 0)
        .line("ground", "way", {0, 0}, {1, 0})
        .line("carriage", "way", {0, 0}, {1, 0})
        .line("carriage", "up", {0, 0}, {0, 1})
        .line("stylus", "up", {0, 0}, {0, 1})
        .point("stylus", "P", 0, 0)
        .slide("X", "ground.way", "carriage.way")
        .slide("Y", "carriage.up", "stylus.up")
        .bar("OD", {{"O", 0}, {"A", a}, {"D", 2 * a}})
        .bar("DQ", {{"D", 0}, {"B", b}, {"Q", 2 * b}})
        .bar("AP", {{"A", 0}, {"P", b}})
        .bar("BP", {{"B", 0}, {"P", a}});
  }
  [[nodiscard]] NamedPlace place(double x, double y, int scaled) const {
    const Points driven{{"O", {0, 0}}, {"P", {{x, rate, second}, {y, -1, 3}}}};
    return {
        "the pantograph" + at(x) + "," + at(y),
        scene(x, y),
        assemblies_of(driven, {pin("A", "O", a, "P", b, {"OD", "AP"}), beside("D", "O", "A", 2),
                               pin("B", "D", b, "P", a, {"DQ", "BP"}), beside("Q", "D", "B", 2)}),
        {copies(scaled)},
        1e-9};
  }
  static Theorem copies(int assemblies) {
    return {"Q is at twice P", assemblies, [](const Points& points) {
              const JetPoint off = points.at("Q") - Jet(2) * points.at("P");
              return off.x + Jet(2) * off.y;
            }};
  }
};

// The equal-armed five-bar: cranks of 5 about (-4, 0) and (4, 0) mirror one another and hold two
// arms of 4. In the frame of the left crank its end is at (x, y).
SceneMaker five_bar_scene(double phi, double x, double y) {
  SceneMaker maker;
  return maker.parameter("phi", phi)
      .drive("A", "phi", rate, second)
      .drive("E", "-phi", -rate, -second)
      .point("ground", "A", -4, 0)
      .point("ground", "E", 4, 0)
      .point("left", "A", 0, 0)
      .point("left", "B", x, y)
      .point("right", "E", 0, 0)
      .point("right", "D", -x, y)
      .bar("BC", {{"B", 0}, {"C", 4}})
      .bar("DC", {{"D", 0}, {"C", 4}});
}

NamedPlace five_bar(double phi, double x, double y) {
  const JetPoint b = JetPoint{-4, 0} + at_angle({phi, rate, second}, x, y);
  const JetPoint d{Jet(0) - b.x, b.y};
  const Known known = assemblies_of({{"B", b}, {"D", d}}, {pin("C", "B", 4, "D", 4, {"BC", "DC"})});
  const bool regular = known.assemblies.size() == 2;
  return {"the five-bar" + at(phi) + at(x),
          five_bar_scene(phi, x, y),
          known,
          {{"C is on the line x = 0", regular ? 2 : 0,
            [](const Points& points) { return points.at("C").x; }}},
          1e-9,
          is_close(phi)};
}

// The kite: a crank as long as its pivots are apart, and two other bars. C is on the line of
// symmetry, at half the crank's angle.
SceneMaker kite_scene(double phi, double a, double b) {
  SceneMaker maker;
  return maker.parameter("phi", phi)
      .drive("A", "phi", rate, second)
      .point("ground", "A", 0, 0)
      .point("ground", "D", a, 0)
      .bar("crank", {{"A", 0}, {"B", a}})
      .bar("coupler", {{"B", 0}, {"C", b}})
      .bar("rocker", {{"D", 0}, {"C", b}});
}

/// C at a cos(phi / 2) plus or minus sqrt(b^2 - a^2 sin(phi / 2)^2) along the line at phi / 2.
Theorem on_axis(double a, double b, double sense, int assemblies) {
  return {"C is on its side of the line of symmetry", assemblies, [=](const Points& points) {
            const JetPoint crank = Jet(1 / a) * points.at("B");
            const double phi = std::atan2(crank.y.value, crank.x.value);
            const double along = a * std::cos(phi / 2) +
                                 sense * std::sqrt(b * b - std::pow(a * std::sin(phi / 2), 2));
            return Jet(std::hypot(points.at("C").x.value - along * std::cos(phi / 2),
                                  points.at("C").y.value - along * std::sin(phi / 2)));
          }};
}

NamedPlace kite(double phi, double a, double b) {
  const Jet half{phi / 2, rate / 2, second / 2};
  const Jet across = Jet(a) * sin(half);
  const Jet under = Jet(b * b) - across * across;
  Known known;
  if (phi == 0) {
    known.families.push_back({1, {"coupler", "rocker"}});
  } else if (std::abs(under.value) < 1e-14) {
    known.assemblies.push_back({{{"C", Jet(a) * cos(half) * at_angle(half, 1)}}, {}, false});
  } else if (under.value > 0) {
    for (const Jet& sense : {Jet(1), Jet(-1)}) {
      const Jet along = Jet(a) * cos(half) + sense * sqrt(under);
      known.assemblies.push_back({{{"C", along * at_angle(half, 1)}}, {}});
    }
  }
  const std::string name = "the kite of " + std::to_string(a) + at(phi);
  return {name, kite_scene(phi, a, b), known, {}, 1e-9, is_close(phi)};
}

// A parallelogram ABCD of 2 and 3, and another of 2 and 3 on its coupler BC, whose crank is driven
// relative to the first crank. Each of the two may be crossed or not.
SceneMaker double_scene(double phi, double psi) {
  SceneMaker maker;
  maker.parameter("phi", phi)
      .parameter("psi", psi)
      .drive("A", "phi", rate, second)
      .drive("K", "psi - phi", -1 - rate, 3 - second)
      .point("ground", "A", 0, 0)
      .point("ground", "D", 3, 0)
      .bar("lower_crank", {{"A", 0}, {"B", 2}, {"K", 2}})
      .bar("lower_coupler", {{"B", 0}, {"C", 3}})
      .bar("lower_rocker", {{"D", 0}, {"C", 2}})
      .bar("upper_crank", {{"K", 0}, {"G", 2}})
      .bar("upper_rocker", {{"C", 0}, {"H", 2}})
      .bar("top", {{"G", 0}, {"H", 3}});
  return maker;
}

Theorem top_stays_level(int assemblies) {
  return {"H is beside G", assemblies, [](const Points& points) {
            const JetPoint off = points.at("H") - points.at("G") - JetPoint{3, 0};
            return off.x + Jet(2) * off.y;
          }};
}

NamedPlace double_parallelogram(double phi, double psi, int level) {
  const JetPoint b = at_angle({phi, rate, second}, 2);
  const JetPoint g = b + at_angle({psi, -1, 3}, 2);
  return {"the double parallelogram" + at(phi) + "," + at(psi),
          double_scene(phi, psi),
          assemblies_of({{"D", {3, 0}}, {"B", b}, {"G", g}},
                        {pin("C", "B", 3, "D", 2, {"lower_coupler", "lower_rocker"}),
                         pin("H", "G", 3, "C", 2, {"top", "upper_rocker"})}),
          {top_stays_level(level)},
          1e-9};
}

// Platforms on three equal legs between equilateral triangles with the radii `base` and `top`. The
// corners of the top follow one another as those of the base do, or the other way around.
struct Platform {
  double base, top;
  bool mirrored;

  [[nodiscard]] SceneMaker scene(double leg) const {
    SceneMaker maker;
    maker.parameter("leg", leg).point("ground", "O", 0, 0).point("platform", "T", 0, 0);
    for (int corner = 0; corner < 3; ++corner) {
      const std::string name(1, static_cast<char>('1' + corner));
      const JetPoint u = ray(corner);
      maker.point("ground", "G" + name, base * u.x.value, base * u.y.value)
          .point("platform", "P" + name, top * u.x.value,
                 mirrored ? -top * u.y.value : top * u.y.value)
          .bar("leg" + name, {{"G" + name, 0}, {"P" + name, "leg"}});
    }
    return maker;
  }
  [[nodiscard]] static JetPoint ray(int corner) {
    const double half_root = std::sqrt(3.0) / 2;
    return corner == 0 ? JetPoint{1, 0} : JetPoint{-.5, corner == 1 ? half_root : -half_root};
  }
  [[nodiscard]] KnownAssembly standing(double x, double y, double theta, bool regular) const {
    KnownAssembly result{{{"T", {x, y}}}, {}, regular};
    for (int corner = 0; corner < 3; ++corner) {
      const JetPoint u = ray(corner);
      result.points["P" + std::string(1, static_cast<char>('1' + corner))] =
          JetPoint{x, y} +
          at_angle(theta, top * u.x.value, mirrored ? -top * u.y.value : top * u.y.value);
    }
    return result;
  }

  // If the corners follow alike, the top turns about the centre until the legs fit:
  // base^2 + top^2 - 2 base top cos theta = leg^2. If it is as large as the base it may also circle
  // without turning.
  [[nodiscard]] Known alike(double leg) const {
    Known known;
    const double cosine = (base * base + top * top - leg * leg) / (2 * base * top);
    if (base == top) {
      known.families.push_back({1, {"leg1", "leg2", "leg3", "platform"}});
    }
    if (std::abs(cosine) == 1) {
      known.assemblies.push_back(standing(0, 0, std::acos(cosine), false));
    } else if (std::abs(cosine) < 1) {
      known.assemblies.push_back(standing(0, 0, std::acos(cosine), true));
      known.assemblies.push_back(standing(0, 0, -std::acos(cosine), true));
    }
    return known;
  }

  // If the top is mirrored, its centre is at q exp(i psi), q^2 = leg^2 - base^2 - top^2, and the
  // legs fit where the vectors top q exp(i a) and -base q exp(-i b) add up to base top, with
  // a = psi - 2 theta and b = psi + theta: a triangle with known sides, or its mirror image, and
  // three theta for each.
  [[nodiscard]] Known opposed(double leg) const {
    Known known;
    const double q = std::sqrt(leg * leg - base * base - top * top);
    const double side = top * q;
    const double ground = base * top;
    const double cosine =
        (side * side + ground * ground - base * q * base * q) / (2 * side * ground);
    if (!(std::abs(cosine) <= 1)) {
      return known;
    }
    const bool regular = std::abs(cosine) < 1;
    for (const double sense : {1.0, -1.0}) {
      const double a = sense * std::acos(cosine);
      const double b = -std::atan2(side * std::sin(a), side * std::cos(a) - ground);
      for (int turn = 0; turn < 3; ++turn) {
        const double theta = (b - a + 2 * pi * turn) / 3;
        const double psi = b - theta;
        known.assemblies.push_back(standing(q * std::cos(psi), q * std::sin(psi), theta, regular));
      }
      if (!regular) {
        break;
      }
    }
    return known;
  }

  [[nodiscard]] NamedPlace place(double leg) const {
    return {
        (mirrored ? "a mirrored platform of " : "a platform of ") + std::to_string(top) + at(leg),
        scene(leg),
        mirrored ? opposed(leg) : alike(leg),
        {},
        1e-8};
  }
};

class NamedLinkage : public testing::TestWithParam<NamedPlace> {};

TEST_P(NamedLinkage, IsAnsweredAsKnown) { expect_as_known(GetParam()); }

std::vector<NamedPlace> places() {
  const Pantograph unequal{5, 4};
  const Pantograph equal{5, 5};
  std::vector<NamedPlace> result{unequal.place(3, 0, 2),
                                 unequal.place(3, 4, 2),
                                 unequal.place(8.99, 0, 2),
                                 unequal.place(9, 0, 0),
                                 unequal.place(1, 0, 0),
                                 unequal.place(0, -1, 0),
                                 unequal.place(1.01, 0, 2),
                                 unequal.place(0.5, 0, 0),
                                 unequal.place(10, 0, 0),
                                 equal.place(6, 0, 2),
                                 equal.place(3, -4, 2),
                                 equal.place(9.99, 0, 2),
                                 equal.place(10, 0, 0),
                                 equal.place(0, 0, 0),
                                 equal.place(0.0625, 0, 2),
                                 double_parallelogram(1, 2, 1),
                                 double_parallelogram(-0.5, 0.5, 1),
                                 double_parallelogram(0, 1, 0),
                                 double_parallelogram(1, 0, 0),
                                 double_parallelogram(0, 0, 0),
                                 double_parallelogram(0.01, 1, 1),
                                 double_parallelogram(1, 0.01, 1)};
  // In the middle, with the arms stretched, with one arm on the other, and beside these.
  for (const double phi : {0.0, 1e-3, -1e-2}) {
    result.push_back(five_bar(phi, 3, 4));
    result.push_back(five_bar(phi, 0, 5));
    result.push_back(five_bar(phi, 4, 3));
  }
  for (const double phi : {-2.0, -1e-3, 0.0, 1e-3, 0.5, 1.5, 3.0, pi}) {
    result.push_back(kite(phi, 2, 3));
    result.push_back(kite(phi, 3, 2));
    result.push_back(kite(phi, 2, 2));
  }
  for (const double leg : {1.75, 2.0, 2.001, 3.0, 4.0, 5.99, 6.0, 6.25}) {
    result.push_back(Platform{4, 2, false}.place(leg));
  }
  for (const double leg : {1.0, 2.0, 3.0, 3.99, 4.0, 5.0}) {
    result.push_back(Platform{2, 2, false}.place(leg));
  }
  for (const double leg : {6.75, 7.0, 7.001, 8.0, 8.5, 8.99, 9.0, 9.25}) {
    result.push_back(Platform{3, 6, true}.place(leg));
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(Everywhere, NamedLinkage, testing::ValuesIn(places()));

class NamedLinkageSwept : public testing::TestWithParam<NamedSweep> {};

TEST_P(NamedLinkageSwept, IsFollowedAsKnown) { expect_swept_as_known(GetParam()); }

std::vector<NamedSweep> sweeps() {
  const double flat = 2 * std::asin(2.0 / 3);  // of a kite of 3 and 2
  // Where the crossed coupler of the lower parallelogram, at twice the angle from B to D, is
  // parallel to the upper crank, which is at 1: tan(1 / 2) = -2 sin(phi) / (3 - 2 cos(phi)).
  const double crossed = 0.5 - std::asin(1.5 * std::sin(0.5));
  const Theorem on_line{"C is on the line x = 0", 2,
                        [](const Points& points) { return points.at("C").x; }};
  const Theorem copies = Pantograph::copies(2);
  return {
      {"the pantograph past its folded position",
       Pantograph{5, 4}.scene(3, 1).sweep("x", -6, 6, 0),
       {4},
       {{{"crossing"}, 0}},
       4,
       {copies}},
      {"the pantograph beside its folded position",
       Pantograph{5, 4}.scene(3, 1.25).sweep("x", -6, 6, 0),
       {4},
       {},
       4,
       {copies}},
      {"the five-bar",
       five_bar_scene(0, 5, 0).sweep("phi", 0.75, 2, 0),
       {4, 9},
       {{{"fold"}, pi / 2}},
       0,
       {on_line}},
      {"the five-bar through its arms' coincidence on a step",
       five_bar_scene(0, 4, 3).sweep("phi", -0.25, 0.25, 0),
       {3, 5},
       {{{"degenerate"}, 0}},
       2,
       {on_line}},
      {"the kite through its fold between two steps",
       kite_scene(0, 2, 3).sweep("phi", -1, 1.5, 0),
       {4, 12},
       {},
       2,
       {on_axis(2, 3, 1, 1), on_axis(2, 3, -1, 1)}},
      {"the kite through its fold on a step",
       kite_scene(0, 2, 3).sweep("phi", -1, 1, 0),
       {3, 9},
       {{{"degenerate"}, 0}},
       2,
       {on_axis(2, 3, 1, 1), on_axis(2, 3, -1, 1)}},
      {"the kite of a long crank",
       kite_scene(0, 3, 2).sweep("phi", 0.25, 3, 0),
       {4, 9},
       {{{"fold"}, flat}},
       0,
       {on_axis(3, 2, 1, 1), on_axis(3, 2, -1, 1)}},
      {"the rhombus",
       kite_scene(0, 2, 2).sweep("phi", 0.5, 5.5, 0),
       {4, 9},
       {{{"crossing"}, pi}},
       2,
       {{"C is on A", 1,
         [](const Points& points) { return points.at("C").x + Jet(2) * points.at("C").y; }}}},
      {"the double parallelogram through the lower change point",
       double_scene(0, 1).sweep("phi", -0.5, 0.5, 0),
       {4, 5},
       {{{"crossing", "crossing"}, 0}, {{"crossing"}, crossed}},
       4,
       {top_stays_level(1)}},
      {"a platform over its legs",
       Platform{4, 2, false}.scene(3).sweep("leg", 1, 7, 0),
       {4, 7},
       {{{"birth"}, 2}, {{"fold"}, 6}},
       0,
       {}},
      {"a mirrored platform over its legs",
       Platform{3, 6, true}.scene(8).sweep("leg", 6.5, 9.5, 0),
       {4},
       {{{"birth", "birth", "birth"}, 7}, {{"fold", "fold", "fold"}, 9}},
       0,
       {}},
  };
}
INSTANTIATE_TEST_SUITE_P(Along, NamedLinkageSwept, testing::ValuesIn(sweeps()));

}  // namespace
}  // namespace assur::test::named_linkages_test
