// Turns the command line of `assur` into one subcommand and an exit status.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <assur/text/names.hpp>
#include <csignal>
#include <functional>
#include <iostream>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "command/arguments.hpp"
#include "command/audit.hpp"
#include "command/campaigns.hpp"
#include "command/catalogue.hpp"
#include "command/command_line_error.hpp"
#include "command/derive.hpp"
#include "command/draw.hpp"
#include "command/emit.hpp"
#include "command/import.hpp"
#include "command/output.hpp"
#include "command/ranks.hpp"
#include "command/remarks.hpp"
#include "command/solve.hpp"
#include "document/render.hpp"

namespace {

using namespace assur::generator;
using namespace assur::generator::command;
using assur::text::InputError;

constexpr int exit_ok = 0;
constexpr int exit_negative = 1;
constexpr int exit_unusable = 2;

constexpr int most_threads = 1024;
/// The limits of `--time-limit`.
constexpr double least_seconds = 0.1;
constexpr double most_seconds = 3600;

constexpr const char* set_help = "NAME=EXPR, replaces a parameter's value;\nmay be repeated";

struct CatalogueOptions {
  std::string format = "text";
};

int run_catalogue(const CatalogueOptions& options) {
  print(options.format == "json"       ? catalogue_json()
        : options.format == "markdown" ? catalogue_markdown()
                                       : catalogue_text());
  return exit_ok;
}

int run_derive(const DeriveOptions& options) {
  const ChosenKind chosen = chosen_kind(options);
  const document::Derivation derivation = document::derive(*chosen.group, chosen.kind);
  print(options.format == "json"    ? document::derivation_json(derivation)
        : options.format == "latex" ? document::derivation_latex(derivation)
                                    : document::derivation_text(derivation));
  return derivation.rigid ? exit_ok : exit_negative;
}

int run_solve(const SolveOptions& options) {
  return print_solution(options) ? exit_negative : exit_ok;
}

std::vector<std::string> group_names() {
  std::vector<std::string> names;
  for (const structure::Group& group : structure::known_groups()) {
    names.push_back(group.name());
  }
  return names;
}

/// A whole number from 1 to `most`.
CLI::Validator whole_number(int most) {
  return {[most](const std::string& text) { return complaint_of_whole_number(text, most); }, ""};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](const std::string& word) { return complaint_of_word(word, words); },
          "{" + assur::text::joined(words, ",") + "}"};
}

/// The options that commands of many solutions share.
void add_campaign_options(CLI::App& command, CampaignOptions& options,
                          const CLI::Validator& not_empty) {
  command
      .add_option("--output", options.output,
                  "the table to write: .csv or .h5;\nor .svg, a picture")
      ->required()
      ->check(not_empty);
  command.add_option("--plot", options.plot, "a picture beside the table: .svg")->check(not_empty);
  command.add_option("--format", options.format, "the form of the summary")
      ->check(one_of({"text", "json"}))
      ->capture_default_str();
  command.add_flag("--force", options.force, "replace files that exist");
}

/// These options, and those of the commands that compute the solutions.
void add_computing_options(CLI::App& command, CampaignOptions& options,
                           const CLI::Validator& not_empty) {
  command.add_option("SCENE", options.scene, "scene file (JSON)")->required()->check(not_empty);
  add_campaign_options(command, options, not_empty);
  command.add_option("--set", options.settings, set_help)->expected(1)->take_all();
  command.add_option("--shard", options.shard, "I/N: compute part I of N only, for assur merge");
  command
      .add_option("--threads", options.threads, "number of threads (default: one for each core)")
      ->type_name("N")
      ->check(whole_number(most_threads));
}

/// One line, whatever the words of the command line and the names of files contain.
void print_error(const std::string& text) {
  std::cerr << "error: " << assur::text::on_one_line(text) << '\n';
}

