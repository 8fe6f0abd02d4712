// Turns the tables of all shards of a campaign into the table of the whole campaign.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// Tables of one campaign, in the order of their shards, whatever order they were named in.
struct ShardFiles {
  Description description;  ///< of the whole
  std::vector<std::filesystem::path> files;
};

/// Throws InputError where a file is no table, two are not of one campaign or hold the same shard,
/// or shards are missing; the message names them.
[[nodiscard]] ShardFiles shard_files(const std::vector<std::filesystem::path>& files);

/// Writes the rows of all of them to one table, if it has a name, and hands them over. Throws
/// InputError where a file is not whole, and leaves no table then.
void merge(const ShardFiles& shards, const std::filesystem::path& table,
           const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
