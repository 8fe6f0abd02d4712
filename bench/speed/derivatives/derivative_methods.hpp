// The derivative tasks and the methods that take part in them.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <tuple>

#include "derivatives/derivative_errors.hpp"
#include "table/row.hpp"

namespace assur::speed {

/// Samples that all methods of a scalar share, so that the caches are alike for all.
template <typename Scalar>
using SharedSamples = std::shared_ptr<const std::vector<TetradSample<Scalar>>>;

/// A derivative task under construction.
struct DerivativeTask {
  const TetradSamples& samples;
  Task task;
  std::tuple<SharedSamples<float>, SharedSamples<double>, SharedSamples<long double>> shared{};

  /// Adds the method `evaluate(sample) -> answer` in the scalar of its samples.
  template <typename Scalar, typename Evaluate>
  void add(const std::string& method, const std::string& scalar, Evaluate evaluate) {
    auto& list = std::get<SharedSamples<Scalar>>(shared);
    if (list == nullptr) {
      list =
          std::make_shared<const std::vector<TetradSample<Scalar>>>(samples.template in<Scalar>());
    }
    Entry entry;
    entry.row.task = task.name;
    entry.row.method = method;
    entry.row.scalar = scalar;
    ErrorTally tally;
    for (std::size_t index = 0; index < list->size(); ++index) {
      tally.add(error_of(evaluate((*list)[index]), samples.truth[index]));
    }
    tally.write_to(entry.row);
    entry.run = [list = list, evaluate](std::size_t first, std::size_t last) {
      for (std::size_t index = first; index < last; ++index) {
        auto answer = evaluate((*list)[index]);
        benchmark::DoNotOptimize(answer);
      }
    };
    task.entries.push_back(std::move(entry));
  }
};

/// A method of the stability laboratory that assembles the group again at each step.
template <stability::Answer<Model01> (*method)(const stability::Geometry<Model01, double>&)>
[[nodiscard]] DerivativesAnswer<double> by_assemblies(const TetradSample<double>& sample) {
  const stability::Answer<Model01> answer = method(sample.g);
  return {answer.sensitivities, answer.motion, answer.status};
}

/// The quantity that a derivative task asks for.
enum class Wanted : unsigned char { jacobian, closure, motion, derivatives };

// One file per family of methods; each adds the methods that compute the wanted quantity.
void add_generated(DerivativeTask& task, Wanted wanted);
void add_eigen(DerivativeTask& task, Wanted wanted);
void add_ceres_jet(DerivativeTask& task, Wanted wanted);
void add_adol_c(DerivativeTask& task, Wanted wanted);
void add_differences(DerivativeTask& task, Wanted wanted);
void add_complex_step(DerivativeTask& task, Wanted wanted);

}  // namespace assur::speed
