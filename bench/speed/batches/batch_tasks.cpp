// The batch tasks: many random groups in one call against one after the other.
#include <benchmark/benchmark.h>

#include <assur/dyad/model_01.hpp>
#include <assur/dyad/model_02.hpp>
#include <assur/dyad/model_03.hpp>
#include <assur/tetrad/model_01.hpp>
#include <memory>

#include "batches/batch_columns.hpp"
#include "derivatives/derivative_errors.hpp"
#include "positions/position_error.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

/// The number of doubles in a register of AVX2; with AVX-512, twice as many are measured, too.
constexpr std::size_t usual_lanes = 4;

Entry entry_of(const Task& task, const std::string& method, ErrorTally& tally) {
  Entry entry;
  entry.row.task = task.name;
  entry.row.method = method;
  tally.write_to(entry.row);
  return entry;
}

/// Calls `add` with the number of lanes of each batch method and its name.
template <typename Add>
void for_each_batch(const Add& add) {
  add(std::integral_constant<std::size_t, usual_lanes>(), "generated, batch");
  if constexpr (numeric::native_lanes > usual_lanes) {
    add(std::integral_constant<std::size_t, numeric::native_lanes>(), "generated, batch of 8");
  }
}

/// The number of groups that a call solves. Their answers overwrite those of the call before, as
/// the answers of single groups do, so they stay in the cache.
constexpr std::size_t at_once = 200;

/// Calls `solve` with the first group and the size of each piece of at most `at_once` groups.
template <typename Solve>
void for_each_piece(std::size_t first, std::size_t last, const Solve& solve) {
  for (; first < last; first += at_once) {
    solve(first, std::min(at_once, last - first));
  }
}

template <typename Model>
Task position_task(const std::string& name, PositionSamples<Model> made) {
  using Dimensions = VariableColumns<typename Model::template Dimensions<double>>;
  using Inputs = VariableColumns<typename Model::template Inputs<double>>;
  const auto samples = std::make_shared<const PositionSamples<Model>>(std::move(made));
  const std::size_t count = samples->list.size();
  const auto dimensions = std::make_shared<Dimensions>(count);
  const auto inputs = std::make_shared<Inputs>(count);
  for (std::size_t group = 0; group < count; ++group) {
    dimensions->put(group, samples->list[group].d);
    inputs->put(group, samples->list[group].u);
  }
  Task task{name, count, {}};
  for_each_batch([&](auto lanes, const std::string& method) {
    constexpr std::size_t width = decltype(lanes)::value;
    AssemblyColumns<Model> answers(count);
    assemblies<Model, width>(count, dimensions->from(0), inputs->from(0), answers.result());
    ErrorTally tally;
    for (std::size_t group = 0; group < count; ++group) {
      tally.add(position_error<Model>(answers.found(group), samples->truth[group]));
    }
    Entry entry = entry_of(task, method, tally);
    entry.run = [=, room = std::make_shared<AssemblyColumns<Model>>(at_once)](std::size_t begin,
                                                                              std::size_t end) {
      for_each_piece(begin, end, [&](std::size_t first, std::size_t groups) {
        assemblies<Model, width>(groups, dimensions->from(first), inputs->from(first),
                                 room->result());
        benchmark::ClobberMemory();
      });
    };
    task.entries.push_back(std::move(entry));
  });
  ErrorTally tally;
  for (std::size_t group = 0; group < count; ++group) {
    const auto answer = assemblies<Model>(samples->list[group].d, samples->list[group].u);
    Found<Model> found;
    for (int index = 0; index < answer.count; ++index) {
      found.add(answer.configurations[static_cast<std::size_t>(index)]);
    }
    tally.add(position_error<Model>(found, samples->truth[group]));
  }
  Entry entry = entry_of(task, "generated", tally);
  entry.run = [samples](std::size_t first, std::size_t last) {
    for (std::size_t group = first; group < last; ++group) {
      auto answer = assemblies<Model>(samples->list[group].d, samples->list[group].u);
      benchmark::DoNotOptimize(answer);
    }
  };
  task.entries.push_back(std::move(entry));
  return task;
}

/// Configurations in motion as columns.
struct MovingColumns {
  VariableColumns<Model01::Dimensions<double>> dimensions;
  VariableColumns<Model01::Inputs<double>> inputs;
  VariableColumns<Model01::Configuration<double>> configurations;
  std::size_t stride;
  std::vector<double> first_rates, second_rates;

