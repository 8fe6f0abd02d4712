#include "table/chart.hpp"

#include <array>
#include <stdexcept>
#include <string_view>

namespace assur::speed {

namespace {

/// Methods by how their names begin, the first that fits: their family, as the legend numbers it,
/// and what a label says in place of that beginning.
struct Naming {
  std::string_view begins;
  int family;
  std::string_view label;
};
constexpr std::array<Naming, 25> namings = {{
    {"generated, the nearest of all configurations", 1, "nearest of all"},
    {"generated, Newton from the neighbour", 1, "Newton, generated"},
    {"generated, ", 1, ""},
    {"generated", 1, "generated"},
    {"emitted", 1, "emitted"},
    {"assur solve", 1, "assur solve"},
    {"by hand", 2, "by hand"},
    {"Eigen", 2, "Eigen"},
    {"Newton", 2, "Newton"},
    {"64-start", 2, "64-start"},
    {"Ceres", 3, "Ceres"},
    {"ADOL-C", 3, "ADOL-C"},
    // The steps of differences are one series; it is named at its best one.
    {"central differences, step 6e-06", 4, "differences, 3 steps"},
    {"central differences, step", 4, {}},
    {"central differences", 4, "differences"},
    {"complex step", 4, "complex step"},
    {"special points", 5, "special points"},
    {"KINSOL", 6, "KINSOL"},
    {"GSL", 6, "GSL"},
    {"MINPACK", 6, "MINPACK"},
    {"SolveSpace", 6, "SolveSpace"},
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

/// Empty where the marker tells enough: float and long double, and all but one step of differences.
std::string label_of(const Row& row) {
  const Naming& naming = naming_of(row.method);
  if (row.scalar != "double" || naming.label.data() == nullptr) {
    return "";
  }
  std::string label = std::string(naming.label) + row.method.substr(naming.begins.size());
  if (row.failures > 0) {
    label += " (" + std::to_string(row.failures) + ")";
  }
  return label;
}

/// Moves heights apart to at least `gap`, in their order, within 0 to 1, each as little as that
/// takes when they are pushed up from below and then down from above.
void spread(std::vector<double*> heights, double gap) {
  std::sort(heights.begin(), heights.end(),
            [](const double* a, const double* b) { return *a < *b; });
  double least = gap / 2;
  for (double* height : heights) {
    *height = std::max(*height, least);
    least = *height + gap;
  }
  double most = 1 - gap / 2;
  for (std::size_t place = heights.size(); place-- > 0;) {
    *heights[place] = std::min(*heights[place], most);
    most = *heights[place] - gap;
  }
}

int number_of(const std::string& scalar) {
  return scalar == "double" ? 1 : scalar == "float" ? 2 : 3;
}

void write_panel(const Task& task, std::ostream& out) {
  constexpr std::size_t lines = 13;  // of labels that a panel has room for
  constexpr std::size_t few = 3;     // methods, beside whose names there is room for their times
  struct Mark {
    const Row* row;
    std::string label;
    double error, height;
  };
  std::vector<Mark> marks;
  double low = 0;
  double high = -20;
  for (const Entry& entry : task.entries) {
    // What errs in every input is drawn at the top, what is exact at the bottom.
    const double error = std::isfinite(entry.row.error) ? entry.row.error : 1;
    marks.push_back({&entry.row, label_of(entry.row), std::log10(std::max(error, 1e-20)), 0});
    if (task.entries.size() <= few && entry.row.failures == 0) {
      marks.back().label += ", " + std::to_string(std::lround(entry.row.ns)) + " ns";
    }
    low = std::min(low, marks.back().error);
    high = std::max(high, marks.back().error);
  }
  low = std::floor(low - 0.3);
  high = std::ceil(high + 0.3);
  std::vector<double*> heights;
  for (Mark& mark : marks) {
    mark.height = (mark.error - low) / (high - low);
    if (!mark.label.empty()) {
      heights.push_back(&mark.height);
    }
  }
  const std::size_t labels = heights.size();
  spread(std::move(heights), 1.0 / static_cast<double>(std::max(lines, labels)));
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

}  // namespace assur::speed
