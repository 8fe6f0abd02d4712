// Turns random groups of models with 6, 4, 2 and 1 configurations into the position tasks.
#include <benchmark/benchmark.h>

#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_05.hpp>
#include <assur/tetrad/model_15.hpp>
#include <memory>

#include "positions/position_error.hpp"
#include "positions/position_methods.hpp"
#include "tasks.hpp"
#ifdef ASSUR_PHC
#include "positions/phcpack.hpp"
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
/// Each input takes a process, so there are few inputs, and the rows bring their own median times.
void add_phc(Task& task, const Samples<tetrad::Model01>& samples, std::size_t inputs) {
  ErrorTally tally;
  std::vector<double> solving;
  std::vector<double> call;
  for (std::size_t index = 0; index < inputs; ++index) {
    const auto answer = solve_by_phc(samples->list[index]);
    if (!answer) {
      tally.add_failure();
      continue;
    }
    tally.add(position_error<tetrad::Model01>(answer->found, samples->truth[index]));
    solving.push_back(answer->solving_ns);
    call.push_back(answer->call_ns);
  }
  Entry entry;
  entry.row.task = task.name;
  tally.write_to(entry.row);
  const auto append = [&](const char* method, std::vector<double>& times) {
    entry.row.method = method;
    std::sort(times.begin(), times.end());
    entry.row.ns = times.empty() ? 0 : times[times.size() / 2];
    task.entries.push_back(entry);
  };
  append("PHCpack, solving alone", solving);
  append("PHCpack, the whole process", call);
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
  tasks.push_back(
      position_task("all configurations, RPP-RRR (at most 4)", random_positions<Model05>(fewer)));
  tasks.push_back(
      position_task("all configurations, RPR-RPR (at most 2)", random_positions<Model04>(fewer)));
  tasks.push_back(
      position_task("all configurations, PPR-RPP (one)", random_positions<Model15>(fewer)));
  return tasks;
}

}  // namespace assur::speed
