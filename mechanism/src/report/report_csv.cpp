// Reports of solutions and sweeps as lines of CSV.
#include <array>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/point_values.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "report_words.hpp"

namespace assur::mechanism::report {

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

/// Adds a cell of 17 significant digits, preceded by a comma; an empty one for a number that is not
/// finite.
void add_number(double number, std::string& row) {
  if (!std::isfinite(number)) {
    row += ',';
    return;
  }
  std::array<char, 32> text = {','};
  const auto [end, error] = std::to_chars(text.data() + 1, text.data() + text.size(), number + 0.0,
                                          std::chars_format::general, 17);
  (void)error;  // 17 digits, a sign, a point and an exponent take 24 characters
  row.append(text.data(), static_cast<std::size_t>(end - text.data()));
}

template <typename Vector>
void add_numbers(bool wanted, const Vector& numbers, std::string& row) {
  for (Eigen::Index index = 0; wanted && index < numbers.size(); ++index) {
    add_number(numbers(index), row);
  }
}

/// The angles of the reported links, in (-pi, pi].
std::vector<double> angles_of_links(const Plan& plan, const Configuration& configuration) {
  std::vector<double> angles;
  for (const LinkIndex link : reported_links(plan, false)) {
    angles.push_back(angle_of(configuration.links[link].pose.direction));
  }
  return angles;
}

/// Adds the cells of a configuration, each preceded by a comma. `angles` are those of the reported
/// links, and `forces` the numbers of the force columns.
void add_cells(const Plan& plan, const Spread& spread, const Configuration& configuration,
               const std::vector<double>& angles, const std::vector<double>& forces,
               std::string& row) {
  if (!configuration.derivatives_known) {
    add_cells(plan, spread, without_derivatives(plan, configuration), angles, forces, row);
    return;
  }
  const Want& want = plan.request().want;
  auto angle = angles.begin();
  for (const LinkIndex link : reported_links(plan, false)) {
    const Frame& frame = configuration.links[link];
    if (want.position) {
      add_number(frame.pose.x, row);
      add_number(frame.pose.y, row);
      add_number(*angle, row);
    }
    ++angle;
    add_numbers(want.velocity, frame.velocity, row);
    add_numbers(want.acceleration, frame.acceleration, row);
  }
  for (const Point& point : configuration.outputs) {
    add_numbers(want.position, point.position, row);
    add_numbers(want.velocity, point.velocity, row);
    add_numbers(want.acceleration, point.acceleration, row);
    if (want.velocity && want.acceleration) {
      const PathAcceleration parts = path_acceleration(point);
      add_number(parts.tangential, row);
      add_number(parts.normal, row);
    }
    if (want.sensitivity) {
      add_numbers(true, worst_case(point, spread), row);
      add_numbers(true, root_sum_square(point, spread), row);
    }
    if (want.sensitivity && plan.request().covariance) {
      const PointSpread about = spread_of(point, spread);
      for (const double number :
           {about.covariance(0, 0), about.covariance(1, 1), about.covariance(0, 1),
            about.mean_shift(0), about.mean_shift(1)}) {
        add_number(number, row);
      }
    }
  }
  for (const double number : forces) {
    add_number(number, row);
  }
  row += ',';
  row += regularity_text(configuration.regularity);
  add_number(configuration.residual, row);
}

/// The numbers of a configuration's forces, and their deviations due to tolerances; unknown rates
/// make the forces unknown that depend on inertia.
std::vector<double> told_forces(const Plan& plan, const Values& values,
                                const Configuration& configuration) {
  if (!plan.request().want.forces) {
    return {};
  }
  std::vector<double> numbers = force_numbers(plan, forces_of(values, configuration));
  const std::vector<double> deviations = force_deviations(plan, values, configuration);
  numbers.insert(numbers.end(), deviations.begin(), deviations.end());
  return numbers;
}

/// The same for a row of a sweep. An event lies between two steps; its forces are not reported.
std::vector<double> told_forces(const Plan& plan, const SweepRecord& record) {
  if (record.event.empty() && plan.request().want.forces) {
    const Mechanism& mechanism = plan.mechanism();
    const ParameterIndex swept = plan.request().sweep->parameter;
    return told_forces(plan, plan.values({{mechanism.parameters()[swept].name, record.parameter}}),
                       *record.state);
  }
  const std::size_t parts = wants_force_sensitivities(plan) ? 3 : 1;
  return std::vector<double>(parts * force_columns(plan).size(),
                             std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

}  // namespace assur::mechanism::report

namespace assur::mechanism {

std::string csv_header(const Plan& plan) {
  const Mechanism& mechanism = plan.mechanism();
  const Request& request = plan.request();
  std::vector<std::string> cells = {"step", "configuration"};
  if (request.sweep) {
    cells.emplace_back("branch");
    cells.push_back(mechanism.parameters()[request.sweep->parameter].name);
  }
  const auto add = [&](bool wanted, const std::string& name,
                       const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
      if (wanted) {
        cells.push_back(name + "." + part);
      }
    }
  };
  const Want& want = request.want;
  for (const LinkIndex link : reported_links(plan, false)) {
    const std::string& name = mechanism.links()[link].name;
    add(want.position, name, {"x", "y", "theta"});
    add(want.velocity, name, {"vx", "vy", "omega"});
    add(want.acceleration, name, {"ax", "ay", "alpha"});
  }
  for (const Output& output : mechanism.outputs()) {
    add(want.position, output.name, {"x", "y"});
    add(want.velocity, output.name, {"vx", "vy"});
    add(want.acceleration, output.name, {"ax", "ay"});
    add(want.velocity && want.acceleration, output.name, {"a_tangential", "a_normal"});
    add(want.sensitivity, output.name, {"worst_case_x", "worst_case_y", "rss_x", "rss_y"});
    add(want.sensitivity && request.covariance, output.name,
        {"variance_x", "variance_y", "covariance_xy", "mean_shift_x", "mean_shift_y"});
  }
  const std::vector<ForceColumn> forces = force_columns(plan);
  for (const ForceColumn& column : forces) {
    cells.push_back(column.name());
  }
  for (const char* deviation : {"worst_case_", "rss_"}) {
    for (const ForceColumn& column : forces) {
      add(wants_force_sensitivities(plan), column.of, {deviation + column.part});
    }
  }
  add(true, "solution", {"regularity", "residual"});
  if (request.sweep) {
    cells.insert(cells.end(), {"circuit", "event"});
  }
  std::string line;
  for (const std::string& cell : cells) {
    line += (line.empty() ? "" : ",") + report::csv_cell(cell);
  }
  return line + "\n";
}

std::string csv_rows(const Report& report) {
  std::string rows;
  const std::vector<Configuration>& configurations = report.solution.configurations;
  for (std::size_t index = 0; index < configurations.size(); ++index) {
    if (report::is_reported(report, index)) {
      const bool is_unnumbered = report.alone && report.nearest;
      rows += "0,";
      rows += is_unnumbered  ? ""
              : report.alone ? std::to_string(report.branch)
                             : std::to_string(index + 1);
      const Configuration& configuration = configurations[index];
      report::add_cells(report.plan, report.values.spread(), configuration,
                        report::angles_of_links(report.plan, configuration),
                        report::told_forces(report.plan, report.values, configuration), rows);
      rows += "\n";
    }
  }
  return rows;
}

void SweepRows::add(const SweepRecord& record, std::string& text) {
  const auto number = [](int value) { return value > 0 ? std::to_string(value) : std::string(); };
  std::vector<double> angles = report::angles_of_links(plan_, *record.state);
  if (angles_ == Angles::unwrapped && record.branch > 0) {
    unwrap(record.branch, angles);
  }
  text += std::to_string(record.step) + "," + number(record.configuration) + "," +
          number(record.branch);
  report::add_number(record.parameter, text);
  report::add_cells(plan_, *record.spread, *record.state, angles,
                    report::told_forces(plan_, record), text);
  text += ",," + record.event + "\n";
}

void SweepRows::set_circuit(const Circuits& circuits, std::string& row) {
  const std::size_t branch_cell = row.find(',', row.find(',') + 1) + 1;
  int branch = 0;  // stays so where the cell is empty
  (void)std::from_chars(row.data() + branch_cell, row.data() + row.size(), branch);
  if (const int circuit = circuits.of(branch); circuit > 0) {
    row.insert(row.rfind(','), std::to_string(circuit));
  }
}

void SweepRows::unwrap(int branch, std::vector<double>& angles) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto [last, is_first] = last_angles_.try_emplace(branch, angles);
  for (std::size_t link = 0; !is_first && link < angles.size(); ++link) {
    angles[link] -= turn * std::round((angles[link] - last->second[link]) / turn);
  }
  last->second = angles;
}

}  // namespace assur::mechanism
