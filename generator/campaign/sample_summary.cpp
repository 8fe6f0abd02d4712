#include "campaign/sample_summary.hpp"

#include <assur/text/counts.hpp>
#include <assur/text/error.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace assur::generator::campaign {

namespace {

using mechanism::Outcome;
using Json = nlohmann::ordered_json;

constexpr std::size_t columns_before_outputs = 2;
constexpr std::size_t bars_of_json = 64;
constexpr std::size_t bars_of_text = 16;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string shown(double number) {
  if (!std::isfinite(number)) {
    return "-";
  }
  return text::short_number(number, 9);
}

Json json_number(double number) { return std::isfinite(number) ? Json(number) : Json(); }

std::string axis_name(std::size_t coordinate) { return coordinate == 0 ? "x" : "y"; }

/// A number of a coordinate in both reports: its name in each, and its value; NaN for an unknown
/// one, such as the deviation of a single sample.
struct Row {
  const char* text;
  const char* json;
  std::function<double(const SampledOutput&, Eigen::Index)> number;
  bool of_points = false;  ///< requires second derivatives, so forces do not have it
};

/// The number, or NaN if there are fewer than `least` samples.
double known(const SampledOutput& output, double number, std::uint64_t least = 1) {
  return output.statistics.count() >= least ? number : std::numeric_limits<double>::quiet_NaN();
}

const FirstOrder& predicted(const SampledOutput& output, Eigen::Index axis) {
  return output.predicted[static_cast<std::size_t>(axis)];
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {"nominal", "nominal",
       [](const SampledOutput& one, Eigen::Index axis) { return predicted(one, axis).nominal; }},
      {"mean - nominal", "mean_shift",
       [](const SampledOutput& one, Eigen::Index axis) {
         return known(one, one.statistics.mean_shift()(axis));
       }},
      {"  by second derivatives", "mean_shift_second_order",
       [](const SampledOutput& one, Eigen::Index axis) { return predicted(one, axis).mean_shift; },
       true},
      {"deviation", "deviation",
       [](const SampledOutput& one, Eigen::Index axis) {
         return known(one, std::sqrt(one.statistics.covariance()(axis, axis)), 2);
       }},
      {"  rss / sqrt(3)", "deviation_first_order",
       [](const SampledOutput& one, Eigen::Index axis) {
         return predicted(one, axis).rss / std::sqrt(3);
       }},
      {"least - nominal", "least",
       [](const SampledOutput& one, Eigen::Index axis) {
         return known(one, one.statistics.least()(axis) - predicted(one, axis).nominal);
       }},
      {"greatest - nominal", "greatest",
       [](const SampledOutput& one, Eigen::Index axis) {
         return known(one, one.statistics.greatest()(axis) - predicted(one, axis).nominal);
       }},
      {"  worst_case", "worst_case",
       [](const SampledOutput& one, Eigen::Index axis) { return predicted(one, axis).worst_case; }},
      {"rss", "rss",
       [](const SampledOutput& one, Eigen::Index axis) { return predicted(one, axis).rss; }}};
  return all;
}

std::string histogram_text(const mechanism::Histogram& histogram, double nominal) {
  const auto bars = histogram.bars(bars_of_text);
  std::uint64_t most = 1;
  for (const auto& bar : bars) {
    most = std::max(most, bar.count);
  }
  constexpr std::uint64_t longest = 50;
  std::string text;
  for (const auto& bar : bars) {
    text += "  " + padded(shown(bar.from - nominal), 16) + " " +
            padded(std::to_string(bar.count), 11) + " " +
            std::string(static_cast<std::size_t>(std::llround(
                            static_cast<double>(bar.count * longest) / static_cast<double>(most))),
                        '#') +
            "\n";
  }
  return text;
}

