#include "command/solve.hpp"

#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <assur/text/numbers.hpp>
#include <optional>
#include <utility>

#include "command/output.hpp"
#include "command/progress.hpp"
#include "command/remarks.hpp"
#include "command/scene_warnings.hpp"

namespace assur::generator::command {

namespace {

/// `--branch` must name one of `count` configurations.
void expect_configuration(const SolveOptions& options, std::size_t count, const std::string& why) {
  if (static_cast<std::size_t>(options.branch) > count) {
    throw text::InputError(
        options.scene + ": --branch: " +
        mechanism::no_configuration(static_cast<std::size_t>(options.branch), count) +
        (count == 0 && !why.empty() ? ": " + why : ""));
  }
}

/// `--branch` must name one of `count` branches.
void expect_branch(const SolveOptions& options, int count) {
  if (options.branch > count) {
    throw text::InputError(
        options.scene + ": --branch: there is no branch " + std::to_string(options.branch) +
        (count == 0 ? "; the sweep has none" : "; the highest number is " + std::to_string(count)));
  }
}

/// The options that ask for a sweep need one.
void expect_sweep(const SolveOptions& options, const mechanism::Scene& scene) {
  if (options.circuits && !scene.request.sweep) {
    throw text::InputError(options.scene + ": --circuits: the scene has no sweep; add one");
  }
  if (options.unwrapped && (options.format != "csv" || !scene.request.sweep)) {
    throw text::InputError(options.scene + ": --unwrapped: only the rows of a sweep have angles " +
                           "that continue; " +
                           (scene.request.sweep ? "use --format csv" : "add a sweep to the scene"));
  }
}

bool print_one(const SolveOptions& options, const mechanism::Scene& scene,
               const mechanism::Plan& plan) {
  const mechanism::Values values = plan.values();
  const bool alone = (options.nearest || options.branch > 0) &&
                     plan.most_configurations() > mechanism::Plan::most_listed;
  mechanism::Solution solution;
  std::optional<mechanism::Nearest> nearest;
  std::size_t count = 0;
  if (!alone) {
    plan.solve(values, solution);
    count = solution.configurations.size();
    nearest = options.nearest ? plan.nearest(values, solution) : std::nullopt;
  } else if (options.nearest) {
    nearest = plan.solve_nearest(values, solution);
  } else {
    count = plan.solve_one(values, static_cast<std::size_t>(options.branch), solution);
  }
  const bool degenerate = solution.status == mechanism::SolutionStatus::degenerate;
  if (!degenerate) {
    expect_configuration(options, count, count == 0 ? plan.obstacle(values) : "");
  }
  const int branch = nearest ? static_cast<int>(nearest->configuration) + 1 : options.branch;
  mechanism::Report report{plan, values, solution, options.scene, branch, nearest, alone};
  if (options.circuits) {
    report.places = swept_places(scene.mechanism, scene.request);
  }
  if (degenerate && options.format == "csv") {
    remarks() << "degenerate: " << solution.reason << '\n';
  }
  print(options.format == "csv"    ? csv_header(plan) + csv_rows(report)
        : options.format == "json" ? report_json(report)
                                   : report_text(report));
  return degenerate;
}

/// The values of a sweep's parameter, step by step, with all other parameters.
class SweptValues {
 public:
  explicit SweptValues(const mechanism::Plan& plan)
      : sweep_(*plan.request().sweep),
        values_(plan.values()),
        from_(values_.value_of(sweep_.from)),
        range_(values_.value_of(sweep_.to) - from_) {}

  const mechanism::Values& at(int step) {
    const int last = sweep_.count - 1;
    values_.set(sweep_.parameter,
                last == 0 ? from_ : from_ + range_ * (static_cast<double>(step) / last));
    return values_;
  }

 private:
  const mechanism::Sweep& sweep_;
  mechanism::Values values_;
  double from_, range_;
};

/// A value of a sweep's parameter as remarks show it.
std::string shown(double number) { return text::short_number(number, 6); }

/// Reports each stretch of steps without configurations once: its range, and the reason.
class StretchTeller {
 public:
  explicit StretchTeller(const mechanism::Plan& plan) : plan_(plan), values_(plan) {}

