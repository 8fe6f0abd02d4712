#include "command/subcommands.hpp"

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <assur/text/names.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "command/arguments.hpp"
#include "command/campaigns.hpp"
#include "command/catalogue.hpp"
#include "command/commands.hpp"
#include "command/derive.hpp"
#include "command/output.hpp"
#include "document/render.hpp"
#include "emission/model/emit.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::command {

namespace {

constexpr int most_threads = 1024;
/// The limits of `--time-limit`, in seconds.
constexpr double least_seconds = 0.1;
constexpr double most_seconds = 3600;

struct CatalogueOptions {
  std::string format = "text";
};

struct NoOptions {};

/// An integer from 1 to `most`.
CLI::Validator whole_number(int most) {
  return {[most](const std::string& text) { return complaint_of_whole_number(text, most); }, ""};
}

CLI::Validator any_whole_number() { return whole_number(std::numeric_limits<int>::max()); }

CLI::Validator not_empty() {
  return {
      [](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); },
      ""};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](const std::string& word) { return complaint_of_word(word, words); },
          "{" + text::joined(words, ",") + "}"};
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const structure::Group& group : structure::known_groups()) {
    names.push_back(group.name());
  }
  return names;
}

std::vector<std::string> words_on_request() {
  std::vector<std::string> words;
  for (const auto& [word, functions] : emission::model::functions_on_request()) {
    words.push_back(word);
  }
  return words;
}

void add_scene(CLI::App& command, std::string& scene) {
  command.add_option("SCENE", scene, "scene file (JSON)")->required()->check(not_empty());
}

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings, "NAME=EXPR, replaces a parameter's value;\nmay be repeated")
      ->expected(1)
      ->take_all();
}

/// The options that commands of many solutions share.
void add_campaign_options(CLI::App& command, CampaignOptions& options) {
  command
      .add_option("--output", options.output,
                  "the table to write: .csv or .h5;\nor .svg, a picture")
      ->required()
      ->check(not_empty());
  command.add_option("--plot", options.plot, "a picture beside the table: .svg")
      ->check(not_empty());
  command.add_option("--format", options.format, "the form of the summary")
      ->check(one_of({"text", "json"}))
      ->capture_default_str();
  command.add_flag("--force", options.force, "replace files that exist");
}

/// These options, and those of the commands that compute solutions.
void add_computing_options(CLI::App& command, CampaignOptions& options) {
  add_scene(command, options.scene);
  add_campaign_options(command, options);
  add_settings(command, options.settings);
  command.add_option("--shard", options.shard, "I/N: compute part I of N only, for assur merge");
  command
      .add_option("--threads", options.threads, "number of threads (default: one for each core)")
      ->type_name("N")
      ->check(whole_number(most_threads));
}

void declare_catalogue(CLI::App& command, CatalogueOptions& options) {
  command.add_option("--format", options.format, "the form of the list")
      ->check(one_of({"text", "markdown", "json"}))
      ->capture_default_str();
}

void declare_derive(CLI::App& command, DeriveOptions& options) {
  command
      .add_option(
          "KIND_OR_MODEL", options.what,
          "a kind such as RRP-RRR, a model's number, or\na scene file (JSON), whose groups are "
          "derived")
      ->required();
  command
      .add_option("--group", options.group,
                  "the group of the model (default: tetrad)\nor of the kind (default: by spelling)")
      ->check(one_of(group_names()));
  command.add_option("--format", options.format, "the form of the derivation")
      ->check(one_of({"text", "latex", "json"}))
      ->capture_default_str();
}

