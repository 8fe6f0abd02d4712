#include "table/chart.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>

namespace assur::speed {

namespace {

/// The family, as numbered in the legend, of methods whose names start with `begins`, and the
/// label that replaces this start. The first match counts.
struct Naming {
  std::string_view begins;
  int family;
  std::string_view label;
};
constexpr std::array<Naming, 27> namings = {{
    {"generated, the nearest of all configurations", 1, "nearest of all"},
    {"generated, Newton from the neighbour", 1, "Newton, generated"},
    {"generated, ", 1, ""},
    {"generated", 1, "generated"},
    {"emitted", 1, "emitted"},
    {"assur solve", 1, "assur solve"},
    {"by hand", 2, "by hand"},
    {"dense LU", 2, "dense LU"},
    {"Eigen", 2, "Eigen"},
    {"Newton", 2, "Newton"},
    {"Ceres", 3, "Ceres"},
    {"ADOL-C", 3, "ADOL-C"},
    {"central differences, step 6e-06", 4, "differences, step 6e-06"},
    {"central differences, step", 4, {}},
    {"central differences", 4, "differences"},
    {"complex step", 4, "complex step"},
    {"special points", 5, "special points"},
    {"KINSOL", 6, "KINSOL"},
    {"GSL", 6, "GSL"},
    {"MINPACK", 6, "MINPACK"},
    {"SolveSpace", 6, "SolveSpace"},
    {"64-start", 7, "64-start"},
    {"200-start", 7, "200-start"},
    {"companion", 7, "companion"},
    {"half angle, Eigen's polynomial solver", 7, "half angle"},
    {"grid of 360 and bisection", 7, "grid, bisection"},
    {"PHCpack", 7, "PHCpack"},
}};

const Naming& naming_of(const std::string& method) {
  const auto* found = std::find_if(namings.begin(), namings.end(), [&](const Naming& naming) {
    return method.compare(0, naming.begins.size(), naming.begins) == 0;
  });
  if (found == namings.end()) {
    throw std::logic_error("the chart knows no family of the method " + method);
  }
  return *found;
}

/// Markers of float and long double, and all but one step size of differences, have no label unless
/// they fail on some inputs.
std::string label_of(const Row& row) {
  const Naming& naming = naming_of(row.method);
  const bool named = row.scalar == "double" && naming.label.data() != nullptr;
  const std::string failures = row.failures > 0 ? "(" + std::to_string(row.failures) + ")" : "";
  if (!named) {
    const std::string step = "step" + row.method.substr(naming.begins.size());
    return failures.empty() ? "" : (row.scalar == "double" ? step : row.scalar) + " " + failures;
  }
  const std::string label = std::string(naming.label) + row.method.substr(naming.begins.size());
  return failures.empty() ? label : label + " " + failures;
}

/// A method in a panel: the place of its marker, and the height of its label at the right.
struct Mark {
  const Row* row;
  std::string label;
  double error;       ///< its power of ten
  double place = 0;   ///< from the panel's bottom, 0, to its top, 1
  double height = 0;  ///< of the label, measured in the same way
  [[nodiscard]] double time() const { return std::log10(row->ns); }
};

/// Whether two labels at the time `right` should change places: the lines from their markers cross,
/// or one line passes through the other marker needlessly.
bool better_exchanged(const Mark& one, const Mark& other, double right) {
  constexpr double radius = 0.025;  // of a marker, with the gap between it and a line
  const Mark& first = one.time() < other.time() ? one : other;
  const Mark& later = one.time() < other.time() ? other : one;
  const double way = (later.time() - first.time()) / (right - first.time());
  const auto above = [&](double height) {
    return first.place + (height - first.place) * way - later.place;
  };
  const double now = above(first.height);
  const double exchanged = above(later.height);
  const double higher = first.height - later.height;
  const bool would_cross = exchanged * higher > 0;
  return now * higher < 0 ||
         (std::abs(now) < radius && std::abs(exchanged) > std::abs(now) && !would_cross);
}

/// Moves labels apart to at least `gap`, within 0 to 1: each is pushed up from below and then down
/// from above, no further than needed; then neighbours change places where that is better.
void spread(std::vector<Mark*> marks, double gap) {
  std::sort(marks.begin(), marks.end(),
            [](const Mark* a, const Mark* b) { return a->height < b->height; });
  double least = gap / 2;
  for (Mark* mark : marks) {
    mark->height = std::max(mark->height, least);
    least = mark->height + gap;
  }
  double most = 1 - gap / 2;
  double right = 0;
  for (std::size_t place = marks.size(); place-- > 0;) {
    marks[place]->height = std::min(marks[place]->height, most);
    most = marks[place]->height - gap;
    right = std::max(right, marks[place]->time() + 0.5);
  }
  for (std::size_t pass = 0; pass < marks.size(); ++pass) {
    for (std::size_t place = 1; place < marks.size(); ++place) {
      Mark*& below = marks[place - 1];
      Mark*& above = marks[place];
      if (better_exchanged(*below, *above, right)) {
        std::swap(below->height, above->height);
        std::swap(below, above);
      }
    }
  }
}

int number_of(const std::string& scalar) {
  return scalar == "double" ? 1 : scalar == "float" ? 2 : 3;
}

/// The panels of the summary, in their order.
constexpr std::array<std::string_view, 4> summary_tasks = {
    {"four-bar, position, velocity, acceleration", "sensitivities, velocity, acceleration",
     "all configurations", "six-link group, all configurations"}};

/// At most eight methods of a task in double precision: the fastest of each family first, then the
/// next of each.
Task most_telling(const Task& task) {
  constexpr std::size_t most = 8;
  std::map<int, std::vector<Entry>> of_family;
  for (const Entry& entry : task.entries) {
    if (!label_of(entry.row).empty() && entry.row.scalar == "double") {
      of_family[naming_of(entry.row.method).family].push_back(entry);
    }
  }
  for (auto& [family, entries] : of_family) {
    std::ranges::sort(entries, {}, [](const Entry& entry) { return entry.row.ns; });
  }
  Task chosen{task.name, task.inputs, {}};
  const std::size_t count = task.entries.size();
  for (std::size_t place = 0; place < count; ++place) {
    for (const auto& [family, entries] : of_family) {
      if (place < entries.size() && chosen.entries.size() < most) {
        chosen.entries.push_back(entries[place]);
      }
    }
  }
  return chosen;
}

void write_panel(const Task& task, std::ostream& out) {
  constexpr std::size_t lines = 13;  // labels that a panel has room for
  constexpr std::size_t few = 3;     // methods at most, if labels are to have room for their times
  std::vector<Mark> marks;
  const bool fails_at_a_step = std::ranges::any_of(task.entries, [](const Entry& entry) {
    return entry.row.failures > 0 && entry.row.method.starts_with("central differences, step");
  });
  double low = 0;
  double high = -20;
  for (const Entry& entry : task.entries) {
    // A method that fails in every input is drawn at the top, an exact one at the bottom.
    const double error = std::isfinite(entry.row.error) ? entry.row.error : 1;
    marks.push_back({&entry.row, label_of(entry.row), std::log10(std::max(error, 1e-20))});
    if (!fails_at_a_step && marks.back().label == "differences, step 6e-06") {
      marks.back().label = "differences, 3 steps";  // one series, named at its best step
    }
    if (task.entries.size() <= few && entry.row.failures == 0) {
      marks.back().label += ", " + std::to_string(std::lround(entry.row.ns)) + " ns";
    }
    low = std::min(low, marks.back().error);
    high = std::max(high, marks.back().error);
  }
  low = std::floor(low - 0.3);
  high = std::ceil(high + 0.3);
  std::vector<Mark*> named;
  for (Mark& mark : marks) {
    mark.place = (mark.error - low) / (high - low);
    mark.height = mark.place;
    if (!mark.label.empty()) {
      named.push_back(&mark);
    }
  }
  const std::size_t labels = named.size();
  spread(std::move(named), 1.0 / static_cast<double>(std::max(lines, labels)));
  for (const Mark& mark : marks) {
    const Row& row = *mark.row;
    out << row.ns << '\t' << std::pow(10, mark.error) << '\t' << row.failures << '\t' << mark.label
        << '\t' << naming_of(row.method).family << '\t' << number_of(row.scalar) << '\t' << row.task
        << '\t' << std::pow(10, low + mark.height * (high - low)) << '\t' << std::pow(10, low)
        << '\t' << std::pow(10, high) << '\n';
  }
  out << "\n\n";
}

}  // namespace

void write_chart_columns(const std::vector<Task>& tasks, std::ostream& out) {
  for (const Task& task : tasks) {
    write_panel(task, out);
  }
}

void write_summary_columns(const std::vector<Task>& tasks, std::ostream& out) {
  for (const std::string_view name : summary_tasks) {
    const auto task = std::ranges::find(tasks, name, &Task::name);
    if (task != tasks.end()) {
      write_panel(most_telling(*task), out);
    }
  }
}

}  // namespace assur::speed
