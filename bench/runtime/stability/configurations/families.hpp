// Families of tetrads whose configurations, though not their derivatives, come near a failure.
#pragma once

#include <array>
#include <assur/tetrad/model_12.hpp>
#include <cmath>
#include <vector>

#include "stability/random_geometry.hpp"

namespace assur::stability {

using tetrad::Model12;

/// A group, and the configurations that are known by its construction.
template <typename Model>
struct KnownGroup {
  typename Model::template Dimensions<Real> d;
  typename Model::template Inputs<Real> u;
  std::vector<typename Model::template Configuration<Real>> known;
};

/// The group that exact arithmetic solves: the member itself, unless the family replaces it.
template <typename Model>
struct AskedAsItIs {
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;

  template <typename Scalar>
  static Dimensions<Scalar> dimensions(const Dimensions<Scalar>& d) {
    return d;
  }
  template <typename Scalar>
  static Inputs<Scalar> inputs(const Inputs<Scalar>& u) {
    return u;
  }
  static Configuration<Real> answer(const Configuration<Real>& q) { return q; }
  static constexpr int roots_at_infinity = 0;  ///< of the final polynomial, at distance 0
};

/// Two configurations come to share theta_BCG, the unknown of the final polynomial; they differ in
/// theta_EDF. At distance 0 the root is double, and both configurations are regular: every length
/// is a rational number there, scaled so that doubles hold the group exactly.
///
/// If theta_BCG is the same, E sees C and D, and G and F, under one angle a or -a. So two
/// triangles, of sides EC, ED, CD and EG, EF, GF, have cos a in common. The first has integer
/// sides. The second, with EG = t EF and GF = (1 + l t) EF, is the line of slope l through a
/// rational point of t^2 + 1 - 2 t cos a = (GF/EF)^2.
struct SharedUnknown {
  using Model = Model01;
  static constexpr const char* name = "shared-unknown";
  static constexpr const char* title = "Two configurations share the final unknown";
  static constexpr const char* kind = "RRR-RRR";

  static KnownGroup<Model> draw(RandomNumbers& random, const Real& distance) {
    const Links links = drawn_links(random);
    const Direction<Real> turn = links.turn;
    const std::array<Direction<Real>, 2> BCG = {turn, turned(turn, direction_of(distance))};
    const Real sine = sqrt(Real(1) - links.cosine * links.cosine);
    const std::array<Direction<Real>, 2> EDF = {turned(turn, Direction<Real>{links.cosine, sine}),
                                                turned(turn, Direction<Real>{links.cosine, -sine})};
    // |P - E| = CD and |Q - E| = GF in both configurations: two linear equations for E, from B.
    std::array<Point, 2> P;
    std::array<Point, 2> Q;
    for (std::size_t i = 0; i < 2; ++i) {
      P[i] = rotated({links.d.BC, Real(0)}, BCG[i]) - rotated({links.d.ED, Real(0)}, EDF[i]);
      Q[i] = rotated({links.d.x_G_BCG, links.d.y_G_BCG}, BCG[i]) -
             rotated({links.d.x_F_EDF, links.d.y_F_EDF}, EDF[i]);
    }
    const Point p = P[0] - P[1];
    const Point q = Q[0] - Q[1];
    const Real p_E = (P[0].squaredNorm() - P[1].squaredNorm()) / Real(2);
    const Real q_E = (Q[0].squaredNorm() - Q[1].squaredNorm()) / Real(2);
    const Real cross = p.x() * q.y() - p.y() * q.x();
    const Point E((p_E * q.y() - q_E * p.y()) / cross, (q_E * p.x() - p_E * q.x()) / cross);

    KnownGroup<Model> group;
    group.d = links.d;
    group.d.CD = (P[0] - E).norm();
    group.d.GF = (Q[0] - E).norm();
    group.u = {links.B.x(), links.B.y(), links.B.x() + E.x(), links.B.y() + E.y()};
    for (std::size_t i = 0; i < 2; ++i) {
      const Point CD = (E - P[i]) / group.d.CD;
      const Point GF = (E - Q[i]) / group.d.GF;
      group.known.push_back({BCG[i], EDF[i], {CD.x(), CD.y()}, {GF.x(), GF.y()}});
    }
    return group;
  }