void declare_emit(CLI::App& command, EmitOptions& options) {
  auto* what = command.add_option_group("source");
  what->add_flag("--all", options.all, "every model of every group");
  CLI::Option* const model =
      what->add_option("--model", options.model, "one model of a group, by its number")
          ->type_name("N")
          ->check(any_whole_number());
  what->add_option("--scene", options.scene, "a solver for one scene file (JSON)")
      ->check(not_empty());
  what->add_option("--closures", options.closures, "the closures that are typed in an audit file")
      ->check(not_empty());
  what->require_option(1);
  command
      .add_option("--variable", options.variables,
                  "with --scene: parameters X,Y that stay arguments\nof the solver, or all")
      ->delimiter(',');
  command
      .add_option(
          "--want", options.wants,
          "with --scene: the results that the solver gives\n(position, velocity, acceleration, "
          "sensitivity,\nforces), in place of the scene's")
      ->delimiter(',');
  command
      .add_option(
          "--with", options.with,
          "with --model or --all: functions that headers hold\non request (jerk; rates: velocity "
          "and right-hand\nsides; special-points; forces: those in the joints\nof rigid models "
          "under given loads)")
      ->delimiter(',')
      ->check(one_of(words_on_request()));
  command
      .add_option("--interface", options.interface,
                  "with --scene: c writes a C header and its\nimplementation beside the C++ "
                  "header, c-float "
                  "the\nsame with numbers of type float")
      ->check(one_of({"cpp", "c", "c-float"}))
      ->capture_default_str();
  command.add_option("--group", options.group, "the group that --model refers to")
      ->check(one_of(group_names()))
      ->needs(model)
      ->capture_default_str();
  command.add_option("--output", options.output, "directory to write to")
      ->required()
      ->check(not_empty());
  command.add_flag("--check", options.check, "write nothing; exit with 1 if a file would change");
}

void declare_solve(CLI::App& command, SolveOptions& options) {
  add_scene(command, options.scene);
  add_settings(command, options.settings);
  command.add_option("--format", options.format, "the form of the answer")
      ->check(one_of({"text", "json", "csv"}))
      ->capture_default_str();
  command
      .add_option(
          "--branch", options.branch,
          "report configuration N only, as numbered\nwithout the option; with --format csv and "
          "a\nsweep, the rows of branch N, as numbered at\nthe first step that has one")
      ->type_name("N")
      ->check(any_whole_number());
  command
      .add_flag("--nearest", options.nearest,
                "report only the configuration nearest to the\nscene's reference; of a sweep, "
                "the branch that\nbegins there")
      ->excludes("--branch");
  command.add_flag("--prove", options.prove,
                   "prove that no configuration is missing: enclose\nall complex configurations of "
                   "every group");
  command.add_flag("--circuits", options.circuits,
                   "also report the branch and circuit of each\nconfiguration in the sweep; with "
                   "--format csv a\n"
                   "sweep always reports them");
  command.add_flag("--unwrapped", options.unwrapped,
                   "with --format csv and a sweep: angles continue\nby whole turns along a branch");
}

void declare_sweep(CLI::App& command, SweepOptions& options) {
  add_scene(command, options.scene);
  add_settings(command, options.settings);
  command
      .add_option("--branch", options.branch,
                  "the rows of branch N only, as numbered at the\nfirst step that has one")
      ->type_name("N")
      ->check(any_whole_number());
  command
      .add_flag("--nearest", options.nearest,
                "only the rows of the branch that begins nearest\nto the scene's reference")
      ->excludes("--branch");
  command.add_flag("--unwrapped", options.unwrapped,
                   "angles continue by whole turns along a branch");
}

void declare_draw(CLI::App& command, DrawOptions& options) {
  add_scene(command, options.scene);
  command.add_option("--output", options.output, "file to write: .svg, .html or .dxf")
      ->required()
      ->check(not_empty());
  add_settings(command, options.settings);
  command
      .add_option("--configuration", options.configuration,
                  "draw configuration N only; of a page, the\nbranch that is shown first")
      ->type_name("N")
      ->check(any_whole_number());
  command
      .add_flag("--nearest", options.nearest,
                "draw only the configuration nearest to the\nscene's reference")
      ->excludes("--configuration");
  command.add_flag(
      "--moving", options.moving,
      "draw one branch of the sweep in motion (.svg\nonly); --configuration gives its number");
}

