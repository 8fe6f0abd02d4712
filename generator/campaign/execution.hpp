// Turns a campaign into its table on the disk, or takes it from there where it has been computed.
#pragma once

#include <assur/mechanism/campaign.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/outputs.hpp"

namespace assur::generator::campaign {

struct Execution {
  const mechanism::Campaign& campaign;
  Description description;  ///< of the table, with the shard to compute
  Outputs outputs;
  bool may_replace = false;
  int threads = 1;
  std::function<void(std::uint64_t)> progress;  ///< items done so far
};

/// Whether a table with the same description exists; it is complete, since tables are written whole
/// or not at all. Throws InputError where something else has its name and may not be replaced.
[[nodiscard]] bool is_computed(const Execution& execution);

/// Hands over the rows of a shard in order, and writes the table and the picture. Where the table
/// has been computed, its rows are taken from it. Throws InputError as `is_computed` does, and
/// where a file cannot be written; no part of either is left then.
void execute(const Execution& execution,
             const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
