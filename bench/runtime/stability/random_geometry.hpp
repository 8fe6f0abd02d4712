// Random groups in 50 digits, assembled by construction.
#pragma once

#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <random>

#include "problem.hpp"

namespace assur::stability {

using tetrad::Model01;
using tetrad::Model04;

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}

  Real between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Real length() { return between(0.5, 2); }
  Real coordinate() { return between(-1, 1); }
  /// Away from pi, which has a family of its own.
  Direction<Real> direction() { return direction_of(between(-2.5, 2.5)); }

 private:
  std::mt19937 engine_;
};

/// Moves E, then F on its link, until both loops close. Exact: both enter linearly.
template <typename Model>
void close_loops(Geometry<Model, Real>& g, const Direction<Real>& EDF) {
  Vector<Real, Model::equation_count> f;
  Model::residual(g.d, g.u, g.q, f);
  g.u.x_E += f(0);
  g.u.y_E += f(1);
  Model::residual(g.d, g.u, g.q, f);
  g.d.x_F_EDF += EDF.cos * f(2) + EDF.sin * f(3);
  g.d.y_F_EDF += EDF.cos * f(3) - EDF.sin * f(2);
}
inline void close_loops(Geometry<Model01, Real>& g) { close_loops(g, g.q.theta_EDF); }
inline void close_loops(Geometry<Model04, Real>& g) {
  close_loops(g, turned(g.q.theta_BCG, g.d.psi_D_CD));
}

/// Rates and accelerations of the inputs, different for each.
template <typename Model>
void set_in_motion(RandomNumbers& random, Geometry<Model, Real>& g) {
  for (int index = 0; index < Model::input_count; ++index) {
    g.u_rate(index) = random.coordinate();
    g.u_second_rate(index) = random.coordinate();
  }
}

/// A random RRR-RRR with its directions; its loops are not closed yet.
inline Geometry<Model01, Real> random_model_01(RandomNumbers& random) {
  Geometry<Model01, Real> g;
  g.d = {random.length(),     random.coordinate(), random.length(), random.length(),
         random.coordinate(), random.length(),     random.length(), random.length()};
  g.u = {random.coordinate(), random.coordinate(), Real(0), Real(0)};
  g.q = {random.direction(), random.direction(), random.direction(), random.direction()};
  set_in_motion(random, g);
  return g;
}

/// A random RPR-RPR with its directions and displacements; its loops are not closed yet.
inline Geometry<Model04, Real> random_model_04(RandomNumbers& random) {
  Geometry<Model04, Real> g;
  g.d.h_C_BCG = random.length();
  g.d.x_G_BCG = random.coordinate();
  g.d.y_G_BCG = random.length();
  g.d.h_D_EDF = random.length();
  g.d.x_F_EDF = random.coordinate();
  g.d.y_F_EDF = random.length();
  g.d.psi_D_CD = random.direction();
  g.d.GF = random.length();
  g.u = {random.coordinate(), random.coordinate(), Real(0), Real(0)};
  g.q.theta_BCG = random.direction();
  g.q.theta_GF = random.direction();
  g.q.s_C = random.coordinate();
  g.q.s_D = random.coordinate();
  set_in_motion(random, g);
  return g;
}

}  // namespace assur::stability
