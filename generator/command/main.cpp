// The command `assur`: each subcommand is one pass through the pipeline.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>

#include "audit/audit.hpp"
#include "audit/audit_report.hpp"
#include "command/catalogue.hpp"
#include "command/derive.hpp"
#include "command/progress.hpp"
#include "derivation/render.hpp"
#include "emission/emit.hpp"
#include "emission/emit_closures.hpp"
#include "emission/emit_scene.hpp"
#include "error.hpp"
#include "scene/report.hpp"

namespace {

using namespace assur::generator;

constexpr int exit_ok = 0;
constexpr int exit_negative = 1;
constexpr int exit_unusable = 2;

struct CatalogueOptions {
  std::string format = "text";
};

int run_catalogue(const CatalogueOptions& options) {
  std::cout << (options.format == "json"       ? catalogue_json()
                : options.format == "markdown" ? catalogue_markdown()
                                               : catalogue_text());
  return exit_ok;
}

int run_derive(const DeriveOptions& options) {
  const ChosenKind chosen = chosen_kind(options);
  const Derivation derivation = derive(*chosen.group, chosen.kind);
  std::cout << (options.format == "json"    ? derivation_json(derivation)
                : options.format == "latex" ? derivation_latex(derivation)
                                            : derivation_text(derivation));
  return derivation.rigid ? exit_ok : exit_negative;
}

struct EmitOptions {
  bool all = false;
  int model = 0;
  std::string group = "tetrad";
  std::string scene;
  std::string closures;
  std::string output;
  bool check = false;
};

int run_emit(const EmitOptions& options) {
  std::vector<EmittedFile> files;
  if (options.all) {
    files = emit_all();
  } else if (!options.scene.empty()) {
    files.push_back(emit_scene(read_scene(options.scene, {})));
  } else if (!options.closures.empty()) {
    files.push_back(emit_closures(read_typed_closures(options.closures)));
  } else {
    const std::vector<Model>& models = models_of(group_named(options.group));
    for (const Model& model : models) {
      if (model.number == options.model) {
        files.push_back(emit_model(model));
      }
    }
    if (files.empty()) {
      throw InputError("--model: no " + options.group + " model " + std::to_string(options.model) +
                       "; the models are 1 to " + std::to_string(models.size()));
    }
  }
  if (!options.check) {
    write_files(files, options.output);
    return exit_ok;
  }
  int differing = 0;
  for (const std::filesystem::path& path : differing_files(files, options.output)) {
    std::cerr << "differs: " << path.generic_string() << '\n';
    ++differing;
  }
  return differing == 0 ? exit_ok : exit_negative;
}

struct AuditOptions {
  std::vector<std::string> files;
  std::string format = "text";
};

int run_audit(const AuditOptions& options) {
  std::vector<AuditReport> reports;
  for (const std::string& file : options.files) {
    reports.push_back(audit_file(file));
  }
  std::cout << (options.format == "json"       ? audit_report_json(reports)
                : options.format == "markdown" ? audit_report_markdown(reports)
                                               : audit_report_text(reports));
  const bool agree = std::all_of(reports.begin(), reports.end(),
                                 [](const AuditReport& report) { return report.agrees(); });
  return agree ? exit_ok : exit_negative;
}

struct SolveOptions {
  std::string scene;
  std::vector<std::string> settings;
  std::string format = "text";
  int branch = 0;
};

/// `--branch` must name one of `count` configurations or branches.
void expect_branch(const SolveOptions& options, int count, const std::string& what) {
  if (options.branch > count) {
    throw InputError(options.scene + ": --branch: no " + what + " " +
                     std::to_string(options.branch) + "; there are " + std::to_string(count));
  }
}

int run_solve(const SolveOptions& options) {
  const Scene scene = read_scene(options.scene, options.settings);
  // The text of a whole run is printed at its end, so that an error leaves no partial result.
  std::string text;
  std::string messages;
  int verdict = exit_ok;
  const auto judge = [&](const Solution& solution) {
    if (solution.status == SolutionStatus::degenerate) {
      verdict = exit_negative;
      if (options.format == "csv") {
        messages += "degenerate: " + solution.reason + "\n";
      }
    }
  };
  if (options.format == "csv" && scene.sweep) {
    ProgressBar bar(scene.sweep->count);
    text = csv_header(scene);
    int last_branch = 0;
    const auto record = [&](const SweepRecord& row) {
      last_branch = std::max(last_branch, row.branch);
      if (options.branch == 0 || row.branch == options.branch) {
        text += csv_row(scene, row);
      }
    };
    sweep(scene, {record, judge, [&](int done) { bar.show(done); }});
    expect_branch(options, last_branch, "branch");
  } else {
    const ParameterValues values(scene);
    const Solution solution = solve(scene, values);
    const SolvedScene solved{&scene, &values, &solution, options.branch};
    judge(solution);
    if (solution.status != SolutionStatus::degenerate) {
      expect_branch(options, static_cast<int>(solution.configurations.size()), "configuration");
    }
    text = options.format == "csv"    ? csv_header(scene) + csv_rows(solved)
           : options.format == "json" ? report_json(solved)
                                      : report_text(solved);
  }
  std::cerr << messages;
  std::cout << text;
  return verdict;
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const Group& group : known_groups()) {
    names.push_back(group.name());
  }
  return names;
}