std::string output_text(const SampledOutput& output) {
  constexpr std::size_t width = 18;
  std::string text =
      "\n" + output.name +
      std::string(std::max<std::size_t>(26, output.name.size()) - output.name.size(), ' ') +
      (output.is_point ? padded("x", width) + padded("y", width) : "") + "\n";
  for (const Row& row : rows()) {
    if (!output.is_point && row.of_points) {
      continue;
    }
    text += "  " + std::string(row.text) + std::string(24 - std::string(row.text).size(), ' ');
    for (std::size_t axis = 0; axis < output.axes(); ++axis) {
      text += padded(shown(row.number(output, static_cast<Eigen::Index>(axis))), width);
    }
    text += "\n";
  }
  if (output.is_point) {
    text += "  covariance of x and y   " +
            padded(shown(known(output, output.statistics.covariance()(0, 1), 2)), width) +
            padded(shown(output.covariance), width) + "  (by first derivatives)\n";
  }
  for (std::size_t axis = 0; axis < output.axes(); ++axis) {
    if (output.statistics.count() > 0) {
      text += "  " + output.name_of(axis) + " - nominal, from        samples\n" +
              histogram_text(output.statistics.histogram(axis), output.predicted[axis].nominal);
    }
  }
  return text;
}

Json histogram_json(const mechanism::Histogram& histogram, double nominal) {
  Json bars = Json::array();
  for (const auto& bar : histogram.bars(bars_of_json)) {
    bars.push_back({{"from", bar.from - nominal}, {"to", bar.to - nominal}, {"count", bar.count}});
  }
  return bars;
}

void add_force(const SampledOutput& force, Json& entry) {
  for (const Row& row : rows()) {
    if (!row.of_points) {
      entry[row.json] = json_number(row.number(force, 0));
    }
  }
  entry["histogram"] = force.statistics.count() > 0 ? histogram_json(force.statistics.histogram(0),
                                                                     force.predicted[0].nominal)
                                                    : Json::array();
}

}  // namespace

SampleSummary::SampleSummary(Description description, const std::string& where)
    : description_(std::move(description)) {
  using Kind = mechanism::Column::Kind;
  if (!description_.has_kinds({Kind::whole, Kind::outcome})) {
    throw text::InputError(where + ": it is not a table of a sample: its columns differ");
  }
  const std::size_t numbers = description_.columns.size() - columns_before_outputs;
  const std::vector<double> nominal = description_.numbers_of("nominal");
  const std::vector<double> worst_case = description_.numbers_of("worst_case");
  const std::vector<double> rss = description_.numbers_of("rss");
  const std::vector<double> covariance = description_.numbers_of("covariance");
  const std::vector<double> mean_shift = description_.numbers_of("mean_shift");
  const std::size_t points = covariance.size() / 3;
  for (const auto* list : {&nominal, &worst_case, &rss, &mean_shift}) {
    if (list->size() != numbers || covariance.size() != 3 * points || 2 * points > numbers) {
      throw text::InputError(where +
                             ": it is not a table of a sample: numbers of its outputs are missing");
    }
  }
  for (std::size_t output = 0; output < points; ++output) {
    const std::string& column = description_.columns[columns_before_outputs + 2 * output].name;
    const std::size_t x = 2 * output;
    const std::size_t y = x + 1;
    outputs_.push_back(
        {column.substr(0, column.rfind('.')),
         true,
         {{{nominal[x], worst_case[x], rss[x], covariance[3 * output], mean_shift[x]},
           {nominal[y], worst_case[y], rss[y], covariance[3 * output + 1], mean_shift[y]}}},
         covariance[3 * output + 2],
         mechanism::PointStatistics({nominal[x], nominal[y]})});
  }
  for (std::size_t force = 2 * points; force < numbers; ++force) {
    outputs_.push_back({description_.columns[columns_before_outputs + force].name,
                        false,
                        {{{nominal[force], worst_case[force], rss[force], none, none}, {}}},
                        none,
                        mechanism::PointStatistics({nominal[force], 0})});
  }
}

void SampleSummary::add(const std::vector<double>& rows) {
  const std::size_t width = description_.columns.size();
  for (std::size_t at = 0; at < rows.size(); at += width) {
    const auto outcome = static_cast<std::size_t>(rows[at + 1]);
    if (counts_[outcome]++ == 0) {
      first_[outcome] = static_cast<std::uint64_t>(rows[at]);
    }
    const double* number = &rows[at + columns_before_outputs];
    for (SampledOutput& output : outputs_) {
      const Eigen::Vector2d numbers(number[0], output.is_point ? number[1] : 0);
      if (numbers.allFinite() && std::isfinite(output.predicted[0].nominal)) {
        output.statistics.add(numbers);
      }
      number += output.axes();
    }
  }
}

