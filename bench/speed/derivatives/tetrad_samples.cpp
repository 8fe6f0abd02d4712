#include "derivatives/tetrad_samples.hpp"

#include <assur/assembly.hpp>

#include "runtime/exact.hpp"

namespace assur::speed {

namespace {

constexpr unsigned random_seed = 1618;
constexpr unsigned singular_seed = 2718;

using Random = test::RandomInputs;
using Dimensions = Model01::Dimensions<double>;
using Inputs = Model01::Inputs<double>;
using Configuration = Model01::Configuration<double>;

TetradTruth truth_at(const Model01::Dimensions<Precise>& d, const Model01::Inputs<Precise>& u,
                     const Model01::Configuration<Precise>& q, const Vector<Precise, 4>& u_rate,
                     const Vector<Precise, 4>& u_second_rate) {
  TetradTruth truth;
  const PreciseJacobian<Model01> jacobian(d, u, q);
  truth.by_unknowns = jacobian.matrix();
  Matrix<Precise, 4, 8> by_dimensions;
  Matrix<Precise, 4, 4> by_inputs;
  Model01::dimension_jacobian(d, u, q, by_dimensions);
  Model01::input_jacobian(d, u, q, by_inputs);
  truth.by_dimensions_and_inputs << by_dimensions, by_inputs;
  truth.sensitivities = jacobian.solve<12>(-truth.by_dimensions_and_inputs);
  Vector<Precise, 4> rhs;
  Model01::velocity_rhs(d, u, q, u_rate, rhs);
  truth.velocity = jacobian.solve<1>(rhs);
  Model01::acceleration_rhs(d, u, q, truth.velocity, u_rate, u_second_rate, rhs);
  truth.acceleration = jacobian.solve<1>(rhs);
  return truth;
}

/// Adds the configuration near `q` with a random motion if Newton's iteration converges.
void append(const Dimensions& d, const Inputs& u, const Configuration& q, Random& random,
            TetradSamples& samples) {
  const auto exact_d = in_scalar<Model01::Dimensions<Precise>>(d);
  const auto exact_u = in_scalar<Model01::Inputs<Precise>>(u);
  auto exact_q = in_scalar<Model01::Configuration<Precise>>(q);
  if (!assemble<Model01>(exact_d, exact_u, exact_q)) {
    return;
  }
  TetradSample<double> sample;
  sample.g.d = d;
  sample.g.u = u;
  sample.g.q = in_scalar<Configuration>(exact_q);
  int index = 0;
  const auto take_angle = [&](const Direction<Precise>& direction) {
    sample.theta(index++) = static_cast<double>(
        std::atan2(rounded<long double>(direction.sin), rounded<long double>(direction.cos)));
  };
  std::apply([&](const auto&... member) { (take_angle(member), ...); }, exact_q.members());
  Vector<Precise, 4> u_rate;
  Vector<Precise, 4> u_second_rate;
  for (int input = 0; input < 4; ++input) {
    sample.g.u_rate(input) = random.between(-1, 1);
    sample.g.u_second_rate(input) = random.between(-1, 1);
    u_rate(input) = precise(sample.g.u_rate(input));
    u_second_rate(input) = precise(sample.g.u_second_rate(input));
  }
  samples.list.push_back(sample);
  samples.truth.push_back(truth_at(exact_d, exact_u, exact_q, u_rate, u_second_rate));
}

/// Directions with det J = 0, except that GF is rotated by the square root of the distance; the
/// ends and F are moved so that the loops close:  (CD x BC) (GF x EF) = (CD x ED) (GF x BG)  with
/// EF = BG + GF - EB.
void make_near_singular(Random& random, double distance, Dimensions& d, Inputs& u,
                        Configuration& q) {
  d = random.variables<Dimensions>();
  q = random.variables<Configuration>();
  u = {random.between(-1, 1), random.between(-1, 1), 0, 0};
  Vector<double, 4> f;
  Model01::residual(d, u, q, f);
  u.x_E += f(0);
  u.y_E += f(1);
  const double BC = d.BC * (q.theta_CD.cos * q.theta_BCG.sin - q.theta_CD.sin * q.theta_BCG.cos);
  const double ED = d.ED * (q.theta_CD.cos * q.theta_EDF.sin - q.theta_CD.sin * q.theta_EDF.cos);
  const double BG_x = q.theta_BCG.cos * d.x_G_BCG - q.theta_BCG.sin * d.y_G_BCG;
  const double BG_y = q.theta_BCG.cos * d.y_G_BCG + q.theta_BCG.sin * d.x_G_BCG;
  const double along = std::atan2(BC * (BG_y - (u.y_E - u.y_B)) - ED * BG_y,
                                  BC * (BG_x - (u.x_E - u.x_B)) - ED * BG_x);
  q.theta_GF = direction_of(along + std::sqrt(distance));
  Model01::residual(d, u, q, f);
  d.x_F_EDF += q.theta_EDF.cos * f(2) + q.theta_EDF.sin * f(3);
  d.y_F_EDF += q.theta_EDF.cos * f(3) - q.theta_EDF.sin * f(2);
}

}  // namespace

TetradSamples random_tetrads(std::size_t count) {
  Random random(random_seed);
  TetradSamples samples;
  while (samples.list.size() < count) {
    const auto d = random.variables<Dimensions>();
    const auto u = random.variables<Inputs>();
    const auto found = assemblies<Model01>(d, u);
    if (found.count > 0) {
      append(d, u,
             found.configurations[static_cast<std::size_t>(random.integer(0, found.count - 1))],
             random, samples);
    }
  }
  return samples;
}

TetradSamples near_singular_tetrads(std::size_t count) {
  Random random(singular_seed);
  TetradSamples samples;
  while (samples.list.size() < count) {
    Dimensions d;
    Inputs u;
    Configuration q;
    make_near_singular(random, std::pow(10.0, random.between(-10, -2)), d, u, q);
    append(d, u, q, random, samples);
  }
  return samples;
}

}  // namespace assur::speed
