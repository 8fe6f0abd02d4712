#include "scene/report.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "scene/covariance.hpp"

namespace assur::generator {

namespace {

using Json = nlohmann::ordered_json;

const char* status_text(SolutionStatus status) {
  switch (status) {
    case SolutionStatus::ok:
      return "ok";
    case SolutionStatus::no_assembly:
      return "no-assembly";
    case SolutionStatus::degenerate:
      return "degenerate";
  }
  return "unknown";
}

double angle(const Direction<Dual>& direction) {
  return std::atan2(direction.sin.value(), direction.cos.value());
}

template <typename Vector>
Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (Eigen::Index index = 0; index < vector.size(); ++index) {
    list.push_back(vector(index));
  }
  return list;
}

/// Sum of |derivative| x tolerance, and root of the sum of squares.
double worst_case(const Dual& coordinate, const Eigen::VectorXd& tolerances) {
  return coordinate.derivatives().cwiseAbs().dot(tolerances);
}
double root_sum_square(const Dual& coordinate, const Eigen::VectorXd& tolerances) {
  return coordinate.derivatives().cwiseProduct(tolerances).norm();
}

Json link_json(const LinkState& link, const SceneWant& want) {
  Json entry = Json::object();
  if (want.position) {
    entry["x"] = link.x.value();
    entry["y"] = link.y.value();
    entry["theta"] = angle(link.direction);
  }
  if (want.velocity) {
    entry["velocity"] = list_of(link.velocity);
  }
  if (want.acceleration) {
    entry["acceleration"] = list_of(link.acceleration);
  }
  return entry;
}

Json joint_json(const JointState& joint, const SceneWant& want) {
  Json entry = Json::object();
  if (want.position) {
    entry["displacement"] = joint.displacement.value();
  }
  if (want.velocity) {
    entry["velocity"] = joint.velocity;
  }
  if (want.acceleration) {
    entry["acceleration"] = joint.acceleration;
  }
  return entry;
}

Json output_json(const PointState& point, const SolvedScene& solved) {
  const SceneWant& want = solved.scene->want;
  Json entry = Json::object();
  if (want.position) {
    entry["position"] = {point.x.value(), point.y.value()};
  }
  if (want.velocity) {
    entry["velocity"] = list_of(point.velocity);
  }
  if (want.acceleration) {
    entry["acceleration"] = list_of(point.acceleration);
  }
  if (want.sensitivity) {
    Json sensitivity = Json::object();
    for (std::size_t index = 0; index < solved.scene->parameters.size(); ++index) {
      const auto row = static_cast<Eigen::Index>(index);
      sensitivity[solved.scene->parameters[index].name] = {point.x.derivatives()(row),
                                                           point.y.derivatives()(row)};
    }
    const Eigen::VectorXd& tolerances = solved.values->tolerances();
    entry["sensitivity"] = sensitivity;
    entry["worst_case"] = {worst_case(point.x, tolerances), worst_case(point.y, tolerances)};
    entry["rss"] = {root_sum_square(point.x, tolerances), root_sum_square(point.y, tolerances)};
  }
  if (solved.values->second_order()) {
    const PointSpread spread = spread_of(point, solved.values->covariance());
    entry["covariance"] = {list_of(spread.covariance.row(0)), list_of(spread.covariance.row(1))};
    entry["mean_shift"] = list_of(spread.mean_shift);
  }
  return entry;
}

const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

/// One row of a table: a name, then numbers with ten significant digits.
std::string table_row(const std::string& name, const std::vector<double>& numbers) {
  std::string row = "    " + name + std::string(name.size() < 16 ? 16 - name.size() : 1, ' ');
  for (const double number : numbers) {
    std::array<char, 32> text{};
    // A zero that carries a sign would print as -0.
    (void)std::snprintf(text.data(), text.size(), " %17.10g", number == 0 ? 0.0 : number);
    row += text.data();
  }
  return row + "\n";
}

std::string table_head(const std::vector<std::string>& titles) {
  std::string row(20, ' ');
  for (const std::string& title : titles) {
    row += std::string(title.size() < 18 ? 18 - title.size() : 1, ' ') + title;
  }
  return row + "\n";
}

std::string configuration_text(const AssemblyConfiguration& configuration,
                               const SolvedScene& solved) {
  const Scene& scene = *solved.scene;
  const SceneWant& want = scene.want;
  constexpr double degree = std::numbers::pi / 180;
  std::string text;
  const auto link_table = [&](const std::string& title, const std::vector<std::string>& head,
                              auto numbers) {
    text += "  " + title + "\n" + table_head(head);
    for (std::size_t link = 0; link < scene.links.size(); ++link) {
      if (scene.links[link].name != "ground") {
        text += table_row(scene.links[link].name, numbers(configuration.links[link]));
      }
    }
  };
  if (want.position) {
    link_table("links", {"x", "y", "theta [deg]"}, [&](const LinkState& link) {
      return std::vector<double>{link.x.value(), link.y.value(), angle(link.direction) / degree};
    });
  }
  if (want.velocity) {
    link_table("velocities", {"vx", "vy", "omega"}, [](const LinkState& link) {
      return std::vector<double>{link.velocity(0), link.velocity(1), link.velocity(2)};
    });
  }
  if (want.acceleration) {
    link_table("accelerations", {"ax", "ay", "alpha"}, [](const LinkState& link) {
      return std::vector<double>{link.acceleration(0), link.acceleration(1), link.acceleration(2)};
    });
  }
  if (!configuration.joints.empty()) {
    text += "  slides\n" + table_head({"displacement", "velocity", "acceleration"});
    for (const JointState& joint : configuration.joints) {
      text +=
          table_row(joint.name, {joint.displacement.value(), joint.velocity, joint.acceleration});
    }
  }
  for (std::size_t index = 0; index < scene.outputs.size(); ++index) {
    const PointState& point = configuration.outputs[index];
    text += "  point " + scene.outputs[index].name + "\n" + table_head({"x", "y"});
    if (want.position) {
      text += table_row("position", {point.x.value(), point.y.value()});
    }
    if (want.velocity) {
      text += table_row("velocity", {point.velocity(0), point.velocity(1)});
    }
    if (want.acceleration) {
      text += table_row("acceleration", {point.acceleration(0), point.acceleration(1)});
    }
    if (want.sensitivity) {
      for (std::size_t parameter = 0; parameter < scene.parameters.size(); ++parameter) {
        const auto row = static_cast<Eigen::Index>(parameter);
        text += table_row("d/d" + scene.parameters[parameter].name,
                          {point.x.derivatives()(row), point.y.derivatives()(row)});
      }
      const Eigen::VectorXd& tolerances = solved.values->tolerances();
      text += table_row("worst case",
                        {worst_case(point.x, tolerances), worst_case(point.y, tolerances)});
      text += table_row(
          "rss", {root_sum_square(point.x, tolerances), root_sum_square(point.y, tolerances)});
    }
    if (solved.values->second_order()) {
      const PointSpread spread = spread_of(point, solved.values->covariance());
      text += table_row("covariance x", {spread.covariance(0, 0), spread.covariance(0, 1)});
      text += table_row("covariance y", {spread.covariance(1, 0), spread.covariance(1, 1)});
      text += table_row("mean shift", {spread.mean_shift(0), spread.mean_shift(1)});
    }
  }
  return text;
}

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

std::string report_json(const SolvedScene& solved) {
  const Scene& scene = *solved.scene;
  const Solution& solution = *solved.solution;
  Json root;
  root["status"] = status_text(solution.status);
  root["mobility"] = solution.mobility;
  if (!solution.reason.empty()) {
    root["reason"] = solution.reason;
  }
  root["groups"] = Json::array();
  for (std::size_t index = 0; index < solution.groups.size(); ++index) {
    const FoundGroup& group = solution.groups[index];
    root["groups"].push_back({{"class", group.model->group->assur_class()},
                              {"kind", spell(*group.model->group, group.kind)},
                              {"model", group.model->number},
                              {"links", solution.group_links[index]}});
  }
  root["configurations"] = Json::array();
  for (std::size_t number = 0; number < solution.configurations.size(); ++number) {
    if (!solved.reports(number)) {
      continue;
    }
    const AssemblyConfiguration& configuration = solution.configurations[number];
    Json entry;
    entry["links"] = Json::object();
    for (std::size_t link = 0; link < scene.links.size(); ++link) {
      entry["links"][scene.links[link].name] = link_json(configuration.links[link], scene.want);
    }
    entry["joints"] = Json::object();
    for (const JointState& joint : configuration.joints) {
      entry["joints"][joint.name] = joint_json(joint, scene.want);
    }
    entry["outputs"] = Json::object();
    for (std::size_t index = 0; index < scene.outputs.size(); ++index) {
      entry["outputs"][scene.outputs[index].name] =
          output_json(configuration.outputs[index], solved);
    }
    entry["regularity"] = regularity_text(configuration.regularity);
    entry["residual"] = configuration.residual;
    root["configurations"].push_back(std::move(entry));
  }
  return root.dump(2) + "\n";
}

std::string report_text(const SolvedScene& solved) {
  const Solution& solution = *solved.solution;
  std::string text = solved.scene->name.empty() ? solved.scene->file : solved.scene->name;
  text += std::string("\nstatus: ") + status_text(solution.status);
  if (solution.status == SolutionStatus::degenerate) {
    text += ", mobility " + std::to_string(solution.mobility) + ": " + solution.reason;
  }
  text += "\n";
  for (std::size_t index = 0; index < solution.groups.size(); ++index) {
    const FoundGroup& group = solution.groups[index];
    text += "group: " + group.model->group->name() + " " + spell(*group.model->group, group.kind) +
            ", model " + std::to_string(group.model->number) + ", links";
    for (const std::string& link : solution.group_links[index]) {
      text += " " + link;
    }
    text += "\n";
  }
  for (std::size_t index = 0; index < solution.configurations.size(); ++index) {
    if (!solved.reports(index)) {
      continue;
    }
    const AssemblyConfiguration& configuration = solution.configurations[index];
    std::array<char, 32> residual{};
    (void)std::snprintf(residual.data(), residual.size(), "%.1e", configuration.residual);
    text += "\nconfiguration " + std::to_string(index + 1) + " of " +
            std::to_string(solution.configurations.size()) + ": " +
            regularity_text(configuration.regularity) + ", residual " + residual.data() + "\n";
    text += configuration_text(configuration, solved);
  }
  return text;
}

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
