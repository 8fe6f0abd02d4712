// Turns the tables of all shards of a campaign into the table of the whole campaign.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/outputs.hpp"

namespace assur::generator::campaign {

/// Tables of one campaign, in the order of their shards, whatever order they were named in.
struct ShardFiles {
  Description description;  ///< of the whole
  std::vector<std::filesystem::path> files;
};

/// Throws InputError where a file is no table, two are not of one campaign or hold the same shard,
/// or shards are missing; the message names them.
[[nodiscard]] ShardFiles shard_files(const std::vector<std::filesystem::path>& files);

/// Writes the rows of all of them to one table, and its picture, and hands them over. Throws
/// InputError where a file does not hold what it should, and writes nothing then.
void merge(const ShardFiles& shards, const Outputs& outputs,
           const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