void declare_import(CLI::App& command, ImportOptions& options) {
  command
      .add_option("FILE_OR_LINK", options.source,
                  "a .linkage2 file, a file with a link of PMKS+\nor an expression of Pyslvs, or "
                  "one of these two\nitself, in quotes")
      ->required()
      ->check(not_empty());
  command.add_option("--output", options.output, "scene file to write (JSON)")
      ->required()
      ->check(not_empty());
  command
      .add_option("--driver", options.driver,
                  "of an expression of Pyslvs: the point, as P0, of\nthe driven joint")
      ->check(not_empty());
  command.add_flag("--force", options.replace, "replace a file that exists");
}

void declare_sample(CLI::App& command, SampleOptions& options) {
  add_computing_options(command, options);
  command.add_option("--count", options.count, "number of samples")->required();
  command.add_option("--seed", options.seed, "seed of the random numbers")->required();
  command
      .add_option(
          "--branch", options.branch,
          "follow configuration N; default: the one nearest\nto the scene's reference, or 1")
      ->type_name("N")
      ->check(any_whole_number());
}

void declare_map(CLI::App& command, MapOptions& options) {
  add_computing_options(command, options);
  command.add_option("--over", options.over, "the grid: X=from:to:count,Y=...")->required();
}

void declare_merge(CLI::App& command, MergeOptions& options) {
  command.add_option("FILE", options.files, "the shards, in any order")->required();
  add_campaign_options(command, options);
}

void declare_audit(CLI::App& command, AuditOptions& options) {
  command
      .add_option("FILE", options.files,
                  "audit files, or papers in LaTeX with --map;\nor a program or paper with --init")
      ->required();
  command.add_option("--map", options.map, "the map of the papers' notation")->check(not_empty());
  command.add_option("--format", options.format, "the form of the report")
      ->check(one_of({"text", "markdown", "json", "github"}))
      ->capture_default_str();
  command.add_flag("--run", options.run,
                   "compile and run the programs that 'printed run'\nnames, on this machine");
  command.add_option("--flags", options.flags, "with --run: further flags for the compiler")
      ->allow_extra_args(false)
      ->needs("--run");
  command
      .add_option("--time-limit", options.seconds, "with --run: seconds that a program may take")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return complaint_of_number(text, least_seconds, most_seconds);
          },
          ""))
      ->capture_default_str()
      ->needs("--run");
  CLI::Option* const init =
      command
          .add_flag("--init", options.draft,
                    "write the audit file for the program FILE, or\nthe map for a paper, as far as "
                    "it can be told")
          ->excludes("--map")
          ->excludes("--run");
  CLI::Option* const draft_file =
      command.add_option("--output", options.output, "with --init: the file to write")
          ->check(not_empty())
          ->needs(init);
  command.add_flag("--force", options.force, "with --output: replace a file that exists")
      ->needs(draft_file);
}

int status(bool is_negative) { return is_negative ? exit_negative : exit_done; }

int print_catalogue(const CatalogueOptions& options) {
  print(options.format == "json"       ? catalogue_json()
        : options.format == "markdown" ? catalogue_markdown()
                                       : catalogue_text());
  return exit_done;
}

/// Prints the derivation of each group of a scene.
int print_derivations_of_scene(const DeriveOptions& options) {
  if (options.format == "latex") {
    throw text::InputError(
        "derive: a scene's groups are derived as text or JSON; for LaTeX give a kind");
  }
  const mechanism::Plan plan(mechanism::read_scene(options.what));
  std::vector<std::string> derivations;
  for (const mechanism::FoundGroup& group : plan.structure().groups) {
    const structure::Model& model = emission::scene::symbolic_model(group);
    const document::Derivation derivation =
        model.is_numbered()
            ? document::derive(*model.group, *structure::parse_kind(*model.group, group.kind))
            : document::derive(model, group.model->max_configurations, group.model->eliminations);
    derivations.push_back(options.format == "json" ? document::derivation_json(derivation)
                                                   : document::derivation_text(derivation));
  }
  print(options.format == "json" ? "[" + text::joined(derivations, ",\n") + "]\n"
                                 : text::joined(derivations, "\n"));
  return exit_done;
}

