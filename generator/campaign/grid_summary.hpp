// The number of configurations of each cell of a grid, and its changes between cells.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// The summary of one cell's rows.
struct Cell {
  std::uint16_t configurations = 0;
  bool near_singular = false;  ///< some configuration is near-singular
  bool families = false;       ///< a group has a self-motion, or is inconsistent
  bool refused = false;
};

/// Whether two cells are known to have different numbers of configurations.
[[nodiscard]] bool is_change(const Cell& one, const Cell& other);

/// The smallest and the largest value of an output's coordinate.
struct CoordinateRange {
  std::string name;
  double least, greatest;
};

class GridSummary {
 public:
  /// Throws InputError, prefixed by `where`, if the description is not that of a grid.
  GridSummary(Description description, const std::string& where);
  void add(const std::vector<double>& rows);

  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] const std::vector<NamedAxis>& axes() const { return axes_; }
  /// The cells of this shard; the last axis runs fastest.
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<CoordinateRange>& ranges() const { return ranges_; }
  /// For each number of configurations, the number of cells that have it, without refused cells.
  [[nodiscard]] std::map<std::uint16_t, std::uint64_t> counts() const;
  /// The number of pairs of cells, neighbours along an axis, with different numbers of
  /// configurations: between them a configuration is singular, or leaves the limits of joints.
  [[nodiscard]] std::uint64_t changes() const;
  /// The number of the first refused cell; the number of cells if there is none.
  [[nodiscard]] std::uint64_t first_refused() const;

 private:
  Description description_;
  std::vector<NamedAxis> axes_;
  std::uint64_t first_cell_;
  std::vector<Cell> cells_;
  std::vector<CoordinateRange> ranges_;
};

[[nodiscard]] std::string grid_text(const GridSummary& summary);
[[nodiscard]] std::string grid_json(const GridSummary& summary);
/// Throws InputError for a grid that has more than two axes, or too many cells to be drawn.
void expect_drawable(const Description& description, const std::string& where);
/// The cells as SVG, coloured by their number of configurations, or by a colour for cells that are
/// near-singular, have a self-motion or are refused. Lines separate cells with different numbers.
[[nodiscard]] std::string grid_picture(const GridSummary& summary);

}  // namespace assur::generator::campaign
