#include "campaign/grid_summary.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/campaign.hpp>
#include <assur/text/counts.hpp>
#include <assur/text/error.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "campaign/svg_text.hpp"

namespace assur::generator::campaign {

namespace {

using Json = nlohmann::ordered_json;

/// The columns after the parameters: configurations, families, configuration, outcome.
constexpr std::size_t columns_of_a_cell = 4;

template <typename Is>
std::uint64_t count_if(const GridSummary& summary, const Is& is) {
  return static_cast<std::uint64_t>(std::ranges::count_if(summary.cells(), is));
}

struct Counted {
  const char* text;
  const char* json;
  bool Cell::*flag;
};
constexpr std::array<Counted, 3> counted = {
    {{"cells with a configuration that is nearly singular", "near_singular", &Cell::near_singular},
     {"cells with families that move freely", "families", &Cell::families},
     {"cells that are refused", "refused", &Cell::refused}}};

}  // namespace

GridSummary::GridSummary(Description description, const std::string& where)
    : description_(std::move(description)), axes_(axes_of(description_)) {
  using Kind = mechanism::Column::Kind;
  std::uint64_t items = 1;
  std::vector<Kind> kinds = {Kind::whole};
  for (const NamedAxis& axis : axes_) {
    items *= axis.count;
    kinds.push_back(Kind::real);
  }
  kinds.insert(kinds.end(), {Kind::whole, Kind::whole, Kind::whole, Kind::outcome});
  const std::size_t before_outputs = kinds.size();
  if (axes_.empty() || items != description_.items || items > mechanism::most_cells ||
      !description_.has_kinds(kinds)) {
    throw text::InputError(where + ": it is not a table of a map: its axes do not fit its cells");
  }
  const auto [first, last] =
      mechanism::part_of(items, description_.shard.number, description_.shard.count);
  first_cell_ = first;
  cells_.resize(last - first);
  for (std::size_t column = before_outputs; column < description_.columns.size(); ++column) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    ranges_.push_back({description_.columns[column].name, infinite, -infinite});
  }
}

void GridSummary::add(const std::vector<double>& rows) {
  const std::size_t width = description_.columns.size();
  for (std::size_t row = 0; row < rows.size(); row += width) {
    Cell& cell = cells_[static_cast<std::uint64_t>(rows[row]) - first_cell_];
    const double* const numbers = &rows[row + 1 + axes_.size()];
    const auto outcome = static_cast<mechanism::Outcome>(numbers[3]);
    cell.configurations = static_cast<std::uint16_t>(std::clamp(numbers[0], 0.0, 65535.0));
    cell.families = numbers[1] > 0;
    cell.near_singular = cell.near_singular || outcome == mechanism::Outcome::near_singular;
    cell.refused = outcome == mechanism::Outcome::refused;
    for (std::size_t range = 0; range < ranges_.size(); ++range) {
      const double number = numbers[columns_of_a_cell + range];
      if (std::isfinite(number)) {
        ranges_[range].least = std::min(ranges_[range].least, number);
        ranges_[range].greatest = std::max(ranges_[range].greatest, number);
      }
    }
  }
}

std::map<std::uint16_t, std::uint64_t> GridSummary::counts() const {
  std::map<std::uint16_t, std::uint64_t> counts;
  for (const Cell& cell : cells_) {
    if (!cell.refused) {
      ++counts[cell.configurations];
    }
  }
  return counts;
}

bool is_change(const Cell& one, const Cell& other) {
  return !one.refused && !other.refused && one.configurations != other.configurations;
}

std::uint64_t GridSummary::changes() const {
  std::uint64_t changes = 0;
  std::uint64_t stride = 1;
  for (std::size_t axis = axes_.size(); axis-- > 0;) {
    for (std::uint64_t place = 0; place + stride < cells_.size(); ++place) {
      const bool is_last =
          (first_cell_ + place) / stride % axes_[axis].count + 1 == axes_[axis].count;
      changes +=
          !is_last && cells_[place].configurations != cells_[place + stride].configurations ? 1 : 0;
    }
    stride *= axes_[axis].count;
  }
  return changes;
}

std::uint64_t GridSummary::first_refused() const {
  const auto found = std::ranges::find_if(cells_, &Cell::refused);
  return first_cell_ + static_cast<std::uint64_t>(found - cells_.begin());
}

std::string grid_text(const GridSummary& summary) {
  const Description& description = summary.description();
  std::string text =
      description.text_of("name") + "\n" + text::with_noun(summary.cells().size(), "cell") +
      (description.shard.is_whole() ? "" : " of shard " + description.shard.text()) + "\n";
  for (const NamedAxis& axis : summary.axes()) {
    text += "  " + axis.name + " from " + text::short_number(axis.from, 4) + " to " +
            text::short_number(axis.to, 4) + " in " + text::with_noun(axis.count, "value") + "\n";
  }
  text += "\n";
  for (const auto& [configurations, cells] : summary.counts()) {
    text += "  " + text::with_noun(cells, "cell") + " with " +
            text::with_noun(configurations, "configuration") + "\n";
  }
  text += "  " + text::with_noun(summary.changes(), "pair") +
          " of neighbours between which the number of configurations changes\n";
  for (const Counted& one : counted) {
    if (const std::uint64_t cells = count_if(summary, one.flag); cells > 0) {
      text += "  " + std::to_string(cells) + " " + one.text + "\n";
    }
  }
  for (const CoordinateRange& range : summary.ranges()) {
    if (range.least <= range.greatest) {
      text += "  " + range.name + " from " + text::short_number(range.least, 4) + " to " +
              text::short_number(range.greatest, 4) + "\n";
    }
  }
  return text;
}

std::string grid_json(const GridSummary& summary) {
  const Description& description = summary.description();
  Json root;
  root["name"] = description.text_of("name");
  root["cells"] = summary.cells().size();
  root["shard"] = description.shard.text();
  root["axes"] = Json::array();
  for (const NamedAxis& axis : summary.axes()) {
    root["axes"].push_back(
        {{"parameter", axis.name}, {"from", axis.from}, {"to", axis.to}, {"count", axis.count}});
  }
  root["configurations"] = Json::array();
  for (const auto& [configurations, cells] : summary.counts()) {
    root["configurations"].push_back({{"configurations", configurations}, {"cells", cells}});
  }
  root["changes"] = summary.changes();
  for (const Counted& one : counted) {
    root[one.json] = count_if(summary, one.flag);
  }
  root["ranges"] = Json::object();
  for (const CoordinateRange& range : summary.ranges()) {
    root["ranges"][range.name] =
        range.least <= range.greatest ? Json{range.least, range.greatest} : Json();
  }
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assur::generator::campaign