int print_derivation(const DeriveOptions& options) {
  if (options.what.ends_with(".json")) {
    return print_derivations_of_scene(options);
  }
  const ChosenKind chosen = chosen_kind(options);
  const document::Derivation derivation = document::derive(*chosen.group, chosen.kind);
  print(options.format == "json"    ? document::derivation_json(derivation)
        : options.format == "latex" ? document::derivation_latex(derivation)
                                    : document::derivation_text(derivation));
  return status(!derivation.rigid);
}

int audit_or_draft(const AuditOptions& options) {
  if (options.draft) {
    draft_audit(options);
    return exit_done;
  }
  return status(!run_audit(options));
}

/// Adds a subcommand with its options and the function that runs it.
template <typename Options>
void add(CLI::App& app, Chosen& chosen, const std::string& name, const std::string& description,
         void (*declare)(CLI::App&, Options&), int (*run)(const Options&)) {
  CLI::App* const command = app.add_subcommand(name, description);
  const auto options = std::make_shared<Options>();
  declare(*command, *options);
  command->callback([&chosen, options, run] { chosen = [options, run] { return run(*options); }; });
}

}  // namespace

void add_subcommands(CLI::App& app, Chosen& chosen) {
  add(app, chosen, "catalogue", "list the kinds and models of each group", declare_catalogue,
      print_catalogue);
  add(app, chosen, "derive", "print the derivation of a model, step by step", declare_derive,
      print_derivation);
  add<EmitOptions>(app, chosen, "emit", "write C++ for one scene, models, or closures",
                   declare_emit,
                   [](const EmitOptions& options) { return status(!run_emit(options)); });
  add<SolveOptions>(app, chosen, "solve", "find the assembly configurations of a scene",
                    declare_solve,
                    [](const SolveOptions& options) { return status(print_solution(options)); });
  add<SweepOptions>(app, chosen, "sweep", "follow the branches of a scene over its sweep",
                    declare_sweep,
                    [](const SweepOptions& options) { return status(run_sweep(options)); });
  add<DrawOptions>(app, chosen, "draw", "draw a scene as SVG, DXF or an interactive page",
                   declare_draw, [](const DrawOptions& options) {
                     draw_scene(options);
                     return exit_done;
                   });
  add<ImportOptions>(app, chosen, "import", "import a file of Linkage, PMKS+ or Pyslvs",
                     declare_import,
                     [](const ImportOptions& options) { return status(!import_file(options)); });
  add<SampleOptions>(app, chosen, "sample", "sample parameters within the tolerances of a scene",
                     declare_sample, [](const SampleOptions& options) {
                       run_sample(options);
                       return exit_done;
                     });
  add<MapOptions>(app, chosen, "map", "solve a scene over a grid of parameters", declare_map,
                  [](const MapOptions& options) {
                    run_map(options);
                    return exit_done;
                  });
  add<MergeOptions>(app, chosen, "merge", "merge the shards of a sample or a map", declare_merge,
                    [](const MergeOptions& options) {
                      run_merge(options);
                      return exit_done;
                    });
  add<NoOptions>(
      app, chosen, "schema", "print the JSON Schema of scene files", [](CLI::App&, NoOptions&) {},
      [](const NoOptions&) {
        print(mechanism::scene_schema());
        return exit_done;
      });
  add(app, chosen, "audit", "compare what a source prints with the derivation", declare_audit,
      audit_or_draft);
  for (CLI::App* each : app.get_subcommands(nullptr)) {
    each->add_flag_callback("--quiet", silence_remarks,
                            "print no progress bar and no remarks, only errors");
  }
}

}  // namespace assur::generator::command
