// The rows of a sweep's branches.
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/sweep.hpp>
#include <assur/text/error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>

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

/// Throws InputError where `--set` gives the sweep's parameter a value, which would be replaced.
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

/// Rows in a temporary file, so that a sweep of any length takes little memory.
class StoredRows {
 public:
  StoredRows() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) {
      fail();
    }
  }

  void add(const std::string& row) {
    if (std::fwrite(row.data(), 1, row.size(), file_.get()) != row.size()) {
      fail();
    }
  }

  /// Calls `use` with each row and its end of line, in their order.
  template <typename Use>
  void for_each(const Use& use) {
    std::rewind(file_.get());
    std::string row;
    for (int letter = std::getc(file_.get()); letter != EOF; letter = std::getc(file_.get())) {
      row += static_cast<char>(letter);
      if (letter == '\n') {
        use(row);
        row.clear();
      }
    }
    if (std::ferror(file_.get()) != 0) {
      fail();
    }
  }

 private:
  [[noreturn]] static void fail() {
    throw text::InputError(std::string("a temporary file for the rows: ") + std::strerror(errno));
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// The rows of a sweep and the stretches without any. Nothing is printed before the sweep's end:
/// any event may join two circuits, and an error leaves no output.
class SweepOutput {
 public:
  SweepOutput(const SweepOptions& options, const mechanism::Plan& plan)
      : header_(csv_header(plan)),
        rows_(plan, options.unwrapped ? mechanism::SweepRows::Angles::unwrapped
                                      : mechanism::SweepRows::Angles::principal),
        stretches_(plan),
        steps_(static_cast<std::uint64_t>(plan.request().sweep->count)) {}

  /// What a sweep calls; `is_wanted` tells which of its records become rows.
  [[nodiscard]] mechanism::SweepObserver observer(
      const std::function<bool(const mechanism::SweepRecord&)>& is_wanted) {
    return {.record =
                [this, is_wanted](const mechanism::SweepRecord& record) {
                  if (is_wanted(record)) {
                    std::string row;
                    rows_.add(record, row);
                    stored_.add(row);
                  }
                },
            .solved =
                [this](double parameter, const mechanism::Solution& solution) {
                  is_degenerate_ =
                      is_degenerate_ || solution.status == mechanism::SolutionStatus::degenerate;
                  stretches_.step(parameter, solution);
                },
            .progress = [this](int done) { bar_->show(static_cast<std::uint64_t>(done), steps_); },
            .circuits = [this](const mechanism::Circuits& circuits) { circuits_ = circuits; }};
  }

  /// Prints everything, and returns whether a step was degenerate.
  [[nodiscard]] bool finish() {
    bar_.reset();
    print(header_);
    stored_.for_each([this](std::string& row) {
      mechanism::SweepRows::set_circuit(circuits_, row);
      print(row);
    });
    stretches_.finish();
    stretches_.tell();
    return is_degenerate_;
  }

 private:
  std::string header_;
  mechanism::SweepRows rows_;
  StoredRows stored_;
  StretchTeller stretches_;
  mechanism::Circuits circuits_;
  std::optional<ProgressBar> bar_ = std::make_optional<ProgressBar>();
  std::uint64_t steps_;
  bool is_degenerate_ = false;
};

/// All branches side by side, or one of them.
bool print_branches(const SweepOptions& options, const mechanism::Scene& scene,
                    const mechanism::Plan& plan) {
  const std::optional<int> chosen = options.nearest ? nearest_branch(scene.mechanism, scene.request)
                                                    : std::optional(options.branch);
  SweepOutput output(options, plan);
  bool has_row = false;
  const auto is_wanted = [&](const mechanism::SweepRecord& row) {
    const bool is_of_chosen = row.event.empty() && row.branch == chosen;
    has_row = has_row || is_of_chosen;
    return chosen == 0 || is_of_chosen;
  };
  expect_branch(options, sweep(plan, output.observer(is_wanted)));
  const bool is_degenerate = output.finish();
  if (options.branch > 0 && !has_row) {
    remarks() << "branch " << options.branch
              << " has no row: at every step it is beyond the limits of joints, or breaks "
                 "redundant constraints\n";
  }
  return is_degenerate;
}

/// One branch among more than can be followed side by side: from the first step that has its
/// configuration to where it ends.
bool print_single_branch(const SweepOptions& options, const mechanism::Plan& plan) {
  SweepOutput output(options, plan);
  const auto end = sweep_branch(plan, static_cast<std::size_t>(options.branch),
                                output.observer([](const auto&) { return true; }));
  const bool is_degenerate = output.finish();
  if (end) {
    const mechanism::Mechanism& mechanism = plan.mechanism();
    remarks() << "the branch ends at "
              << mechanism.parameters()[plan.request().sweep->parameter].name << " = "
              << shown_value(*end) << ": it folds there, or comes too close to another\n";
  }
  return is_degenerate;
}

}  // namespace

bool print_sweep(const SweepOptions& options, const mechanism::Scene& scene,
                 const mechanism::Plan& plan) {
  warn_of_idle_sweep(scene);
  expect_no_setting_of(plan, options);
  const bool follows_one = (options.nearest || options.branch > 0) &&
                           plan.most_configurations() > mechanism::most_followed;
  return follows_one ? print_single_branch(options, plan) : print_branches(options, scene, plan);
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
