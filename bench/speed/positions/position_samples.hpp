// Random groups that can be assembled, with all their configurations by Sturm's theorem and CLN.
#pragma once

#include <Eigen/LU>
#include <assur/assembly.hpp>
#include <random>
#include <vector>

#include "derivatives/tetrad_samples.hpp"
#include "precise.hpp"
#include "runtime/reference_roots.hpp"
#include "runtime/sturm.hpp"
#include "stability/problem.hpp"

namespace assur::speed {

template <typename Model>
struct PositionSample {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
};

/// The configurations that a method lists, up to `capacity`.
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
  std::vector<double> tolerances;  ///< an answer this near is that configuration
};

/// Largest difference of two configurations, relative for displacements above one.
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

/// The condition number of a configuration: its displacement to first order per relative change of
/// every given length, and per radian of every given angle.
template <typename Model>
[[nodiscard]] double condition(const PositionSample<Model>& sample,
                               const typename Model::template Configuration<long double>& q) {
  using Long = long double;
  constexpr int rows = Model::equation_count;
  const auto d = stability::converted<typename Model::template Dimensions<Long>>(sample.d);
  const auto u = stability::converted<typename Model::template Inputs<Long>>(sample.u);
  Matrix<Long, rows, rows> J;
  Matrix<Long, rows, Model::dimension_count> by_dimensions;
  Matrix<Long, rows, Model::input_count> by_inputs;
  Model::jacobian(d, u, q, J);
  Model::dimension_jacobian(d, u, q, by_dimensions);
  Model::input_jacobian(d, u, q, by_inputs);
  const Eigen::PartialPivLU<Matrix<Long, rows, rows>> factors(J);
  Vector<Long, rows> moved = Vector<Long, rows>::Zero();
  const auto add = [&](const auto& columns, const auto& variables) {
    const auto S = factors.solve(columns).eval();
    int column = 0;
    const auto by = [&](const auto& variable) {
      if constexpr (std::is_arithmetic_v<std::decay_t<decltype(variable)>>) {
        moved += S.col(column).cwiseAbs() * std::abs(variable);
      } else {
        moved += S.col(column).cwiseAbs();
      }
      ++column;
    };
    std::apply([&](const auto&... member) { (by(member), ...); }, variables.members());
  };
  add(by_dimensions, d);
  add(by_inputs, u);
  return static_cast<double>(moved.maxCoeff());
}

/// 1e-6, or a third of the distance to the next configuration if that is less, so that one answer
/// is never two configurations; but at least the displacement that a hundred roundings of the given
/// numbers cause, because doubles cannot resolve less.
template <typename Model>
void set_tolerances(const PositionSample<Model>& sample, PositionTruth<Model>& truth) {
  for (const auto& q : truth.list) {
    double tolerance = 1e-6;
    for (const auto& other : truth.list) {
      const double distance = apart(q, other);
      tolerance = distance > 0 ? std::min(tolerance, distance / 3) : tolerance;
    }
    const double held = 100 * std::numeric_limits<double>::epsilon() * condition(sample, q);
    truth.tolerances.push_back(std::max(tolerance, held));
  }
}

template <typename Model>
struct PositionSamples {
  std::vector<PositionSample<Model>> list;
  std::vector<PositionTruth<Model>> truth;
};

/// The different ones among the configurations of lists, in 60 digits; nothing of those that do not
/// converge.
template <typename Model, typename... Lists>
[[nodiscard]] PositionTruth<Model> precise_configurations(const PositionSample<Model>& sample,
                                                          const Lists&... lists) {
  PositionTruth<Model> truth;
  const auto d = in_scalar<typename Model::template Dimensions<Precise>>(sample.d);
  const auto u = in_scalar<typename Model::template Inputs<Precise>>(sample.u);
  const auto add = [&](const Found<Model>& found) {
    for (std::size_t index = 0; index < found.count; ++index) {
      auto q = in_scalar<typename Model::template Configuration<Precise>>(found.list[index]);
      if (!assemble<Model>(d, u, q)) {
        continue;
      }
      const auto exact = in_scalar<typename Model::template Configuration<long double>>(q);
      const bool known = std::any_of(truth.list.begin(), truth.list.end(), [&](const auto& other) {
        return apart(exact, other) < 1e-15;
      });
      if (!known) {
        truth.list.push_back(exact);
      }
    }
  };
  (add(lists), ...);
  set_tolerances(sample, truth);
  return truth;
}

/// All configurations that the generated code lists.
template <typename Model>
[[nodiscard]] Found<Model> closed_form(const PositionSample<Model>& sample) {
  const auto assembled = assemblies<Model>(sample.d, sample.u);
  Found<Model> found;
  for (int index = 0; index < assembled.count; ++index) {
    found.add(assembled.configurations[static_cast<std::size_t>(index)]);
  }
  return found;
}

template <typename Model>
[[nodiscard]] PositionTruth<Model> position_truth(const PositionSample<Model>& sample) {
  PositionTruth<Model> truth = precise_configurations(sample, closed_form(sample));
  truth.count = static_cast<std::size_t>(test::exact_assembly_count<Model>(sample.d, sample.u));
  return truth;
}

/// Groups with lengths from -2 to 2 that can be assembled; the others would be cheap.
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

/// The groups of tetrad samples without their configurations.
template <typename Model>
[[nodiscard]] PositionSamples<Model> positions_of(
    const std::vector<TetradSample<double>>& tetrads) {
  PositionSamples<Model> samples;
  for (const TetradSample<double>& tetrad : tetrads) {
    const PositionSample<Model> sample = {tetrad.g.d, tetrad.g.u};
    samples.list.push_back(sample);
    samples.truth.push_back(position_truth<Model>(sample));
  }
  return samples;
}

}  // namespace assur::speed