  /// The same group with its ternary links exchanged: then theta_EDF is the final unknown, which
  /// the two configurations do not share.
  struct Asked : AskedAsItIs<Model> {
    template <typename Scalar>
    static Model::Dimensions<Scalar> dimensions(const Model::Dimensions<Scalar>& d) {
      return {d.ED, d.x_F_EDF, d.y_F_EDF, d.BC, d.x_G_BCG, d.y_G_BCG, d.CD, d.GF};
    }
    template <typename Scalar>
    static Model::Inputs<Scalar> inputs(const Model::Inputs<Scalar>& u) {
      return {u.x_E, u.y_E, u.x_B, u.y_B};
    }
    static Model::Configuration<Real> answer(const Model::Configuration<Real>& q) {
      return {q.theta_EDF,
              q.theta_BCG,
              {-q.theta_CD.cos, -q.theta_CD.sin},
              {-q.theta_GF.cos, -q.theta_GF.sin}};
    }
  };

 private:
  using Point = Eigen::Matrix<Real, 2, 1>;
  struct Links {
    Model::Dimensions<Real> d;  ///< CD and GF are still to be found
    Direction<Real> turn;       ///< of BCG where both share it
    Real cosine;                ///< of the angle a
    Point B;
  };

  static Point rotated(const Point& p, const Direction<Real>& by) {
    return {by.cos * p.x() - by.sin * p.y(), by.sin * p.x() + by.cos * p.y()};
  }
  static int whole(RandomNumbers& random, int low, int high) {
    return static_cast<int>(random.between(low, high + 1));
  }

  static Links drawn_links(RandomNumbers& random) {
    constexpr std::array<std::array<int, 3>, 4> triples = {
        {{3, 4, 5}, {12, -5, 13}, {-4, 3, 5}, {8, 15, 17}}};
    constexpr std::array<std::array<int, 2>, 6> slopes = {
        {{1, 2}, {-1, 2}, {1, 3}, {-1, 3}, {2, 3}, {-2, 3}}};
    for (;;) {
      const int EC = whole(random, 2, 9) * (whole(random, 0, 1) == 0 ? 1 : -1);
      const int ED = whole(random, 2, 9);
      const int CD = whole(random, 2, 9);
      const auto [a, b] = slopes[static_cast<std::size_t>(whole(random, 0, 5))];
      const auto of_F = triples[static_cast<std::size_t>(whole(random, 0, 3))];
      const auto of_turn = triples[static_cast<std::size_t>(whole(random, 0, 3))];
      const int size_of_F = whole(random, 1, 2);
      const int BC = whole(random, 2, 9);
      const Point B(Real(whole(random, -64, 64)) / Real(64),
                    Real(whole(random, -64, 64)) / Real(64));
      // cos a = p/q and t = 2b (a q + p b) / (q (b^2 - a^2)).
      const int p = EC * EC + ED * ED - CD * CD;
      const int q = 2 * EC * ED;
      const int denominator = q * (b * b - a * a);
      const int numerator = 2 * b * (a * q + p * b);
      const double t = static_cast<double>(numerator) / denominator;
      const double GF = 1 + t * a / b;
      // Where B and E coincide, the group can rotate about them.
      if (std::abs(EC) == BC || std::abs(static_cast<double>(p) / q) > 0.9 || std::abs(t) < 0.3 ||
          std::abs(t) > 3 || std::abs(GF) < 0.2) {
        continue;
      }
      // All lengths times this are integers; a power of two brings them near one.
      const int whole_unit = denominator * of_turn[2];
      const Real unit =
          Real(whole_unit) /
          Real(std::exp2(std::ceil(std::log2(6.0 * std::abs(static_cast<double>(whole_unit))))));
      const Real x_F = unit * Real(size_of_F * of_F[0]);
      const Real y_F = unit * Real(size_of_F * of_F[1]);
      const Real ratio = Real(numerator) / Real(denominator);
      Links links;
      links.d.BC = abs(unit) * Real(BC);
      links.d.ED = unit * Real(ED);
      links.d.x_F_EDF = x_F;
      links.d.y_F_EDF = y_F;
      // From E, along the axis of the two configurations, C is at EC and G at t F.
      const Real x_B = unit * Real(EC) - links.d.BC;
      links.d.x_G_BCG = ratio * x_F - x_B;
      links.d.y_G_BCG = ratio * y_F;
      links.turn = {Real(of_turn[0]) / Real(of_turn[2]), Real(of_turn[1]) / Real(of_turn[2])};
      links.cosine = Real(p) / Real(q);
      links.B = B;
      return links;
    }
  }
};

/// The two slides of link BCG become parallel, and two of four configurations run to infinity: the
/// root of the final polynomial stays where it is, but the coefficient of s_B, which is then found
/// from it, goes to zero with the distance. The other two stay; one of them is known.
struct SomeToInfinity {
  using Model = Model12;
  static constexpr const char* name = "some-to-infinity";
  static constexpr const char* title = "Two of four run to infinity";
  static constexpr const char* kind = "PPR-RRP";

