// Turns a solution into tables for people.
#include <array>
#include <assur/mechanism/point_values.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "report_words.hpp"

namespace assur::mechanism::report {

namespace {

/// One row of a table: a name, then numbers with ten significant digits.
std::string table_row(const std::string& name, const std::vector<double>& numbers) {
  std::string row = "    " + name + std::string(name.size() < 16 ? 16 - name.size() : 1, ' ');
  for (const double number : numbers) {
    std::array<char, 32> text{};
    if (!std::isfinite(number)) {
      row += std::string(17, ' ') + '-';
      continue;
    }
    // A zero that carries a sign would print as -0.
    (void)std::snprintf(text.data(), text.size(), " %17.10g", number == 0 ? 0.0 : number);
    row += text.data();
  }
  return row + "\n";
}
std::string table_row(const std::string& name, const Eigen::Vector2d& pair) {
  return table_row(name, std::vector<double>{pair.x(), pair.y()});
}
std::string table_row(const std::string& name, const Eigen::Vector3d& triple) {
  return table_row(name, std::vector<double>{triple.x(), triple.y(), triple.z()});
}

std::string table_head(const std::vector<std::string>& titles) {
  std::string row(20, ' ');
  for (const std::string& title : titles) {
    row += std::string(title.size() < 18 ? 18 - title.size() : 1, ' ') + title;
  }
  return row + "\n";
}

std::string point_text(const Point& point, const Report& report, const Want& want) {
  std::string text = table_head({"x", "y"});
  if (want.position) {
    text += table_row("position", point.position);
  }
  if (want.velocity) {
    text += table_row("velocity", point.velocity);
  }
  if (want.acceleration) {
    text += table_row("acceleration", point.acceleration);
  }
  if (want.velocity && want.acceleration) {
    const PathAcceleration parts = path_acceleration(point);
    text += table_row("a_t, a_n", std::vector<double>{parts.tangential, parts.normal});
  }
  if (want.sensitivity) {
    const auto& parameters = report.plan.mechanism().parameters();
    for (const ParameterIndex parameter : parameters.keys()) {
      text += table_row("d/d" + parameters[parameter].name,
                        Eigen::Vector2d(point.follows.first.col(parameter.row())));
    }
    text += table_row("worst case", worst_case(point, report.values.spread()));
    text += table_row("rss", root_sum_square(point, report.values.spread()));
  }
  if (want.sensitivity && report.values.second_order()) {
    const PointSpread spread = spread_of(point, report.values.spread());
    text += table_row("covariance x", Eigen::Vector2d(spread.covariance.row(0)));
    text += table_row("covariance y", Eigen::Vector2d(spread.covariance.row(1)));
    text += table_row("mean shift", spread.mean_shift);
  }
  return text;
}

/// Tables of what a configuration is asked for.
std::string tables_text(const Configuration& configuration, const Report& report,
                        const Want& want) {
  const Mechanism& mechanism = report.plan.mechanism();
  constexpr double degree = std::numbers::pi / 180;
  std::string text;
  const std::vector<LinkIndex> links = reported_links(report.plan, false);
  const auto link_table = [&](const std::string& title, const std::vector<std::string>& head,
                              const auto& numbers) {
    if (links.empty()) {
      return;
    }
    text += "  " + title + "\n" + table_head(head);
    for (const LinkIndex link : links) {
      text += table_row(mechanism.links()[link].name, numbers(configuration.links[link]));
    }
  };
  if (want.position) {
    link_table("links", {"x", "y", "theta [deg]"}, [](const Frame& link) {
      return Eigen::Vector3d(link.pose.x, link.pose.y, angle_of(link.pose.direction) / degree);
    });
  }
  if (want.velocity) {
    link_table("velocities", {"vx", "vy", "omega"},
               [](const Frame& link) { return link.velocity; });
  }
  if (want.acceleration) {
    link_table("accelerations", {"ax", "ay", "alpha"},
               [](const Frame& link) { return link.acceleration; });
  }
  const std::vector<const SlideState*> slides = reported_slides(report.plan, configuration);
  if (!slides.empty()) {
    text += "  slides\n" + table_head({"displacement", "velocity", "acceleration"});
    for (const SlideState* slide : slides) {
      text += table_row(mechanism.joints()[slide->joint].name,
                        Eigen::Vector3d(slide->displacement, slide->velocity, slide->acceleration));
    }
  }
  for (const OutputIndex output : mechanism.outputs().keys()) {
    text += "  point " + mechanism.outputs()[output].name + "\n" +
            point_text(configuration.outputs[output], report, want);
  }
  return text;
}

std::string configuration_text(const Configuration& configuration, const Report& report) {
  if (!configuration.derivatives_known || !configuration.rates_known) {
    return configuration_text(without_unknown(report.plan, configuration), report);
  }
  const Want& want = report.plan.request().want;
  std::string text = tables_text(configuration, report, want);
  for (std::size_t index = 0; index < configuration.branches.size(); ++index) {
    text += "  branch " + std::to_string(index + 1) + " of " +
            std::to_string(configuration.branches.size()) + " through this configuration\n" +
            tables_text(configuration.branches[index], report, rates_alone(want));
  }
  return text;
}

}  // namespace

}  // namespace assur::mechanism::report

