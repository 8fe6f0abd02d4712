#include "emission/scene/scene_warnings.hpp"

#include <algorithm>
#include <assur/mechanism/force_columns.hpp>
#include <assur/mechanism/plan.hpp>

namespace assur::generator::emission::scene {

std::vector<std::string> scene_warnings(const mechanism::Scene& scene) {
  constexpr std::size_t most_groups = 10;
  const mechanism::Plan plan(scene);
  std::vector<std::string> warnings;
  for (const mechanism::RedundantJoint& joint : plan.redundant()) {
    warnings.push_back("joints." + joint.name +
                       ": constraints of the joint are redundant; the solver leaves them out, and "
                       "excludes the configurations in which they do not hold");
  }
  if (mechanism::wants_force_sensitivities(plan)) {
    warnings.emplace_back(
        "want: the forces of the solver have no sensitivities; `assur solve` computes them");
  }
  if (plan.structure().groups.size() > most_groups) {
    return warnings;
  }
  const mechanism::Solution solution = plan.solve(plan.values());
  if (solution.status == mechanism::SolutionStatus::no_assembly) {
    warnings.push_back("the mechanism cannot be assembled at the scene's own numbers: " +
                       plan.obstacle(plan.values()));
  }
  for (const mechanism::Family& family : solution.families) {
    const std::string warning =
        "the solution at the scene's own numbers has a family: " + family.reason;
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) {
      warnings.push_back(warning);
    }
  }
  const auto singular =
      std::count_if(solution.configurations.begin(), solution.configurations.end(),
                    [](const mechanism::Configuration& configuration) {
                      return configuration.regularity != Status::ok;
                    });
  if (singular > 0) {
    warnings.push_back(
        std::to_string(singular) + " of the " + std::to_string(solution.configurations.size()) +
        " configurations at the scene's own numbers " + (singular == 1 ? "is" : "are") +
        " near-singular: `assur solve` shows which");
  }
  return warnings;
}

}  // namespace assur::generator::emission::scene
