#include "emission/scene/variable_parameters.hpp"

#include <algorithm>
#include <assur/mechanism/error.hpp>

namespace assur::generator::emission::scene {

namespace {

using mechanism::ParameterIndex;

/// The parameters on which numbers of a mechanism depend. A held parameter depends on no other.
class Dependence {
 public:
  Dependence(const mechanism::Mechanism& mechanism, const std::vector<ParameterIndex>& held)
      : mechanism_(mechanism),
        on_(mechanism.parameters().size(), false),
        is_held_(mechanism.parameters().size(), false) {
    for (const ParameterIndex parameter : held) {
      is_held_[parameter] = true;
    }
  }

  /// The positions of joints and outputs.
  Dependence& add_places() {
    for (const mechanism::Joint& joint : mechanism_.joints()) {
      for (const mechanism::FeatureIndex feature : joint.between) {
        add(feature);
      }
    }
    for (const mechanism::Output& output : mechanism_.outputs()) {
      add(output.point);
    }
    return *this;
  }
  Dependence& add_limits() {
    for (const mechanism::Joint& joint : mechanism_.joints()) {
      if (joint.lowest.exists()) {
        add(joint.lowest);
        add(joint.highest);
      }
    }
    return *this;
  }
  /// Masses, gravity, loads and springs, where they are wanted.
  Dependence& add_loading(const mechanism::Want& want) {
    if (!want.loaded()) {
      return *this;
    }
    const mechanism::Loading& loading = mechanism_.loading();
    add_all({loading.gravity[0], loading.gravity[1]});
    for (const mechanism::Mass& mass : loading.masses) {
      add_all({mass.at.x, mass.at.y, mass.mass, mass.inertia});
    }
    for (const mechanism::Load& load : loading.loads) {
      add_all({load.at.x, load.at.y, load.force_x, load.force_y, load.moment});
    }
    for (const mechanism::Spring& spring : loading.springs) {
      add(spring.between[0]);
      add(spring.between[1]);
      add_all({spring.stiffness, spring.rest, spring.damping});
    }
    return *this;
  }
  Dependence& add_laws() {
    for (const mechanism::Driver& driver : mechanism_.drivers()) {
      add(driver.position);
    }
    return *this;
  }

  [[nodiscard]] bool on(ParameterIndex parameter) const { return on_[parameter]; }

 private:
  void add(mechanism::FeatureIndex index) {
    const mechanism::Feature& feature = mechanism_.features()[index];
    add(feature.x);
    add(feature.y);
    if (feature.is_line) {
      add(feature.along_x);
      add(feature.along_y);
    }
  }
  /// Absent numbers are skipped.
  void add_all(const std::vector<mechanism::NumberIndex>& numbers) {
    for (const mechanism::NumberIndex number : numbers) {
      if (number.exists()) {
        add(number);
      }
    }
  }
  void add(mechanism::NumberIndex number) {
    std::vector<mechanism::NumberIndex> pending{number};
    while (!pending.empty()) {
      const mechanism::Formula& formula = mechanism_.numbers()[pending.back()].formula;
      pending.pop_back();
      for (const ParameterIndex parameter : formula.parameters()) {
        if (!on_[parameter] && !is_held_[parameter]) {
          pending.push_back(mechanism_.parameters()[parameter].value);
        }
        on_[parameter] = true;
      }
    }
  }

  const mechanism::Mechanism& mechanism_;
  mechanism::Table<ParameterIndex, bool> on_, is_held_;
};

}  // namespace

std::vector<ParameterIndex> independent_parameters(const mechanism::Scene& scene) {
  const mechanism::Plan plan(scene);
  const mechanism::Mechanism& mechanism = plan.mechanism();
  const Dependence places = Dependence(mechanism, {}).add_places().add_loading(plan.request().want);
  std::vector<ParameterIndex> found;
  for (const ParameterIndex parameter : mechanism.parameters().keys()) {
    const mechanism::NumberIndex value = mechanism.parameters()[parameter].value;
    if (places.on(parameter) && mechanism.numbers()[value].formula.parameters().empty()) {
      found.push_back(parameter);
    }
  }
  return found;
}

void expect_arguments(const mechanism::Plan& plan, const std::vector<ParameterIndex>& parameters) {
  const Dependence places = Dependence(plan.mechanism(), parameters)
                                .add_places()
                                .add_limits()
                                .add_loading(plan.request().want);
  const Dependence laws = Dependence(plan.mechanism(), parameters).add_laws();
  for (const ParameterIndex parameter : parameters) {
    if (!places.on(parameter)) {
      throw mechanism::MechanismError(
          "parameters." + plan.mechanism().parameters()[parameter].name,
          laws.on(parameter)
              ? "only the law of a driver depends on it, and drivers are arguments of the solver "
                "already; do not make it variable"
              : "no reported result depends on it; do not make it variable");
    }
  }
}

}  // namespace assur::generator::emission::scene
