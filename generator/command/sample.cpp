// The command `assur sample`: rows, a summary and a picture of random deviations.
#include <array>
#include <assur/mechanism/error.hpp>
#include <assur/text/counts.hpp>
#include <assur/text/error.hpp>
#include <assur/text/names.hpp>
#include <limits>

#include "campaign/partial_file.hpp"
#include "campaign/sample_summary.hpp"
#include "command/campaigns.hpp"
#include "command/output.hpp"
#include "command/scene_warnings.hpp"

namespace assur::generator::command {

namespace {

using mechanism::Outcome;

constexpr std::uint64_t most_samples = 10'000'000'000;

std::string tolerances_of(const mechanism::Mechanism& mechanism,
                          const std::vector<mechanism::Deviation>& deviations) {
  return text::joined(deviations, ", ", [&](const mechanism::Deviation& deviation) {
    return mechanism.parameters()[deviation.parameter].name + " +- " +
           campaign::number_text(deviation.half_width);
  });
}

/// Reports the first sample of each outcome without a configuration, and the reason.
void tell_lost_samples(const mechanism::Mechanism& mechanism, const mechanism::Sampling& sampling,
                       const campaign::SampleSummary& summary) {
  constexpr std::array<Outcome, 4> lost = {Outcome::beyond_limits, Outcome::no_assembly,
                                           Outcome::degenerate, Outcome::refused};
  for (const Outcome outcome : lost) {
    if (summary.count_of(outcome) == 0) {
      continue;
    }
    const std::uint64_t sample = summary.first_of(outcome);
    const std::vector<double> numbers = sampling.parameters_of(sample);
    std::string settings;
    for (std::size_t place = 0; place < numbers.size(); ++place) {
      settings += " --set " + mechanism.parameters()[sampling.deviations()[place].parameter].name +
                  "=" + campaign::number_text(numbers[place]);
    }
    remarks() << text::with_noun(summary.count_of(outcome), "sample")
              << (summary.count_of(outcome) == 1 ? " is " : " are ")
              << mechanism::outcome_words[static_cast<std::size_t>(outcome)] << "; sample "
              << sample << ": " << sampling.reason_of(sample) << " (" << settings.substr(1)
              << ")\n";
  }
}

void sample(const SampleOptions& options, CampaignScene& scene) {
  const std::uint64_t count = whole_number(options.count, 1, most_samples, "--count");
  const std::uint64_t seed =
      whole_number(options.seed, 0, std::numeric_limits<std::uint64_t>::max(), "--seed");
  campaign::Outputs files = files_of(options, {options.scene});
  const mechanism::Mechanism& mechanism = scene.scene.mechanism;
  const mechanism::Request& request = scene.scene.request;
  const mechanism::Sampling sampling(mechanism, request, static_cast<std::size_t>(options.branch),
                                     seed, count);
  warn_of_idle_links(scene.scene);
  const mechanism::Campaign campaign = sampling.campaign();
  campaign::Description& description = scene.description;
  description.columns = campaign.columns;
  description.items = campaign.items;
  description.add("seed", std::to_string(seed));
  description.add("configuration",
                  options.branch > 0          ? "configuration " + std::to_string(options.branch)
                  : request.reference.empty() ? "configuration 1"
                                              : "the configuration of the reference");
  description.add("tolerances", tolerances_of(mechanism, sampling.deviations()));
  campaign::describe_nominal(sampling, description);
  campaign::SampleSummary summary(description, options.scene);
  files.drawing = [&summary] { return campaign::histogram_picture(summary); };
  if (!compute(options, files, campaign, description,
               [&summary](const std::vector<double>& rows) { summary.add(rows); })) {
    return;
  }
  tell_lost_samples(mechanism, sampling, summary);
  print(options.format == "json" ? campaign::sample_json(summary) : campaign::sample_text(summary));
}

}  // namespace

void run_sample(const SampleOptions& options) {
  CampaignScene scene = campaign_scene("sample", options);
  try {
    sample(options, scene);
  } catch (const mechanism::NoSuchConfiguration& error) {
    throw text::InputError(options.scene + ": --branch: " + error.what());
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(options.scene + ": " + error.what());
  }
}

}  // namespace assur::generator::command
