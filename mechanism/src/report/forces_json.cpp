#include "forces_json.hpp"

#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/reported_parts.hpp>
#include <cmath>
#include <utility>

namespace assur::mechanism::report {

namespace {

using Json = nlohmann::ordered_json;

/// A vector with an unknown component is null as a whole.
Json vector_json(const Eigen::Vector2d& vector) {
  return vector.allFinite() ? Json{vector.x() + 0.0, vector.y() + 0.0} : Json();
}

Json number_json(double number) { return std::isfinite(number) ? Json(number + 0.0) : Json(); }

/// The force that a joint transmits, or one on each link of a pin of more than two; and the couple.
Json joint_json(const JointForce& force, const Mechanism& mechanism) {
  Json entry;
  if (force.on.size() > 2) {
    for (const auto& [link, part] : force.on) {
      entry["forces"][mechanism.links()[link].name] = vector_json(part);
    }
  } else {
    entry["force"] = vector_json(force.on.back().second);
  }
  if (force.has_moment) {
    entry["moment"] = number_json(force.moment);
  }
  return entry;
}

/// Derivatives with respect to each parameter, worst case and rss of forces; nothing if they are
/// not requested.
struct Deviations {
  std::vector<std::pair<std::string, Forces>> sensitivities;
  Forces worst_case, rss;

  Deviations(const Report& report, const Configuration& configuration) {
    if (wants_force_sensitivities(report.plan)) {
      std::vector<Forces> all = force_sensitivities(report.values, configuration);
      worst_case = mechanism::worst_case(all, report.values.spread());
      rss = root_sum_square(all, report.values.spread());
      const auto& parameters = report.plan.mechanism().parameters();
      for (const ParameterIndex parameter : parameters.keys()) {
        sensitivities.emplace_back(parameters[parameter].name, std::move(all[parameter.place()]));
      }
    }
  }

