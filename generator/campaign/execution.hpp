// Computes a campaign and writes its table, or reads the table if it exists.
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

/// Whether a table with the same description exists; tables are never written in part, so it is
/// complete. Throws InputError if another file has its name and may not be replaced.
[[nodiscard]] bool is_computed(const Execution& execution);

/// Hands over the rows of a shard in order, and writes the table and the picture. If the table
/// exists, its rows are read from it. Throws InputError as `is_computed` does, and if a file cannot
/// be written; then no part of either is left.
void execute(const Execution& execution,
             const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
