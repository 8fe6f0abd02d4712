#include "tracking/tracking_samples.hpp"

#include "positions/position_samples.hpp"

namespace assur::speed {

namespace {

constexpr unsigned seed = 57721;

/// The configuration nearest to another one, and the distance of the second nearest.
struct Nearest {
  int index = -1;
  double distance = 10;
  double second = 10;
};

Nearest nearest(const Assemblies<Model01>& set, const Model01::Configuration<double>& q) {
  Nearest result;
  for (int index = 0; index < set.count; ++index) {
    const double distance = apart(set.configurations[static_cast<std::size_t>(index)], q);
    if (distance < result.distance) {
      result = {index, distance, result.distance};
    } else {
      result.second = std::min(result.second, distance);
    }
  }
  return result;
}

/// Follows the branch by complete sets of configurations: a match must be 20 times nearer than any
/// other configuration, or the interval is halved. Empty where the branch ends; `unclear` where
/// even a billionth of the step does not decide.
std::optional<Model01::Configuration<double>> follow(const TrackingSample& sample, double from,
                                                     double to, Model01::Configuration<double> q,
                                                     bool& unclear) {
  const double shortest = 1e-9 * std::abs(to - from);
  double width = (to - from) / 16;
  while (from < to) {
    const double next = std::min(to, from + width);
    const auto set = assemblies<Model01>(sample.d, sample.at(next).u);
    const Nearest match = nearest(set, q);
    if (match.index >= 0 && 20 * match.distance < match.second && match.distance < 0.05) {
      q = set.configurations[static_cast<std::size_t>(match.index)];
      from = next;
      width *= 2;
      continue;
    }
    width = (next - from) / 2;
    if (width < shortest) {
      // Near a fold the two configurations that meet are apart by the square root of the distance.
      const auto here = assemblies<Model01>(sample.d, sample.at(from).u);
      const auto beyond = assemblies<Model01>(sample.d, sample.at(from + 1e-6).u);
      unclear = beyond.count >= here.count;
      return std::nullopt;
    }
  }
  return q;
}

}  // namespace

TrackingSamples random_steps(std::size_t count, double step) {
  test::RandomInputs random(seed);
  TrackingSamples samples;
  while (samples.list.size() < count) {
    TrackingSample sample;
    sample.d = random.variables<Model01::Dimensions<double>>();
    sample.u = random.variables<Model01::Inputs<double>>();
    sample.radius = random.between(0.2, 1);
    sample.from = random.between(0, 6.28);
    sample.to = sample.from + step;
    const InputMotion<Model01> inputs = sample.at(sample.from);
    const auto set = assemblies<Model01>(sample.d, inputs.u);
    if (set.count == 0) {
      continue;
    }
    const int chosen = random.integer(0, set.count - 1);
    const auto& q = set.configurations[static_cast<std::size_t>(chosen)];
    sample.start = branch_point<Model01>(sample.d, inputs, q);
    sample.theta = {angle_of(q.theta_BCG), angle_of(q.theta_EDF), angle_of(q.theta_CD),
                    angle_of(q.theta_GF)};
    bool unclear = false;
    const auto end = follow(sample, sample.from, sample.to, q, unclear);
    if (unclear) {
      continue;
    }
    std::optional<Model01::Configuration<long double>> exact_end;
    if (end) {
      auto exact = in_scalar<Model01::Configuration<Precise>>(*end);
      if (!assemble<Model01>(in_scalar<Model01::Dimensions<Precise>>(sample.d),
                             in_scalar<Model01::Inputs<Precise>>(sample.at(sample.to).u), exact)) {
        continue;
      }
      exact_end = in_scalar<Model01::Configuration<long double>>(exact);
    }
    samples.list.push_back(sample);
    samples.ends.push_back(exact_end);
  }
  return samples;
}

}  // namespace assur::speed