  /// Adds them for a part of the forces, which `told` selects.
  template <typename Told>
  void add(const Told& told, Json& entry) const {
    if (sensitivities.empty()) {
      return;
    }
    for (const auto& [parameter, forces] : sensitivities) {
      entry["sensitivity"][parameter] = told(forces);
    }
    entry["worst_case"] = told(worst_case);
    entry["rss"] = told(rss);
  }
};

void add_all_forces(const Report& report, const Configuration& configuration, Json& entry) {
  const Mechanism& mechanism = report.plan.mechanism();
  const Forces forces = forces_of(report.values, configuration);
  const Deviations deviations(report, configuration);
  const auto add = [&](const auto& told, bool is_determined, Json& part) {
    part.update(told(forces));
    if (!is_determined) {
      part["reason"] = forces.reason;
    }
    deviations.add(told, part);
  };
  for (std::size_t place = 0; place < forces.joints.size(); ++place) {
    const JointForce& force = forces.joints[place];
    const JointIndex joint = index_of(mechanism.joints(), force.joint);
    if (!joint.exists() || report.plan.request().reported.has(joint)) {
      Json& part = entry["joints"][force.joint];
      if (force.on.size() == 2) {
        part["on"] = mechanism.links()[force.on.back().first].name;
      }
      add([&](const Forces& of) { return joint_json(of.joints[place], mechanism); },
          force.is_determined(), part);
    }
  }
  entry["drivers"] = Json::object();
  for (const DriverIndex driver : described_drivers(mechanism)) {
    add(
        [&](const Forces& of) {
          return Json{{"effort", number_json(of.efforts[driver])}};
        },
        std::isfinite(forces.efforts[driver]),
        entry["drivers"][mechanism.joints()[mechanism.drivers()[driver].joint].name]);
  }
  add(
      [](const Forces& of) {
        return Json{{"force", vector_json(of.ground.force)},
                    {"moment", number_json(of.ground.moment)}};
      },
      true, entry["ground"]);
}

template <typename Numbers>
Json list_json(const Numbers& numbers) {
  Json list = Json::array();
  for (Eigen::Index index = 0; index < numbers.size(); ++index) {
    list.push_back(number_json(numbers(index)));
  }
  return list;
}

std::vector<std::string> names_of(const Mechanism& mechanism,
                                  const std::vector<DriverIndex>& drivers) {
  std::vector<std::string> names;
  for (const DriverIndex driver : drivers) {
    names.push_back(mechanism.joints()[mechanism.drivers()[driver].joint].name);
  }
  return names;
}

void add_dynamics(const Report& report, const Configuration& configuration, Json& entry) {
  const Dynamics dynamics = dynamics_of(report.values, configuration);
  Json& told = entry["dynamics"];
  told["drivers"] = names_of(report.plan.mechanism(), dynamics.drivers);
  told["mass_matrix"] = Json::array();
  for (Eigen::Index row = 0; row < dynamics.mass_matrix.rows(); ++row) {
    told["mass_matrix"].push_back(list_json(dynamics.mass_matrix.row(row)));
  }
  told["bias"] = list_json(dynamics.bias);
  told["load"] = list_json(dynamics.load);
  if (!dynamics.reason.empty()) {
    told["reason"] = dynamics.reason;
  }
}

/// First and second derivatives under the names of the drivers; a single coordinate is a number.
template <int Coordinates>
Json coefficients_json(const Derivatives<Coordinates>& derivatives,
                       const std::vector<std::string>& drivers, const std::string& reason) {
  bool is_known = true;
  const auto told = [&](const Eigen::Matrix<double, Coordinates, 1>& numbers) {
    is_known = is_known && numbers.allFinite();
    if constexpr (Coordinates == 1) {
      return number_json(numbers(0));
    } else {
      return numbers.allFinite() ? list_json(numbers) : Json();
    }
  };
  Json entry = {{"first", Json::object()}, {"second", Json::object()}};
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    entry["first"][drivers[i]] = told(derivatives.first.col(row));
    for (std::size_t j = 0; j < drivers.size(); ++j) {
      Eigen::Matrix<double, Coordinates, 1> second;
      for (std::size_t part = 0; part < Coordinates; ++part) {
        second(static_cast<Eigen::Index>(part)) =
            derivatives.second[part](row, static_cast<Eigen::Index>(j));
      }
      entry["second"][drivers[i]][drivers[j]] = told(second);
    }
  }
  if (!is_known) {
    entry["reason"] = reason;
  }
  return entry;
}

void add_coefficients(const Report& report, const Configuration& configuration, Json& entry) {
  const Mechanism& mechanism = report.plan.mechanism();
  const KinematicCoefficients all = coefficients_of(report.values, configuration);
  const std::vector<std::string> drivers = names_of(mechanism, all.drivers);
  for (const LinkIndex link : reported_links(report.plan, false)) {
    entry["links"][mechanism.links()[link].name]["coefficients"] =
        coefficients_json(all.links[link], drivers, all.reason);
  }
  for (const OutputIndex output : mechanism.outputs().keys()) {
    entry["outputs"][mechanism.outputs()[output].name]["coefficients"] =
        coefficients_json(all.outputs[output], drivers, all.reason);
  }
  for (const JointCoefficients& of : all.joints) {
    const JointIndex joint = index_of(mechanism.joints(), of.joint);
    if (!joint.exists() || report.plan.request().reported.has(joint)) {
      entry["joints"][of.joint]["coefficients"] =
          coefficients_json(of.coordinate, drivers, all.reason);
    }
  }
}

}  // namespace

void add_forces(const Report& report, const Configuration& configuration, Json& entry) {
  const Want& want = report.plan.request().want;
  if (want.forces) {
    add_all_forces(report, configuration, entry);
  }
  if (want.dynamics) {
    add_dynamics(report, configuration, entry);
  }
  if (want.coefficients) {
    add_coefficients(report, configuration, entry);
  }
}

}  // namespace assur::mechanism::report
