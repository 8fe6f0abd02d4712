// The command `assur map`: rows, a summary and a picture of a grid of parameters.
#include <algorithm>
#include <assur/mechanism/error.hpp>
#include <assur/text/counts.hpp>
#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <cmath>

#include "campaign/grid_summary.hpp"
#include "campaign/partial_file.hpp"
#include "command/campaigns.hpp"
#include "command/output.hpp"
#include "command/scene_warnings.hpp"

namespace assur::generator::command {

namespace {

constexpr std::uint64_t most_values = 100'000'000;  // as many as cells of a grid

/// Parts of a text between separators outside all parentheses.
std::vector<std::string> parts_between(const std::string& text, char separator) {
  std::vector<std::string> parts = {""};
  int depth = 0;
  for (const char letter : text) {
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == separator && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

/// An axis of `--over`, with its ends as numbers of the mechanism.
struct WrittenAxis {
  mechanism::ParameterIndex parameter;
  mechanism::NumberIndex from, to;
  std::uint64_t count;
};

std::vector<WrittenAxis> written_axes(const std::string& over,
                                      const std::vector<std::string>& settings,
                                      mechanism::Mechanism& mechanism) {
  std::vector<WrittenAxis> axes;
  for (const std::string& part : parts_between(over, ',')) {
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const std::string where = "--over " + name;
    const std::vector<std::string> range = equals == std::string::npos
                                               ? std::vector<std::string>()
                                               : parts_between(part.substr(equals + 1), ':');
    if (range.size() != 3) {
      throw mechanism::MechanismError("--over", text::in_quotes(part) +
                                                    " is not an axis; expected NAME=FROM:TO:COUNT, "
                                                    "such as phi=0:2*pi:361");
    }
    const auto is_given = [&name](const std::string& setting) {
      return setting.substr(0, setting.find('=')) == name;
    };
    if (std::ranges::any_of(settings, is_given)) {
      throw mechanism::MechanismError(
          "--set " + name, "--over gives '" + name + "' its values; leave one of the two out");
    }
    axes.push_back({mechanism.parameter_named(name, "--over"),
                    mechanism.add_number(range[0], where), mechanism.add_number(range[1], where),
                    whole_number(range[2], 1, most_values, where + ": COUNT")});
  }
  return axes;
}

std::vector<mechanism::GridAxis> grid_axes(const std::vector<WrittenAxis>& written,
                                           const mechanism::Plan& plan) {
  const mechanism::Values values = plan.values();
  std::vector<mechanism::GridAxis> axes;
  for (const WrittenAxis& axis : written) {
    axes.push_back(
        {axis.parameter, values.value_of(axis.from), values.value_of(axis.to), axis.count});
    if (!std::isfinite(axes.back().to - axes.back().from)) {
      throw mechanism::MechanismError("--over", "the range from FROM to TO is not finite");
    }
  }
  return axes;
}

void tell_refused_cells(const campaign::GridSummary& summary) {
  const auto refused =
      static_cast<std::uint64_t>(std::ranges::count_if(summary.cells(), &campaign::Cell::refused));
  if (refused == 0) {
    return;
  }
  std::uint64_t rest = summary.first_refused();
  std::string settings;
  for (auto axis = summary.axes().rbegin(); axis != summary.axes().rend(); ++axis) {
    const double value =
        mechanism::value_at({{}, axis->from, axis->to, axis->count}, rest % axis->count);
    settings = " --set " + axis->name + "=" + campaign::number_text(value) + settings;
    rest /= axis->count;
  }
  remarks() << text::with_noun(refused, "cell") << (refused == 1 ? " is" : " are")
            << " refused; `assur solve SCENE" << settings << "` tells the reason"
            << (refused == 1 ? "" : " for the first") << '\n';
}

void map(const MapOptions& options, CampaignScene& scene) {
  campaign::Outputs files = files_of(options, {options.scene});
  mechanism::Mechanism& mechanism = scene.scene.mechanism;
  const mechanism::Request& request = scene.scene.request;
  const std::vector<WrittenAxis> written = written_axes(options.over, options.settings, mechanism);
  const mechanism::Plan plan(mechanism, request);
  warn_of_idle_links(scene.scene);
  const std::vector<mechanism::GridAxis> axes = grid_axes(written, plan);
  const mechanism::Campaign campaign = mechanism::grid_campaign(mechanism, request, axes);
  campaign::Description& description = scene.description;
  description.columns = campaign.columns;
  description.items = campaign.items;
  for (const mechanism::GridAxis& axis : axes) {
    description.add("axis", campaign::axis_text({mechanism.parameters()[axis.parameter].name,
                                                 axis.from, axis.to, axis.count}));
  }
  if (!files.picture.empty()) {
    campaign::expect_drawable(description, files.picture.string());
  }
  campaign::GridSummary summary(description, options.scene);
  files.drawing = [&summary] { return campaign::grid_picture(summary); };
  if (!compute(options, files, campaign, description,
               [&summary](const std::vector<double>& rows) { summary.add(rows); })) {
    return;
  }
  tell_refused_cells(summary);
  print(options.format == "json" ? campaign::grid_json(summary) : campaign::grid_text(summary));
}

}  // namespace

void run_map(const MapOptions& options) {
  CampaignScene scene = campaign_scene("map", options);
  try {
    map(options, scene);
  } catch (const mechanism::MechanismError& error) {
    throw text::InputError(options.scene + ": " + error.what());
  }
}

}  // namespace assur::generator::command
