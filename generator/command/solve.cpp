// The command `assur solve`: the configurations of a scene.
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <optional>

#include "command/commands.hpp"
#include "command/output.hpp"
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

/// Throws if an option that needs a sweep is given without one.
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

}  // namespace

bool print_solution(const SolveOptions& options) {
  mechanism::Scene scene = mechanism::read_scene(options.scene, options.settings, "--set");
  scene.request.prove = options.prove;
  expect_sweep(options, scene);
  try {
    const mechanism::Plan plan(scene);
    warn_of_idle_links(scene);
    return options.format == "csv" && scene.request.sweep ? print_sweep(options, scene, plan)
                                                          : print_one(options, scene, plan);
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(scene.file + ": " + error.what());
  }
}

}  // namespace assur::generator::command
