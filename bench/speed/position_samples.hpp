// Random groups that can be assembled, and all their configurations by Sturm's theorem and CLN.
#pragma once

#include <assur/assembly.hpp>
#include <random>
#include <vector>

#include "../../tests/reference_roots.hpp"
#include "../../tests/sturm.hpp"
#include "precise.hpp"

namespace assur::speed {

template <typename Model>
struct PositionSample {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
};

/// What a method lists, at most this many.
template <typename Model>
struct Found {
  using Configuration = typename Model::template Configuration<double>;
  static constexpr std::size_t capacity = 16;
  std::size_t count = 0;
  std::array<Configuration, capacity> list;

  void add(const Configuration& q) {
    if (count < capacity) {
      list[count++] = q;
    }
  }
};

/// The configurations of a sample in 60 digits, kept as long double.
template <typename Model>
struct PositionTruth {
  std::size_t count = 0;  ///< by Sturm's theorem
  std::vector<typename Model::template Configuration<long double>> list;
};

/// Largest difference of two configurations; of displacements above one, relative.
template <typename A, typename B>
[[nodiscard]] double apart(const A& a, const B& b) {
  long double largest = 0;
  const auto off = [](const auto& x, const auto& y) -> long double {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(x)>>) {
      const auto exact = static_cast<long double>(y);
      return std::abs(static_cast<long double>(x) - exact) / std::max(1.0L, std::abs(exact));
    } else {
      return std::max(std::abs(static_cast<long double>(x.cos) - static_cast<long double>(y.cos)),
                      std::abs(static_cast<long double>(x.sin) - static_cast<long double>(y.sin)));
    }
  };
  std::apply(
      [&](const auto&... x) {
        std::apply([&](const auto&... y) { ((largest = std::max(largest, off(x, y))), ...); },
                   b.members());
      },
      a.members());
  return static_cast<double>(largest);
}

template <typename Model>
struct PositionSamples {
  std::vector<PositionSample<Model>> list;
  std::vector<PositionTruth<Model>> truth;
};

template <typename Model>
[[nodiscard]] PositionTruth<Model> position_truth(const PositionSample<Model>& sample) {
  PositionTruth<Model> truth;
  truth.count = static_cast<std::size_t>(test::exact_assembly_count<Model>(sample.d, sample.u));
  const auto d = in_scalar<typename Model::template Dimensions<Precise>>(sample.d);
  const auto u = in_scalar<typename Model::template Inputs<Precise>>(sample.u);
  const auto found = assemblies<Model>(sample.d, sample.u);
  for (int index = 0; index < found.count; ++index) {
    auto q = in_scalar<typename Model::template Configuration<Precise>>(
        found.configurations[static_cast<std::size_t>(index)]);
    if (!assemble<Model>(d, u, q)) {
      continue;
    }
    const auto exact = in_scalar<typename Model::template Configuration<long double>>(q);
    const bool known = std::any_of(truth.list.begin(), truth.list.end(),
                                   [&](const auto& other) { return apart(exact, other) < 1e-15; });
    if (!known) {
      truth.list.push_back(exact);
    }
  }
  return truth;
}

/// Lengths from -2 to 2, all of which can be assembled: one that cannot would be cheap.
template <typename Model>
[[nodiscard]] PositionSamples<Model> random_positions(std::size_t count) {
  test::RandomInputs random(31415 + static_cast<unsigned>(Model::number));
  PositionSamples<Model> samples;
  while (samples.list.size() < count) {
    const PositionSample<Model> sample = {
        random.variables<typename Model::template Dimensions<double>>(),
        random.variables<typename Model::template Inputs<double>>()};
    PositionTruth<Model> truth = position_truth<Model>(sample);
    if (truth.count > 0) {
      samples.list.push_back(sample);
      samples.truth.push_back(std::move(truth));
    }
  }
  return samples;
}

/// The largest error of a complete answer; infinite if one is lost or invented. Near is below 1e-6.
template <typename Model>
[[nodiscard]] double position_error(const Found<Model>& found, const PositionTruth<Model>& truth) {
  constexpr double near = 1e-6;
  double worst = 0;
  std::vector<bool> used(found.count, false);
  for (const auto& exact : truth.list) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    for (std::size_t index = 0; index < found.count; ++index) {
      const double distance = apart(found.list[index], exact);
      if (!used[index] && distance < best) {
        best = distance;
        chosen = index;
      }
    }
    if (!(best < near)) {
      return std::numeric_limits<double>::infinity();
    }
    used[chosen] = true;
    worst = std::max(worst, best);
  }
  const bool complete = truth.list.size() == truth.count && found.count == truth.count;
  return complete ? worst : std::numeric_limits<double>::infinity();
}

}  // namespace assur::speed
