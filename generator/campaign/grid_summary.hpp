// The number of configurations of each cell of a grid, and where it changes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// What the rows of one cell say.
struct Cell {
  std::uint16_t configurations = 0;
  bool near_singular = false;  ///< one of its configurations is
  bool families = false;       ///< a group moves freely, or is inconsistent
  bool refused = false;
};

/// Whether two cells are known to have different numbers of configurations.
[[nodiscard]] bool is_change(const Cell& one, const Cell& other);

/// The least and the greatest value of an output's coordinate.
struct CoordinateRange {
  std::string name;
  double least, greatest;
};

class GridSummary {
 public:
  /// Throws InputError, with `where` in front, if the description is not that of a grid.
  GridSummary(Description description, const std::string& where);
  void add(const std::vector<double>& rows);

  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] const std::vector<NamedAxis>& axes() const { return axes_; }
  /// The cells of this shard; the last axis runs fastest.
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<CoordinateRange>& ranges() const { return ranges_; }
  /// For each number of configurations, how many cells have it. Refused cells are left out.
  [[nodiscard]] std::map<std::uint16_t, std::uint64_t> counts() const;
  /// How many pairs of cells that are neighbours along an axis have different numbers of
  /// configurations: between them a configuration is singular, or leaves the limits of joints.
  [[nodiscard]] std::uint64_t changes() const;
  /// The number of the first cell that is refused; the one behind the last cell if none is.
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
/// nearly singular, move freely or are refused. Lines stand where the number changes.
[[nodiscard]] std::string grid_picture(const GridSummary& summary);

}  // namespace assur::generator::campaign
