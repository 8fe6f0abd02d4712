// Turns a campaign into its table on the disk, or takes it from there where it has been computed.
#pragma once

#include <assur/mechanism/campaign.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

struct Execution {
  const mechanism::Campaign& campaign;
  Description description;      ///< of the table, with the shard to compute
  std::filesystem::path table;  ///< empty where rows are not kept
  bool may_replace = false;
  int threads = 1;
  std::function<void(std::uint64_t)> progress;  ///< items done so far
};

/// Whether a table with the same description exists; it is complete, since tables are written whole
/// or not at all. Throws InputError where something else has its name and may not be replaced.
[[nodiscard]] bool is_computed(const Execution& execution);

/// Hands over the rows of a shard in order, and writes them to the table. Where the table has been
/// computed, its rows are taken from it. Throws InputError as `is_computed` does, and where the
/// table cannot be written; no part of it is left then.
void execute(const Execution& execution,
             const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
