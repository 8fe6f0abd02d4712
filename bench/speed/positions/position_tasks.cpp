// The position tasks: random groups of models with 6, 4, 2 and 1 configurations.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_05.hpp>
#include <assur/tetrad/model_15.hpp>
#include <memory>

#include "positions/position_error.hpp"
#include "positions/position_methods.hpp"
#include "tasks.hpp"
#ifdef ASSUR_PHC
#include "phcpack.hpp"
#endif

namespace assur::speed {

namespace {

template <typename Model>
using Samples = std::shared_ptr<const PositionSamples<Model>>;

template <typename Model, typename Find>
void add(Task& task, const Samples<Model>& samples, const std::string& method, Find find) {
  Entry entry;
  entry.row.task = task.name;
  entry.row.method = method;
  ErrorTally tally;
  for (std::size_t index = 0; index < samples->list.size(); ++index) {
    tally.add(position_error<Model>(find(samples->list[index]), samples->truth[index]));
  }
  tally.write_to(entry.row);
  entry.run = [samples, find](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      auto found = find(samples->list[index]);
      benchmark::DoNotOptimize(found);
    }
  };
  task.entries.push_back(std::move(entry));
}

#ifdef ASSUR_PHC
void add_phc(Task& task, const Samples<tetrad::Model01>& samples, std::size_t inputs) {
  using Model = tetrad::Model01;
  using Complex = std::complex<double>;
  const auto closures = [samples](std::size_t input) {
    const auto& d = samples->list[input].d;
    const auto& u = samples->list[input].u;
    const Complex b(u.x_B - u.x_E, u.y_B - u.y_E);
    const Complex G(d.x_G_BCG, d.y_G_BCG);
    const Complex F(d.x_F_EDF, d.y_F_EDF);
    return std::vector<SquaredClosure>{{1, 2, b, d.BC, d.ED, d.CD}, {1, 2, b, G, F, d.GF}};
  };
  const auto error = [samples, closures](std::size_t input,
                                         const std::vector<LinkDirections>& answer) {
    const auto direction = [](const Complex& z) {
      return Direction<double>{z.real() / std::abs(z), z.imag() / std::abs(z)};
    };
    Found<Model> found;
    for (const LinkDirections& z : answer) {
      std::vector<Direction<double>> directions = {direction(z[0]), direction(z[1])};
      for (const SquaredClosure& one : closures(input)) {
        directions.push_back(direction(-(one.b + one.g * z[0] - one.f * z[1]) / one.bar));
      }
      Model::Configuration<double> q = {directions[0], directions[1], directions[2], directions[3]};
      const auto& sample = samples->list[input];
      (void)refine<Model, double>(sample.d, sample.u, q, 3);
      found.add(q);
    }
    return position_error<Model>(found, samples->truth[input]);
  };
  add_phc_rows(task, inputs, {closures, error});
}
#endif

template <typename Model>
Task position_task(const std::string& name, PositionSamples<Model> made, std::size_t phc_inputs = 0,
                   Effort effort = usual_effort) {
  const auto samples = std::make_shared<const PositionSamples<Model>>(std::move(made));
  const std::size_t inputs = samples->list.size();
  Task task{name, inputs, {}};
  add<Model>(task, samples, "generated", closed_form<Model>);
  if constexpr (Model::unknowns[static_cast<std::size_t>(Model::first_unknown)].is_angle) {
    using T = Polynomial<Model>;
    using Sample = PositionSample<Model>;
    add<Model>(task, samples, "companion eigenvalues", [=](const Sample& sample) {
      return from_roots<Model>(sample, effort,
                               [](const T& t) { return test::companion_roots(t, nearly_real); });
    });
    add<Model>(task, samples, "half angle, Eigen's polynomial solver", [=](const Sample& sample) {
      return from_roots<Model>(sample, effort, [](const T& t) { return half_angle_roots(t); });
    });
    add<Model>(task, samples, "grid of 360 and bisection", [=](const Sample& sample) {
      return from_roots<Model>(sample, effort,
                               [](const T& t) { return test::subdivision_roots(t); });
    });
  }
  add<Model>(task, samples, "64-start Newton", [=](const PositionSample<Model>& sample) {
    return MultiStartNewton<Model>::find(sample, effort);
  });
#ifdef ASSUR_PHC
  if constexpr (std::is_same_v<Model, tetrad::Model01>) {
    add_phc(task, samples, std::min(inputs, phc_inputs));
  }
#else
  (void)phc_inputs;
#endif
  return task;
}

/// Regular groups in special position: their numbers are -2, -1, 1 and 2, and their final
/// polynomial has another number of roots than they have configurations, because a root belongs to
/// none or to two. Their configurations are all that the generated code or many starts find.
PositionSamples<tetrad::Model01> special_positions(std::size_t count) {
  using Model = tetrad::Model01;
  test::RandomInputs random(27182);
  PositionSamples<Model> samples;
  const auto draw = [&](auto& variables) {
    for_each_member(variables, [&](double& member, std::size_t) {
      member = static_cast<double>(random.integer(1, 2) * (2 * random.integer(0, 1) - 1));
    });
  };
  while (samples.list.size() < count) {
    PositionSample<Model> sample;
    draw(sample.d);
    draw(sample.u);
    const Found<Model> listed = closed_form(sample);
    const Found<Model> started = MultiStartNewton<Model>::find(sample, patient_effort);
    PositionTruth<Model> truth = precise_configurations(sample, listed, started);
    truth.count = truth.list.size();
    const auto final = test::exact_final_polynomial<Model>(sample.d, sample.u);
    if (std::ranges::all_of(final, [](const auto& coefficient) { return coefficient.is_zero(); })) {
      continue;
    }
    const int roots = test::exact_assembly_count<Model>(sample.d, sample.u);
    const bool is_regular =
        std::ranges::all_of(truth.list, [&](const auto& q) { return condition(sample, q) < 1e6; });
    if (truth.count > 0 && is_regular && roots != static_cast<int>(truth.count)) {
      samples.list.push_back(sample);
      samples.truth.push_back(std::move(truth));
    }
  }
  return samples;
}

}  // namespace

std::vector<Task> position_tasks(const TaskSizes& sizes) {
  using namespace tetrad;
  const std::size_t fewer = sizes.inputs / 4;
  std::vector<Task> tasks;
  tasks.push_back(position_task("all configurations", random_positions<Model01>(sizes.inputs),
                                sizes.phc_inputs));
  tasks.push_back(
      position_task("all configurations, near singular",
                    positions_of<Model01>(near_singular_tetrads(sizes.near_singular).list),
                    sizes.phc_inputs, patient_effort));
  tasks.push_back(position_task("all configurations, special position",
                                special_positions(sizes.near_singular), 0, patient_effort));
  tasks.push_back(
      position_task("all configurations, RPP-RRR (at most 4)", random_positions<Model05>(fewer)));
  tasks.push_back(
      position_task("all configurations, RPR-RPR (at most 2)", random_positions<Model04>(fewer)));
  tasks.push_back(
      position_task("all configurations, PPR-RPP (one)", random_positions<Model15>(fewer)));
  return tasks;
}

}  // namespace assur::speed
