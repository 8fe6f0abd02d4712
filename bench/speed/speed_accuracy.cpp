// Turns random inputs into the speed and the accuracy of every method: speed_accuracy.json, .md and
// .dat, into a directory. A number after it scales the run: 0.05 is a quick look.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "table/interleaved_timer.hpp"
#include "table/report.hpp"
#include "tasks.hpp"

namespace {

using namespace assur::speed;

void append(std::vector<Task>& all, std::vector<Task> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

int run(const std::filesystem::path& directory, double scale) {
  const auto scaled = [scale](std::size_t count, std::size_t least) {
    return std::max(least, static_cast<std::size_t>(static_cast<double>(count) * scale));
  };
  TaskSizes sizes;
  sizes.inputs = scaled(sizes.inputs, 64);
  sizes.near_singular = scaled(sizes.near_singular, 64);
  sizes.phc_inputs = scaled(sizes.phc_inputs, 2);
  std::vector<Task> tasks;
  append(tasks, derivative_tasks(sizes));
  append(tasks, position_tasks(sizes));
  append(tasks, tracking_tasks(sizes));
  append(tasks, scene_tasks());
  append(tasks, sweep_tasks(sizes));
  measure(tasks, TimerSettings());
  write_report(tasks, directory);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 && count != 3) {
    std::cerr << "usage: speed_accuracy DIRECTORY [SCALE]\n";
    return 2;
  }
  try {
    return run(arguments[1], count == 3 ? std::atof(arguments[2]) : 1);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
}