  explicit MovingColumns(const std::vector<TetradSample<double>>& list)
      : dimensions(list.size()),
        inputs(list.size()),
        configurations(list.size()),
        stride(list.size() + 8),
        first_rates(4 * stride),
        second_rates(4 * stride) {
    for (std::size_t index = 0; index < list.size(); ++index) {
      const auto& g = list[index].g;
      dimensions.put(index, g.d);
      inputs.put(index, g.u);
      configurations.put(index, g.q);
      for (std::size_t input = 0; input < 4; ++input) {
        const auto row = static_cast<Eigen::Index>(input);
        first_rates[input * stride + index] = g.u_rate(row);
        second_rates[input * stride + index] = g.u_second_rate(row);
      }
    }
  }

  template <std::size_t Lanes>
  void solve(std::size_t first, std::size_t count, DerivativeColumns<Model01>& answers) const {
    const BatchConfigurations<Model01> given{dimensions.from(first), inputs.from(first),
                                             configurations.from(first)};
    sensitivities_and_motion<Model01, Lanes>(
        count, given, {first_rates.data() + first, second_rates.data() + first, stride},
        answers.sensitivities(), answers.motion());
  }
};

Task derivative_task(const std::string& name, const TetradSamples& samples) {
  const auto list = std::make_shared<const std::vector<TetradSample<double>>>(samples.list);
  const auto columns = std::make_shared<const MovingColumns>(*list);
  const std::size_t count = list->size();
  Task task{name, count, {}};
  for_each_batch([&](auto lanes, const std::string& method) {
    constexpr std::size_t width = decltype(lanes)::value;
    DerivativeColumns<Model01> answers(count);
    columns->solve<width>(0, count, answers);
    ErrorTally tally;
    for (std::size_t index = 0; index < count; ++index) {
      DerivativesAnswer<double> answer;
      answers.read(index, answer.sensitivities, answer.motion, answer.status);
      tally.add(error_of(answer, samples.truth[index]));
    }
    Entry entry = entry_of(task, method, tally);
    entry.run = [=, room = std::make_shared<DerivativeColumns<Model01>>(at_once)](std::size_t begin,
                                                                                  std::size_t end) {
      for_each_piece(begin, end, [&](std::size_t first, std::size_t configurations) {
        columns->solve<width>(first, configurations, *room);
        benchmark::ClobberMemory();
      });
    };
    task.entries.push_back(std::move(entry));
  });
  const auto add = [&](const std::string& method, auto evaluate) {
    ErrorTally tally;
    for (std::size_t index = 0; index < count; ++index) {
      tally.add(error_of(evaluate((*list)[index].g), samples.truth[index]));
    }
    Entry entry = entry_of(task, method, tally);
    entry.run = [list, evaluate](std::size_t first, std::size_t last) {
      for (std::size_t index = first; index < last; ++index) {
        auto answer = evaluate((*list)[index].g);
        benchmark::DoNotOptimize(answer);
      }
    };
    task.entries.push_back(std::move(entry));
  };
  using Geometry = stability::Geometry<Model01, double>;
  add("generated", [](const Geometry& g) {
    DerivativesAnswer<double> answer;
    Model01::sensitivities_and_motion(
        g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.sensitivities.to_dimensions,
        answer.sensitivities.to_inputs, answer.motion.velocity, answer.motion.acceleration);
    return answer;
  });
  add("generated, with status", [](const Geometry& g) {
    DerivativesAnswer<double> answer;
    answer.status = sensitivities_and_motion<Model01, double>(
        g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.sensitivities, answer.motion);
    return answer;
  });
  return task;
}

}  // namespace

std::vector<Task> batch_tasks(const TaskSizes& sizes) {
  const TetradSamples singular = near_singular_tetrads(sizes.near_singular);
  std::vector<Task> tasks;
  tasks.push_back(
      position_task("all configurations, batch", random_positions<tetrad::Model01>(sizes.inputs)));
  tasks.push_back(position_task("all configurations, near singular, batch",
                                positions_of<tetrad::Model01>(singular.list)));
  tasks.push_back(position_task("dyad RRR, all configurations, batch",
                                random_positions<dyad::Model01>(sizes.inputs)));
  tasks.push_back(position_task("dyad RRP, all configurations, batch",
                                random_positions<dyad::Model02>(sizes.inputs)));
  tasks.push_back(position_task("dyad RPR, all configurations, batch",
                                random_positions<dyad::Model03>(sizes.inputs)));
  tasks.push_back(derivative_task("sensitivities, velocity, acceleration, batch",
                                  random_tetrads(sizes.inputs)));
  tasks.push_back(
      derivative_task("sensitivities, velocity, acceleration, near singular, batch", singular));
  return tasks;
}

}  // namespace assur::speed
