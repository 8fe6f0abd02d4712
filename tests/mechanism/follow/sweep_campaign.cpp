// Campaign over random mechanisms: branches of a coarse sweep against those of a ten times finer
// one.
#include <cstdlib>
#include <iostream>

#include "mechanism/random_sweep.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test {
namespace {

struct Tally {
  int scenes = 0;
  int steps = 0;
  SweepDifference difference;
  std::map<std::string, int> events;
  int unbalanced = 0;  ///< steps where the number of configurations and the events disagree
  double residual = 0;
};

/// Steps whose number of rows does not follow from the step before and the events between.
int unbalanced_steps(const SweepKept& kept) {
  std::vector<int> rows(static_cast<std::size_t>(kept.steps), 0);
  std::vector<int> change(static_cast<std::size_t>(kept.steps), 0);
  for (const SweepRowKept& row : kept.rows) {
    ++rows[static_cast<std::size_t>(row.step)];
  }
  for (const SweepEventKept& event : kept.events) {
    const std::string kind = event.kind();
    const int by = kind == "fold"      ? -2
                   : kind == "birth"   ? 2
                   : kind == "escape"  ? -1
                   : kind == "arrival" ? 1
                                       : 0;
    change[static_cast<std::size_t>(event.step)] += by;
  }
  int wrong = 0;
  for (std::size_t step = 1; step < rows.size(); ++step) {
    wrong += rows[step] != rows[step - 1] + change[step - 1] ? 1 : 0;
  }
  return wrong;
}

void run(const std::string& kind, RandomSweep::Swept swept, unsigned seed, int count, bool verbose,
         Tally& tally) {
  constexpr int factor = 10;
  const RandomSweep made = random_sweep(kind, swept, seed, count);
  const SweepKept few = run_sweep(made.scene);
  const SweepKept many = run_sweep(made.scene, (count - 1) * factor + 1);
  const SweepDifference found = difference(few, many, factor);
  const int unbalanced = unbalanced_steps(few) + unbalanced_steps(many);
  tally.scenes += 1;
  tally.steps += few.steps + many.steps;
  tally.difference.add(found);
  tally.unbalanced += unbalanced;
  for (const SweepEventKept& event : many.events) {
    ++tally.events[event.kind()];
    if (event.residual > tally.residual) {
      tally.residual = event.residual;
    }
  }
  const bool odd = found.jumps + found.breaks + found.mismatched + unbalanced != 0 ||
                   found.missed != 0 ||
                   many.count_of("unresolved") + few.count_of("unresolved") > 0;
  if (verbose && odd) {
    std::cout << kind << " swept " << static_cast<int>(swept) << " seed " << seed << ": jumps "
              << found.jumps << ", breaks " << found.breaks << ", missed " << found.missed
              << ", mismatched " << found.mismatched << ", unbalanced " << unbalanced << '\n';
    for (const SweepKept* kept : {&few, &many}) {
      for (const SweepEventKept& event : kept->events) {
        std::cout << "  " << event.text << " at " << event.parameter << '\n';
      }
      std::cout << "  --\n";
    }
  }
}

}  // namespace
}  // namespace assur::test

// NOLINTNEXTLINE(bugprone-exception-escape): what a campaign throws ends it with its message
int main(int argc, char** argv) {
  using namespace assur::test;
  const int scenes = argc > 1 ? std::atoi(argv[1]) : 40;
  const int count = argc > 2 ? std::atoi(argv[2]) : 61;
  const bool verbose = argc > 3;
  constexpr unsigned first_seed = 16180;
  const std::vector<std::string> kinds = {"RRRRRR", "RRRRPR", "RPRRRR", "PRRRRR", "RRPRPR",
                                          "PRRPRR", "RPRPRR", "RPRRRP", "PRRRPR", "RPPRRR"};
  std::cout.precision(15);
  Tally tally;
  for (int index = 0; index < scenes; ++index) {
    const auto number = static_cast<unsigned>(index);
    run(kinds[number % kinds.size()], static_cast<RandomSweep::Swept>(number / kinds.size() % 3),
        first_seed + number, count, verbose, tally);
  }
  const SweepDifference& found = tally.difference;
  std::cout << "first seed " << first_seed << ", " << tally.scenes << " scenes, " << tally.steps
            << " steps, " << found.joins << " joins in the coarse sweeps\n"
            << "silent jumps " << found.jumps << ", breaks " << found.breaks
            << ", events that the coarse sweeps miss " << found.missed << ", samples that differ "
            << found.mismatched << ", steps out of balance " << tally.unbalanced
            << "\nlargest closure error at an event " << tally.residual << "\nevents:";
  for (const auto& [kind, number] : tally.events) {
    std::cout << ' ' << kind << ' ' << number;
  }
  std::cout << '\n';
  const bool failed =
      found.jumps + found.breaks + found.mismatched + tally.unbalanced != 0 || found.missed != 0;
  return failed ? 1 : 0;
}
