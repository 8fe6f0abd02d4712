// Law: linkages that are known to guide a point along a straight line, exactly or nearly, do so, at
// their special positions and beside them.
#include <gtest/gtest.h>

#include "named_linkages.hpp"

namespace assur::test::named_straight_lines_test {
namespace {

const double pi = std::acos(-1.0);
constexpr double rate = 2;    // of every crank
constexpr double second = 1;  // and its second rate

Jet crank(double phi) { return {phi, rate, second}; }

SceneMaker driven_by_crank(double phi) {
  SceneMaker maker;
  maker.parameter("phi", phi).drive("M", "phi", rate, second);
  return maker;
}

std::string at(double phi) { return " at " + std::to_string(phi); }

// Peaucellier's inversor: arms of 60 and a rhombus of 20, so that |OB| |OC| = 3600 - 400. The crank
// of 25 about (25, 0) moves B on a circle through O; at its angle 0, B = (32, 24) and both arms are
// in line with their sides of the rhombus: |OB| = 60 - 20.
SceneMaker inversor(double phi) {
  return driven_by_crank(phi)
      .point("ground", "M", 25, 0)
      .point("ground", "O", 0, 0)
      .point("crank", "M", 0, 0)
      .point("crank", "B", 7, 24)
      .bar("upper_arm", {{"O", 0}, {"P", 60}})
      .bar("lower_arm", {{"O", 0}, {"Q", 60}})
      .bar("BP", {{"B", 0}, {"P", 20}})
      .bar("BQ", {{"B", 0}, {"Q", 20}})
      .bar("CP", {{"C", 0}, {"P", 20}})
      .bar("CQ", {{"C", 0}, {"Q", 20}});
}

Points inversor_crank(double phi) {
  return {{"O", {0, 0}}, {"M", {25, 0}}, {"B", JetPoint{25, 0} + at_angle(crank(phi), 7, 24)}};
}

NamedPlace peaucellier(double phi, int straight) {
  const Known known =
      assemblies_of(inversor_crank(phi), {pin("P", "O", 60, "B", 20, {"upper_arm", "BP"}),
                                          pin("Q", "O", 60, "B", 20, {"lower_arm", "BQ"}),
                                          pin("C", "P", 20, "Q", 20, {"CP", "CQ"})});
  return {"Peaucellier's inversor" + at(phi),
          inversor(phi),
          known,
          {{"C is on the line x = 64", straight,
            [](const Points& points) { return points.at("C").x - Jet(64); }},
           {"C is where an inversion of 3200 takes B", straight,
            [](const Points& points) {
              const JetPoint& b = points.at("B");
              return points.at("C").y - Jet(3200) / dot(b, b) * b.y;
            }},
           {"the rhombus is folded, C on B", straight,
            [](const Points& points) {
              const JetPoint apart = points.at("C") - points.at("B");
              return apart.x + apart.y;
            }}},
          1e-9};
}

// Hart's inversor: bars AB, CD of 50 and AD, BC of 30 with O, P, Q in their middles. The crank
// moves P on a circle through O; at its angle 0 |OP| = 25 + 15 and all bars are in line.
SceneMaker contraparallelogram(double phi) {
  return driven_by_crank(phi)
      .point("ground", "M", 25, 0)
      .point("ground", "O", 0, 0)
      .point("crank", "M", 0, 0)
      .point("crank", "P", 7, 24)
      .bar("AB", {{"O", 0}, {"A", 25}, {"B", -25}})
      .bar("AD", {{"P", 0}, {"A", 15}, {"D", -15}})
      .bar("BC", {{"B", 0}, {"Q", 15}, {"C", 30}})
      .bar("CD", {{"C", 0}, {"D", 50}});
}

NamedPlace hart(double phi, int straight) {
  Points driven = inversor_crank(phi);
  driven["P"] = driven["B"];
  driven.erase("B");
  return {"Hart's inversor" + at(phi),
          contraparallelogram(phi),
          assemblies_of(driven, {pin("A", "O", 25, "P", 15, {"AB", "AD"}), beside("B", "A", "O", 2),
                                 beside("D", "A", "P", 2), pin("C", "B", 30, "D", 50, {"BC", "CD"}),
                                 beside("Q", "B", "C", .5)}),
          {{"Q is on the line x = -8", straight,
            [](const Points& points) { return points.at("Q").x + Jet(8); }},
           {"O, P and Q are in line", straight,
            [](const Points& points) { return dot(points.at("P").turned(), points.at("Q")); }},
           {"ABCD is a parallelogram", straight,
            [](const Points& points) {
              const JetPoint open =
                  points.at("A") + points.at("C") - points.at("B") - points.at("D");
              return dot(open, open);
            }}},
          1e-9};
}

/// A four-bar with its crank about A, its rocker about D, and a point on its coupler: `along` BC
/// and `aside` of it, in parts of BC. In the crank's frame its end is at (x, y).
struct FourBar {
  double ax, ay, dx, dy;
  double x, y;
  double coupler, rocker;
  double along, aside;