int run(int argc, char** argv) {
  const CLI::Validator any_whole_number = whole_number(std::numeric_limits<int>::max());
  const CLI::Validator not_empty(
      [](const std::string& name) { return name.empty() ? std::string("the name is empty") : ""; },
      "");
  CLI::App app{"Derives the kinematics of planar linkages and emits closed-form solvers."};
  app.name("assur");
  app.set_version_flag("--version", "assur " ASSUR_VERSION);
  app.require_subcommand(1);
  std::function<int()> chosen;

  CatalogueOptions catalogue;
  CLI::App* command = app.add_subcommand("catalogue", "list the kinds and models of each group");
  command->add_option("--format", catalogue.format, "the form of the list")
      ->check(one_of({"text", "markdown", "json"}))
      ->capture_default_str();
  command->callback([&] { chosen = [&] { return run_catalogue(catalogue); }; });

  DeriveOptions derivation;
  command = app.add_subcommand("derive", "print the derivation of a model, step by step");
  command
      ->add_option("KIND_OR_MODEL", derivation.what, "a kind such as RRP-RRR, or a model's number")
      ->required();
  command
      ->add_option(
          "--group", derivation.group,
          "the group of the model (default: tetrad)\nor of the kind (default: by spelling)")
      ->check(one_of(group_names()));
  command->add_option("--format", derivation.format, "the form of the derivation")
      ->check(one_of({"text", "latex", "json"}))
      ->capture_default_str();
  command->callback([&] { chosen = [&] { return run_derive(derivation); }; });

  EmitOptions emit;
  command = app.add_subcommand("emit", "write C++ for one scene, models, or closures");
  auto* what = command->add_option_group("source");
  what->add_flag("--all", emit.all, "every model of every group");
  CLI::Option* const model =
      what->add_option("--model", emit.model, "one model of a group, by its number")
          ->type_name("N")
          ->check(any_whole_number);
  what->add_option("--scene", emit.scene, "a solver for one scene file (JSON)")->check(not_empty);
  what->add_option("--closures", emit.closures, "the closures that are typed in an audit file")
      ->check(not_empty);
  what->require_option(1);
  command
      ->add_option("--variable", emit.variables,
                   "with --scene: parameters X,Y that stay arguments\nof the solver, or all")
      ->delimiter(',');
  command
      ->add_option(
          "--want", emit.wants,
          "with --scene: the results that the solver gives\n(position, velocity, acceleration, "
          "sensitivity,\nforces), in place of the scene's")
      ->delimiter(',');
  command
      ->add_option("--with", emit.with,
                   "with --model: more functions of a rigid model\n(forces: those in its joints "
                   "under given loads)")
      ->needs(model)
      ->check(one_of({"forces"}));
  command
      ->add_option("--interface", emit.interface,
                   "with --scene: c writes a C header and its\nimplementation beside the C++ "
                   "header, c-float "
                   "the\nsame with numbers of type float")
      ->check(one_of({"cpp", "c", "c-float"}))
      ->capture_default_str();
  command->add_option("--group", emit.group, "the group that --model refers to")
      ->check(one_of(group_names()))
      ->needs(model)
      ->capture_default_str();
  command->add_option("--output", emit.output, "directory to write to")
      ->required()
      ->check(not_empty);
  command->add_flag("--check", emit.check, "write nothing; exit with 1 if a file would change");
  command->callback([&] { chosen = [&] { return run_emit(emit) ? exit_ok : exit_negative; }; });

  SolveOptions solve;
  command = app.add_subcommand("solve", "find the assembly configurations of a scene");
  command->add_option("SCENE", solve.scene, "scene file (JSON)")->required()->check(not_empty);
  command->add_option("--set", solve.settings, set_help)->expected(1)->take_all();
  command->add_option("--format", solve.format, "the form of the answer")
      ->check(one_of({"text", "json", "csv"}))
      ->capture_default_str();
  command
      ->add_option(
          "--branch", solve.branch,
          "report configuration N only, as numbered\nwithout the option; with --format csv and "
          "a\nsweep, the rows of branch N, as numbered at\nthe first step that has one")
      ->type_name("N")
      ->check(any_whole_number);
  command
      ->add_flag("--nearest", solve.nearest,
                 "report only the configuration nearest to the\nscene's reference; of a sweep, "
                 "the branch that\nbegins there")
      ->excludes("--branch");
  command->add_flag(
      "--prove", solve.prove,
      "prove that no configuration is missing: enclose\nall complex configurations of "
      "every group");
  command->add_flag("--circuits", solve.circuits,
                    "also tell on which branch and circuit of the\nsweep a configuration is; with "
                    "--format csv a\nsweep always tells");
  command->add_flag(
      "--unwrapped", solve.unwrapped,
      "with --format csv and a sweep: angles continue\nby whole turns along a branch");
  command->callback([&] { chosen = [&] { return run_solve(solve); }; });

  DrawOptions draw;
  command = app.add_subcommand("draw", "draw a scene as SVG, DXF or an interactive page");
  command->add_option("SCENE", draw.scene, "scene file (JSON)")->required()->check(not_empty);
  command->add_option("--output", draw.output, "file to write: .svg, .html or .dxf")
      ->required()
      ->check(not_empty);
  command->add_option("--set", draw.settings, set_help)->expected(1)->take_all();
  command
      ->add_option("--configuration", draw.configuration,
                   "draw configuration N only; of a page, the\nbranch that is shown first")
      ->type_name("N")
      ->check(any_whole_number);
  command
      ->add_flag("--nearest", draw.nearest,
                 "draw only the configuration nearest to the\nscene's reference")
      ->excludes("--configuration");
  command->add_flag(
      "--moving", draw.moving,
      "draw one branch of the sweep in motion (.svg\nonly); --configuration gives its number");
  command->callback([&] {
    chosen = [&] {
      draw_scene(draw);
      return exit_ok;
    };
  });

  ImportOptions import_options;
  command = app.add_subcommand("import", "make a scene of a file of Linkage, PMKS+ or Pyslvs");
  command
      ->add_option("FILE_OR_LINK", import_options.source,
                   "a .linkage2 file, a file with a link of PMKS+\nor an expression of Pyslvs, or "
                   "one of these two\nitself, in quotes")
      ->required()
      ->check(not_empty);
  command->add_option("--output", import_options.output, "scene file to write (JSON)")
      ->required()
      ->check(not_empty);
  command
      ->add_option("--driver", import_options.driver,
                   "of an expression of Pyslvs: the point, as P0, of\nthe driven joint")
      ->check(not_empty);
  command->add_flag("--force", import_options.replace, "replace a file that exists");
  command->callback(
      [&] { chosen = [&] { return import_file(import_options) ? exit_ok : exit_negative; }; });

  SampleOptions sample;
  command = app.add_subcommand("sample", "sample parameters within the tolerances of a scene");
  add_computing_options(*command, sample, not_empty);
  command->add_option("--count", sample.count, "number of samples")->required();
  command->add_option("--seed", sample.seed, "seed of the random numbers")->required();
  command
      ->add_option(
          "--branch", sample.branch,
          "follow configuration N; default: the one nearest\nto the scene's reference, or 1")
      ->type_name("N")
      ->check(any_whole_number);
  command->callback([&] {
    chosen = [&] {
      run_sample(sample);
      return exit_ok;
    };
  });

  MapOptions map;
  command = app.add_subcommand("map", "solve a scene over a grid of parameters");
  add_computing_options(*command, map, not_empty);
  command->add_option("--over", map.over, "the grid: X=from:to:count,Y=...")->required();
  command->callback([&] {
    chosen = [&] {
      run_map(map);
      return exit_ok;
    };
  });

  MergeOptions merge;
  command = app.add_subcommand("merge", "put the shards of a sample or a map together");
  command->add_option("FILE", merge.files, "the shards, in any order")->required();
  add_campaign_options(*command, merge, not_empty);
  command->callback([&] {
    chosen = [&] {
      run_merge(merge);
      return exit_ok;
    };
  });

  command = app.add_subcommand("schema", "print the JSON Schema of scene files");
  command->callback([&] {
    chosen = [] {
      print(assur::mechanism::scene_schema());
      return exit_ok;
    };
  });

  AuditOptions audit;
  command = app.add_subcommand("audit", "compare what a source prints with the derivation");
  command
      ->add_option("FILE", audit.files,
                   "audit files, or papers in LaTeX with --map;\nor a program or paper with --init")
      ->required();
  command->add_option("--map", audit.map, "what the notation of the papers stands for")
      ->check(not_empty);
  command->add_option("--format", audit.format, "the form of the report")
      ->check(one_of({"text", "markdown", "json", "github"}))
      ->capture_default_str();
  command->add_flag("--run", audit.run,
                    "compile and run the programs that 'printed run'\nnames, on this machine");
  command->add_option("--flags", audit.flags, "with --run: further flags for the compiler")
      ->allow_extra_args(false)
      ->needs("--run");
  command->add_option("--time-limit", audit.seconds, "with --run: seconds that a program may take")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return complaint_of_number(text, least_seconds, most_seconds);
          },
          ""))
      ->capture_default_str()
      ->needs("--run");
  CLI::Option* const init =
      command
          ->add_flag(
              "--init", audit.draft,
              "write the audit file for the program FILE, or\nthe map for a paper, as far as "
              "it can be told")
          ->excludes("--map")
          ->excludes("--run");
  CLI::Option* const draft_file =
      command->add_option("--output", audit.output, "with --init: the file to write")
          ->check(not_empty)
          ->needs(init);
  command->add_flag("--force", audit.force, "with --output: replace a file that exists")
      ->needs(draft_file);
  command->callback([&] {
    chosen = [&] {
      if (audit.draft) {
        draft_audit(audit);
        return exit_ok;
      }
      return run_audit(audit) ? exit_ok : exit_negative;
    };
  });

  for (CLI::App* each : app.get_subcommands(nullptr)) {
    each->add_flag_callback("--quiet", silence_remarks,
                            "print no progress bar and no remarks, only errors");
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    print_error(command_line_error(app, error, {argv + 1, argv + argc}));
    return exit_unusable;
  }
  return chosen();
}

}  // namespace

int main(int argc, char** argv) {
  // Writing to a closed pipe, or to a file that may not grow, is to fail with an error and a status
  // instead of ending the process.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int status = run(argc, argv);
    finish_output();
    return status;
  } catch (const InputError& error) {
    print_error(error.what());
  } catch (const std::bad_alloc&) {
    print_error("the memory does not suffice; ask for less in one run");
  } catch (const OtherRankFailed&) {  // that rank says why
  } catch (const ClosedPipe&) {       // the reader closed it on purpose
  } catch (const std::exception& error) {
    print_error(std::string("internal: ") + error.what() + "; please report this with its input");
  }
  return exit_unusable;
}
