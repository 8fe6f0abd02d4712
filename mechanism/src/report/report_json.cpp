// Report of a solution as the JSON object of the scene format.
#include <algorithm>
#include <assur/mechanism/point_values.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "drawn_configuration.hpp"
#include "forces_json.hpp"
#include "report_words.hpp"

namespace assur::mechanism::report {

namespace {

using Json = nlohmann::ordered_json;

// The library writes null for NaN and infinity.
template <typename Vector>
Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (Eigen::Index index = 0; index < vector.size(); ++index) {
    list.push_back(vector(index));
  }
  return list;
}

Json link_json(const Frame& link, const Want& want) {
  Json entry = Json::object();
  if (want.position) {
    entry["x"] = link.pose.x;
    entry["y"] = link.pose.y;
    entry["theta"] = angle_of(link.pose.direction);
  }
  if (want.velocity) {
    entry["velocity"] = list_of(link.velocity);
  }
  if (want.acceleration) {
    entry["acceleration"] = list_of(link.acceleration);
  }
  return entry;
}

Json slide_json(const SlideState& slide, const Want& want) {
  Json entry = Json::object();
  if (want.position) {
    entry["displacement"] = slide.displacement;
  }
  if (want.velocity) {
    entry["velocity"] = slide.velocity;
  }
  if (want.acceleration) {
    entry["acceleration"] = slide.acceleration;
  }
  return entry;
}

Json output_json(const Point& point, const Report& report, const Want& want) {
  Json entry = Json::object();
  if (want.position) {
    entry["position"] = list_of(point.position);
  }
  if (want.velocity) {
    entry["velocity"] = list_of(point.velocity);
  }
  if (want.acceleration) {
    entry["acceleration"] = list_of(point.acceleration);
  }
  if (want.velocity && want.acceleration) {
    const PathAcceleration parts = path_acceleration(point);
    entry["tangential"] = parts.tangential;
    entry["normal"] = parts.normal;
  }
  if (want.sensitivity) {
    Json sensitivity = Json::object();
    for (const ParameterIndex parameter : report.plan.mechanism().parameters().keys()) {
      sensitivity[report.plan.mechanism().parameters()[parameter].name] =
          list_of(point.follows.first.col(parameter.row()));
    }
    entry["sensitivity"] = sensitivity;
    entry["worst_case"] = list_of(worst_case(point, report.values.spread()));
    entry["rss"] = list_of(root_sum_square(point, report.values.spread()));
  }
  if (want.sensitivity && report.values.second_order()) {
    const PointSpread spread = spread_of(point, report.values.spread());
    entry["covariance"] = {list_of(spread.covariance.row(0)), list_of(spread.covariance.row(1))};
    entry["mean_shift"] = list_of(spread.mean_shift);
  }
  return entry;
}

/// The names of a group's joints, each once.
Json joints_of(const Structure& structure, const FoundGroup& group) {
  std::set<std::string> names;
  for (const ElementaryJointIndex joint : group.assignments.front().joints) {
    names.insert(structure.linkage.joints[joint].name);
  }
  return names;
}

Json groups_json(const Structure& structure) {
  Json list = Json::array();
  for (const FoundGroup& group : structure.groups) {
    list.push_back({{"class", group.model->group->assur_class}, {"kind", group.kind}});
    if (!group.model->is_derived()) {
      list.back()["model"] = group.model->number;
    }
    list.back()["links"] = structure.names_of(group.links);
    list.back()["joints"] = joints_of(structure, group);
    if (group.model->rigid) {
      list.back()["complex_configurations"] = group.model->max_configurations;
    }
    if (group.base.exists()) {
      list.back()["relative_to"] = structure.linkage.links[group.base];
    }
  }
  return list;
}

/// The requested results of a configuration's links, joints and outputs.
Json parts_json(const Configuration& configuration, const Report& report, const Want& want) {
  const Mechanism& mechanism = report.plan.mechanism();
  Json entry;
  entry["links"] = Json::object();
  for (const LinkIndex link : reported_links(report.plan, true)) {
    entry["links"][mechanism.links()[link].name] = link_json(configuration.links[link], want);
  }
  entry["joints"] = Json::object();
  for (const SlideState* slide : reported_slides(report.plan, configuration)) {
    entry["joints"][mechanism.joints()[slide->joint].name] = slide_json(*slide, want);
  }
  entry["outputs"] = Json::object();
  for (const OutputIndex output : mechanism.outputs().keys()) {
    entry["outputs"][mechanism.outputs()[output].name] =
        output_json(configuration.outputs[output], report, want);
  }
  return entry;
}

Json configuration_json(const Configuration& configuration, const Report& report) {
  if (!configuration.derivatives_known) {
    return configuration_json(without_derivatives(report.plan, configuration), report);
  }
  const Want& want = report.plan.request().want;
  Json entry = parts_json(configuration, report, want);
  add_forces(report, configuration, entry);
  if (!configuration.branches.empty()) {
    entry["branches"] = Json::array();
  }
  for (const Configuration& branch : configuration.branches) {
    entry["branches"].push_back(parts_json(branch, report, rates_alone(want)));
  }
  for (const GroupProof& proof : configuration.proofs) {
    Json& group = entry["groups"].emplace_back();
    group["proof"] = {{"boxes", proof.boxes},
                      {"of", proof.of > 0 ? Json(proof.of) : Json()},
                      {"radius", proof.obstacle.empty() ? Json(proof.radius) : Json()}};
    if (!proof.obstacle.empty()) {
      group["proof"]["reason"] = proof.obstacle;
    }
  }
  entry["regularity"] = regularity_text(configuration.regularity);
  entry["residual"] = configuration.residual;
  return entry;
}

/// The distance of one configuration; its number is null if it is unknown.
Json nearest_json(const Nearest& nearest, bool is_numbered) {
  return {{"configuration", is_numbered ? Json(nearest.configuration + 1) : Json()},
          {"distance", nearest.distance},
          {"runner_up", nearest.runner_up ? Json(*nearest.runner_up) : Json()}};
}

Json drawn_json(const Report& report) {
  Json entry = {{"configuration", nullptr}, {"distance", nullptr}, {"runner_up", nullptr}};
  if (const std::optional<DrawnConfiguration> drawn = drawn_configuration(report)) {
    entry = nearest_json(drawn->nearest, drawn->is_numbered);
  }
  if (const std::optional<DrawnGap>& gap = report.plan.request().drawn->gap) {
    entry["gap"] = {{"joint", gap->joint}, {"length", gap->length}};
  }
  return entry;
}

/// The choices of earlier groups for which a group moves freely or is inconsistent.
Json families_json(const Report& report) {
  const Mechanism& mechanism = report.plan.mechanism();
  Json list = Json::array();
  for (const Family& family : report.solution.families) {
    Json links = Json::object();
    for (const LinkIndex link : mechanism.links().keys()) {
      if (family.is_placed[link]) {
        const Pose<double>& pose = family.links[link].pose;
        links[mechanism.links()[link].name] = {
            {"x", pose.x}, {"y", pose.y}, {"theta", angle_of(pose.direction)}};
      }
    }
    list.push_back({{"group", family.group.place() + 1},
                    {"mobility", family.mobility},
                    {"reason", family.reason},
                    {"after", {{"links", links}}}});
  }
  return list;
}

}  // namespace

}  // namespace assur::mechanism::report