  /// Takes the next step.
  void step(double parameter, const mechanism::Solution& solution) {
    const std::string what = what_is_missing(solution);
    const std::string& reason = what == incomplete ? solution.incomplete : solution.reason;
    if (what != what_ || reason != reason_) {
      finish();
      what_ = what;
      reason_ = reason;
      first_ = step_;
      from_ = parameter;
    }
    if (what == beyond) {
      for (const mechanism::LimitBreach& breach : solution.breaches) {
        add_breach(breach, breaches_);
      }
    }
    to_ = parameter;
    ++step_;
  }

  /// Prints the stretches that have ended.
  void tell() {
    remarks() << text_;
    text_.clear();
  }

  /// Ends the open stretch, if there is one.
  void finish() {
    if (what_.empty()) {
      return;
    }
    const int count = step_ - first_;
    const std::string& name = plan_.mechanism().parameters()[plan_.request().sweep->parameter].name;
    text_ += what_ +
             (count == 1 ? " at " + name + " = " + shown(from_)
                         : " from " + name + " = " + shown(from_) + " to " + shown(to_) + " (" +
                               std::to_string(count) + " steps)") +
             reason_of_stretch(count) + '\n';
    what_.clear();
    breaches_.clear();
  }

 private:
  static constexpr const char* beyond = "beyond the limits of joints";
  static constexpr const char* incomplete = "incomplete";

  static std::string what_is_missing(const mechanism::Solution& solution) {
    using mechanism::SolutionStatus;
    const bool all_beyond =
        std::ranges::none_of(solution.configurations,
                             [](const mechanism::Configuration& one) { return one.within_limits; });
    return solution.status == SolutionStatus::degenerate    ? "degenerate"
           : solution.status == SolutionStatus::no_assembly ? "no-assembly"
           : all_beyond                                     ? beyond
           : solution.incomplete.empty()                    ? ""
                                                            : incomplete;
  }

  /// The reason of a stretch. The distance by which links fail to close is that half-way along it.
  std::string reason_of_stretch(int count) {
    if (what_ == beyond) {
      return ": " + breaches_text(plan_.mechanism(), breaches_);
    }
    if (what_ != "no-assembly") {
      return reason_.empty() ? "" : ": " + reason_;
    }
    const mechanism::Values& values = values_.at(first_ + count / 2);
    const double place = values.parameter(plan_.request().sweep->parameter);
    const std::string reason = plan_.obstacle(values);
    if (reason.empty()) {  // solved alone, that step can be assembled
      return plan_.structure().reading.empty()
                 ? ": at " + shown(place) + ", the links reach to within rounding"
                 : ": laws read angles that count whole turns from the first step; solved alone, "
                   "with angles in (-pi, pi], the mechanism can be assembled at " +
                       shown(place);
    }
    return count == 1 ? ": " + reason : ": at " + shown(place) + ", " + reason;
  }

