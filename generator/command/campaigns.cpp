#include "command/campaigns.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/quoted.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <thread>

#include "campaign/execution.hpp"
#include "campaign/merge.hpp"
#include "campaign/table_file.hpp"
#include "command/output.hpp"
#include "command/ranks.hpp"

namespace assur::generator::command {

namespace {

namespace fs = std::filesystem;
using Use = std::function<void(const std::vector<double>&)>;

/// The file of a rank's shard is beside the file of the whole.
fs::path shard_file(const CampaignOptions& options, const campaign::Shard& shard) {
  const fs::path output = options.output;
  fs::path file = output;
  file.replace_extension(".shard-" + std::to_string(shard.number) + "-of-" +
                         std::to_string(shard.count) +
                         (output.extension() == ".svg" ? ".csv" : output.extension().string()));
  return file;
}

int threads_of(const CampaignOptions& options, const Ranks& ranks) {
  if (options.threads > 0) {
    return options.threads;
  }
  // Several ranks are assumed to have one core each.
  return ranks.count() > 1 ? 1
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Every rank computes its shard; then the first one merges them.
bool compute_on_ranks(const Ranks& ranks, campaign::Execution whole, const CampaignOptions& options,
                      const Use& use) {
  std::vector<fs::path> files;
  for (std::uint64_t rank = 1; rank <= ranks.count(); ++rank) {
    files.push_back(shard_file(options, {rank, ranks.count()}));
  }
  ranks.together([&] {
    campaign::Execution own = whole;
    own.description.shard = {ranks.number() + 1, ranks.count()};
    own.outputs = {files[ranks.number()], {}, {}};
    campaign::execute(own, [](const std::vector<double>&) {});
  });
  ranks.together([&] {
    if (ranks.is_first()) {
      campaign::merge(campaign::shard_files(files), whole.outputs, use);
      for (const fs::path& file : files) {
        fs::remove(file);
      }
    }
  });
  return ranks.is_first();
}

}  // namespace

campaign::Outputs files_of(const CampaignOptions& options, const std::vector<std::string>& inputs) {
  const fs::path output = options.output;
  const fs::path plot = options.plot;
  campaign::Outputs files;
  if (output.extension() == ".svg") {
    if (!plot.empty()) {
      throw text::InputError("--plot: " + plot.string() + ": the output is a picture already");
    }
    files.picture = output;
  } else {
    campaign::expect_table_name(output, "--output");
    files.table = output;
    files.picture = plot;
  }
  for (const fs::path& file : {files.table, files.picture}) {
    if (!file.empty()) {
      campaign::expect_writable(file);
      campaign::expect_other(file, {inputs.begin(), inputs.end()});
    }
  }
  if (files.picture.empty()) {
    return files;
  }
  if (files.picture.extension() != ".svg") {
    throw text::InputError("--plot: " + plot.string() +
                           ": a picture is SVG; give it the extension .svg");
  }
  if (!campaign::shard_of(options.shard, "--shard").is_whole()) {
    throw text::InputError(files.picture.string() +
                           ": a single shard has no picture; draw it when the shards are merged");
  }
  campaign::expect_new(files.picture, options.force);
  return files;
}

CampaignScene campaign_scene(const std::string& campaign, const CampaignOptions& options) {
  const std::string text = text::read_input_file(options.scene);
  CampaignScene result{mechanism::parse_scene(text, options.scene, options.settings, "--set"), {}};
  campaign::Description& description = result.description;
  const std::string& name = result.scene.mechanism.name();
  description.add("assur", campaign);
  description.add("version", ASSUR_VERSION);
  description.add("scene", campaign::hash_of(text));
  description.add("name", name.empty() ? "a mechanism without a name" : name);
  for (const std::string& setting : options.settings) {
    description.add("set", setting);
  }
  description.shard = campaign::shard_of(options.shard, "--shard");
  return result;
}

bool compute(const CampaignOptions& options, const campaign::Outputs& files,
             const mechanism::Campaign& campaign, const campaign::Description& description,
             const Use& use) {
  const Ranks ranks;
  const std::uint64_t items =
      description.items / description.shard.count / ranks.count();  // roughly, for the progress bar
  ProgressBar bar;
  campaign::Execution execution{
      campaign, description, files, options.force, threads_of(options, ranks), nullptr};
  execution.progress = [&](std::uint64_t done) {
    if (ranks.is_first()) {
      bar.show(done, items);
    }
  };
  if (ranks.count() == 1) {
    if (campaign::is_computed(execution)) {
      remarks() << files.table.string() << ": the table is complete and is not computed again\n";
    }
    campaign::execute(execution, use);
    return true;
  }
  bool is_computed = false;
  ranks.together([&] {
    if (!description.shard.is_whole()) {
      throw text::InputError("--shard: each rank of MPI is a shard; leave it out");
    }
    is_computed = campaign::is_computed(execution);
  });
  if (is_computed) {
    if (ranks.is_first()) {
      campaign::execute(execution, use);
    }
    return ranks.is_first();
  }
  return compute_on_ranks(ranks, execution, options, use);
}

std::uint64_t whole_number(const std::string& text, std::uint64_t least, std::uint64_t most,
                           const std::string& option) {
  const char* const end = text.data() + text.size();
  std::uint64_t number = 0;
  const auto [at, error] = std::from_chars(text.data(), end, number);
  bool is_whole = error == std::errc() && at == end;
  if (!is_whole) {
    double power = 0;  // 1e6 is an integer, too
    const auto [stop, failure] = std::from_chars(text.data(), end, power);
    is_whole = failure == std::errc() && stop == end && power >= 0 && power <= 0x1p53 &&
               power == std::floor(power);
    number = is_whole ? static_cast<std::uint64_t>(power) : 0;
  }
  if (!is_whole || number < least || number > most) {
    throw text::InputError(option + ": expected a whole number from " + std::to_string(least) +
                           " to " + std::to_string(most) + ", found " + text::in_quotes(text));
  }
  return number;
}

}  // namespace assur::generator::command
