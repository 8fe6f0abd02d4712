#include "command/command_line_error.hpp"

#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>

#include "command/arguments.hpp"

namespace assur::generator::command {

namespace {

/// Adds the long names of a command's options, including those of its option groups.
void add_options(const CLI::App& command, std::vector<std::string>& names) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  for (const CLI::App* group : command.get_subcommands(nullptr)) {
    add_options(*group, names);
  }
}

/// What a command needs in addition to a missing option: one option of each group of which none is
/// given.
std::string missing_choices(const CLI::App& command) {
  std::string choices;
  for (const CLI::App* group : command.get_subcommands(nullptr)) {
    std::vector<std::string> names;
    bool is_chosen = false;
    for (const CLI::Option* option : group->get_options()) {
      if (option != group->get_help_ptr()) {
        names.push_back("--" + option->get_lnames().front());
        is_chosen = is_chosen || option->count() > 0;
      }
    }
    choices += is_chosen ? "" : ", and exactly one of " + text::listed(names);
  }
  return choices;
}

}  // namespace

std::string command_line_error(const CLI::App& app, const CLI::ParseError& error,
                               const std::vector<std::string>& words) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  if (!chosen.empty()) {
    const std::string name = chosen.front()->get_name();
    std::vector<std::string> options;
    add_options(*chosen.front(), options);
    std::string fault = complaint_of_options(words, options);
    if (const auto rest = chosen.front()->remaining(); fault.empty() && !rest.empty()) {
      fault = "the argument " + text::in_quotes(rest.front()) + " is one too many; leave it out";
    }
    if (fault.empty()) {
      fault = complaint_of_library(error.what());
      fault += fault.ends_with(" is required") ? missing_choices(*chosen.front()) : "";
    }
    return name + ": " + fault + " (see assur " + name + " --help)";
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    names.push_back(command->get_name());
  }
  const std::string found =
      words.empty() ? ""
                    : " " + text::in_quotes(words.front()) + text::suggestion(words.front(), names);
  return "no subcommand" + found + "; the subcommands are " + text::listed(names) +
         " (see assur --help)";
}

}  // namespace assur::generator::command
