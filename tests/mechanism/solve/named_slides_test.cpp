// Law: well-known mechanisms with slides have the configurations that are known of them, at their
// special positions and beside them.
#include <gtest/gtest.h>

#include "named_linkages.hpp"

namespace assur::test::named_slides_test {
namespace {

const double pi = std::acos(-1.0);
constexpr double rate = 2;
constexpr double second = 1;

std::string at(double place) { return " at " + std::to_string(place); }

/// A scene with a crank about M, whose pin B is at (x, y) where phi is zero.
SceneMaker with_crank(double phi, double mx, double my, double x, double y) {
  SceneMaker maker;
  return maker.parameter("phi", phi)
      .drive("M", "phi", rate, second)
      .point("ground", "M", mx, my)
      .point("crank", "M", 0, 0)
      .point("crank", "B", x, y);
}

/// A scene with a carriage that is driven along the x-axis.
SceneMaker with_carriage(double s) {
  SceneMaker maker;
  return maker.parameter("s", s)
      .drive("drive", "s", rate, second)
      .line("ground", "way", {0, 0}, {1, 0})
      .line("carriage", "way", {0, 0}, {1, 0})
      .point("carriage", "S", 0, 0)
      .slide("drive", "ground.way", "carriage.way");
}

// The Scotch yoke: a pin on a crank of 5 in the upright slot of a yoke that slides along x, so that
// the yoke is at 5 cos phi and the pin at 5 sin phi in the slot.
SceneMaker yoke_scene(double phi) {
  return with_crank(phi, 0, 0, 5, 0)
      .line("ground", "way", {0, 0}, {1, 0})
      .line("yoke", "way", {0, 0}, {1, 0})
      .line("yoke", "slot", {0, 0}, {0, 1})
      .point("yoke", "Y", 0, 7)
      .slide("S", "ground.way", "yoke.way")
      .slot("T", "yoke.slot", "crank.B");
}

NamedPlace scotch_yoke(double phi) {
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  const Jet x{5 * c, -5 * s * rate, -5 * c * rate * rate - 5 * s * second};
  const Jet y{5 * s, 5 * c * rate, -5 * s * rate * rate + 5 * c * second};
  return {"the Scotch yoke" + at(phi),
          yoke_scene(phi),
          {{{{{"B", {x, y}}, {"Y", {x, 7}}}, {{"S", x}, {"T", y}}}}, {}},
          {},
          1e-12};
}

// The elliptic trammel: a bar of 5 with its ends on the axes. P, at 2 from the end S on the x-axis,
// is on an ellipse with the axes 3 and 2; Q, at 7, on one with the axes 2 and 7.
SceneMaker trammel_scene(double s) {
  return with_carriage(s)
      .bar("bar", {{"S", 0}, {"P", 2}, {"Y", 5}, {"Q", 7}})
      .line("ground", "upright", {0, 0}, {0, 1})
      .slot("T", "ground.upright", "bar.Y");
}

Theorem on_ellipse(const std::string& point, double a, double b, int assemblies) {
  return {point + " is on its ellipse", assemblies, [=](const Points& points) {
            const JetPoint& p = points.at(point);
            return p.x * p.x / Jet(a * a) + p.y * p.y / Jet(b * b) - Jet(1);
          }};
}

NamedPlace trammel(double s) {
  Known known;
  const Jet x{s, rate, second};
  const double under = 25 - s * s;
  if (under == 0) {
    known.assemblies.push_back(
        {{{"S", {x, 0}}, {"Y", {0, 0}}, {"P", {.6 * s, 0}}}, {{"drive", s}, {"T", 0}}, false});
  } else if (under > 0) {
    for (const double sign : {1.0, -1.0}) {
      const double y = sign * std::sqrt(under);
      const double v = -s * rate / y;  // from x^2 + y^2 = 25
      const double a = -(rate * rate + s * second + v * v) / y;
      known.assemblies.push_back({{{"S", {x, 0}},
                                   {"Y", {0, {y, v, a}}},
                                   {"P", {Jet(.6) * x, Jet(.4) * Jet(y, v, a)}},
                                   {"Q", {Jet(-.4) * x, Jet(1.4) * Jet(y, v, a)}}},
                                  {{"drive", x}, {"T", {y, v, a}}}});
    }
  }
  const int assemblies = under > 0 ? 2 : 0;
  return {"the elliptic trammel" + at(s),
          trammel_scene(s),
          known,
          {on_ellipse("P", 3, 2, assemblies), on_ellipse("Q", 2, 7, assemblies)},
          1e-9};
}

// A quick return: the pin of a crank about M is in the slot of a rocker about O. The end C of the
// rocker is 45 from O, towards the pin or away from it.
SceneMaker quick_return_scene(double phi, double distance, double x, double y) {
  return with_crank(phi, 0, distance, x, y)
      .point("ground", "O", 0, 0)
      .point("rocker", "O", 0, 0)
      .point("rocker", "C", 45, 0)
      .line("rocker", "slot", {0, 0}, {1, 0})
      .slot("T", "rocker.slot", "crank.B");
}

/// If the crank is as long as the distance between the pivots, its pin goes through O.
NamedPlace quick_return(double phi, double distance, double x, double y,
                        const std::vector<Theorem>& theorems = {}) {
  const JetPoint b = JetPoint{0, distance} + at_angle({phi, rate, second}, x, y);
  const Jet square = dot(b, b);
  Known known;
  if (square.value < 1e-20) {
    known.families.push_back({1, {"T", "rocker"}});
  } else {
    const Jet reach = sqrt(square);
    for (const Jet& sense : {Jet(1), Jet(-1)}) {
      known.assemblies.push_back(
          {{{"B", b}, {"C", sense * Jet(45) / reach * b}}, {{"T", sense * reach}}});
    }
  }
  return {"a quick return of " + std::to_string(distance) + at(phi),
          quick_return_scene(phi, distance, x, y), known, theorems, 1e-9};
}

/// The rocker stands still.
const Theorem stands{"the rocker stands", 2, [](const Points& points) {
                       const JetPoint& c = points.at("C");
                       return Jet(std::hypot(c.x.rate, c.y.rate));
                     }};

/// If the distance between the pivots is the crank's length, 25, the rocker turns half as fast: the
/// square of its sine is (1 + the crank's sine) / 2. Only the rocker towards the pin counts.
const Theorem turns_half{
    "the rocker, towards the pin, turns half as fast", 1, [](const Points& points) {
      const JetPoint& b = points.at("B");
      const JetPoint& c = points.at("C");
      const Jet crank = Jet(1 / 25.0) * (b.y - Jet(25));
      const Jet rocker = Jet(1 / 45.0) * c.y;
      return dot(c, b).value > 0 ? rocker * rocker - Jet(.5) * (Jet(1) + crank) : Jet(1);
    }};

// A lift of three pairs of scissors, bars of 10. At 6 between the feet every pair is 8 high, and
// may be folded up or down.
SceneMaker lift_scene(double s) {
  SceneMaker maker = with_carriage(s);
  maker.point("ground", "L0", 0, 0);
  std::string right = "S";
  for (int stage = 1; stage <= 3; ++stage) {
    const std::string above = std::to_string(stage);
    const std::string below = std::to_string(stage - 1);
    maker.bar("rising" + above, {{"L" + below, 0}, {"M" + above, 5}, {"R" + above, 10}})
        .bar("falling" + above, {{right, 0}, {"M" + above, 5}, {"L" + above, 10}});
    right = "R" + above;
  }
  return maker;
}

NamedPlace lift(double s) {
  const Jet x{s, rate, second};
  const Jet under = Jet(100) - x * x;
  Known known;
  if (s == 0) {
    known.families.push_back({1, {"rising1", "falling1"}});
  } else if (under.value >= 0) {
    const bool is_flat = under.value == 0;
    const Jet height = is_flat ? Jet(0) : sqrt(under);
    for (int signs = 0; signs < (is_flat ? 1 : 8); ++signs) {
      KnownAssembly assembly{{{"S", {x, 0}}}, {{"drive", x}}, !is_flat};
      Jet level = 0;
      for (int stage = 1; stage <= 3; ++stage) {
        const Jet next = level + Jet((signs >> (stage - 1)) % 2 == 0 ? 1 : -1) * height;
        assembly.points["M" + std::to_string(stage)] = {Jet(.5) * x, Jet(.5) * (level + next)};
        assembly.points["L" + std::to_string(stage)] = {0, next};
        assembly.points["R" + std::to_string(stage)] = {x, next};
        level = next;
      }
      known.assemblies.push_back(assembly);
    }
  }
  return {"a scissor lift" + at(s), lift_scene(s), known, {}, 1e-8, std::abs(s) < 0.2};
}

// Oldham's coupling between shafts about M and (2, 0): the middle disc is where its perpendicular
// slots go through both centres, and turns as the shafts do.
NamedPlace coupling(double phi) {
  SceneMaker scene = with_crank(phi, 0, 0, 3, 0);
  scene.point("ground", "D", 2, 0)
      .line("crank", "slot", {0, 0}, {1, 0})
      .line("disc", "slot", {0, 0}, {1, 0})
      .line("disc", "groove", {0, 0}, {0, 1})
      .point("disc", "P", 0, 0)
      .line("shaft", "groove", {0, 0}, {0, 1})
      .point("shaft", "D", 0, 0)
      .point("shaft", "Q", 3, 0)
      .slide("S", "crank.slot", "disc.slot")
      .slide("T", "disc.groove", "shaft.groove");
  const Jet angle{phi, rate, second};
  const Jet in_slot = Jet(2) * cos(angle);
  return {"Oldham's coupling" + at(phi),
          scene,
          {{{{{"P", in_slot * at_angle(angle, 1)}, {"Q", JetPoint{2, 0} + at_angle(angle, 3)}},
             {{"S", in_slot}, {"T", Jet(-2) * sin(angle)}}}},
           {}},
          {},
          1e-12};
}

// A triangle in a circle of radius 2 through the crossing of three slots at 60 degrees: its corners
// stay in them while the circle rolls in one of radius 4. With A at s the circle's centre is at
// s / 2 along the first slot, above or below it. One of the slots is redundant.
NamedPlace three_slots(double s) {
  const double half = 0.5;
  const double high = std::sqrt(3.0) / 2;
  SceneMaker scene;
  scene.parameter("s", s)
      .drive("A in its slot", "s", rate, second)
      .line("ground", "along", {0, 0}, {1, 0})
      .line("ground", "rising", {0, 0}, {half, high})
      .line("ground", "falling", {0, 0}, {-half, high})
      .point("triangle", "A", 2, 0)
      .point("triangle", "B", -1, 2 * high)
      .point("triangle", "C", -1, -2 * high)
      .slot("A in its slot", "ground.along", "triangle.A")
      .slot("B in its slot", "ground.rising", "triangle.B")
      .slot("C in its slot", "ground.falling", "triangle.C");
  const Jet x{s / 2, rate / 2, second / 2};
  const Jet under = Jet(4) - x * x;
  Known known;
  for (const double sign : {1.0, -1.0}) {
    const Jet y = under.value == 0 ? Jet(0) : Jet(sign) * sqrt(under);
    const JetPoint middle{x, y};
    const JetPoint arm = JetPoint{Jet(2) * x, 0} - middle;
    known.assemblies.push_back({{{"B", middle + Jet(-half) * arm + Jet(high) * arm.turned()},
                                 {"C", middle + Jet(-half) * arm + Jet(-high) * arm.turned()}},
                                {},
                                under.value != 0});
    if (under.value == 0) {
      break;
    }
  }
  return {"a triangle in three slots" + at(s), scene, known, {}, 1e-9, is_close(s - 4)};
}

class NamedSlide : public testing::TestWithParam<NamedPlace> {};

TEST_P(NamedSlide, IsAnsweredAsKnown) { expect_as_known(GetParam()); }

std::vector<NamedPlace> places() {
  std::vector<NamedPlace> result;
  for (const double phi : {0.0, 1e-3, 0.5, pi / 2, 2.0, pi, 4.5}) {
    result.push_back(scotch_yoke(phi));
  }
  for (const double s : {-5.0, -4.999, -3.0, 0.0, 1e-3, 4.0, 4.99, 5.0, 5.25}) {
    result.push_back(trammel(s));
  }
  for (const double s : {-6.0, -0.125, 0.0, 0.25, 1.0, 6.0, 8.0, 9.99, 10.0, 11.0}) {
    result.push_back(lift(s));
  }
  // The crank of 15 at a distance of 25 stands across the rocker where its pin is at (12, 16).
  result.push_back(quick_return(0, 25, 12, -9, {stands}));
  for (const double phi : {-1e-3, 0.5, 2.0, 4.0}) {
    result.push_back(quick_return(phi, 25, 12, -9));
  }
  for (const double phi : {0.0, 1.5, 3.0, 4.5}) {  // Whitworth's: the rocker goes all around
    result.push_back(quick_return(phi, 7, 25, 0));
  }
  for (const double phi : {0.0, 1e-3, 0.75, pi / 2, 3.0}) {
    result.push_back(coupling(phi));
  }
  for (const double s : {-4.0, -3.0, 0.0, 1e-6, 2.0, 3.999, 4.0}) {
    result.push_back(three_slots(s));
  }
  // The pin of the crank of 25 goes through O.
  result.push_back(quick_return(0, 25, 0, -25));
  for (const double phi : {-1e-3, 0.01, 0.5, 3.0}) {
    result.push_back(quick_return(phi, 25, 0, -25, {turns_half}));
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(Everywhere, NamedSlide, testing::ValuesIn(places()));

class NamedSlideSwept : public testing::TestWithParam<NamedSweep> {};

TEST_P(NamedSlideSwept, IsFollowedAsKnown) { expect_swept_as_known(GetParam()); }

std::vector<NamedSweep> sweeps() {
  // The rocker's angle is half the crank's and does not jump where the pin goes through O: with phi
  // the angle of the crank from the x-axis, it is phi / 2 + 45 degrees, or opposite.
  const auto follows_half = [](double sense) {
    return Theorem{"the rocker turns half as fast through O", 1, [=](const Points& points) {
                     const JetPoint crank = points.at("B") - JetPoint{0, 25};
                     // phi lies in (-pi, pi]; the pin is in O where phi is -pi / 2.
                     const double phi = std::atan2(crank.y.value, crank.x.value);
                     const JetPoint half = at_angle(phi / 2 + pi / 4, 45);
                     const JetPoint off = points.at("C") - Jet(sense) * half;
                     return Jet(std::hypot(off.x.value, off.y.value));
                   }};
  };
  const auto stage_height = [](const std::string& name, int assemblies) {
    return Theorem{name + " is at the known height", assemblies, [=](const Points& points) {
                     const Jet& x = points.at("S").x;
                     return points.at(name).y - Jet(3) * sqrt(Jet(100) - x * x);
                   }};
  };
  return {
      {"the Scotch yoke",
       yoke_scene(0).sweep("phi", -1, 6, 0),
       {2, 9, 64},
       {},
       1,
       {{"Y is above the pin", 1,
         [](const Points& points) { return points.at("Y").x - points.at("B").x; }}}},
      {"the elliptic trammel",
       trammel_scene(0).sweep("s", -6, 6, 0),
       {4, 13, 24},
       {{{"birth"}, -5}, {{"fold"}, 5}},
       0,
       {on_ellipse("P", 3, 2, 2), on_ellipse("Q", 2, 7, 2)}},
      {"a quick return",
       quick_return_scene(0, 25, 12, -9).sweep("phi", -3, 4, 0),
       {4, 9},
       {},
       2,
       {}},
      {"a quick return through O between two steps",
       quick_return_scene(0, 25, 25, 0).sweep("phi", -3, -.25, 0),
       {4, 24},
       {},
       2,
       {follows_half(1), follows_half(-1)}},
      {"a quick return through O on a step",
       quick_return_scene(0, 25, 0, -25).sweep("phi", -1, 1, 0),
       {3, 9},
       {{{"degenerate"}, 0}},
       2,
       {follows_half(1), follows_half(-1)}},
      {"a scissor lift", lift_scene(0).sweep("s", 1, 9, 0), {5}, {}, 8, {stage_height("R3", 1)}},
      {"a scissor lift folded to nothing on a step",
       lift_scene(0).sweep("s", -4, 4, 0),
       {3},
       {{{"degenerate"}, 0}},
       8,
       {stage_height("R3", 1)}},
      {"a scissor lift until it is flat",
       lift_scene(0).sweep("s", 4, 11, 0),
       {5},
       {{{"fold", "fold", "fold", "fold"}, 10}},
       0,
       {stage_height("R3", 1)}},
  };
}
INSTANTIATE_TEST_SUITE_P(Along, NamedSlideSwept, testing::ValuesIn(sweeps()));

}  // namespace
}  // namespace assur::test::named_slides_test
