// Results that later calls take as arguments: a configuration of a solution, and a batch.
#pragma once

#include <cstdint>
#include <map>

#include "following.hpp"
#include "solved_scene.hpp"

namespace assur::python {

/// A row of a solution.
struct SolvedConfiguration : RowsView {
  SharedSolution solution;
  std::size_t place;
};

/// The configurations of many items; if the batch follows a branch, one row for each item.
struct SolvedBatch : RowsView {
  SharedPlan planned;
  std::vector<std::uint8_t> status, gap;
  std::vector<std::int64_t> item, configuration, offsets;
  std::map<std::int64_t, std::string>
      reasons;                ///< reasons of the gaps in a batch that follows a branch
  std::optional<Place> last;  ///< the last row of such a batch that is not a gap
};

}  // namespace assur::python
