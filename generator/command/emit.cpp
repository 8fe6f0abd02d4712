// The command `assur emit`: files of C++ and C.
#include "emission/model/emit.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/error.hpp>
#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <iterator>
#include <set>
#include <utility>

#include "campaign/partial_file.hpp"
#include "command/commands.hpp"
#include "command/output.hpp"
#include "command/scene_warnings.hpp"
#include "emission/closures/emit_closures.hpp"
#include "emission/scene/emit_scene.hpp"
#include "emission/scene/scene_warnings.hpp"
#include "emission/scene/variable_parameters.hpp"

namespace assur::generator::command {

using emission::cpp::EmittedFile;
using text::InputError;

namespace {

/// Adds the parameters of `--variable` to those that the scene itself makes variable.
void add_variables(const std::vector<std::string>& names, assur::mechanism::Scene& scene) {
  std::vector<assur::mechanism::ParameterIndex>& variable = scene.request.variable;
  std::vector<assur::mechanism::ParameterIndex> added;
  if (names == std::vector<std::string>{"all"}) {
    added = emission::scene::independent_parameters(scene);
  } else if (std::find(names.begin(), names.end(), "all") != names.end()) {
    throw InputError("--variable: 'all' stands for every parameter; leave out 'all' or the rest");
  } else {
    std::transform(names.begin(), names.end(), std::back_inserter(added),
                   [&](const std::string& name) {
                     return scene.mechanism.parameter_named(name, "--variable");
                   });
  }
  for (auto one = added.begin(); one != added.end(); ++one) {
    if (std::find(added.begin(), one, *one) != one) {
      throw InputError("--variable: '" + scene.mechanism.parameters()[*one].name +
                       "' occurs twice; leave one out");
    }
  }
  for (const assur::mechanism::ParameterIndex parameter : added) {
    if (std::find(variable.begin(), variable.end(), parameter) == variable.end()) {
      variable.push_back(parameter);
    }
  }
}

/// The wanted results, by the words of a scene's `want`.
assur::mechanism::Want wanted(const std::vector<std::string>& words) {
  assur::mechanism::Want want = {false, false, false, false};
  using Flag = std::pair<std::string, bool*>;
  const std::array<Flag, 5> flags = {{{"position", &want.position},
                                      {"velocity", &want.velocity},
                                      {"acceleration", &want.acceleration},
                                      {"sensitivity", &want.sensitivity},
                                      {"forces", &want.forces}}};
  for (const std::string& word : words) {
    const auto* flag = std::find_if(flags.begin(), flags.end(),
                                    [&word](const auto& known) { return known.first == word; });
    if (flag == flags.end()) {
      std::vector<std::string> names;
      std::ranges::transform(flags, std::back_inserter(names), &Flag::first);
      throw InputError("--want: no result named " + text::in_quotes(word) +
                       text::suggestion_or_choice(word, names));
    }
    if (*flag->second) {
      throw InputError("--want: '" + word + "' occurs twice; leave one out");
    }
    *flag->second = true;
  }
  return want;
}

emission::scene::Interface interface_named(const std::string& name) {
  using emission::scene::Interface;
  return name == "c" ? Interface::c : name == "c-float" ? Interface::c_float : Interface::cpp;
}

std::vector<EmittedFile> emitted_scene(const EmitOptions& options) {
  const std::string& file = options.scene;
  assur::mechanism::Scene scene = assur::mechanism::read_scene(file);
  std::string want_option;
  if (!options.wants.empty()) {
    scene.request.want = wanted(options.wants);
    want_option = " --want " + text::joined(options.wants, ",");
  }
  try {
    add_variables(options.variables, scene);
    std::vector<EmittedFile> emitted =
        emission::scene::emit_scene(scene, want_option, interface_named(options.interface));
    warn_of_idle_links(scene);
    for (const std::string& warning : emission::scene::scene_warnings(scene)) {
      remarks() << "warning: " << file << ": " << warning << '\n';
    }
    return emitted;
  } catch (const assur::mechanism::MechanismError& error) {
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace

bool run_emit(const EmitOptions& options) {
  if (!options.variables.empty() && options.scene.empty()) {
    throw InputError("--variable: only scenes have parameters; give it with --scene");
  }
  if (!options.wants.empty() && options.scene.empty()) {
    throw InputError("--want: only solvers of scenes give results; give it with --scene");
  }
  if (options.interface != "cpp" && options.scene.empty()) {
    throw InputError(
        "--interface: only solvers of scenes have a C interface; give it with --scene");
  }
  const std::set<std::string> with(options.with.begin(), options.with.end());
  if (!with.empty() && !options.all && options.model == 0) {
    throw InputError(
        "--with: only models have functions on request; give it with --model or --all");
  }
  std::vector<EmittedFile> files;
  if (options.all) {
    ProgressBar bar;
    files = emission::model::emit_all(
        with, [&bar](std::uint64_t done, std::uint64_t count) { bar.show(done, count); });
  } else if (!options.scene.empty()) {
    files = emitted_scene(options);
  } else if (!options.closures.empty()) {
    const closures::TypedClosures closures = closures::read_typed_closures(options.closures);
    files.push_back(emission::closures::emit_closures(closures));
    for (const std::string& warning : emission::closures::closure_warnings(closures)) {
      remarks() << "warning: " << options.closures << ": " << warning << '\n';
    }
  } else {
    const std::vector<structure::Model>& models =
        structure::models_of(structure::group_named(options.group));
    for (const structure::Model& model : models) {
      if (model.number == options.model) {
        files.push_back(emission::model::emit_model(model, with));
      }
    }
    if (files.empty()) {
      throw InputError("--model: no " + options.group + " model " + std::to_string(options.model) +
                       "; the models are 1 to " + std::to_string(models.size()));
    }
  }
  if (!options.check) {
    const std::filesystem::path directory = options.output;
    for (const EmittedFile& file : files) {
      campaign::expect_other(directory / file.path, {options.scene, options.closures});
    }
    emission::cpp::write_files(files, options.output);
    return true;
  }
  bool same = true;
  for (const std::filesystem::path& path : emission::cpp::differing_files(files, options.output)) {
    const bool exists = std::filesystem::exists(std::filesystem::path(options.output) / path);
    remarks() << path.generic_string()
              << (exists ? " differs from what would be written\n" : " does not exist\n");
    same = false;
  }
  return same;
}

}  // namespace assur::generator::command