namespace assur::mechanism {

std::string report_json(const Report& report) {
  const Solution& solution = report.solution;
  report::Json root;
  root["status"] = report::status_text(solution.status);
  root["mobility"] = solution.mobility;
  const std::string incomplete = report::incomplete_text(report);
  const std::string reason = report::reason_text(report);
  root["complete"] = incomplete.empty();
  if (!reason.empty() || !incomplete.empty()) {
    root["reason"] = reason + (reason.empty() || incomplete.empty() ? "" : "; ") + incomplete;
  }
  if (!report.plan.redundant().empty()) {
    for (const RedundantJoint& joint : report.plan.redundant()) {
      root["redundant"].push_back(joint.name);
    }
  }
  for (const Link& link : report.plan.mechanism().links()) {
    if (link.is_idle) {
      root["idle"].push_back(link.name);
    }
  }
  root["groups"] = report::groups_json(report.plan.structure());
  if (std::ranges::any_of(report.plan.mechanism().joints(),
                          [](const Joint& joint) { return joint.lowest.exists(); })) {
    root["left_out"] = solution.left_out ? report::Json(*solution.left_out) : report::Json();
  }
  if (solution.dropped > 0) {
    root["dropped"] = {{"count", solution.dropped}, {"reason", solution.drop_reason}};
  }
  if (report.nearest) {
    root["nearest"] = report::nearest_json(*report.nearest, !report.alone);
  }
  if (report.plan.request().drawn) {
    root["drawn"] = report::drawn_json(report);
  }
  if (const std::vector<std::string> corners = report.values.corners(); !corners.empty()) {
    root["corners"] = corners;
  }
  root["configurations"] = report::Json::array();
  for (std::size_t number = 0; number < solution.configurations.size(); ++number) {
    if (report::is_reported(report, number)) {
      root["configurations"].push_back(
          report::configuration_json(solution.configurations[number], report));
      if (const auto place = report::place_in_sweep(report, number)) {
        const auto known = [](int of) { return of > 0 ? report::Json(of) : report::Json(); };
        root["configurations"].back()["branch"] = known(place->branch);
        root["configurations"].back()["circuit"] = known(place->circuit);
      }
    }
  }
  if (const auto nearest = report::nearest_to_limits(report)) {
    report::Json& entry = root["nearest_to_limits"];
    for (const NearestToLimits::Excess& excess : nearest->excesses) {
      const Joint& joint = report.plan.mechanism().joints()[excess.joint];
      entry["excess"][joint.name] = excess.by;
    }
    entry.update(report::configuration_json(nearest->configuration, report));
  }
  if (!solution.families.empty()) {
    root["families"] = report::families_json(report);
  }
  return root.dump(2) + "\n";
}

}  // namespace assur::mechanism
