// Options and files that `assur sample`, `assur map` and `assur merge` share.
#pragma once

#include <assur/mechanism/campaign.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/outputs.hpp"

namespace assur::generator::command {

struct CampaignOptions {
  std::string scene;
  std::vector<std::string> settings;
  std::string output, plot;
  std::string shard = "1/1";
  std::string format = "text";
  int threads = 0;  ///< zero: as many as there are cores
  bool force = false;
};

struct SampleOptions : CampaignOptions {
  std::string count, seed;
  int branch = 0;
};

struct MapOptions : CampaignOptions {
  std::string over;
};

struct MergeOptions : CampaignOptions {
  std::vector<std::string> files;
};

/// Each writes the table, unless sample or map find it complete, and the picture, and prints a
/// summary. Throws InputError for invalid input and if a file cannot be written.
void run_sample(const SampleOptions& options);
void run_map(const MapOptions& options);
void run_merge(const MergeOptions& options);

/// The files of `--output`, in the format of its extension, and `--plot`. Throws InputError for
/// other extensions, for impossible names, for files that are read (`inputs`), for a picture of a
/// shard, and if the name of the picture is taken.
[[nodiscard]] campaign::Outputs files_of(const CampaignOptions& options,
                                         const std::vector<std::string>& inputs);

/// The scene, its text's hash and the settings.
struct CampaignScene {
  mechanism::Scene scene;
  campaign::Description description;
};
[[nodiscard]] CampaignScene campaign_scene(const std::string& campaign,
                                           const CampaignOptions& options);

/// Computes and writes the rows and the picture, on this rank or on all of them together, and hands
/// over the rows of the requested shard. Returns false, without rows, on any rank but the first.
[[nodiscard]] bool compute(const CampaignOptions& options, const campaign::Outputs& files,
                           const mechanism::Campaign& campaign,
                           const campaign::Description& description,
                           const std::function<void(const std::vector<double>&)>& use);

/// An integer up to a limit, in digits or as 1e6; throws InputError with the option's name.
[[nodiscard]] std::uint64_t whole_number(const std::string& text, std::uint64_t least,
                                         std::uint64_t most, const std::string& option);

}  // namespace assur::generator::command
