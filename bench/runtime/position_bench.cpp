// Times all configurations of an RRR-RRR tetrad from scratch, in closed form and by companion
// eigenvalues of the same elimination, over the same 10,000 groups, all of which can be assembled,
// in one run.
#include <benchmark/benchmark.h>

#include <assur/assembly.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <random>
#include <vector>

#include "runtime/reference_roots.hpp"

namespace {

constexpr int group_count = 10000;
constexpr unsigned seed = 2718;

template <typename Model>
struct Group {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
};

template <typename Model>
const std::vector<Group<Model>>& groups() {
  static const std::vector<Group<Model>> list = [] {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> length(-2, 2);
    std::uniform_real_distribution<double> angle(-3.14159, 3.14159);
    const auto fill = [&](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member = length(engine);
      } else {
        member = assur::direction_of(angle(engine));
      }
    };
    std::vector<Group<Model>> made(group_count);
    for (Group<Model>& group : made) {
      do {  // until the links reach: a group without configurations would be cheap
        std::apply([&](auto&... member) { (fill(member), ...); }, group.d.members());
        std::apply([&](auto&... member) { (fill(member), ...); }, group.u.members());
      } while (assur::assemblies<Model>(group.d, group.u).count == 0);
    }
    return made;
  }();
  return list;
}

template <typename Model>
void closed_form(benchmark::State& state) {
  const auto& list = groups<Model>();
  std::size_t next = 0;
  for (auto _ : state) {
    const Group<Model>& group = list[next];
    next = next + 1 == list.size() ? 0 : next + 1;
    auto found = assur::assemblies<Model>(group.d, group.u);
    benchmark::DoNotOptimize(found);
  }
}

using Model01Polynomial = assur::TrigonometricPolynomial<double, 3>;
using Roots = assur::test::ReferenceRoots<3>;

/// The same elimination, its roots by another method, completed and polished in the same way.
template <Roots (*find)(const Model01Polynomial&)>
void reference(benchmark::State& state) {
  using Model = assur::tetrad::Model01;
  const auto& list = groups<Model>();
  std::size_t next = 0;
  for (auto _ : state) {
    const Group<Model>& group = list[next];
    next = next + 1 == list.size() ? 0 : next + 1;
    Model01Polynomial T;
    Model::position_polynomial(group.d, group.u, T);
    const Roots roots = find(T);
    for (int root = 0; root < roots.count; ++root) {
      Model::Configuration<double> q;
      q.theta_BCG = assur::direction_of(roots.angles[static_cast<std::size_t>(root)]);
      assur::Matrix<double, 2, 3> e;
      Model::second_equations(group.d, group.u, q, e);
      q.theta_EDF = assur::numeric::second_candidates<assur::Direction<double>>(e).list[0].value;
      Model::complete(group.d, group.u, q);
      benchmark::DoNotOptimize(assur::refine<Model, double>(group.d, group.u, q, 3));
      benchmark::DoNotOptimize(q);
    }
  }
}

Roots companion_eigenvalues(const Model01Polynomial& T) { return assur::test::companion_roots(T); }
Roots half_angle(const Model01Polynomial& T) { return assur::test::half_angle_roots(T); }
Roots grid_of_360(const Model01Polynomial& T) { return assur::test::subdivision_roots(T); }

BENCHMARK(closed_form<assur::tetrad::Model01>);
BENCHMARK(reference<companion_eigenvalues>);
BENCHMARK(reference<half_angle>);
BENCHMARK(reference<grid_of_360>);
BENCHMARK(closed_form<assur::tetrad::Model04>);

}  // namespace

BENCHMARK_MAIN();
