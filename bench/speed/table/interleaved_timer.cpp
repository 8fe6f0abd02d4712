#include "table/interleaved_timer.hpp"

#include <ctime>
#include <iostream>

namespace assur::speed {

namespace {

double thread_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The median difference of two consecutive readings of the clock.
double clock_ns() {
  std::vector<double> samples;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const double start = thread_ns();
    samples.push_back(thread_ns() - start);
  }
  return median(std::move(samples));
}

void measure(Task& task, const TimerSettings& settings, double clock) {
  const std::size_t slices = std::min(settings.slices, task.inputs);
  const std::size_t width = task.inputs / slices;
  std::vector<Entry*> entries;  // an entry that cannot be run here has its time already
  for (Entry& entry : task.entries) {
    if (entry.run) {
      entries.push_back(&entry);
    }
  }
  const std::size_t methods = entries.size();
  std::vector<std::vector<double>> samples(methods);
  std::vector<bool> slow(methods, false);
  for (int round = 0; round < settings.rounds; ++round) {
    for (std::size_t slice = 0; slice < slices; ++slice) {
      const std::size_t before = (slice + slices - 1) % slices;
      for (std::size_t turn = 0; turn < methods; ++turn) {
        const std::size_t method = (turn + slice + static_cast<std::size_t>(round)) % methods;
        const auto& run = entries[method]->run;
        if (slow[method] && round > 0) {
          continue;
        }
        if (!slow[method]) {
          run(before * width, (before + 1) * width);
        }
        const double start = thread_ns();
        run(slice * width, (slice + 1) * width);
        const double spent = thread_ns() - start - clock;
        samples[method].push_back(spent / static_cast<double>(width));
        slow[method] = slow[method] || spent > 1e6 * settings.patience_ms;
      }
    }
  }
  for (std::size_t method = 0; method < methods; ++method) {
    entries[method]->row.ns = median(samples[method]);
  }
}

}  // namespace

void measure(std::vector<Task>& tasks, const TimerSettings& settings) {
  const double clock = clock_ns();
  for (Task& task : tasks) {
    std::cerr << "timing: " << task.name << '\n';
    measure(task, settings, clock);
  }
}

}  // namespace assur::speed
