#include "command/solve.hpp"

#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <iostream>
#include <optional>
#include <utility>

#include "command/output.hpp"
#include "command/progress.hpp"

namespace assur::generator::command {

namespace {

/// `--branch` must name one of `count` configurations or branches.
void expect_branch(const SolveOptions& options, std::ptrdiff_t count, const std::string& what) {
  if (options.branch > count) {
    throw text::InputError(options.scene + ": --branch: no " + what + " " +
                           std::to_string(options.branch) + "; there are " + std::to_string(count));
  }
}

bool print_one(const SolveOptions& options, const mechanism::Plan& plan) {
  const mechanism::Values values = plan.values();
  const mechanism::Solution solution = plan.solve(values);
  const bool degenerate = solution.status == mechanism::SolutionStatus::degenerate;
  if (!degenerate) {
    expect_branch(options, std::ssize(solution.configurations), "configuration");
  }
  const std::optional<mechanism::Nearest> nearest =
      options.nearest ? plan.nearest(values, solution) : std::nullopt;
  const int branch = nearest ? static_cast<int>(nearest->configuration) + 1 : options.branch;
  const mechanism::Report report{plan, values, solution, options.scene, branch, nearest};
  if (degenerate && options.format == "csv") {
    std::cerr << "degenerate: " << solution.reason << '\n';
  }
  print(options.format == "csv"    ? csv_header(plan) + csv_rows(report)
        : options.format == "json" ? report_json(report)
                                   : report_text(report));
  return degenerate;
}

/// A configuration at a step of a sweep.
struct SweptConfiguration {
  int step;
  std::size_t place;
};

/// The configuration nearest to the reference at the first step that has any.
std::optional<SweptConfiguration> nearest_in_sweep(const mechanism::Plan& plan) {
  mechanism::Values values = plan.values();
  const mechanism::Sweep& sweep = *plan.request().sweep;
  const double from = values.value_of(sweep.from);
  const double range = values.value_of(sweep.to) - from;
  for (int step = 0; step < sweep.count; ++step) {
    values.set(sweep.parameter, from + (step > 0 ? range * step / (sweep.count - 1) : 0));
    if (const auto found = plan.nearest(values, plan.solve(values))) {
      return SweptConfiguration{step, found->configuration};
    }
  }
  return std::nullopt;
}

/// Prints rows as they are computed. The head waits for the first row of the branch that is asked
/// for, so that nothing is printed of one that does not exist.
bool print_sweep(const SolveOptions& options, const mechanism::Plan& plan) {
  ProgressBar bar(plan.request().sweep->count);
  bool degenerate = false;
  int last_branch = 0;
  int chosen = options.branch;  // 0 for all, until the nearest one is known
  const std::optional<SweptConfiguration> nearest =
      options.nearest ? nearest_in_sweep(plan) : std::nullopt;
  std::string text = csv_header(plan);
  const auto record = [&](const mechanism::SweepRecord& row) {
    last_branch = std::max(last_branch, row.branch);
    if (nearest && row.step == nearest->step &&
        std::cmp_equal(row.configuration, nearest->place + 1)) {
      chosen = row.branch;
    }
    const bool is_chosen = options.nearest ? chosen > 0 && row.branch == chosen
                                           : chosen == 0 || row.branch == chosen;
    if (is_chosen) {
      add_csv_row(plan, row, text);
    }
  };
  std::string reason;  // of the step before: a stretch of steps is told once
  const auto judge = [&](const mechanism::Solution& solution) {
    if (solution.status != mechanism::SolutionStatus::degenerate) {
      reason.clear();
      return;
    }
    degenerate = true;
    if (solution.reason != reason) {
      reason = solution.reason;
      std::cerr << "degenerate: " << reason << '\n';
    }
  };
  const auto step_done = [&](int done) {
    bar.show(done);
    if (options.branch <= last_branch) {
      print(text);
      text.clear();
    }
  };
  sweep(plan, {record, judge, step_done});
  expect_branch(options, last_branch, "branch");
  print(text);
  return degenerate;
}

}  // namespace

bool print_solution(const SolveOptions& options) {
  const mechanism::Scene scene = mechanism::read_scene(options.scene, options.settings);
  try {
    const mechanism::Plan plan(scene);
    return options.format == "csv" && scene.request.sweep ? print_sweep(options, plan)
                                                          : print_one(options, plan);
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(scene.file + ": " + error.what());
  }
}

}  // namespace assur::generator::command
