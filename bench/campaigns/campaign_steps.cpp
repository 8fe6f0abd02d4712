// Runs one step of a campaign for callgrind, which counts its instructions per sample:
// campaign_steps (loop | rows | statistics) SCENE COUNT.
#include <array>
#include <assur/mechanism/campaign.hpp>
#include <assur/mechanism/sample_statistics.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace {

using namespace assur::mechanism;

/// What a user would write without a campaign: sets the values and finds the configuration nearest
/// to the first one. The values of a hundred samples are computed beforehand and used in turn.
double loop(const Scene& scene, const Sampling& sampling, std::uint64_t count) {
  constexpr std::uint64_t different = 100;
  std::vector<std::vector<std::pair<ParameterIndex, double>>> values_of(different);
  for (std::uint64_t sample = 0; sample < different; ++sample) {
    const std::vector<double> numbers = sampling.parameters_of(sample);
    for (std::size_t at = 0; at < numbers.size(); ++at) {
      values_of[sample].emplace_back(sampling.deviations()[at].parameter, numbers[at]);
    }
  }

  Mechanism mechanism = scene.mechanism;
  Request request;
  request.want = {.position = true, .velocity = false, .acceleration = false, .sensitivity = false};
  request.reported.links.emplace();
  request.reported.joints.emplace();
  const Plan whole(scene.mechanism, request);
  const Solution nominal = whole.solve(whole.values());
  const Table<LinkIndex, bool> by_drivers = whole.structure().placed_by_drivers();
  for (const LinkIndex link : whole.mechanism().links().keys()) {
    if (!by_drivers[link] && link != whole.mechanism().ground()) {
      const auto& direction = nominal.configurations.front().links[link].pose.direction;
      request.reference.push_back(
          {assur::text::index_of(mechanism.links(), whole.mechanism().links()[link].name),
           mechanism.add_number(std::atan2(direction.sin, direction.cos), "the nominal angle")});
    }
  }
  const Plan plan(mechanism, request);
  Values values = plan.values();
  Solution solution;
  double sum = 0;
  for (std::uint64_t sample = 0; sample < count; ++sample) {
    values.set(values_of[sample % different]);
    const auto nearest = plan.solve_nearest(values, solution);
    sum += solution.configurations[nearest->configuration].outputs.begin()->position.x();
  }
  return sum;
}

double campaign(const Sampling& sampling, bool with_statistics) {
  const Campaign campaign = sampling.campaign();
  std::vector<PointStatistics> statistics;
  for (const NominalPoint& point : sampling.nominal()) {
    statistics.emplace_back(point.position);
  }
  const std::size_t width = campaign.columns.size();
  double sum = 0;
  run_campaign(campaign, {0, campaign.items}, 1, nullptr, [&](const RowBlock& block) {
    for (std::size_t at = 0; at < block.rows.size(); at += width) {
      sum += block.rows[at + 2];  // behind the sample number and its outcome
      for (std::size_t point = 0; with_statistics && point < statistics.size(); ++point) {
        statistics[point].add({block.rows[at + 2 + 2 * point], block.rows[at + 3 + 2 * point]});
      }
    }
  });
  return sum + statistics.front().mean_shift().x();
}

}  // namespace

int main(int count, char** arguments) try {
  const std::string_view step = count == 4 ? arguments[1] : "";
  std::uint64_t samples = 0;
  const std::string_view number = count == 4 ? arguments[3] : "";
  std::from_chars(number.data(), number.data() + number.size(), samples);
  if ((step != "loop" && step != "rows" && step != "statistics") || samples == 0) {
    std::fputs("usage: campaign_steps (loop | rows | statistics) SCENE COUNT\n", stderr);
    return 2;
  }
  const Scene scene = read_scene(arguments[2]);
  const Sampling sampling(scene.mechanism, scene.request, 1, 1, samples);
  std::printf("%.17g\n", step == "loop" ? loop(scene, sampling, samples)
                                        : campaign(sampling, step == "statistics"));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "campaign_steps: %s\n", error.what());
  return 2;
}
