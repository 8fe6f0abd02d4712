// The force tasks, random dyads and tetrads under random loads: the transposed elimination against
// dense LU of three equations per link.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <assur/assembly.hpp>
#include <memory>
#include <vector>

#include "derivatives/tetrad_samples.hpp"
#include "forces/dense_equilibrium.hpp"
#include "runtime/exact.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

/// An assembled group under loads.
template <typename Model>
struct LoadedSample {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
  typename Model::template Configuration<double> q;
  Matrix<double, Model::link_count, 3> loads;
};

template <typename Model>
using Forces = Matrix<double, Model::joint_count, 2>;

template <typename Model>
Forces<Model> generated(const LoadedSample<Model>& sample) {
  Matrix<double, Model::joint_count, 3> F;
  Model::forces(sample.d, sample.u, sample.q, sample.loads, F);
  return F.template leftCols<2>();
}

template <typename Model>
Forces<Model> dense(const LoadedSample<Model>& sample) {
  return dense_forces<Model, double>(sample.d, sample.q, sample.loads);
}

template <typename Model>
Task force_task(const std::string& name, std::vector<LoadedSample<Model>> list) {
  Task task{name, list.size(), {}};
  const auto samples = std::make_shared<const std::vector<LoadedSample<Model>>>(std::move(list));
  const auto add = [&](const std::string& method, auto find) {
    Entry entry;
    entry.row.task = name;
    entry.row.method = method;
    ErrorTally tally;
    for (const LoadedSample<Model>& sample : *samples) {
      using Long = long double;
      const auto truth = dense_forces<Model, Long>(
          stability::converted<typename Model::template Dimensions<Long>>(sample.d),
          stability::converted<typename Model::template Configuration<Long>>(sample.q),
          sample.loads.template cast<Long>());
      const auto off = (find(sample).template cast<Long>() - truth).cwiseAbs().maxCoeff();
      tally.add(static_cast<double>(off / truth.cwiseAbs().maxCoeff()));
    }
    tally.write_to(entry.row);
    entry.run = [samples, find](std::size_t first, std::size_t last) {
      for (std::size_t index = first; index < last; ++index) {
        auto answer = find((*samples)[index]);
        benchmark::DoNotOptimize(answer);
      }
    };
    task.entries.push_back(std::move(entry));
  };
  add("generated", generated<Model>);
  add("dense LU", dense<Model>);
  return task;
}

template <typename Model>
Matrix<double, Model::link_count, 3> random_loads(test::RandomInputs& random) {
  const auto numbers = random.vector<Vector<double, 3 * Model::link_count>>();
  Matrix<double, Model::link_count, 3> loads;
  for (int place = 0; place < 3 * Model::link_count; ++place) {
    loads(place / 3, place % 3) = numbers(place);
  }
  return loads;
}

std::vector<LoadedSample<dyad::Model01>> random_dyads(std::size_t count) {
  using Dyad = dyad::Model01;
  test::RandomInputs random(14142);
  std::vector<LoadedSample<Dyad>> list;
  while (list.size() < count) {
    const auto d = random.variables<Dyad::Dimensions<double>>();
    const auto u = random.variables<Dyad::Inputs<double>>();
    const auto found = assemblies<Dyad>(d, u);
    if (found.count > 0) {
      list.push_back({d, u, found.configurations[0], random_loads<Dyad>(random)});
    }
  }
  return list;
}

std::vector<LoadedSample<Model01>> loaded_tetrads(std::size_t count) {
  test::RandomInputs random(17320);
  std::vector<LoadedSample<Model01>> list;
  for (const TetradSample<double>& tetrad : random_tetrads(count).list) {
    list.push_back({tetrad.g.d, tetrad.g.u, tetrad.g.q, random_loads<Model01>(random)});
  }
  return list;
}

}  // namespace

std::vector<Task> force_tasks(const TaskSizes& sizes) {
  std::vector<Task> tasks;
  tasks.push_back(force_task("dyad RRR, forces", random_dyads(sizes.inputs)));
  tasks.push_back(force_task("RRR-RRR, forces", loaded_tetrads(sizes.inputs)));
  return tasks;
}

}  // namespace assur::speed
