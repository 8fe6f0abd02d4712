// Families of tetrads that each approach one failure as a distance goes to zero.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "random_geometry.hpp"
#include "truth.hpp"

namespace assur::stability {

/// A regular family keeps the condition number of J below this at every distance, so a failure
/// there is the method's and not the group's.
inline constexpr double regular_condition = 50;
inline constexpr double any_condition = std::numeric_limits<double>::infinity();

/// An unknown angle approaches pi.
struct HalfAngle {
  using Model = Model01;
  static constexpr const char* name = "half-angle";
  static constexpr const char* title = "an angle comes to pi";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    g.q.theta_BCG = {-cos(distance), sin(distance)};
    close_loops(g);
    return g;
  }
};

/// The lines BC and ED become parallel: their special point goes to infinity.
struct SpecialPoint {
  using Model = Model01;
  static constexpr const char* name = "special-point";
  static constexpr const char* title = "BC and ED become parallel";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    g.q.theta_EDF = turned(g.q.theta_BCG, direction_of(distance));
    close_loops(g);
    return g;
  }
};

/// Two configurations meet. GF is rotated by the square root of the distance from where det J = 0,
/// so that a length must change by about the distance for the two to meet.
struct Fold {
  using Model = Model01;
  static constexpr const char* name = "fold";
  static constexpr const char* title = "two configurations meet";
  static constexpr double largest_condition = any_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    close_loops(g);
    // det J = 0 is (CD x BC) (GF x EF) = (CD x ED) (GF x BG), and EF = BG + GF - EB as the loop
    // closes, so GF must be along (CD x BC) (BG - EB) - (CD x ED) BG.
    const Direction<Real>& along = g.q.theta_CD;
    const Direction<Real>& BCG = g.q.theta_BCG;
    const Real BC = g.d.BC * (along.cos * BCG.sin - along.sin * BCG.cos);
    const Real ED = g.d.ED * (along.cos * g.q.theta_EDF.sin - along.sin * g.q.theta_EDF.cos);
    const Real BG_x = BCG.cos * g.d.x_G_BCG - BCG.sin * g.d.y_G_BCG;
    const Real BG_y = BCG.cos * g.d.y_G_BCG + BCG.sin * g.d.x_G_BCG;
    const Real x = BC * (BG_x - (g.u.x_E - g.u.x_B)) - ED * BG_x;
    const Real y = BC * (BG_y - (g.u.y_E - g.u.y_B)) - ED * BG_y;
    const Real length = sqrt(x * x + y * y);
    g.q.theta_GF =
        turned(Direction<Real>{x / length, y / length}, direction_of(Real(sqrt(distance))));
    close_loops(g);
    return g;
  }
};

/// BCDE is a parallelogram that comes to lie flat, where a second branch crosses. Its base is a
/// Pythagorean multiple, so that doubles hold the parallelogram exactly.
struct Crossing {
  using Model = Model01;
  static constexpr const char* name = "crossing";
  static constexpr const char* title = "a parallelogram falls flat";
  static constexpr double largest_condition = any_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    constexpr std::array<std::array<int, 3>, 5> triples = {
        {{3, 4, 5}, {12, 5, 13}, {8, -15, 17}, {-7, 24, 25}, {-20, -21, 29}}};
    const std::array<int, 3>& triple =
        triples[static_cast<std::size_t>(static_cast<int>(random.between(0, 5)))];
    const Real unit = Real(static_cast<int>(random.between(64, 256))) / Real(128 * 8);
    Geometry<Model, Real> g = random_model_01(random);
    g.u = {Real(0), Real(0), unit * triple[0], unit * triple[1]};
    g.d.CD = unit * triple[2];
    g.d.ED = g.d.BC;
    g.q.theta_CD = {Real(triple[0]) / Real(triple[2]), Real(triple[1]) / Real(triple[2])};
    g.q.theta_BCG = turned(g.q.theta_CD, direction_of(distance));
    g.q.theta_EDF = g.q.theta_BCG;
    point_GF(g);
    return g;
  }

 private:
  /// Gives the bar GF the length and the direction that close its loop.
  static void point_GF(Geometry<Model, Real>& g) {
    g.d.GF = Real(0);
    Vector<Real, Model::equation_count> f;
    Model::residual(g.d, g.u, g.q, f);
    g.d.GF = sqrt(f(2) * f(2) + f(3) * f(3));
    g.q.theta_GF = {-f(2) / g.d.GF, -f(3) / g.d.GF};
  }
};

