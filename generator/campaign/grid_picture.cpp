// Draws a grid of cells with the curves on which the number of configurations changes.
#include <algorithm>
#include <array>
#include <assur/text/error.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <functional>

#include "campaign/grid_summary.hpp"
#include "campaign/svg_text.hpp"

namespace assur::generator::campaign {

namespace {

constexpr double map_width = 640;
constexpr double map_height = 480;
constexpr double map_height_of_one_axis = 60;
constexpr double map_left = 90;
constexpr double map_top = 60;
constexpr double legend = 170;
constexpr std::uint64_t most_drawn = 4'000'000;

constexpr const char* singular = "#ff7f0e";
constexpr const char* free_motion = "#d62728";
constexpr const char* refused = "#7f7f7f";

/// Nearly white for the smallest number of configurations, and darker for larger ones.
std::string colour_of(std::size_t rank, std::size_t ranks) {
  const double share = ranks < 2 ? 0 : static_cast<double>(rank) / static_cast<double>(ranks - 1);
  const auto between = [share](int light, int dark) {
    return std::to_string(light + static_cast<int>(std::lround(share * (dark - light))));
  };
  return "rgb(" + between(247, 49) + "," + between(251, 110) + "," + between(255, 173) + ")";
}

class Map {
 public:
  explicit Map(const GridSummary& summary) : summary_(summary) {
    for (const auto& [configurations, cells] : summary.counts()) {
      numbers_.push_back(configurations);
    }
    const std::vector<NamedAxis>& axes = summary.axes();
    columns_ = axes[0].count;
    rows_ = axes.size() == 2 ? axes[1].count : 1;
    height_ = axes.size() == 2 ? map_height : map_height_of_one_axis;
  }

  [[nodiscard]] std::string svg() const {
    return document(map_left + map_width + legend, map_top + height_ + 50,
                    head() + cells() + curves() + axes() + key());
  }

 private:
  /// The first axis runs to the right, the second upwards.
  [[nodiscard]] const Cell& cell(std::uint64_t column, std::uint64_t row) const {
    return summary_.cells()[column * rows_ + row];
  }
  [[nodiscard]] double x_of(std::uint64_t column) const {
    return map_left + map_width * static_cast<double>(column) / static_cast<double>(columns_);
  }
  [[nodiscard]] double y_of(std::uint64_t row) const {
    return map_top + height_ * (1 - static_cast<double>(row) / static_cast<double>(rows_));
  }

  [[nodiscard]] std::string fill_of(const Cell& cell) const {
    if (cell.refused) {
      return refused;
    }
    if (cell.families) {
      return free_motion;
    }
    return cell.near_singular ? singular : colour_of(cell.configurations);
  }
  [[nodiscard]] std::string colour_of(std::uint16_t configurations) const {
    const auto found = std::ranges::lower_bound(numbers_, configurations);
    return campaign::colour_of(static_cast<std::size_t>(found - numbers_.begin()), numbers_.size());
  }

  [[nodiscard]] std::string head() const {
    return words(map_left, 22, "start", summary_.description().text_of("name")) +
           words(map_left, 42, "start", "number of configurations; lines where it changes");
  }

  /// One rectangle for neighbouring cells of one colour in a column.
  [[nodiscard]] std::string cells() const {
    std::string body = "<g shape-rendering=\"crispEdges\">\n";
    for (std::uint64_t column = 0; column < columns_; ++column) {
      for (std::uint64_t row = 0; row < rows_;) {
        const std::string fill = fill_of(cell(column, row));
        std::uint64_t end = row + 1;
        while (end < rows_ && fill_of(cell(column, end)) == fill) {
          ++end;
        }
        body += rectangle(x_of(column), y_of(end), x_of(column + 1) - x_of(column),
                          y_of(row) - y_of(end), fill);
        row = end;
      }
    }
    return body + "</g>\n";
  }

  [[nodiscard]] std::string curves() const {
    std::string path;
    const auto add = [&path](double x1, double y1, double x2, double y2) {
      path += "M" + at(x1) + " " + at(y1) + "L" + at(x2) + " " + at(y2);
    };
    for (std::uint64_t column = 0; column < columns_; ++column) {
      for (std::uint64_t row = 0; row < rows_; ++row) {
        const Cell& here = cell(column, row);
        if (column + 1 < columns_ && is_change(here, cell(column + 1, row))) {
          add(x_of(column + 1), y_of(row), x_of(column + 1), y_of(row + 1));
        }
        if (row + 1 < rows_ && is_change(here, cell(column, row + 1))) {
          add(x_of(column), y_of(row + 1), x_of(column + 1), y_of(row + 1));
        }
      }
    }
    return "<path d=\"" + path + "\" stroke=\"black\" stroke-width=\"1.2\" fill=\"none\"/>\n";
  }

  [[nodiscard]] std::string axes() const {
    const NamedAxis& across = summary_.axes()[0];
    const double below = map_top + height_ + 18;
    std::string body = words(map_left, below, "start", text::short_number(across.from, 4)) +
                       words(map_left + map_width, below, "end", text::short_number(across.to, 4)) +
                       words(map_left + map_width / 2, below + 10, "middle", across.name);
    if (summary_.axes().size() == 2) {
      const NamedAxis& up = summary_.axes()[1];
      body += words(map_left - 6, map_top + height_, "end", text::short_number(up.from, 4)) +
              words(map_left - 6, map_top + 10, "end", text::short_number(up.to, 4)) +
              words(map_left - 6, map_top + height_ / 2, "end", up.name);
    }
    return body;
  }

  [[nodiscard]] std::string key() const {
    std::string body;
    double y = map_top;
    const auto add = [&](const std::string& colour, const std::string& text) {
      body += rectangle(map_left + map_width + 15, y, 14, 14, "black") +
              rectangle(map_left + map_width + 16, y + 1, 12, 12, colour) +
              words(map_left + map_width + 36, y + 11, "start", text);
      y += 20;
    };
    for (const std::uint16_t number : numbers_) {
      add(colour_of(number), std::to_string(number));
    }
    const auto has = [this](bool Cell::*flag) {
      return std::ranges::any_of(summary_.cells(), std::mem_fn(flag));
    };
    if (has(&Cell::near_singular)) {
      add(singular, "nearly singular");
    }
    if (has(&Cell::families)) {
      add(free_motion, "moves freely");
    }
    if (has(&Cell::refused)) {
      add(refused, "refused");
    }
    return body;
  }

  const GridSummary& summary_;
  std::vector<std::uint16_t> numbers_;
  std::uint64_t columns_, rows_;
  double height_;
};

}  // namespace

void expect_drawable(const Description& description, const std::string& where) {
  const std::size_t axes = description.texts_of("axis").size();
  if (axes > 2) {
    throw text::InputError(where + ": a picture has one or two axes, not " + std::to_string(axes) +
                           "; write a table only, .csv or .h5");
  }
  if (description.items > most_drawn) {
    throw text::InputError(where + ": a picture has at most " + std::to_string(most_drawn) +
                           " cells, not " + std::to_string(description.items) +
                           "; write a table only, .csv or .h5");
  }
}

std::string grid_picture(const GridSummary& summary) { return Map(summary).svg(); }

}  // namespace assur::generator::campaign
