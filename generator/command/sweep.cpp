// Prints the rows of a sweep's branches.
#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/sweep.hpp>
#include <assur/text/error.hpp>
#include <optional>
#include <utility>

#include "command/commands.hpp"
#include "command/output.hpp"
#include "command/scene_warnings.hpp"
#include "command/stretches.hpp"

namespace assur::generator::command {

namespace {

/// `--branch` must name one of `count` branches.
void expect_branch(const SweepOptions& options, int count) {
  if (options.branch > count) {
    throw text::InputError(
        options.scene + ": --branch: there is no branch " + std::to_string(options.branch) +
        (count == 0 ? "; the sweep has none" : "; the highest number is " + std::to_string(count)));
  }
}

/// Throws InputError if `--set` gives the sweep's parameter a value, which would be replaced.
void expect_no_setting_of(const mechanism::Plan& plan, const SweepOptions& options) {
  const std::string& parameter =
      plan.mechanism().parameters()[plan.request().sweep->parameter].name;
  for (const std::string& setting : options.settings) {
    if (setting.substr(0, setting.find('=')) == parameter) {
      throw text::InputError(options.scene + ": --set " + parameter + ": the sweep gives '" +
                             parameter + "' its values; leave this out, or change the sweep");
    }
  }
}

/// The rows of a sweep and the stretches without any, kept until they may be printed.
class SweepOutput {
 public:
  SweepOutput(const SweepOptions& options, const mechanism::Plan& plan,
              mechanism::Circuits circuits)
      : text_(csv_header(plan)),
        rows_(plan, std::move(circuits),
              options.unwrapped ? mechanism::SweepRows::Angles::unwrapped
                                : mechanism::SweepRows::Angles::principal),
        stretches_(plan) {}

  void add(const mechanism::SweepRecord& row) { rows_.add(row, text_); }

  /// Takes the solution of the next step.
  void judge(double parameter, const mechanism::Solution& solution) {
    degenerate_ = degenerate_ || solution.status == mechanism::SolutionStatus::degenerate;
    stretches_.step(parameter, solution);
  }

  /// Prints all that is known so far.
  void release() {
    print(text_);
    text_.clear();
    stretches_.tell();
  }

  /// Prints the rest, and returns whether a step was degenerate.
  [[nodiscard]] bool finish() {
    stretches_.finish();
    release();
    return degenerate_;
  }

 private:
  std::string text_;
  mechanism::SweepRows rows_;
  StretchTeller stretches_;
  bool degenerate_ = false;
};

/// The number of steps followed before the first rows are printed: the first two may be too far
/// apart, which is an error.
constexpr int steps_before_rows = 2;

/// All branches side by side, or one of them. Nothing is printed before the requested branch has
/// begun, since it may not exist.
bool print_branches(const SweepOptions& options, const mechanism::Scene& scene,
                    const mechanism::Plan& plan) {
  const std::optional<int> chosen = options.nearest ? nearest_branch(scene.mechanism, scene.request)
                                                    : std::optional(options.branch);
  const bool is_all = chosen == 0;
  ProgressBar bar;
  const auto steps = static_cast<std::uint64_t>(plan.request().sweep->count);
  // Any event may join two circuits, so they are known only at the end of a sweep.
  const mechanism::SweptPlaces places = swept_places(scene.mechanism, scene.request, [&](int done) {
    bar.show(static_cast<std::uint64_t>(done), 2 * steps);
  });
  SweepOutput output(options, plan, places.circuits);
  int last_branch = 0;
  bool has_row = false;
  const auto record = [&](const mechanism::SweepRecord& row) {
    last_branch = std::max(last_branch, row.branch);
    if (is_all || (row.event.empty() && row.branch == chosen)) {
      has_row = true;
      output.add(row);
    }
  };
  const auto judge = [&](double parameter, const mechanism::Solution& solution) {
    output.judge(parameter, solution);
  };
  const auto step_done = [&](int done) {
    bar.show(steps + static_cast<std::uint64_t>(done), 2 * steps);
    if (done >= steps_before_rows && options.branch <= last_branch) {
      output.release();
    }
  };
  expect_branch(options, sweep(plan, {record, judge, step_done}));
  const bool degenerate = output.finish();
  if (options.branch > 0 && !has_row) {
    remarks() << "branch " << options.branch
              << " has no row: at every step it is beyond the limits of joints, or breaks "
                 "redundant constraints\n";
  }
  return degenerate;
}

/// One branch among more than can be followed side by side: from the first step that has its
/// configuration to its end.
bool print_lone_branch(const SweepOptions& options, const mechanism::Plan& plan) {
  const mechanism::Sweep& range = *plan.request().sweep;
  ProgressBar bar;
  SweepOutput output(options, plan, {});
  const auto record = [&](const mechanism::SweepRecord& row) { output.add(row); };
  const auto judge = [&](double parameter, const mechanism::Solution& solution) {
    output.judge(parameter, solution);
  };
  const auto step_done = [&](int done) {
    bar.show(static_cast<std::uint64_t>(done), static_cast<std::uint64_t>(range.count));
    if (done >= steps_before_rows) {
      output.release();
    }
  };
  const auto end =
      sweep_branch(plan, static_cast<std::size_t>(options.branch), {record, judge, step_done});
  const bool degenerate = output.finish();
  if (end) {
    remarks() << "the branch ends at " << plan.mechanism().parameters()[range.parameter].name
              << " = " << shown_value(*end) << ": it folds there, or comes too close to another\n";
  }
  return degenerate;
}

}  // namespace

bool print_sweep(const SweepOptions& options, const mechanism::Scene& scene,
                 const mechanism::Plan& plan) {
  warn_of_idle_sweep(scene);
  expect_no_setting_of(plan, options);
  const bool follows_one = (options.nearest || options.branch > 0) &&
                           plan.most_configurations() > mechanism::most_followed;
  return follows_one ? print_lone_branch(options, plan) : print_branches(options, scene, plan);
}

bool run_sweep(const SweepOptions& options) {
  const mechanism::Scene scene = mechanism::read_scene(options.scene, options.settings, "--set");
  if (!scene.request.sweep) {
    throw text::InputError(options.scene +
                           ": the scene has no sweep; add one, as \"sweep\": {\"parameter\": "
                           "\"phi\", \"from\": 0, \"to\": \"2*pi\", \"count\": 361}");
  }
  try {
    const mechanism::Plan plan(scene);
    warn_of_idle_links(scene);
    return print_sweep(options, scene, plan);
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(scene.file + ": " + error.what());
  }
}

}  // namespace assur::generator::command