/// Congruent ternary links on equal bars have a self-motion; every length and angle differs from
/// this case by about the distance.
struct SelfMotion {
  using Model = Model01;
  static constexpr const char* name = "self-motion";
  static constexpr const char* title = "equal links on equal bars";
  static constexpr double largest_condition = any_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    const auto off = [&] { return distance * random.between(0.2, 0.6); };
    g.d.ED = g.d.BC * (Real(1) + off());
    g.d.GF = g.d.CD * (Real(1) + off());
    g.q.theta_EDF = turned(g.q.theta_BCG, direction_of(off()));
    g.q.theta_GF = turned(g.q.theta_CD, direction_of(off()));
    close_loops(g);
    return g;
  }
};

/// The two slides of link CD become parallel.
struct ParallelSlides {
  using Model = Model04;
  static constexpr const char* name = "parallel-slides";
  static constexpr const char* title = "slides of one link, parallel";
  static constexpr double largest_condition = any_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_04(random);
    g.d.psi_D_CD = direction_of(distance);
    close_loops(g);
    return g;
  }
};

/// The length of the bar CD goes to zero.
struct ZeroBar {
  using Model = Model01;
  static constexpr const char* name = "zero-bar";
  static constexpr const char* title = "bar CD loses its length";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    g.d.CD = distance;
    close_loops(g);
    return g;
  }
};

/// The length of the side BC of a ternary link goes to zero.
struct ZeroSide {
  using Model = Model01;
  static constexpr const char* name = "zero-side";
  static constexpr const char* title = "side BC loses its length";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    g.d.BC = distance;
    close_loops(g);
    return g;
  }
};

/// The group lies at one over the distance from the origin.
struct FarAway {
  using Model = Model01;
  static constexpr const char* name = "far-away";
  static constexpr const char* title = "origin 1/distance away";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_01(random);
    close_loops(g);
    const Direction<Real> toward = random.direction();
    g.u.x_B += toward.cos / distance;
    g.u.x_E += toward.cos / distance;
    g.u.y_B += toward.sin / distance;
    g.u.y_E += toward.sin / distance;
    return g;
  }
};

/// The unit of length changes by the factor `distance`; unknowns are angles and displacements.
struct Units {
  using Model = Model04;
  static constexpr const char* name = "units";
  static constexpr const char* title = "lengths times the distance";
  static constexpr double largest_condition = regular_condition;
  static Geometry<Model, Real> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_04(random);
    close_loops(g);
    const auto scale = [&](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Real>) {
        member *= distance;
      }
    };
    std::apply([&](auto&... member) { (scale(member), ...); }, g.d.members());
    std::apply([&](auto&... member) { (scale(member), ...); }, g.u.members());
    std::apply([&](auto&... member) { (scale(member), ...); }, g.q.members());
    g.u_rate *= distance;
    g.u_second_rate *= distance;
    g.size = distance;
    return g;
  }
};

using Families = std::tuple<HalfAngle, SpecialPoint, Fold, Crossing, SelfMotion, ParallelSlides,
                            ZeroBar, ZeroSide, FarAway, Units>;

/// 1, 1e-1 ... 1e-14; for the units 1e6 ... 1e-6.
template <typename Family>
[[nodiscard]] std::vector<double> distances() {
  constexpr bool units = std::is_same_v<Family, Units>;
  std::vector<double> list;
  for (int exponent = units ? 6 : 0; exponent >= (units ? -6 : -14); --exponent) {
    list.push_back(std::pow(10.0, exponent));
  }
  return list;
}

/// A member of a family: the input of the methods in double, and the reference in 50 digits.
template <typename Model>
struct Member {
  Geometry<Model, double> given;  ///< q is the assembled configuration of (d, u), rounded once
  Truth<Model> truth;             ///< at the assembled configuration of (d, u)
  Truth<Model> truth_as_given;    ///< at `given.q` as it stands, taken for exact
};

/// Members with the same number use the same random numbers at all distances.
inline constexpr unsigned seed = 16180;
inline constexpr int members_per_distance = 20;

template <typename Family>
[[nodiscard]] Member<typename Family::Model> make_member(int number, double distance) {
  using Model = typename Family::Model;
  RandomNumbers random(seed + static_cast<unsigned>(number));
  for (;;) {
    const Geometry<Model, Real> drawn = Family::draw(random, Real(distance));
    Geometry<Model, Real> exact = converted<Real>(converted<double>(drawn));
    exact.q = drawn.q;
    if (!assemble(exact)) {
      continue;
    }
    const Geometry<Model, double> given = converted<double>(exact);
    Member<Model> member{given, derivatives(exact), derivatives(converted<Real>(given))};
    if (member.truth.condition < Family::largest_condition) {
      return member;
    }
  }
}

}  // namespace assur::stability
