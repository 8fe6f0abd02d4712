// Turns a solution into the contract's JSON object.
#include <nlohmann/json.hpp>

#include "scene/covariance.hpp"
#include "scene/report.hpp"
#include "scene/report_values.hpp"

namespace assur::generator {

namespace {

using Json = nlohmann::ordered_json;

template <typename Vector>
Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (Eigen::Index index = 0; index < vector.size(); ++index) {
    list.push_back(vector(index));
  }
  return list;
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
  if (want.velocity && want.acceleration) {
    const PathAcceleration parts = path_acceleration(point);
    entry["tangential"] = parts.tangential;
    entry["normal"] = parts.normal;
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

}  // namespace assur::generator
