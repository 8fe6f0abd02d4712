// Turns solutions and sweeps into the lines of a CSV table.
#include <array>
#include <cstdio>

#include "scene/covariance.hpp"
#include "scene/report.hpp"
#include "scene/report_values.hpp"

namespace assur::generator {

namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return quoted + "\"";
}

std::string csv_number(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.17g", number);
  return text.data();
}

/// The cells of a configuration, each with a comma ahead.
std::string csv_cells(const Scene& scene, const ParameterValues& values,
                      const AssemblyConfiguration& configuration) {
  const SceneWant& want = scene.want;
  std::string row;
  const auto add = [&](bool wanted, const std::vector<double>& numbers) {
    for (const double value : numbers) {
      row += wanted ? "," + csv_number(value) : "";
    }
  };
  for (std::size_t link = 0; link < scene.links.size(); ++link) {
    if (scene.links[link].name == "ground") {
      continue;
    }
    const LinkState& state = configuration.links[link];
    add(want.position, {state.x.value(), state.y.value(), angle(state.direction)});
    add(want.velocity, {state.velocity(0), state.velocity(1), state.velocity(2)});
    add(want.acceleration, {state.acceleration(0), state.acceleration(1), state.acceleration(2)});
  }
  for (const PointState& point : configuration.outputs) {
    const Eigen::VectorXd& tolerances = values.tolerances();
    add(want.position, {point.x.value(), point.y.value()});
    add(want.velocity, {point.velocity(0), point.velocity(1)});
    add(want.acceleration, {point.acceleration(0), point.acceleration(1)});
    const PathAcceleration parts = path_acceleration(point);
    add(want.velocity && want.acceleration, {parts.tangential, parts.normal});
    add(want.sensitivity,
        {worst_case(point.x, tolerances), worst_case(point.y, tolerances),
         root_sum_square(point.x, tolerances), root_sum_square(point.y, tolerances)});
    if (values.second_order()) {
      const PointSpread spread = spread_of(point, values.covariance());
      add(true, {spread.covariance(0, 0), spread.covariance(1, 1), spread.covariance(0, 1),
                 spread.mean_shift(0), spread.mean_shift(1)});
    }
  }
  return row + "," + regularity_text(configuration.regularity) + "," +
         csv_number(configuration.residual);
}

}  // namespace

std::string csv_header(const Scene& scene) {
  std::vector<std::string> cells = {"step", "configuration"};
  if (scene.sweep) {
    cells.emplace_back("branch");
    cells.push_back(scene.parameters[static_cast<std::size_t>(scene.sweep->parameter)].name);
  }
  const auto add = [&](bool wanted, const std::string& name,
                       const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
      if (wanted) {
        cells.push_back(name + "." + part);
      }
    }
  };
  const SceneWant& want = scene.want;
  for (const SceneLink& link : scene.links) {
    if (link.name == "ground") {
      continue;
    }
    add(want.position, link.name, {"x", "y", "theta"});
    add(want.velocity, link.name, {"vx", "vy", "omega"});
    add(want.acceleration, link.name, {"ax", "ay", "alpha"});
  }
  for (const SceneOutput& output : scene.outputs) {
    add(want.position, output.name, {"x", "y"});
    add(want.velocity, output.name, {"vx", "vy"});
    add(want.acceleration, output.name, {"ax", "ay"});
    add(want.velocity && want.acceleration, output.name, {"a_tangential", "a_normal"});
    add(want.sensitivity, output.name, {"worst_case_x", "worst_case_y", "rss_x", "rss_y"});
    add(want.sensitivity && scene.covariance, output.name,
        {"variance_x", "variance_y", "covariance_xy", "mean_shift_x", "mean_shift_y"});
  }
  add(true, "solution", {"regularity", "residual"});
  if (scene.sweep) {
    cells.emplace_back("event");
  }
  std::string line;
  for (const std::string& cell : cells) {
    line += (line.empty() ? "" : ",") + csv_cell(cell);
  }
  return line + "\n";
}

std::string csv_rows(const SolvedScene& solved) {
  std::string rows;
  const std::vector<AssemblyConfiguration>& configurations = solved.solution->configurations;
  for (std::size_t index = 0; index < configurations.size(); ++index) {
    if (solved.reports(index)) {
      rows += "0," + std::to_string(index + 1) +
              csv_cells(*solved.scene, *solved.values, configurations[index]) + "\n";
    }
  }
  return rows;
}

std::string csv_row(const Scene& scene, const SweepRecord& record) {
  const auto number = [](int value) { return value > 0 ? std::to_string(value) : std::string(); };
  const auto parameter = static_cast<std::size_t>(scene.sweep->parameter);
  return std::to_string(record.step) + "," + number(record.configuration) + "," +
         number(record.branch) + "," + csv_number(record.values->parameters()[parameter].value()) +
         csv_cells(scene, *record.values, *record.state) + "," + record.event + "\n";
}

}  // namespace assur::generator
