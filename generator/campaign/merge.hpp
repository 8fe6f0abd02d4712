// Merges the tables of all shards of a campaign into one.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/outputs.hpp"

namespace assur::generator::campaign {

/// Tables of one campaign, sorted by shard.
struct ShardFiles {
  Description description;  ///< of the whole
  std::vector<std::filesystem::path> files;
};

/// Throws InputError if a file is not a table, two are not of one campaign or contain the same
/// shard, or shards are missing; the message names them.
[[nodiscard]] ShardFiles shard_files(const std::vector<std::filesystem::path>& files);

/// Writes the rows of all tables to one, and its picture, and hands the rows over. Throws
/// InputError if the rows of a file do not fit its description; then writes nothing.
void merge(const ShardFiles& shards, const Outputs& outputs,
           const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
