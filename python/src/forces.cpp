#include "forces.hpp"

#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/reported_parts.hpp>

#include "arrays.hpp"
#include "errors.hpp"

namespace assur::python {

namespace {

using mechanism::Forces;

py::array_t<double> array_of(const Eigen::Vector2d& vector) {
  py::array_t<double> array(2);
  std::copy_n(vector.data(), 2, array.mutable_data());
  return array;
}

/// The numbers of forces, or of their derivatives; those that are not determined are NaN.
py::dict numbers_of(const mechanism::Plan& plan, const Forces& forces) {
  const mechanism::Mechanism& mechanism = plan.mechanism();
  py::dict efforts;
  for (const mechanism::DriverIndex driver : mechanism.drivers().keys()) {
    const mechanism::JointIndex joint = mechanism.drivers()[driver].joint;
    efforts[py::str(mechanism.joints()[joint].name)] = forces.efforts[driver];
  }
  py::dict joints;
  for (const mechanism::JointForce& force : forces.joints) {
    const mechanism::JointIndex joint = index_of(mechanism.joints(), force.joint);
    if (joint.exists() && !plan.request().reported.has(joint)) {
      continue;
    }
    py::dict told;
    if (force.on.size() > 2) {
      py::dict on;
      for (const auto& [link, vector] : force.on) {
        on[py::str(mechanism.links()[link].name)] = array_of(vector);
      }
      told["forces"] = on;
    } else {
      told["force"] = array_of(force.on.back().second);
      told["on"] = mechanism.links()[force.on.back().first].name;
    }
    if (force.has_moment) {
      told["moment"] = force.moment;
    }
    joints[py::str(force.joint)] = told;
  }
  py::dict ground;
  ground["force"] = array_of(forces.ground.force);
  ground["moment"] = forces.ground.moment;
  py::dict result;
  result["efforts"] = efforts;
  result["joints"] = joints;
  result["ground"] = ground;
  return result;
}

}  // namespace

py::dict forces_in(const SolvedScene& solved, std::size_t place) {
  const mechanism::Plan& plan = solved.planned->plan;
  const mechanism::Want& want = plan.request().want;
  if (!want.forces) {
    throw NotWanted("forces: the scene does not want it; add \"forces\" to \"want\"");
  }
  const mechanism::Values values = solved.values();
  const mechanism::Configuration& configuration = solved.solution.configurations[place];
  const Forces forces = forces_of(values, without_unknown(plan, configuration));
  py::dict result = numbers_of(plan, forces);
  result["reason"] = forces.reason;
  if (want.sensitivity && plan.mechanism().parameters().size() > 0) {
    const std::vector<Forces> all = force_sensitivities(values, configuration);
    py::dict sensitivity;
    for (const mechanism::ParameterIndex parameter : plan.mechanism().parameters().keys()) {
      sensitivity[py::str(plan.mechanism().parameters()[parameter].name)] =
          numbers_of(plan, all[parameter.place()]);
    }
    result["sensitivity"] = sensitivity;
    result["worst_case"] = numbers_of(plan, worst_case(all, values.spread()));
    result["rss"] = numbers_of(plan, root_sum_square(all, values.spread()));
  }
  return result;
}

}  // namespace assur::python
