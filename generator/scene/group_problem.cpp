#include "scene/group_problem.hpp"

#include <map>
#include <string>

#include "error.hpp"
#include "scene/model_state.hpp"

namespace assur::generator {

namespace {

const GroupFunctions& functions_for(const Model& model) {
  static const std::map<std::string, GroupFunctions> by_group = {
      {"dyad", dyad_functions()}, {"triad", triad_functions()}, {"tetrad", tetrad_functions()}};
  const auto found = by_group.find(model.group->name());
  if (found == by_group.end()) {
    throw GeneratorError("scene", model.title(), "the models of this group are not compiled in");
  }
  return found->second;
}

}  // namespace

GroupSolution solve_group(const Model& model, const GroupProblem& problem) {
  return functions_for(model).solve(model.number, problem);
}

ModelVerdict verdict_of(const Model& model) { return functions_for(model).verdict(model.number); }

bool is_compatible(const Model& model, const GroupProblem& problem) {
  return functions_for(model).is_compatible(model.number, problem);
}

}  // namespace assur::generator