std::uint64_t SampleSummary::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

void describe_nominal(const mechanism::Sampling& sampling, Description& description) {
  const Eigen::Vector2d unknown(none, none);
  std::vector<double> nominal;
  std::vector<double> worst_case;
  std::vector<double> rss;
  std::vector<double> covariance;
  std::vector<double> mean_shift;
  const auto add = [](std::vector<double>& numbers, const Eigen::Vector2d& point) {
    numbers.insert(numbers.end(), {point.x(), point.y()});
  };
  for (const mechanism::NominalPoint& point : sampling.nominal()) {
    add(nominal, point.position);
    add(worst_case, point.worst_case.value_or(unknown));
    add(rss, point.rss.value_or(unknown));
    add(mean_shift, point.spread ? point.spread->mean_shift : unknown);
    add(covariance, point.spread ? Eigen::Vector2d(point.spread->covariance.diagonal()) : unknown);
    covariance.push_back(point.spread ? point.spread->covariance(0, 1) : none);
  }
  for (const mechanism::NominalForce& force : sampling.nominal_forces()) {
    nominal.push_back(force.number);
    worst_case.push_back(force.worst_case);
    rss.push_back(force.rss);
    mean_shift.push_back(none);
  }
  description.add("nominal", nominal);
  description.add("worst_case", worst_case);
  description.add("rss", rss);
  description.add("covariance", covariance);
  description.add("mean_shift", mean_shift);
}

std::string sample_text(const SampleSummary& summary) {
  const Description& description = summary.description();
  std::string text =
      description.text_of("name") + "\n" + text::with_noun(summary.count(), "sample") +
      (description.shard.is_whole() ? "" : " of shard " + description.shard.text()) + ", seed " +
      description.text_of("seed") + ", near to " + description.text_of("configuration") +
      "\nuniform and independent: " + description.text_of("tolerances") + "\n\n";
  for (std::size_t outcome = 0; outcome < mechanism::outcome_words.size(); ++outcome) {
    const std::uint64_t count = summary.count_of(static_cast<Outcome>(outcome));
    if (count > 0) {
      text += "  " + padded(std::to_string(count), 12) + " " +
              std::string(mechanism::outcome_words[outcome]) + "\n";
    }
  }
  for (const SampledOutput& output : summary.outputs()) {
    text += output_text(output);
  }
  return text;
}

std::string sample_json(const SampleSummary& summary) {
  const Description& description = summary.description();
  Json root;
  root["name"] = description.text_of("name");
  root["samples"] = summary.count();
  root["seed"] = Json::parse(description.text_of("seed"), nullptr, false);
  root["shard"] = description.shard.text();
  root["followed"] = description.text_of("configuration");
  root["tolerances"] = description.text_of("tolerances");
  for (std::size_t outcome = 0; outcome < mechanism::outcome_words.size(); ++outcome) {
    root["outcomes"][std::string(mechanism::outcome_words[outcome])] =
        summary.count_of(static_cast<Outcome>(outcome));
  }
  root["outputs"] = Json::object();
  for (const SampledOutput& output : summary.outputs()) {
    if (!output.is_point) {
      add_force(output, root["forces"][output.name]);
      continue;
    }
    Json& entry = root["outputs"][output.name];
    for (const Row& row : rows()) {
      entry[row.json] = {json_number(row.number(output, 0)), json_number(row.number(output, 1))};
    }
    const Eigen::Matrix2d spread = output.statistics.covariance();
    const auto matrix = [](double xx, double xy, double yy) {
      return Json::array({{json_number(xx), json_number(xy)}, {json_number(xy), json_number(yy)}});
    };
    entry["covariance"] =
        output.statistics.count() > 0 ? matrix(spread(0, 0), spread(0, 1), spread(1, 1)) : Json();
    entry["covariance_first_order"] =
        matrix(output.predicted[0].variance, output.covariance, output.predicted[1].variance);
    for (const std::size_t axis : {0U, 1U}) {
      entry["histogram_" + axis_name(axis)] =
          output.statistics.count() > 0
              ? histogram_json(output.statistics.histogram(axis), output.predicted[axis].nominal)
              : Json::array();
    }
  }
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assur::generator::campaign
