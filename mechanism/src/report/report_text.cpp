// Report of a solution as tables for people.
#include <algorithm>
#include <array>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/point_values.hpp>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "drawn_configuration.hpp"
#include "report_words.hpp"

namespace assur::mechanism::report {

namespace {

/// Numbers below this part of the largest one of their kind are printed as zero.
constexpr double rounding = 1e-14;

/// One row of a table: a name, on a line of its own if it is longer than its column, then numbers
/// with ten significant digits.
std::string table_row(const std::string& name, const std::vector<double>& numbers) {
  // Continuation bytes of UTF-8 take no column.
  const auto letters = static_cast<std::size_t>(
      std::count_if(name.begin(), name.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
  std::string row = "    " + name;
  row += letters <= 16 ? std::string(16 - letters, ' ') : "\n" + std::string(20, ' ');
  for (const double number : numbers) {
    std::array<char, 32> text{};
    if (!std::isfinite(number)) {
      row += std::string(17, ' ') + '-';
      continue;
    }
    // Negative zero would print as -0.
    (void)std::snprintf(text.data(), text.size(), " %17.10g", number == 0 ? 0.0 : number);
    row += text.data();
  }
  return row + "\n";
}

/// The largest length and angle of a table, of positions or of rates: numbers within their rounding
/// are printed as zero.
struct Size {
  double length = 0;
  double angle = 0;

  void cover(const Eigen::Vector3d& triple) {
    cover(Eigen::Vector2d(triple.head<2>()));
    angle = larger(angle, triple.z());
  }
  void cover(const Eigen::Vector2d& pair) { length = larger(larger(length, pair.x()), pair.y()); }
  [[nodiscard]] std::string row(const std::string& name, const Eigen::Vector2d& pair) const {
    return table_row(name, {shown(pair.x(), length), shown(pair.y(), length)});
  }
  [[nodiscard]] std::string row(const std::string& name, const Eigen::Vector3d& triple) const {
    return table_row(
        name, {shown(triple.x(), length), shown(triple.y(), length), shown(triple.z(), angle)});
  }

 private:
  static double larger(double most, double number) {
    return std::isfinite(number) ? std::max(most, std::abs(number)) : most;
  }
  static double shown(double number, double largest) {
    return std::abs(number) <= rounding * largest ? 0 : number;
  }
};

Eigen::Vector3d in_degrees(const Pose<double>& pose) {
  return {pose.x, pose.y, angle_of(pose.direction) * 180 / std::numbers::pi};
}

/// The sizes of all links and outputs of a configuration, reported or not.
struct Sizes {
  Sizes(const Configuration& configuration, const Spread& spread)
      : derivatives(static_cast<std::size_t>(spread.tolerances.size())) {
    for (const LinkIndex link : configuration.links.keys()) {
      const Frame& frame = configuration.links[link];
      positions.cover(in_degrees(frame.pose));
      velocities.cover(frame.velocity);
      accelerations.cover(frame.acceleration);
      // An angular acceleration that cancels has the rounding of squared angular velocities.
      accelerations.cover(Eigen::Vector3d(0, 0, frame.velocity.z() * frame.velocity.z()));
    }
    for (const OutputIndex output : configuration.outputs.keys()) {
      positions.cover(configuration.outputs[output].position);
      velocities.cover(configuration.outputs[output].velocity);
      accelerations.cover(configuration.outputs[output].acceleration);
    }
    for (std::size_t parameter = 0; parameter < derivatives.size(); ++parameter) {
      const auto column = static_cast<Eigen::Index>(parameter);
      const auto cover = [&](const auto& first) {
        if (column < first.cols()) {
          derivatives[parameter].cover(Eigen::Vector2d(first.col(column).template head<2>()));
        }
      };
      for (const LinkIndex link : configuration.links.keys()) {
        cover(configuration.links[link].follows.first);
      }
      for (const OutputIndex output : configuration.outputs.keys()) {
        cover(configuration.outputs[output].follows.first);
      }
      tolerances.length += derivatives[parameter].length * spread.tolerances(column);
    }
  }
  Size positions{0, 180};
  Size velocities;
  Size accelerations;
  std::vector<Size> derivatives;  ///< with respect to each parameter
  Size tolerances;                ///< of the deviations due to tolerances
};

std::string table_head(const std::vector<std::string>& titles) {
  std::string row(20, ' ');
  for (const std::string& title : titles) {
    row += std::string(title.size() < 18 ? 18 - title.size() : 1, ' ') + title;
  }
  return row + "\n";
}

std::string point_text(const Point& point, const Sizes& sizes, const Report& report,
                       const Want& want) {
  std::string text = table_head({"x", "y"});
  if (want.position) {
    text += sizes.positions.row("position", point.position);
  }
  if (want.velocity) {
    text += sizes.velocities.row("velocity", point.velocity);
  }
  if (want.acceleration) {
    text += sizes.accelerations.row("acceleration", point.acceleration);
  }
  if (want.velocity && want.acceleration) {
    const PathAcceleration parts = path_acceleration(point);
    text += sizes.accelerations.row("a_t, a_n", Eigen::Vector2d(parts.tangential, parts.normal));
  }
  if (want.sensitivity) {
    const auto& parameters = report.plan.mechanism().parameters();
    for (const ParameterIndex parameter : parameters.keys()) {
      text += sizes.derivatives[parameter.place()].row(
          "d/d" + parameters[parameter].name,
          Eigen::Vector2d(point.follows.first.col(parameter.row())));
    }
    if (!report.values.spread().tolerances.isZero(0)) {
      text += sizes.tolerances.row("worst case", worst_case(point, report.values.spread()));
      text += sizes.tolerances.row("rss", root_sum_square(point, report.values.spread()));
    }
  }
  if (want.sensitivity && report.values.second_order()) {
    const PointSpread spread = spread_of(point, report.values.spread());
    text += table_row("covariance x", {spread.covariance(0, 0), spread.covariance(0, 1)});
    text += table_row("covariance y", {spread.covariance(1, 0), spread.covariance(1, 1)});
    text += table_row("mean shift", {spread.mean_shift.x(), spread.mean_shift.y()});
  }
  return text;
}

/// The tables of a configuration's requested results.
std::string tables_text(const Configuration& configuration, const Report& report,
                        const Want& want) {
  const Mechanism& mechanism = report.plan.mechanism();
  const Sizes sizes(configuration, report.values.spread());
  std::string text;
  const std::vector<LinkIndex> links = reported_links(report.plan, false);
  const auto link_table = [&](const std::string& title, const std::vector<std::string>& head,
                              const Size& size, const auto& numbers) {
    if (links.empty()) {
      return;
    }
    text += "  " + title + "\n" + table_head(head);
    for (const LinkIndex link : links) {
      text += size.row(mechanism.links()[link].name, numbers(configuration.links[link]));
    }
  };
  if (want.position) {
    link_table("links", {"x", "y", "theta [deg]"}, sizes.positions,
               [](const Frame& link) { return in_degrees(link.pose); });
  }
  if (want.velocity) {
    link_table("velocities", {"vx", "vy", "omega [rad/t]"}, sizes.velocities,
               [](const Frame& link) { return link.velocity; });
  }
  if (want.acceleration) {
    link_table("accelerations", {"ax", "ay", "alpha [rad/t^2]"}, sizes.accelerations,
               [](const Frame& link) { return link.acceleration; });
  }
  const std::vector<const SlideState*> slides = reported_slides(report.plan, configuration);
  if (!slides.empty()) {
    text += "  slides\n" + table_head({"displacement", "velocity", "acceleration"});
    for (const SlideState* slide : slides) {
      text += table_row(mechanism.joints()[slide->joint].name,
                        {slide->displacement, slide->velocity, slide->acceleration});
    }
  }
  for (const OutputIndex output : mechanism.outputs().keys()) {
    text += "  point " + mechanism.outputs()[output].name + "\n" +
            point_text(configuration.outputs[output], sizes, report, want);
  }
  return text;
}

/// The numbers of forces; those within the rounding of the largest one of their kind are zero. A
/// couple is as uncertain as the largest force at the largest distance.
std::vector<double> shown_forces(const std::vector<ForceColumn>& columns,
                                 std::vector<double> numbers, double distance) {
  double force = 0;
  double couple = 0;
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    if (std::isfinite(numbers[row])) {
      double& largest = columns[row].is_couple ? couple : force;
      largest = std::max(largest, std::abs(numbers[row]));
    }
  }
  couple = std::max(couple, force * distance);
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    const double largest = columns[row].is_couple ? couple : force;
    numbers[row] = std::abs(numbers[row]) <= rounding * largest ? 0 : numbers[row];
  }
  return numbers;
}

/// The table of requested forces, one number a row, under the names of the columns of CSV; with
/// sensitivities, a table of deviations, and one for each parameter.
std::string forces_text(const Configuration& configuration, const Report& report) {
  const Plan& plan = report.plan;
  const std::vector<ForceColumn> columns = force_columns(plan);
  if (columns.empty()) {
    return "";
  }
  const double distance = Sizes(configuration, report.values.spread()).positions.length;
  std::string text;
  const auto add_table = [&](const std::string& title, const std::vector<std::string>& head,
                             const std::vector<Forces>& all) {
    text += "  " + title + "\n" + (head.empty() ? "" : table_head(head));
    std::vector<std::vector<double>> numbers;
    for (const Forces& forces : all) {
      numbers.push_back(shown_forces(columns, force_numbers(plan, forces), distance));
    }
    for (std::size_t row = 0; row < columns.size(); ++row) {
      std::vector<double> cells;
      for (const std::vector<double>& one : numbers) {
        cells.push_back(one[row]);
      }
      text += table_row(columns[row].name(), cells);
    }
  };
  const Forces forces = forces_of(report.values, configuration);
  add_table("forces", {}, {forces});
  text += forces.reason.empty() ? "" : "    not determined: " + forces.reason + "\n";
  if (wants_force_sensitivities(plan)) {
    const std::vector<Forces> sensitivities = force_sensitivities(report.values, configuration);
    const Spread& spread = report.values.spread();
    for (const ParameterIndex parameter : plan.mechanism().parameters().keys()) {
      add_table("forces, d/d" + plan.mechanism().parameters()[parameter].name, {},
                {sensitivities[parameter.place()]});
    }
    if (!spread.tolerances.isZero(0)) {
      add_table("forces, by tolerances", {"worst case", "rss"},
                {worst_case(sensitivities, spread), root_sum_square(sensitivities, spread)});
    }
  }
  return text;
}

std::string configuration_text(const Configuration& configuration, const Report& report) {
  if (!configuration.derivatives_known) {
    return configuration_text(without_derivatives(report.plan, configuration), report);
  }
  const Want& want = report.plan.request().want;
  std::string text = tables_text(configuration, report, want) + forces_text(configuration, report);
  for (std::size_t index = 0; index < configuration.branches.size(); ++index) {
    text += "  branch " + std::to_string(index + 1) + " of " +
            std::to_string(configuration.branches.size()) + " through this configuration\n" +
            tables_text(configuration.branches[index], report, rates_alone(want));
  }
  return text;
}

/// An angle in radians, as degrees; zero within rounding.
std::string degrees_text(double angle) {
  std::array<char, 32> digits{};
  const double shown = angle <= rounding ? 0 : angle * 180 / std::numbers::pi;
  (void)std::snprintf(digits.data(), digits.size(), "%.4g deg", shown);
  return digits.data();
}

/// The branch and the circuit of a configuration, if they were requested.
std::string place_text(const Report& report, std::size_t configuration) {
  const std::optional<PlaceInSweep> place = place_in_sweep(report, configuration);
  if (!place) {
    return "";
  }
  return place->branch == 0 ? ", on no known branch"
                            : ", branch " + std::to_string(place->branch) + ", circuit " +
                                  std::to_string(place->circuit);
}

/// The number of the nearest configuration, if it is known.
std::string which_text(const Nearest& nearest, bool is_numbered) {
  return is_numbered ? "configuration " + std::to_string(nearest.configuration + 1) + ", " : "one ";
}

/// The number of the drawn configuration, and the pin that is drawn beside its slot.
std::string drawn_text(const Report& report) {
  std::string text;
  if (const std::optional<DrawnConfiguration> drawn = drawn_configuration(report)) {
    const Nearest& nearest = drawn->nearest;
    text += "drawn: " + which_text(nearest, drawn->is_numbered) + degrees_text(nearest.distance) +
            " away" +
            (nearest.runner_up ? " (the next one " + degrees_text(*nearest.runner_up) + ")" : "") +
            "\n";
  }
  const std::optional<DrawnPose>& pose = report.plan.request().drawn;
  if (pose && pose->gap) {
    text += "gap: the joint " + pose->gap->joint + " is drawn " +
            text::short_number(pose->gap->length, 4) + " beside its slot\n";
  }
  return text;
}

/// A line for each group, on the enclosure of its configuration.
std::string proofs_text(const Table<GroupIndex, GroupProof>& proofs) {
  std::string text;
  for (const GroupIndex group : proofs.keys()) {
    const GroupProof& proof = proofs[group];
    std::array<char, 32> radius{};
    (void)std::snprintf(radius.data(), radius.size(), "%.1e", proof.radius);
    text += "  group " + std::to_string(group.place() + 1) + ": " + std::to_string(proof.boxes) +
            " of " + std::to_string(proof.of) + " complex configurations enclosed, " +
            (proof.obstacle.empty() ? std::string("this one within ") + radius.data()
                                    : proof.obstacle) +
            "\n";
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
    text += "group: " + group.model->group->name + " " + group.kind +
            (group.model->is_derived() ? ", " + std::to_string(group.model->max_configurations) +
                                             " complex configurations"
                                       : ", model " + std::to_string(group.model->number)) +
            ", links";
    for (const std::string& link : structure.names_of(group.links)) {
      text += " " + link;
    }
    text += group.base.exists() ? ", relative to " + structure.linkage.links[group.base] : "";
    text += "\n";
  }
  for (const RedundantJoint& joint : report.plan.redundant()) {
    text += "redundant: constraints of the joint " + joint.name +
            " are left out; configurations in which they do not hold are excluded\n";
  }
  if (const std::string incomplete = report::incomplete_text(report); !incomplete.empty()) {
    text += "incomplete: " + incomplete + "\n";
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
    text += "nearest to the reference: " + report::which_text(*report.nearest, !report.alone) +
            report::degrees_text(report.nearest->distance) + " away" +
            (report.nearest->runner_up
                 ? "; the next one is " + report::degrees_text(*report.nearest->runner_up) + " away"
                 : "") +
            "\n";
  }
  text += report::drawn_text(report);
  for (const std::string& part : report.values.corners()) {
    text += "corner: " + part + " has a corner here, so that derivatives are those of one side\n";
  }
  for (std::size_t index = 0; index < solution.configurations.size(); ++index) {
    if (!report::is_reported(report, index)) {
      continue;
    }
    const Configuration& configuration = solution.configurations[index];
    std::array<char, 32> residual{};
    (void)std::snprintf(residual.data(), residual.size(), "%.1e", configuration.residual);
    text +=
        "\nconfiguration " +
        (!report.alone
             ? std::to_string(index + 1) + " of " + std::to_string(solution.configurations.size())
         : report.nearest ? "nearest to the reference"
                          : std::to_string(report.branch)) +
        ": " + report::regularity_text(configuration.regularity) + ", residual " + residual.data() +
        report::place_text(report, index) + "\n" + report::proofs_text(configuration.proofs);
    text += report::configuration_text(configuration, report);
  }
  if (const auto nearest = report::nearest_to_limits(report)) {
    text +=
        "\nnearest to the limits: " + excesses_text(report.plan.mechanism(), nearest->excesses) +
        "\n" + report::configuration_text(nearest->configuration, report);
  }
  return text;
}

}  // namespace assur::mechanism