int run(int argc, char** argv) {
  CLI::App app{"Derives the kinematics of planar linkages and emits closed-form solvers."};
  app.name("assur");
  app.set_version_flag("--version", "assur " ASSUR_VERSION);
  app.require_subcommand(1);
  std::function<int()> chosen;

  CatalogueOptions catalogue;
  CLI::App* command =
      app.add_subcommand("catalogue", "the kinds and models of each group, derived");
  command->add_option("--format", catalogue.format)
      ->check(CLI::IsMember({"text", "markdown", "json"}))
      ->capture_default_str();
  command->callback([&] { chosen = [&] { return run_catalogue(catalogue); }; });

  DeriveOptions derivation;
  command =
      app.add_subcommand("derive", "the equations of a model, step by step, to read and audit");
  command
      ->add_option("KIND_OR_MODEL", derivation.what, "a kind such as RRP-RRR, or a model's number")
      ->required();
  command
      ->add_option("--group", derivation.group,
                   "the group of the model (default: tetrad) or of the kind (default: by spelling)")
      ->check(CLI::IsMember(group_names()));
  command->add_option("--format", derivation.format)
      ->check(CLI::IsMember({"text", "latex", "json"}))
      ->capture_default_str();
  command->callback([&] { chosen = [&] { return run_derive(derivation); }; });

  EmitOptions emit;
  command = app.add_subcommand("emit", "write the C++ of models, of one scene, or of closures");
  auto* what = command->add_option_group("what");
  what->add_flag("--all", emit.all, "every model of every group");
  what->add_option("--model", emit.model, "one model of a group, by its number");
  what->add_option("--scene", emit.scene, "a solver for one scene file (JSON) alone");
  what->add_option("--closures", emit.closures, "the closures that an audit file types");
  what->require_option(1);
  command->add_option("--group", emit.group, "the group that --model means")
      ->check(CLI::IsMember(group_names()))
      ->capture_default_str();
  command->add_option("--output", emit.output, "directory to write to")->required();
  command->add_flag("--check", emit.check, "write nothing; exit 1 if what is there differs");
  command->callback([&] { chosen = [&] { return run_emit(emit); }; });

  SolveOptions solve;
  command = app.add_subcommand("solve", "the assembly configurations of a scene");
  command->add_option("scene", solve.scene, "scene file (JSON)")->required();
  command->add_option("--set", solve.settings, "NAME=EXPR, replaces a parameter's value")
      ->expected(1)
      ->take_all();
  command->add_option("--format", solve.format)
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();
  command
      ->add_option("--branch", solve.branch,
                   "report configuration N alone; of a sweep, the rows of branch N")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->callback([&] { chosen = [&] { return run_solve(solve); }; });

  AuditOptions audit;
  command = app.add_subcommand("audit", "what a source prints against what the derivation says");
  command->add_option("files", audit.files, "audit files")->required();
  command->add_option("--format", audit.format)
      ->check(CLI::IsMember({"text", "markdown", "json"}))
      ->capture_default_str();
  command->callback([&] { chosen = [&] { return run_audit(audit); }; });

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "error: " << error.what() << " (see assur --help)\n";
    return exit_unusable;
  }
  return chosen();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << "error: " << error.what() << '\n';
  } catch (const std::exception& error) {
    std::cerr << "error: internal: " << error.what() << '\n';
  }
  return exit_unusable;
}
