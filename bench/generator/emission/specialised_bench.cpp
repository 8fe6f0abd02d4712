// Times the worked mechanism's group: its general model against the solver of the scene alone.
#include <benchmark/benchmark.h>

#include <array>
#include <assur/assembly.hpp>
#include <assur/scenes/quintero_2011_rrp_rrr.hpp>
#include <assur/tetrad/model_02.hpp>

namespace {

using Model = assur::tetrad::Model02;
using Solver = assur::scenes::Quintero2011RrpRrr;
using Group = assur::scenes::Quintero2011RrpRrrGroup1;

/// The place of the crank pin; step 0 is the angle of the scene.
std::array<double, 2> crank_pin(int step) {
  const double angle = 1.2217304763960306 + 0.001 * (step % 200);
  return {100 * std::cos(angle), 100 * std::sin(angle)};
}

/// The group's dimensions in the scene, for the roles of the joints that the scene's solver chose.
Model::Dimensions<double> dimensions() {
  Model::Dimensions<double> d;
  d.x_G_BCG = 500;
  d.ED = 300;
  d.x_F_EDF = 133.5;
  d.y_F_EDF = -68.39407869106799;
  d.GF = 300;
  return d;
}

Model::Inputs<double> inputs(int step) {
  const auto [x, y] = crank_pin(step);
  Model::Inputs<double> u;
  u.x_B = x;
  u.y_B = y;
  u.x_E = 275;
  return u;
}

void positions_by_the_general_model(benchmark::State& state) {
  const Model::Dimensions<double> d = dimensions();
  int step = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(assur::assemblies<Model>(d, inputs(step++)));
  }
}

void positions_by_the_specialised_group(benchmark::State& state) {
  int step = 0;
  for (auto _ : state) {
    const auto [x, y] = crank_pin(step++);
    Group::Inputs<double> u;
    u.x_B = x / Group::unit;
    u.y_B = y / Group::unit;
    benchmark::DoNotOptimize(assur::assemblies<assur::support::Specialised<Group>>({}, u));
  }
}

void polynomial_by_the_general_model(benchmark::State& state) {
  const Model::Dimensions<double> d = dimensions();
  const Model::Inputs<double> u = inputs(0);
  assur::TrigonometricPolynomial<double, Model::polynomial_degree> T;
  for (auto _ : state) {
    benchmark::DoNotOptimize(&d);
    benchmark::DoNotOptimize(&u);
    benchmark::ClobberMemory();
    Model::position_polynomial(d, u, T);
    benchmark::DoNotOptimize(&T);
  }
}

void polynomial_by_the_specialised_group(benchmark::State& state) {
  Group::Inputs<double> u;
  u.x_B = 0.1;
  u.y_B = 0.3;
  assur::TrigonometricPolynomial<double, Group::polynomial_degree> T;
  for (auto _ : state) {
    benchmark::DoNotOptimize(&u);
    benchmark::ClobberMemory();
    Group::position_polynomial(u, T);
    benchmark::DoNotOptimize(&T);
  }
}

/// All results that the scene asks for, for every configuration.
void whole_scene(benchmark::State& state) {
  std::array<Solver::State<double>, Solver::max_configurations> states;
  Solver::Drivers<double> drivers;
  int step = 0;
  const double start = drivers.A.position;
  for (auto _ : state) {
    drivers.A.position = start + 0.001 * (step++ % 200);
    benchmark::DoNotOptimize(Solver::solve(drivers, states));
    benchmark::ClobberMemory();
  }
}

BENCHMARK(positions_by_the_general_model);
BENCHMARK(positions_by_the_specialised_group);
BENCHMARK(polynomial_by_the_general_model);
BENCHMARK(polynomial_by_the_specialised_group);
BENCHMARK(whole_scene);

}  // namespace

BENCHMARK_MAIN();