  static KnownGroup<Model> draw(RandomNumbers& random, const Real& distance) {
    KnownGroup<Model> group;
    group.d = {random.coordinate(), direction_of(distance), random.coordinate(),
               random.length(),     random.coordinate(),    random.coordinate(),
               random.coordinate(), random.coordinate()};
    group.u = {random.coordinate(), random.coordinate(), random.direction(), Real(0), Real(0)};
    Model::Configuration<Real> q = {random.direction(), random.coordinate(), random.coordinate(),
                                    random.coordinate()};
    // E closes the first loop, the link GF and its slide close the second: all enter linearly.
    Vector<Real, Model::equation_count> f;
    Model::residual(group.d, group.u, q, f);
    group.u.x_E += f(0);
    group.u.y_E += f(1);
    Model::residual(group.d, group.u, q, f);
    group.d.h_F_GF += q.theta_EDF.sin * f(2) - q.theta_EDF.cos * f(3);
    q.s_F += q.theta_EDF.cos * f(2) + q.theta_EDF.sin * f(3);
    group.known.push_back(q);
    return group;
  }

  struct Asked : AskedAsItIs<Model> {
    static constexpr int roots_at_infinity = 2;
  };
};

/// The two slides of link CD become parallel, and both configurations run to infinity. Their places
/// are known: angles do not depend on the slides, which follow from two linear equations.
struct AllToInfinity {
  using Model = Model04;
  static constexpr const char* name = "all-to-infinity";
  static constexpr const char* title = "Both run to infinity";
  static constexpr const char* kind = "RPR-RPR";

  static KnownGroup<Model> draw(RandomNumbers& random, const Real& distance) {
    Geometry<Model, Real> g = random_model_04(random);
    g.d.psi_D_CD = direction_of(distance);
    g.u.x_E = random.coordinate();
    g.u.y_E = random.coordinate();
    Vector<Real, Model::equation_count> f;
    Model::residual(g.d, g.u, g.q, f);
    const Direction<Real> EDF = turned(g.q.theta_BCG, g.d.psi_D_CD);
    g.d.x_F_EDF += EDF.cos * f(2) + EDF.sin * f(3);
    g.d.y_F_EDF += EDF.cos * f(3) - EDF.sin * f(2);
    KnownGroup<Model> group{g.d, g.u, {}};
    if (distance > Real(0)) {
      group.known.push_back(g.q);
      Matrix<Real, Model::equation_count, Model::unknown_count> J;
      Model::residual(g.d, g.u, g.q, f);
      Model::jacobian(g.d, g.u, g.q, J);
      // The slides are the last two unknowns.
      const Real determinant = J(0, 2) * J(1, 3) - J(0, 3) * J(1, 2);
      group.known[0].s_C -= (f(0) * J(1, 3) - f(1) * J(0, 3)) / determinant;
      group.known[0].s_D -= (f(1) * J(0, 2) - f(0) * J(1, 2)) / determinant;
    }
    return group;
  }

  struct Asked : AskedAsItIs<Model> {
    static constexpr int roots_at_infinity = 2;
  };
};

using ConfigurationFamilies = std::tuple<SharedUnknown, SomeToInfinity, AllToInfinity>;

/// 1e-1, 1e-2 ... 1e-14, and 0: the failure itself.
[[nodiscard]] inline std::vector<double> configuration_distances() {
  std::vector<double> list;
  for (int exponent = 1; exponent <= 14; ++exponent) {
    list.push_back(std::pow(10.0, -exponent));
  }
  list.push_back(0);
  return list;
}

}  // namespace assur::stability