  [[nodiscard]] SceneMaker scene(double phi) const {
    return driven_by_crank(phi)
        .point("ground", "M", ax, ay)
        .point("ground", "D", dx, dy)
        .point("crank", "M", 0, 0)
        .point("crank", "B", x, y)
        .point("coupler", "B", 0, 0)
        .point("coupler", "C", coupler, 0)
        .point("coupler", "P", along * coupler, aside * coupler)
        .bar("rocker", {{"D", 0}, {"C", rocker}});
  }
  [[nodiscard]] Known known(double phi) const {
    return assemblies_of({{"D", {dx, dy}}, {"B", JetPoint{ax, ay} + at_angle(crank(phi), x, y)}},
                         {pin("C", "B", coupler, "D", rocker, {"coupler", "rocker"}),
                          beside("P", "B", "C", along, aside)});
  }
};

/// In one assembly P has a known place, velocity and acceleration.
Theorem passes(const Jet& x, const Jet& y) {
  return {"P passes its known place with its known rates", 1, [=](const Points& points) {
            return Jet(
                apart(points.at("P").x, x, true) + apart(points.at("P").y, y, true) < 1e-9 ? 0 : 1);
          }};
}
/// In one assembly P has a known place, and any velocity.
Theorem passes(double x, double y) {
  return {"P passes its known place", 1, [=](const Points& points) {
            return Jet(std::hypot(points.at("P").x.value - x, points.at("P").y.value - y));
          }};
}

NamedPlace four_bar(const std::string& name, const FourBar& bars, double phi,
                    const std::vector<Theorem>& theorems) {
  return {name + at(phi), bars.scene(phi), bars.known(phi), theorems, 1e-9, is_close(phi)};
}

// Watt: the coupler of 4 stands across two parallel cranks of 3. Its middle passes the centre along
// y, without curvature: a straight tangent of third order.
const FourBar watt{-3, 2, 3, -2, 3, 0, 4, 3, .5, 0};

// Bernoulli's lemniscate: cranks of sqrt 2 about the foci (-1, 0) and (1, 0), coupler of 2.
const FourBar bernoulli{-1, 0, 1, 0, std::sqrt(2.0), 0, 2, std::sqrt(2.0), .5, 0};

Theorem on_lemniscate(int assemblies) {
  return {"the distances of P from the foci have the product 1", assemblies,
          [](const Points& points) {
            const JetPoint one = points.at("P") + JetPoint{1, 0};
            const JetPoint other = points.at("P") - JetPoint{1, 0};
            return dot(one, one) * dot(other, other) - Jet(1);
          }};
}
Theorem on_circle(int assemblies) {
  return {"P is at sqrt 2 from the centre", assemblies,
          [](const Points& points) { return dot(points.at("P"), points.at("P")) - Jet(2); }};
}

// Chebyshev: cranks of 5 at a distance of 4, a coupler of 2; its middle is at the height 4 in three
// places. Each has its own (x, y), with which it is at phi = 0 and exact.
FourBar chebyshev(double x, double y) { return {0, 0, 4, 0, x, y, 2, 5, .5, 0}; }

// Roberts: cranks of 10 at a distance of 12, and an isosceles coupler of 6 with sides of 10, whose
// point passes both pivots and the middle between.
FourBar roberts(double x, double y) { return {0, 0, 12, 0, x, y, 6, 10, .5, -std::sqrt(91.0) / 6}; }

// Scott Russell: a crank of 5 and a rod of 5 on either side of its end; X slides along the x-axis.
SceneMaker scott_russell_scene(double phi, double x, double y) {
  return driven_by_crank(phi)
      .point("ground", "M", 0, 0)
      .line("ground", "way", {0, 0}, {1, 0})
      .point("crank", "M", 0, 0)
      .point("crank", "B", x, y)
      .bar("rod", {{"B", 0}, {"X", 5}, {"Y", -5}})
      .point("piston", "X", 0, 0)
      .line("piston", "way", {0, 0}, {1, 0})
      .slide("S", "ground.way", "piston.way");
}

NamedPlace scott_russell(double phi, double x, double y) {
  const JetPoint b = at_angle(crank(phi), x, y);
  const JetPoint doubled = Jet(2) * b;
  const KnownAssembly straight{{{"X", {doubled.x, 0}}, {"Y", {0, doubled.y}}}, {{"S", doubled.x}}};
  const KnownAssembly folded{{{"X", {0, 0}}, {"Y", doubled}}, {{"S", 0}}};
  KnownAssembly both{{{"X", {0, 0}}, {"Y", doubled}}, {{"S", 0}}, false};
  const bool at_change = std::abs(b.x.value) < 1e-14;
  const Theorem is_straight{"Y is on the line x = 0", at_change ? 0 : 1,
                            [](const Points& points) { return points.at("Y").x; }};
  return {"Scott Russell's linkage" + at(phi),
          scott_russell_scene(phi, x, y),
          at_change ? Known{{both}, {}} : Known{{straight, folded}, {}},
          {is_straight},
          1e-9,
          is_close(phi)};
}

// Hart's A-frame: cranks of 4 about M and (4, 0), joined at 3 from their pivots by a bar of 2, hold
// two bars of 2, whose pin E goes up the middle wherever the frame stands upright. At angle 0 all
// lies on the ground.
NamedPlace a_frame(double phi) {
  SceneMaker scene = driven_by_crank(phi);
  scene.bar("ground", {{"M", 0}, {"O", 4}})
      .bar("crank", {{"M", 0}, {"F", 3}, {"C", 4}})
      .bar("leg", {{"O", 0}, {"G", 3}, {"D", 4}})
      .bar("FG", {{"F", 0}, {"G", 2}})
      .bar("CE", {{"C", 0}, {"E", 2}})
      .bar("DE", {{"D", 0}, {"E", 2}});
  const Points driven{
      {"O", {4, 0}}, {"F", at_angle(crank(phi), 3)}, {"C", at_angle(crank(phi), 4)}};
  return {"Hart's A-frame" + at(phi),
          scene,
          assemblies_of(driven,
                        {pin("G", "F", 2, "O", 3, {"FG", "leg"}), beside("D", "O", "G", 4.0 / 3),
                         pin("E", "C", 2, "D", 2, {"CE", "DE"})}),
          {{"E is in the middle", phi == 0 ? 0 : 2,
            [](const Points& points) { return points.at("E").x - Jet(2); }}},
          1e-9,
          is_close(phi)};
}

class NamedStraightLine : public testing::TestWithParam<NamedPlace> {};

TEST_P(NamedStraightLine, IsAnsweredAsKnown) { expect_as_known(GetParam()); }

std::vector<NamedPlace> places() {
  const double stretched = std::atan2(24, 7);  // from the x-axis to the crank's own vector
  std::vector<NamedPlace> result;
  for (const double phi : {0.0, 0.25}) {
    result.push_back(peaucellier(phi, 0));
  }
  for (const double phi : {-1e-3, -0.5, -stretched, -stretched - 1}) {
    result.push_back(peaucellier(phi, 2));
  }
  for (const double phi : {-0.25, 0.0}) {
    result.push_back(hart(phi, 0));
  }
  for (const double phi : {1e-3, 0.5, 1.0}) {
    result.push_back(hart(phi, 2));
  }
  const Jet still{0, 0, 0};
  result.push_back(four_bar("Watt's linkage", watt, 0,
                            {passes(still, {0, 3 * rate, 3 * second}), passes(0, 0)}));
  for (const double phi : {1e-3, -0.5, 1.0, 3.0}) {
    result.push_back(four_bar("Watt's linkage", watt, phi, {}));
  }
  result.push_back(four_bar("the lemniscate", bernoulli, 0, {passes(std::sqrt(2.0), 0)}));
  for (const double phi : {1e-3, -1e-2, 0.5, 1.0, 0.75 * pi, 3.0}) {
    result.push_back(four_bar("the lemniscate", bernoulli, phi, {on_lemniscate(1), on_circle(1)}));
  }
  result.push_back(four_bar(
      "Chebyshev's linkage in the middle", chebyshev(3, 4), 0,
      {passes(2, 4), {"P moves along x at 4 / 5 of its crank's end", 1, [](const Points& points) {
                        const JetPoint& p = points.at("P");
                        return Jet(std::abs(p.x.value - 2) + std::abs(p.y.value - 4) +
                                   std::abs(p.x.rate + 4 * rate) + std::abs(p.y.rate));
                      }}}));
  result.push_back(four_bar("Chebyshev's linkage at its end", chebyshev(0, 5), 0, {passes(0, 4)}));
  for (const double phi : {-1e-2, 0.0, 1e-3}) {
    result.push_back(four_bar("Chebyshev's linkage stretched", chebyshev(4, 3), phi,
                              phi == 0 ? std::vector{passes(4, 4)} : std::vector<Theorem>{}));
  }
  result.push_back(
      four_bar("Roberts' linkage in the middle", roberts(3, std::sqrt(91.0)), 0, {passes(6, 0)}));
  result.push_back(four_bar("Roberts' linkage at its pivot D", roberts(6, 8), 0, {passes(12, 0)}));
  result.push_back(four_bar("Roberts' linkage at its pivot A", roberts(10, 0),
                            std::atan2(8, 6) + 2 * std::asin(0.3), {passes(0, 0)}));
  for (const double phi : {0.0, 1e-3, -1e-2, 1.0, 4.0}) {
    result.push_back(scott_russell(phi, 0, 5));
    result.push_back(scott_russell(phi, 3, 4));
  }
  for (const double phi : {0.0, 0.5, 1.0, -1.25, 1.5}) {
    result.push_back(a_frame(phi));
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(Everywhere, NamedStraightLine, testing::ValuesIn(places()));

class NamedStraightLineSwept : public testing::TestWithParam<NamedSweep> {};

TEST_P(NamedStraightLineSwept, IsFollowedAsKnown) { expect_swept_as_known(GetParam()); }

std::vector<NamedSweep> sweeps() {
  const double between = std::atan2(-4, 6);  // Watt's pivots
  const double dead = std::acos(2 / std::sqrt(52.0));
  const double nearest = std::acos(0.95);  // Roberts' coupler and rocker in line
  const double farthest = std::acos(-0.05);
  return {
      {"Watt's linkage",
       watt.scene(0).sweep("phi", between - pi, between + pi, 0),
       {9, 24},
       {{{"birth"}, between - dead}, {{"fold"}, between + dead}},
       0,
       {}},
      {"the lemniscate",
       bernoulli.scene(0).sweep("phi", -1, 4, 0),
       {5, 6, 21},
       {{{"crossing"}, 0}, {{"crossing"}, pi}},
       2,
       {on_lemniscate(1), on_circle(1)}},
      {"Roberts' linkage",
       roberts(10, 0).scene(0).sweep("phi", 0, pi, 0),
       {9, 24},
       {{{"birth"}, nearest}, {{"fold"}, farthest}},
       0,
       {}},
      {"Scott Russell's linkage",
       scott_russell_scene(0, 5, 0).sweep("phi", -1, 5, 0),
       {7, 8, 25},
       {{{"crossing"}, pi / 2}, {{"crossing"}, 3 * pi / 2}},
       2,
       {{"Y is on the line x = 0", 1, [](const Points& points) { return points.at("Y").x; }},
        {"X stays", 1, [](const Points& points) { return points.at("X").x; }}}},
      {"Peaucellier's inversor",
       inversor(0).sweep("phi", -2, -0.125, 0),
       {6},
       {},
       4,
       {{"C is on the line x = 64", 2,
         [](const Points& points) { return points.at("C").x - Jet(64); }}}},
      {"Hart's inversor",
       contraparallelogram(0).sweep("phi", 0.125, 1, 0),
       {6, 17},
       {},
       4,
       {{"Q is on the line x = -8", 2,
         [](const Points& points) { return points.at("Q").x + Jet(8); }}}},
      {"Peaucellier's inversor up to its stretched arms",
       inversor(0).sweep("phi", -0.75, 0.25, 0),
       {4},
       {{{"fold", "fold"}, 0}},
       0,
       {}},
      {"Hart's inversor from its position in line",
       contraparallelogram(0).sweep("phi", -0.25, 0.75, 0),
       {4, 5},
       {{{"birth", "birth"}, 0}},
       0,
       {}},
  };
}
INSTANTIATE_TEST_SUITE_P(Along, NamedStraightLineSwept, testing::ValuesIn(sweeps()));

}  // namespace
}  // namespace assur::test::named_straight_lines_test