namespace assur::mechanism {

std::string report_text(const Report& report) {
  const Solution& solution = report.solution;
  const std::string& name = report.plan.mechanism().name();
  std::string text = name.empty() ? report.title : name;
  text += std::string("\nstatus: ") + report::status_text(solution.status);
  if (solution.status == SolutionStatus::degenerate) {
    text += ", mobility " + std::to_string(solution.mobility);
  }
  const std::string reason = report::reason_text(report);
  text += (reason.empty() ? "" : ": " + reason) + "\n";
  const Structure& structure = report.plan.structure();
  for (const FoundGroup& group : structure.groups) {
    text += "group: " + group.model->group->name + " " + group.kind + ", model " +
            std::to_string(group.model->number) + ", links";
    for (const std::string& link : structure.names_of(group.links)) {
      text += " " + link;
    }
    text += group.base.exists() ? ", relative to " + structure.linkage.links[group.base] : "";
    text += "\n";
  }
  for (const std::string& joint : report.plan.redundant()) {
    text += "redundant: the joint " + joint + " holds wherever the other joints do\n";
  }
  for (const Family& family : solution.families) {
    text += "family of group " + std::to_string(family.group.place() + 1) + ", mobility " +
            std::to_string(family.mobility) + ": " + family.reason + "\n";
  }
  if (!solution.left_out) {
    text += "left out, and not counted: configurations beyond the limits of joints\n";
  } else if (*solution.left_out > 0) {
    text += "left out: " + std::to_string(*solution.left_out) +
            (*solution.left_out == 1 ? " configuration" : " configurations") +
            " beyond the limits of joints\n";
  }
  if (solution.dropped > 0) {
    text += "dropped: " + std::to_string(solution.dropped) +
            (solution.dropped == 1 ? " choice" : " choices") +
            " of configurations of earlier groups: " + solution.drop_reason + "\n";
  }
  if (report.nearest) {
    const auto degrees = [](double angle) {
      std::array<char, 32> digits{};
      (void)std::snprintf(digits.data(), digits.size(), "%.4g deg", angle * 180 / std::numbers::pi);
      return std::string(digits.data());
    };
    text += "nearest to the reference: " +
            (report.alone
                 ? "one "
                 : "configuration " + std::to_string(report.nearest->configuration + 1) + ", ") +
            degrees(report.nearest->distance) + " away" +
            (report.nearest->runner_up
                 ? "; the next one is " + degrees(*report.nearest->runner_up) + " away"
                 : "") +
            "\n";
  }
  for (std::size_t index = 0; index < solution.configurations.size(); ++index) {
    if (!report::is_reported(report, index)) {
      continue;
    }
    const Configuration& configuration = solution.configurations[index];
    std::array<char, 32> residual{};
    (void)std::snprintf(residual.data(), residual.size(), "%.1e", configuration.residual);
    text += "\nconfiguration " +
            (!report.alone ? std::to_string(index + 1) + " of " +
                                 std::to_string(solution.configurations.size())
             : report.nearest ? "nearest to the reference"
                              : std::to_string(report.branch)) +
            ": " + report::regularity_text(configuration.regularity) + ", residual " +
            residual.data() + "\n";
    text += report::configuration_text(configuration, report);
  }
  return text;
}

}  // namespace assur::mechanism