  const mechanism::Plan& plan_;
  SweptValues values_;
  std::string what_, reason_;                     ///< of the open stretch; empty if there is none
  std::string text_;                              ///< of the stretches that have ended
  std::vector<mechanism::LimitBreach> breaches_;  ///< in the open stretch
  int step_ = 0, first_ = 0;
  double from_ = 0, to_ = 0;
};

/// Throws InputError where `--set` gives the sweep's parameter a value, which would be replaced.
void expect_no_setting_of(const mechanism::Plan& plan, const SolveOptions& options) {
  const std::string& parameter =
      plan.mechanism().parameters()[plan.request().sweep->parameter].name;
  for (const std::string& setting : options.settings) {
    if (setting.substr(0, setting.find('=')) == parameter) {
      throw text::InputError(options.scene + ": --set " + parameter + ": the sweep gives '" +
                             parameter + "' its values; leave this out, or change the sweep");
    }
  }
}

mechanism::SweepRows::Angles angles_of(const SolveOptions& options) {
  using Angles = mechanism::SweepRows::Angles;
  return options.unwrapped ? Angles::unwrapped : Angles::principal;
}

/// Prints rows as they are computed. It prints nothing before the requested branch has begun, since
/// it may not exist, nor before the second step, since the steps may be too far apart.
bool print_sweep(const SolveOptions& options, const mechanism::Scene& scene,
                 const mechanism::Plan& plan) {
  const mechanism::Sweep& range = *plan.request().sweep;
  expect_no_setting_of(plan, options);
  const std::optional<int> chosen = options.nearest ? nearest_branch(scene.mechanism, scene.request)
                                                    : std::optional(options.branch);
  const bool is_all = chosen == 0;
  ProgressBar bar;
  const auto steps = static_cast<std::uint64_t>(range.count);
  // Any event may join two circuits, so they are known at the end of a sweep only.
  const mechanism::SweptPlaces places = swept_places(scene.mechanism, scene.request, [&](int done) {
    bar.show(static_cast<std::uint64_t>(done), 2 * steps);
  });
  mechanism::SweepRows rows(plan, places.circuits, angles_of(options));
  bool degenerate = false;
  int last_branch = 0;
  bool has_row = false;
  std::string text = csv_header(plan);
  const auto record = [&](const mechanism::SweepRecord& row) {
    last_branch = std::max(last_branch, row.branch);
    if (is_all || (row.event.empty() && row.branch == chosen)) {
      has_row = true;
      rows.add(row, text);
    }
  };
  StretchTeller stretches(plan);
  const auto judge = [&](double parameter, const mechanism::Solution& solution) {
    degenerate = degenerate || solution.status == mechanism::SolutionStatus::degenerate;
    stretches.step(parameter, solution);
  };
  const auto step_done = [&](int done) {
    bar.show(steps + static_cast<std::uint64_t>(done), 2 * steps);
    if (done > 1 && options.branch <= last_branch) {
      print(text);
      text.clear();
      stretches.tell();
    }
  };
  const int branches = sweep(plan, {record, judge, step_done});
  expect_branch(options, branches);
  print(text);
  stretches.finish();
  stretches.tell();
  if (options.branch > 0 && !has_row) {
    remarks() << "branch " << options.branch
              << " has no row: at every step it is beyond the limits of joints, or breaks "
                 "redundant constraints\n";
  }
  return degenerate;
}

/// One branch among more than can be followed side by side: from the first step that has its
/// configuration to where it ends.
bool print_branch(const SolveOptions& options, const mechanism::Plan& plan) {
  const mechanism::Sweep& range = *plan.request().sweep;
  expect_no_setting_of(plan, options);
  ProgressBar bar;
  bool degenerate = false;
  std::string text = csv_header(plan);
  StretchTeller stretches(plan);
  mechanism::SweepRows rows(plan, {}, angles_of(options));
  const auto record = [&](const mechanism::SweepRecord& row) { rows.add(row, text); };
  const auto judge = [&](double parameter, const mechanism::Solution& solution) {
    degenerate = degenerate || solution.status == mechanism::SolutionStatus::degenerate;
    stretches.step(parameter, solution);
  };
  const auto step_done = [&](int done) {
    bar.show(static_cast<std::uint64_t>(done), static_cast<std::uint64_t>(range.count));
    if (done > 1) {
      print(text);
      text.clear();
      stretches.tell();
    }
  };
  const auto end =
      sweep_branch(plan, static_cast<std::size_t>(options.branch), {record, judge, step_done});
  print(text);
  stretches.finish();
  stretches.tell();
  if (end) {
    remarks() << "the branch ends at " << plan.mechanism().parameters()[range.parameter].name
              << " = " << shown(*end) << ": it folds there, or comes too close to another\n";
  }
  return degenerate;
}

}  // namespace

bool print_solution(const SolveOptions& options) {
  mechanism::Scene scene = mechanism::read_scene(options.scene, options.settings, "--set");
  scene.request.prove = options.prove;
  expect_sweep(options, scene);
  try {
    const mechanism::Plan plan(scene);
    warn_of_idle_links(scene);
    if (options.format != "csv" || !scene.request.sweep) {
      return print_one(options, scene, plan);
    }
    warn_of_idle_sweep(scene);
    const bool follows_one = (options.nearest || options.branch > 0) &&
                             plan.most_configurations() > mechanism::most_followed;
    return follows_one ? print_branch(options, plan) : print_sweep(options, scene, plan);
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(scene.file + ": " + error.what());
  }
}

}  // namespace assur::generator::command
