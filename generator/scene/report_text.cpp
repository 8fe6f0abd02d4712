// Turns a solution into tables for people.
#include <array>
#include <cstdio>
#include <numbers>

#include "scene/covariance.hpp"
#include "scene/report.hpp"
#include "scene/report_values.hpp"

namespace assur::generator {

namespace {

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

std::string point_text(const PointState& point, const SolvedScene& solved) {
  const Scene& scene = *solved.scene;
  const SceneWant& want = scene.want;
  std::string text = table_head({"x", "y"});
  if (want.position) {
    text += table_row("position", {point.x.value(), point.y.value()});
  }
  if (want.velocity) {
    text += table_row("velocity", {point.velocity(0), point.velocity(1)});
  }
  if (want.acceleration) {
    text += table_row("acceleration", {point.acceleration(0), point.acceleration(1)});
  }
  if (want.velocity && want.acceleration) {
    const PathAcceleration parts = path_acceleration(point);
    text += table_row("a_t, a_n", {parts.tangential, parts.normal});
  }
  if (want.sensitivity) {
    for (std::size_t parameter = 0; parameter < scene.parameters.size(); ++parameter) {
      const auto row = static_cast<Eigen::Index>(parameter);
      text += table_row("d/d" + scene.parameters[parameter].name,
                        {point.x.derivatives()(row), point.y.derivatives()(row)});
    }
    const Eigen::VectorXd& tolerances = solved.values->tolerances();
    text +=
        table_row("worst case", {worst_case(point.x, tolerances), worst_case(point.y, tolerances)});
    text += table_row("rss",
                      {root_sum_square(point.x, tolerances), root_sum_square(point.y, tolerances)});
  }
  if (solved.values->second_order()) {
    const PointSpread spread = spread_of(point, solved.values->covariance());
    text += table_row("covariance x", {spread.covariance(0, 0), spread.covariance(0, 1)});
    text += table_row("covariance y", {spread.covariance(1, 0), spread.covariance(1, 1)});
    text += table_row("mean shift", {spread.mean_shift(0), spread.mean_shift(1)});
  }
  return text;
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
    text += "  point " + scene.outputs[index].name + "\n" +
            point_text(configuration.outputs[index], solved);
  }
  return text;
}

}  // namespace

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

}  // namespace assur::generator
