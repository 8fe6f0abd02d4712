#include "command/derive.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <cctype>
#include <optional>
#include <vector>

namespace assur::generator::command {

namespace {

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char letter) {
    return std::isdigit(letter) != 0;
  });
}

ChosenKind model_kind(const structure::Group& group, const std::string& number) {
  const std::vector<structure::Model>& models = structure::models_of(group);
  for (const structure::Model& model : models) {
    if (std::to_string(model.number) == number) {
      return {&group, model.representative};
    }
  }
  throw text::InputError("derive: no " + group.name() + " model " + number +
                         "; the models are 1 to " + std::to_string(models.size()));
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

}  // namespace

ChosenKind chosen_kind(const DeriveOptions& options) {
  if (is_number(options.what)) {
    return model_kind(structure::group_named(options.group.empty() ? "tetrad" : options.group),
                      options.what);
  }
  std::vector<ChosenKind> found;
  std::vector<std::string> spellings;
  std::vector<std::string> groups;
  for (const structure::Group& group : structure::known_groups()) {
    if (!options.group.empty() && options.group != group.name()) {
      continue;
    }
    if (const std::optional<structure::Kind> kind = structure::parse_kind(group, options.what)) {
      found.push_back({&group, *kind});
      groups.push_back(group.name());
    }
    for (const structure::Kind& kind : structure::all_kinds(group)) {
      spellings.push_back(structure::spell(group, kind));
    }
  }
  if (found.size() > 1) {
    throw text::InputError("derive: " + text::in_quotes(options.what) + " is a kind of " +
                           groups[0] + " and of " + groups[1] + "; say which by --group");
  }
  if (found.empty()) {
    throw text::InputError("derive: no " + options.group + (options.group.empty() ? "" : " ") +
                           "kind " + text::in_quotes(options.what) +
                           text::suggestion(upper_case(options.what), spellings) +
                           "; give a kind such as " + spellings.front() + " or a model's number");
  }
  return found.front();
}

}  // namespace assur::generator::command
