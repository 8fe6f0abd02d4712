// Measures the speed and the accuracy of every method on random inputs. Writes speed_accuracy.json,
// .md and .dat into a directory. A number after it scales the run: 0.05 is a quick look. Names
// after that choose parts of the bench.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "table/interleaved_timer.hpp"
#include "table/report.hpp"
#include "tasks.hpp"

namespace {

using namespace assur::speed;

void append(std::vector<Task>& all, std::vector<Task> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// Tasks that are built together.
struct Part {
  const char* name;
  std::vector<Task> (*tasks)(const TaskSizes& sizes);
};
constexpr std::array<Part, 9> parts = {{
    {"everyday", everyday_tasks},
    {"forces", force_tasks},
    {"derivatives", derivative_tasks},
    {"positions", position_tasks},
    {"groups", group_tasks},
    {"tracking", tracking_tasks},
    {"scenes", [](const TaskSizes&) { return scene_tasks(); }},
    {"sweeps", sweep_tasks},
    {"batches", batch_tasks},
}};

/// Runs the named parts; all of them if none is named.
int run(const std::filesystem::path& directory, double scale,
        const std::vector<std::string>& names) {
  const auto scaled = [scale](std::size_t count, std::size_t least) {
    return std::max(least, static_cast<std::size_t>(static_cast<double>(count) * scale));
  };
  TaskSizes sizes;
  sizes.inputs = scaled(sizes.inputs, 64);
  sizes.near_singular = scaled(sizes.near_singular, 64);
  sizes.phc_inputs = scaled(sizes.phc_inputs, 2);
  std::vector<Task> tasks;
  for (const Part& part : parts) {
    if (names.empty() || std::find(names.begin(), names.end(), part.name) != names.end()) {
      append(tasks, part.tasks(sizes));
    }
  }
  std::filesystem::create_directories(directory);
  measure(tasks, TimerSettings());
  write_report(tasks, directory);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> names(arguments + std::min(count, 3), arguments + count);
  const bool known = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const Part& part) { return name == part.name; });
  });
  if (count < 2 || !known) {
    std::cerr << "usage: speed_accuracy DIRECTORY [SCALE [PART]...]\nparts:";
    for (const Part& part : parts) {
      std::cerr << ' ' << part.name;
    }
    std::cerr << '\n';
    return 2;
  }
  try {
    return run(arguments[1], count > 2 ? std::atof(arguments[2]) : 1, names);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
}
